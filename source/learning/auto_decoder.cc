#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/learning/auto_decoder.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "checked_file.h"

namespace asperity
{
  namespace
  {
    const char *const kind = "learned model";

    void
    check_length(const std::string &name, const std::size_t n, const unsigned m)
    {
      if (n == 0 || n % m != 0)
        throw InputError("The sample " + quoted_name(name) + " has " +
                         std::to_string(n) +
                         " numbers, which are not points "
                         "of " +
                         std::to_string(m) + " components.");
    }
  } // namespace



  Scaling
  scaling_of_positions(const std::vector<FieldSample> &samples,
                       const unsigned int              n_coordinates)
  {
    const double        infinity = std::numeric_limits<double>::infinity();
    std::vector<double> low(n_coordinates, infinity),
      up(n_coordinates, -infinity);
    for (const FieldSample &sample : samples)
      {
        check_length(sample.name, sample.positions.size(), n_coordinates);
        for (std::size_t i = 0; i < sample.positions.size(); ++i)
          {
            double &l = low[i % n_coordinates], &u = up[i % n_coordinates];
            l = std::min(l, sample.positions[i]);
            u = std::max(u, sample.positions[i]);
          }
      }
    Scaling result(n_coordinates);
    for (unsigned int c = 0; c < n_coordinates && low[c] < infinity; ++c)
      {
        result.centre[c] = 0.5 * (low[c] + up[c]);
        if (up[c] > low[c])
          result.scale[c] = 0.5 * (up[c] - low[c]);
      }
    return result;
  }



  Scaling
  scaling_of_values(const std::vector<FieldSample> &samples,
                    const unsigned int              n_components)
  {
    Scaling             result(n_components);
    std::vector<double> sum(n_components, 0.), squares(n_components, 0.);
    double              n = 0.;
    for (const FieldSample &sample : samples)
      {
        check_length(sample.name, sample.values.size(), n_components);
        n += static_cast<double>(sample.values.size() / n_components);
        for (std::size_t i = 0; i < sample.values.size(); ++i)
          sum[i % n_components] += sample.values[i];
      }
    for (unsigned int c = 0; c < n_components && n > 0.; ++c)
      result.centre[c] = sum[c] / n;
    for (const FieldSample &sample : samples)
      for (std::size_t i = 0; i < sample.values.size(); ++i)
        {
          const double d = sample.values[i] - result.centre[i % n_components];
          squares[i % n_components] += d * d;
        }
    for (unsigned int c = 0; c < n_components; ++c)
      if (squares[c] > 0.)
        result.scale[c] = std::sqrt(squares[c] / n);
    return result;
  }



  AutoDecoder::AutoDecoder(const Decoder<float>           &decoder,
                           const std::vector<float>       &codes,
                           const std::vector<std::string> &names,
                           const Scaling                  &position_scaling,
                           const Scaling                  &value_scaling)
    : decoder_(decoder)
    , codes_(codes)
    , names_(names)
    , position_scaling_(position_scaling)
    , value_scaling_(value_scaling)
  {
    check();
  }



  void
  AutoDecoder::check() const
  {
    const DecoderShape &shape = decoder_.shape();
    const auto is_scaling     = [](const Scaling &s, const unsigned int n) {
      return s.centre.size() == n && s.scale.size() == n &&
             std::all_of(s.scale.begin(), s.scale.end(), [](const double x) {
               return x > 0. && std::isfinite(x);
             });
    };
    if (codes_.size() != names_.size() * shape.n_code ||
        decoder_.parameters().size() != shape.n_parameters() ||
        !is_scaling(position_scaling_, shape.n_position) ||
        !is_scaling(value_scaling_, shape.n_outputs))
      throw InputError("The parts of a learned model do not fit together.");
  }



  std::vector<float>
  AutoDecoder::code(const std::size_t sample) const
  {
    const auto begin = codes_.begin() + sample * decoder_.shape().n_code;
    return {begin, begin + decoder_.shape().n_code};
  }



  std::vector<double>
  AutoDecoder::evaluate(const std::vector<float>  &code,
                        const std::vector<double> &positions,
                        std::vector<double>       *derivatives) const
  {
    const DecoderShape &shape = decoder_.shape();
    const unsigned int  dim = shape.n_position, n_out = shape.n_outputs;
    if (code.size() != shape.n_code || positions.size() % dim != 0)
      throw InputError(
        "The learned model takes codes of " + std::to_string(shape.n_code) +
        " numbers and points of " + std::to_string(dim) + " coordinates, not " +
        std::to_string(code.size()) + " and " +
        std::to_string(positions.size()) + " numbers.");
    constexpr std::size_t     block = 512;
    const std::size_t         n     = positions.size() / dim;
    std::vector<double>       values(n * n_out);
    std::vector<float>        slopes(block * dim * n_out);
    Decoder<float>::Workspace workspace;
    if (derivatives != nullptr)
      derivatives->resize(n * dim * n_out);
    for (std::size_t begin = 0; begin < n; begin += block)
      {
        const std::size_t m     = std::min(block, n - begin);
        float            *input = decoder_.inputs(m, workspace);
        for (std::size_t i = begin * dim; i < (begin + m) * dim; ++i)
          {
            const unsigned int c = i % dim;
            if (c == 0)
              input = std::copy(code.begin(), code.end(), input);
            *input++ =
              static_cast<float>((positions[i] - position_scaling_.centre[c]) /
                                 position_scaling_.scale[c]);
          }
        const float *const y = decoder_.evaluate(m, workspace);
        for (std::size_t i = 0; i < m * n_out; ++i)
          values[begin * n_out + i] = value_scaling_.centre[i % n_out] +
                                      value_scaling_.scale[i % n_out] * y[i];
        if (derivatives == nullptr)
          continue;
        decoder_.position_derivatives(m, workspace, slopes.data());
        for (std::size_t i = 0; i < m * dim * n_out; ++i)
          (*derivatives)[begin * dim * n_out + i] =
            slopes[i] * value_scaling_.scale[i % n_out] /
            position_scaling_.scale[i / n_out % dim];
      }
    return values;
  }



  template <typename Archive>
  void
  AutoDecoder::serialize(Archive &archive)
  {
    DecoderShape shape = decoder_.shape();
    archive     &shape;
    shape.check();
    std::vector<float>                   parameters = decoder_.parameters();
    archive &parameters &codes_ &names_ &description;
    archive &position_scaling_          &value_scaling_;
    if (parameters.size() == shape.n_parameters())
      {
        decoder_              = Decoder<float>(shape);
        decoder_.parameters() = std::move(parameters);
      }
    else
      codes_.clear(); // what check() refuses
  }



  void
  AutoDecoder::write(const std::string &path) const
  {
    AutoDecoder copy = *this;
    write_checked_file(path, kind, to_bytes([&](OutputArchive &archive) {
                         copy.serialize(archive);
                       }));
  }



  AutoDecoder
  AutoDecoder::read(const std::string &path)
  {
    AutoDecoder       result;
    const std::string bytes = read_checked_file(path, kind);
    from_bytes(bytes,
               std::string("The ") + kind + " " + quoted_name(path),
               [&](InputArchive &archive) { result.serialize(archive); });
    result.check();
    return result;
  }
} // namespace asperity
