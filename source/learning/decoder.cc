#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learning/decoder.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "blas.h"

namespace asperity
{
  unsigned int
  DecoderShape::inputs_of(const unsigned int layer) const
  {
    if (layer == 0)
      return n_inputs();
    return layer == skip_layer ? width + n_inputs() : width;
  }



  std::size_t
  DecoderShape::n_parameters() const
  {
    std::size_t n = 0;
    for (unsigned int layer = 0; layer <= n_layers; ++layer)
      n += (inputs_of(layer) + std::size_t(1)) * outputs_of(layer);
    return n;
  }



  double
  DecoderShape::flops(const bool with_gradient) const
  {
    double n = 0.;
    for (unsigned int layer = 0; layer <= n_layers; ++layer)
      n += 2. * inputs_of(layer) * outputs_of(layer);
    return with_gradient ? 3. * n : n;
  }



  void
  DecoderShape::check() const
  {
    const auto refuse = [](const std::string &what) {
      throw InputError("A network with " + what + " is not possible.");
    };
    const unsigned int most = 4096;
    if (n_position < 1 || n_position > 16)
      refuse(std::to_string(n_position) + " coordinates (1 to 16)");
    if (n_code > 1024)
      refuse("codes of " + std::to_string(n_code) + " numbers (0 to 1024)");
    if (n_outputs < 1 || n_outputs > most)
      refuse(std::to_string(n_outputs) + " outputs (1 to 4096)");
    if (n_layers < 1 || n_layers > 64)
      refuse(std::to_string(n_layers) + " hidden layers (1 to 64)");
    if (width < 1 || width > most)
      refuse(std::to_string(width) + " neurons a layer (1 to 4096)");
    if (skip_layer > n_layers)
      refuse("inputs fed in again at layer " + std::to_string(skip_layer) +
             " of " + std::to_string(n_layers));
    if (activation > Activation::sine || activation == Activation::identity)
      refuse("an unknown activation");
    if (output != Activation::tanh && output != Activation::identity)
      refuse("another output than tanh or none");
    if (!(frequency > 0. && frequency < 1e3))
      refuse("a frequency that is not between 0 and 1000");
  }



  template <typename Number>
  Decoder<Number>::Decoder(const DecoderShape &shape)
    : shape_(shape)
  {
    shape.check();
    std::size_t n = 0;
    for (unsigned int layer = 0; layer <= shape.n_layers; ++layer)
      {
        first.push_back(n);
        n +=
          (shape.inputs_of(layer) + std::size_t(1)) * shape.outputs_of(layer);
      }
    parameters_.assign(n, Number(0));
  }



  template <typename Number>
  void
  Decoder<Number>::initialize(RandomNumbers &random)
  {
    const double pi = 3.14159265358979323846;
    for (unsigned int layer = 0; layer <= shape_.n_layers; ++layer)
      {
        const unsigned int n = shape_.inputs_of(layer);
        const unsigned int m = shape_.outputs_of(layer);

        const bool   is_last = layer == shape_.n_layers;
        const bool   is_sine = shape_.activation == Activation::sine;
        const bool   is_relu = shape_.activation == Activation::relu;
        const double limit = is_sine && layer == 0 ? pi * shape_.frequency / n :
                             (is_sine || is_relu) && !is_last ?
                                                     std::sqrt(6. / n) :
                                                     std::sqrt(6. / (n + m));
        Number *const w    = parameters_.data() + first[layer];
        for (std::size_t i = 0; i < std::size_t(n) * m; ++i)
          w[i] = static_cast<Number>(limit * (2. * random.uniform() - 1.));
        std::fill_n(w + std::size_t(n) * m, m, Number(0));
      }
  }



  template <typename Number>
  Number *
  Decoder<Number>::inputs(const std::size_t n, Workspace &workspace) const
  {
    const unsigned int n_layers = shape_.n_layers;
    workspace.values.resize(n_layers + 2);
    workspace.derivatives.resize(n_layers + 1);
    const auto make_room = [](std::vector<Number> &v, const std::size_t size) {
      if (v.size() < size)
        v.resize(size);
    };
    for (unsigned int layer = 0; layer <= n_layers; ++layer)
      {
        make_room(workspace.values[layer], n * shape_.inputs_of(layer));
        make_room(workspace.derivatives[layer], n * shape_.outputs_of(layer));
      }
    make_room(workspace.values[n_layers + 1], n * shape_.n_outputs);
    const unsigned int widest =
      std::max(shape_.width + shape_.n_inputs(), shape_.n_outputs);
    make_room(workspace.delta, n * widest);
    make_room(workspace.above, n * widest);
    return workspace.values[0].data();
  }



  template <typename Number>
  const Number *
  Decoder<Number>::evaluate(const std::size_t n, Workspace &workspace) const
  {
    const unsigned int n_in = shape_.n_inputs();
    for (unsigned int layer = 0; layer <= shape_.n_layers; ++layer)
      {
        const bool         is_last = layer == shape_.n_layers;
        const unsigned int in      = shape_.inputs_of(layer);
        const unsigned int out     = shape_.outputs_of(layer);
        const unsigned int stride = is_last ? out : shape_.inputs_of(layer + 1);
        const Number *const w     = matrix(layer);
        const Number *const offset = w + std::size_t(in) * out;
        Number *const       y      = workspace.values[layer + 1].data();
        for (std::size_t j = 0; j < n; ++j)
          std::copy_n(offset, out, y + j * stride);
        gemm('N',
             'N',
             out,
             n,
             in,
             w,
             out,
             workspace.values[layer].data(),
             in,
             Number(1),
             y,
             stride);
        activate(is_last ? shape_.output : shape_.activation,
                 out,
                 n,
                 stride,
                 y,
                 workspace.derivatives[layer].data());
        if (stride > out)
          for (std::size_t j = 0; j < n; ++j)
            std::copy_n(workspace.values[0].data() + j * n_in,
                        n_in,
                        y + j * stride + out);
      }
    return workspace.values.back().data();
  }



  /** Of matrix and offsets, with the derivatives by a layer's sums in delta. */
  template <typename Number>
  void
  Decoder<Number>::add_layer_gradient(const unsigned int layer,
                                      const std::size_t  n,
                                      const Workspace   &workspace,
                                      Number            *gradient) const
  {
    const unsigned int  in    = shape_.inputs_of(layer);
    const unsigned int  out   = shape_.outputs_of(layer);
    const Number *const delta = workspace.delta.data();
    gemm('N',
         'T',
         out,
         in,
         n,
         delta,
         out,
         workspace.values[layer].data(),
         in,
         Number(1),
         gradient,
         out);
    Number *const offsets = gradient + std::size_t(in) * out;
    for (std::size_t j = 0; j < n; ++j)
      for (unsigned int i = 0; i < out; ++i)
        offsets[i] += delta[j * out + i];
  }



  template <typename Number>
  void
  Decoder<Number>::add_gradient(const std::size_t n,
                                const Number     *d_outputs,
                                Workspace        &workspace,
                                Number           *d_parameters,
                                Number           *d_inputs) const
  {
    const unsigned int n_in     = shape_.n_inputs();
    Number *const      delta    = workspace.delta.data();
    Number *const      above    = workspace.above.data();
    const auto         multiply = [&](const unsigned int layer,
                              const Number      *d,
                              const unsigned int stride) {
      const unsigned int  out = shape_.outputs_of(layer);
      const Number *const s   = workspace.derivatives[layer].data();
      for (std::size_t j = 0; j < n; ++j)
        for (unsigned int i = 0; i < out; ++i)
          delta[j * out + i] = d[j * stride + i] * s[j * out + i];
    };
    if (d_inputs != nullptr)
      std::fill_n(d_inputs, n * n_in, Number(0));
    multiply(shape_.n_layers, d_outputs, shape_.n_outputs);
    for (unsigned int layer = shape_.n_layers + 1; layer-- > 0;)
      {
        const unsigned int in  = shape_.inputs_of(layer);
        const unsigned int out = shape_.outputs_of(layer);
        if (d_parameters != nullptr)
          add_layer_gradient(layer, n, workspace, d_parameters + first[layer]);
        const bool feeds_inputs = layer == 0 || layer == shape_.skip_layer;
        if (layer == 0 && d_inputs == nullptr)
          return;
        gemm('T',
             'N',
             in,
             n,
             out,
             matrix(layer),
             out,
             delta,
             out,
             Number(0),
             above,
             in);
        if (feeds_inputs && d_inputs != nullptr)
          for (std::size_t j = 0; j < n; ++j)
            for (unsigned int i = 0; i < n_in; ++i)
              d_inputs[j * n_in + i] += above[(j + 1) * in - n_in + i];
        if (layer > 0)
          multiply(layer - 1, above, in);
      }
  }



  template <typename Number>
  void
  Decoder<Number>::position_derivatives(const std::size_t n,
                                        Workspace        &workspace,
                                        Number           *derivatives) const
  {
    const unsigned int n_in = shape_.n_inputs(), dim = shape_.n_position;
    Number *const      tangent = workspace.delta.data();
    Number *const      next    = workspace.above.data();
    for (unsigned int d = 0; d < dim; ++d)
      {
        const unsigned int input = shape_.n_code + d;
        for (unsigned int layer = 0; layer <= shape_.n_layers; ++layer)
          {
            const unsigned int  out = shape_.outputs_of(layer);
            const Number *const w   = matrix(layer);
            const Number *const s   = workspace.derivatives[layer].data();
            // The inputs of a layer are those of the one before it, and at most
            // one more that changes at rate 1: a column of the matrix.
            const bool has_inputs = layer == 0 || layer == shape_.skip_layer;
            const Number *const column =
              w + std::size_t(out) * (shape_.inputs_of(layer) - n_in + input);
            for (std::size_t j = 0; j < n; ++j)
              if (has_inputs)
                std::copy_n(column, out, next + j * out);
              else
                std::fill_n(next + j * out, out, Number(0));
            if (layer > 0)
              gemm('N',
                   'N',
                   out,
                   n,
                   shape_.width,
                   w,
                   out,
                   tangent,
                   shape_.width,
                   Number(1),
                   next,
                   out);
            for (std::size_t i = 0; i < n * out; ++i)
              tangent[i] = next[i] * s[i];
          }
        const unsigned int out = shape_.n_outputs;
        for (std::size_t j = 0; j < n; ++j)
          std::copy_n(tangent + j * out,
                      out,
                      derivatives + (j * dim + d) * out);
      }
  }



  template class Decoder<float>;
  template class Decoder<double>;
} // namespace asperity
