#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/base/text.h>
#include <asperity/surrogate/design.h>

#include <gsl/gsl_qrng.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace asperity
{
  namespace
  {
    constexpr std::size_t largest_design = 1000000;

    /** Latin hypercubes of which the best one is taken. */
    constexpr unsigned int n_hypercubes = 20;

    double
    on_scale(const Scale scale, const double x)
    {
      return scale == Scale::logarithmic ? std::log(x) : x;
    }

    void
    check_box(const std::vector<LawInput> &inputs)
    {
      if (inputs.empty())
        throw InputError("A design without inputs was asked for; at least one "
                         "input with a range is expected.");
      for (const LawInput &input : inputs)
        {
          const std::string range = "The range of the input " +
                                    quoted_name(input.name) + " goes from " +
                                    std::to_string(input.lower) + " to " +
                                    std::to_string(input.upper);
          if (!(input.lower < input.upper) || !std::isfinite(input.lower) ||
              !std::isfinite(input.upper))
            throw InputError(range + ", but must be finite and not empty.");
          if (input.scale == Scale::logarithmic && input.lower <= 0.)
            throw InputError(
              range + ", but a logarithmic scale needs positive values.");
        }
    }

    /** Square of the distance between the closest two points. */
    double
    smallest_distance(const std::vector<double> &x, const unsigned int d)
    {
      double            smallest = std::numeric_limits<double>::infinity();
      const std::size_t n        = x.size() / d;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j)
          {
            double square = 0.;
            for (unsigned int k = 0; k < d; ++k)
              {
                const double difference = x[i * d + k] - x[j * d + k];
                square += difference * difference;
              }
            smallest = std::min(smallest, square);
          }
      return smallest;
    }

    std::vector<double>
    draw_hypercube(const std::size_t  n,
                   const unsigned int d,
                   RandomNumbers     &random)
    {
      std::vector<double> x(n * d);
      for (unsigned int k = 0; k < d; ++k)
        {
          const std::vector<std::size_t> slice = random.permutation(n);
          for (std::size_t i = 0; i < n; ++i)
            x[i * d + k] =
              (static_cast<double>(slice[i]) + random.uniform()) / n;
        }
      return x;
    }
  } // namespace



  double
  unit_coordinate(const LawInput &input, const double x)
  {
    const double start = on_scale(input.scale, input.lower);
    return (on_scale(input.scale, x) - start) /
           (on_scale(input.scale, input.upper) - start);
  }



  double
  from_unit_coordinate(const LawInput &input, const double z)
  {
    if (z == 0.)
      return input.lower;
    if (z == 1.)
      return input.upper;
    if (input.scale == Scale::logarithmic)
      return input.lower * std::pow(input.upper / input.lower, z);
    return input.lower + z * (input.upper - input.lower);
  }



  std::vector<double>
  map_to_box(const std::vector<LawInput> &inputs,
             const std::vector<double>   &unit)
  {
    check_box(inputs);
    std::vector<double> x(unit.size());
    for (std::size_t i = 0; i < unit.size(); ++i)
      x[i] = from_unit_coordinate(inputs[i % inputs.size()], unit[i]);
    return x;
  }



  std::vector<double>
  map_to_unit(const std::vector<LawInput> &inputs, const std::vector<double> &x)
  {
    check_box(inputs);
    std::vector<double> unit(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      unit[i] = unit_coordinate(inputs[i % inputs.size()], x[i]);
    return unit;
  }



  std::vector<double>
  unit_grid(const std::vector<unsigned int> &n_values)
  {
    std::size_t n = 1;
    for (const unsigned int values : n_values)
      {
        if (values == 0)
          throw InputError("A grid without values of an input was asked for; "
                           "at least one value is expected.");
        n *= values;
        if (n > largest_design)
          throw InputError("A grid of more than a million points was asked "
                           "for; fewer values of each input are expected.");
      }
    std::vector<double> x(n * n_values.size());
    for (std::size_t i = 0; i < n; ++i)
      {
        std::size_t rest = i;
        for (std::size_t k = n_values.size(); k-- > 0;)
          {
            const unsigned int values = n_values[k];
            x[i * n_values.size() + k] =
              values == 1 ? 0.5 :
                            static_cast<double>(rest % values) / (values - 1);
            rest /= values;
          }
      }
    return x;
  }



  std::vector<double>
  unit_sobol(const std::size_t  n,
             const unsigned int n_inputs,
             const std::size_t  first)
  {
    if (n_inputs < 1 || n_inputs > gsl_qrng_sobol->max_dimension)
      throw InputError("Sobol points of " + std::to_string(n_inputs) +
                       " inputs were asked for; 1 to " +
                       std::to_string(gsl_qrng_sobol->max_dimension) +
                       " inputs are possible.");
    const std::unique_ptr<gsl_qrng, void (*)(gsl_qrng *)> sequence(
      gsl_qrng_alloc(gsl_qrng_sobol, n_inputs), gsl_qrng_free);
    std::vector<double> skipped(n_inputs), x(n * n_inputs);
    for (std::size_t i = 1; i < first; ++i)
      gsl_qrng_get(sequence.get(), skipped.data());
    for (std::size_t i = 0; i < n; ++i)
      gsl_qrng_get(sequence.get(), &x[i * n_inputs]);
    return x;
  }



  std::vector<double>
  unit_latin_hypercube(const std::size_t   n,
                       const unsigned int  n_inputs,
                       const std::uint64_t seed)
  {
    RandomNumbers       random(seed);
    std::vector<double> best;
    double              best_distance = -1.;
    for (unsigned int i = 0; i < n_hypercubes; ++i)
      {
        std::vector<double> x        = draw_hypercube(n, n_inputs, random);
        const double        distance = smallest_distance(x, n_inputs);
        if (distance > best_distance)
          {
            best          = std::move(x);
            best_distance = distance;
          }
      }
    return best;
  }



  std::vector<double>
  unit_random(const std::size_t   n,
              const unsigned int  n_inputs,
              const std::uint64_t seed)
  {
    RandomNumbers       random(seed);
    std::vector<double> x(n * n_inputs);
    for (double &value : x)
      value = random.uniform();
    return x;
  }



  std::vector<double>
  unit_corners(const unsigned int n_inputs)
  {
    return unit_grid(std::vector<unsigned int>(n_inputs, 2));
  }



  std::vector<double>
  design_points(const DesignKind             kind,
                const unsigned int           n,
                const std::vector<LawInput> &inputs,
                const std::uint64_t          seed)
  {
    check_box(inputs);
    const unsigned int d = inputs.size();
    switch (kind)
      {
        case DesignKind::grid:
          return grid_points(std::vector<unsigned int>(d, n), inputs);
        case DesignKind::sobol:
          return map_to_box(inputs, unit_sobol(n, d));
        case DesignKind::latin_hypercube:
          return map_to_box(inputs, unit_latin_hypercube(n, d, seed));
        case DesignKind::random:
          return map_to_box(inputs, unit_random(n, d, seed));
      }
    return {};
  }



  std::vector<double>
  grid_points(const std::vector<unsigned int> &n_values,
              const std::vector<LawInput>     &inputs)
  {
    if (n_values.size() != inputs.size())
      throw InputError("A grid with numbers of values for " +
                       std::to_string(n_values.size()) +
                       " inputs was asked for; one number for each of the " +
                       std::to_string(inputs.size()) + " inputs is expected.");
    return map_to_box(inputs, unit_grid(n_values));
  }
} // namespace asperity
