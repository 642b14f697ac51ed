#include "scaled_sample.h"

#include <asperity/base/errors.h>
#include <asperity/base/text.h>

#include <cmath>
#include <string>

namespace asperity
{
  namespace
  {
    std::vector<float>
    scaled(const std::vector<double> &numbers,
           const Scaling             &scaling,
           const std::string         &name)
    {
      const std::size_t  n = scaling.scale.size();
      std::vector<float> result(numbers.size());
      for (std::size_t i = 0; i < numbers.size(); ++i)
        {
          result[i] = static_cast<float>((numbers[i] - scaling.centre[i % n]) /
                                         scaling.scale[i % n]);
          if (!std::isfinite(result[i]))
            throw InputError("The sample " + quoted_name(name) +
                             " has a position or value that is no number.");
        }
      return result;
    }
  } // namespace



  ScaledSample::ScaledSample(const FieldSample  &sample,
                             const DecoderShape &shape,
                             const Scaling      &position_scaling,
                             const Scaling      &value_scaling)
  {
    const std::size_t n = sample.positions.size() / shape.n_position;
    if (n == 0 || sample.positions.size() != n * shape.n_position ||
        sample.values.size() != n * shape.n_outputs)
      throw InputError(
        "The sample " + quoted_name(sample.name) + " has " +
        std::to_string(sample.positions.size()) + " coordinates and " +
        std::to_string(sample.values.size()) +
        " values, which are not points of " + std::to_string(shape.n_position) +
        " with " + std::to_string(shape.n_outputs) + ".");
    if (position_scaling.scale.size() != shape.n_position ||
        value_scaling.scale.size() != shape.n_outputs)
      throw InputError("Scaling and shape of a network do not fit together.");
    positions = scaled(sample.positions, position_scaling, sample.name);
    values    = scaled(sample.values, value_scaling, sample.name);
  }



  void
  add_length_gradient(const unsigned int n,
                      const double       factor,
                      const float       *z,
                      float             *gradient)
  {
    double square = 0.;
    for (unsigned int i = 0; i < n; ++i)
      square += double(z[i]) * z[i];
    if (square > 0.)
      for (unsigned int i = 0; i < n; ++i)
        gradient[i] += static_cast<float>(factor / std::sqrt(square) * z[i]);
  }
} // namespace asperity
