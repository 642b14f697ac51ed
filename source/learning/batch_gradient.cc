#include "batch_gradient.h"

#include <algorithm>

namespace asperity
{
  namespace
  {
    /** Points whose signals fit the caches of a core. */
    constexpr std::size_t block = 512;
  } // namespace



  void
  PointBatch::add(const unsigned int place,
                  const float       *x,
                  const unsigned int n_position,
                  const float       *y,
                  const unsigned int n_outputs)
  {
    sample.push_back(place);
    positions.insert(positions.end(), x, x + n_position);
    values.insert(values.end(), y, y + n_outputs);
  }



  BatchGradient::BatchGradient(const Decoder<float> &decoder, const Loss &loss)
    : decoder(decoder)
    , loss(loss)
    , d_outputs(block * decoder.shape().n_outputs)
    , d_inputs(block * decoder.shape().n_inputs())
  {}



  double
  BatchGradient::add(const PointBatch &batch,
                     const std::size_t begin,
                     const std::size_t end,
                     const float      *codes,
                     const float       factor,
                     float            *d_parameters,
                     float            *d_codes)
  {
    const DecoderShape &shape = decoder.shape();
    const unsigned int  n_in = shape.n_inputs(), n_code = shape.n_code,
                       n_out = shape.n_outputs;
    double sum               = 0.;
    for (std::size_t first = begin; first < end; first += block)
      {
        const std::size_t n     = std::min(block, end - first);
        float            *input = decoder.inputs(n, workspace);
        for (std::size_t j = first; j < first + n; ++j)
          {
            input =
              std::copy_n(codes + batch.sample[j] * n_code, n_code, input);
            input = std::copy_n(batch.positions.data() + j * shape.n_position,
                                shape.n_position,
                                input);
          }
        sum += loss.evaluate(n * n_out,
                             decoder.evaluate(n, workspace),
                             batch.values.data() + first * n_out,
                             factor,
                             d_outputs.data());
        decoder.add_gradient(n,
                             d_outputs.data(),
                             workspace,
                             d_parameters,
                             n_code > 0 ? d_inputs.data() : nullptr);
        for (std::size_t j = 0; j < n && n_code > 0; ++j)
          for (unsigned int i = 0; i < n_code; ++i)
            d_codes[batch.sample[first + j] * n_code + i] +=
              d_inputs[j * n_in + i];
      }
    return sum;
  }
} // namespace asperity
