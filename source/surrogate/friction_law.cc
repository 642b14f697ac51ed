#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/surrogate/friction_law.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    double
    transform(const Scale scale, const double x)
    {
      return scale == Scale::logarithmic ? std::log(x) : x;
    }

    void
    check_input(const LawInput &input, const std::string &origin)
    {
      if (input.name.empty() || input.symbol.empty())
        throw InputError(origin + ": An input of the law has no name or no "
                                  "symbol; each needs both.");
      if (!(std::isfinite(input.upper - input.lower) &&
            input.lower < input.upper))
        throw InputError(origin + ": The input " + quoted_name(input.name) +
                         " ranges from " + format_number(input.lower) + " to " +
                         format_number(input.upper) +
                         "; a finite range that increases is expected.");
      if (input.scale == Scale::logarithmic && input.lower <= 0.)
        throw InputError(origin + ": The input " + quoted_name(input.name) +
                         " has a logarithmic scale and starts at " +
                         format_number(input.lower) +
                         "; a positive lower end is expected.");
    }

    void
    check_names(const std::vector<LawInput> &inputs, const std::string &origin)
    {
      for (std::size_t i = 0; i < inputs.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (inputs[i].name == inputs[j].name ||
              inputs[i].symbol == inputs[j].symbol)
            throw InputError(origin + ": The inputs " +
                             quoted_name(inputs[j].name) + " and " +
                             quoted_name(inputs[i].name) +
                             " of the law have one name or symbol; different "
                             "ones are expected.");
    }

    void
    check_values(const FrictionLawDescription &description,
                 const LawData                &data,
                 const std::string            &origin)
    {
      const std::string number = ": Value number ";
      for (std::size_t j = 0; j < data.y.size(); ++j)
        {
          if (!std::isfinite(data.y[j]))
            throw InputError(origin + number + std::to_string(j + 1) + " of " +
                             quoted_name(description.output) +
                             " is not finite.");
          if (description.output_scale == Scale::logarithmic && data.y[j] <= 0.)
            throw InputError(origin + number + std::to_string(j + 1) + " of " +
                             quoted_name(description.output) + " is " +
                             format_number(data.y[j]) +
                             "; on a logarithmic scale all must be positive.");
          if (!data.known_deviation.empty() &&
              !(std::isfinite(data.known_deviation[j]) &&
                data.known_deviation[j] >= 0.))
            throw InputError(origin + ": The known deviation of value number " +
                             std::to_string(j + 1) + " of " +
                             quoted_name(description.output) +
                             " is negative or not finite.");
        }
    }

    void
    check_points(const FrictionLawDescription &description,
                 const LawData                &data,
                 const std::string            &origin)
    {
      const std::size_t d = description.inputs.size();
      for (std::size_t j = 0; j < data.y.size(); ++j)
        for (std::size_t i = 0; i < d; ++i)
          {
            const LawInput &input = description.inputs[i];
            const double    x     = data.x[j * d + i],
                         margin   = FrictionLaw::edge_tolerance *
                                  (input.upper - input.lower);
            if (!(x >= input.lower - margin && x <= input.upper + margin))
              throw InputError(origin + ": The input " +
                               quoted_name(input.name) + " of point number " +
                               std::to_string(j + 1) + " is " +
                               format_number(x) + "; its range is " +
                               format_number(input.lower) + " to " +
                               format_number(input.upper) + " (SI units).");
          }
    }
  } // namespace



  bool
  is_friction_coefficient(const std::string &output)
  {
    return output == "mu" || output == "mu_end";
  }



  FrictionLaw::FrictionLaw(const FrictionLawDescription &description,
                           const LawData                &data,
                           const std::string            &origin)
    : description_(description)
    , data_(data)
  {
    const std::size_t d = description.inputs.size(), n = data.y.size();
    if (d == 0)
      throw InputError(origin + ": The law has no input; at least one is "
                                "expected.");
    if (n > largest_number_of_runs)
      throw InputError(origin + ": There are " + std::to_string(n) +
                       " training points; at most " +
                       std::to_string(largest_number_of_runs) +
                       " are expected.");
    for (const LawInput &input : description.inputs)
      check_input(input, origin);
    check_names(description.inputs, origin);
    if (data.x.size() != n * d ||
        (!data.known_deviation.empty() && data.known_deviation.size() != n))
      throw InputError(
        origin + ": The training data have " + std::to_string(n) + " values, " +
        std::to_string(data.x.size()) + " coordinates and " +
        std::to_string(data.known_deviation.size()) +
        " known deviations; for each value " + std::to_string(d) +
        " coordinates, and one known deviation or none, are expected.");
    if (n < d + 2)
      throw InputError(origin + ": There are " + std::to_string(n) +
                       " training points; at least " + std::to_string(d + 2) +
                       " are expected for " + std::to_string(d) + " inputs.");
    check_values(description, data, origin);
    check_points(description, data, origin);

    coordinates_ = LawCoordinates(description.inputs,
                                  description.shear_limit,
                                  description.pressure_over_strength,
                                  origin);
  }



  void
  FrictionLaw::set_fitted(const PiecewisePowerLaw &law)
  {
    regression = std::make_shared<const PiecewisePowerRegression>(
      law, description_.inputs[0].upper, description_.calibration);
    coordinates_ = LawCoordinates::logarithm(description_.inputs[0]);
  }



  TrainingData
  FrictionLaw::scaled_data() const
  {
    const std::size_t d = description_.inputs.size(), n = data_.y.size();
    TrainingData      result;
    result.n_inputs = d;
    result.x        = coordinates_.transform(data_.x);
    result.y.resize(n);
    for (std::size_t j = 0; j < n; ++j)
      {
        const double y = data_.y[j];
        result.y[j] =
          (transform(description_.output_scale, y) - offset_) / factor_;
        if (!data_.known_deviation.empty())
          {
            const double slope =
              description_.output_scale == Scale::logarithmic ? 1. / y : 1.;
            const double deviation = data_.known_deviation[j] * slope / factor_;
            result.known_variance.push_back(deviation * deviation);
          }
      }
    return result;
  }



  double
  FrictionLaw::left_out_error() const
  {
    double       error    = 0.;
    const auto   left_out = process().leave_one_out();
    const double n        = static_cast<double>(data_.y.size());
    for (std::size_t j = 0; j < data_.y.size(); ++j)
      error += std::abs(unscaled(left_out[j].mean) - data_.y[j]) /
               std::max(std::abs(data_.y[j]), 1e-300);
    return error / n;
  }



  double
  FrictionLaw::unscaled(const double value) const
  {
    const double g = offset_ + factor_ * value;
    return description_.output_scale == Scale::logarithmic ? std::exp(g) : g;
  }



  LawPrediction
  FrictionLaw::predict(const double *x) const
  {
    const std::size_t   d = description_.inputs.size();
    std::vector<double> z(d);
    coordinates_.transform(x, z.data());

    LawPrediction result;
    result.gradient.resize(d);
    double       variance;
    const double value =
      regression->evaluate(z.data(), &variance, result.gradient.data());
    const bool is_logarithmic = description_.output_scale == Scale::logarithmic;
    const double of_function  = factor_ * std::sqrt(variance);
    const double noise        = regression->noise_variance();
    result.mean               = unscaled(value);
    result.deviation = is_logarithmic ? result.mean * of_function : of_function;

    const auto interval = [&](const double half, double &lower, double &upper) {
      const double m = result.mean;
      lower          = is_logarithmic ? m * std::exp(-half) : m - half;
      upper          = is_logarithmic ? m * std::exp(half) : m + half;
    };
    const double of_run        = 1.96 * factor_ * std::sqrt(variance + noise);
    const double of_topography = description_.topography_error *
                                 (is_logarithmic ? 1. : std::abs(result.mean));
    interval(of_run, result.lower, result.upper);
    interval(std::hypot(of_run, of_topography),
             result.surface_lower,
             result.surface_upper);

    // d mean / d value, times d value / d z
    const double slope = is_logarithmic ? factor_ * result.mean : factor_;
    for (double &derivative : result.gradient)
      derivative *= slope;
    coordinates_.pull_back(x, result.gradient.data());
    result.trusted =
      is_inside(x) && std::isfinite(result.mean) &&
      std::isfinite(result.deviation) &&
      result.deviation <=
        description_.largest_trusted_deviation * std::abs(result.mean);
    return result;
  }



  double
  FrictionLaw::mean(const double *x) const
  {
    double result;
    means(1, x, &result);
    return result;
  }



  void
  FrictionLaw::means(const std::size_t n, const double *x, double *result) const
  {
    const std::size_t   d = description_.inputs.size();
    std::vector<double> z(n * d);
    for (std::size_t j = 0; j < n; ++j)
      coordinates_.transform(x + j * d, &z[j * d]);
    regression->means(n, z.data(), result);
    for (std::size_t j = 0; j < n; ++j)
      result[j] = unscaled(result[j]);
  }



  bool
  FrictionLaw::is_inside(const double *x) const
  {
    bool inside = true;
    for (std::size_t i = 0; i < description_.inputs.size(); ++i)
      {
        const LawInput &input  = description_.inputs[i];
        const double    margin = edge_tolerance * (input.upper - input.lower);
        inside                 = inside && x[i] >= input.lower - margin &&
                 x[i] <= input.upper + margin;
      }
    return inside;
  }



  const FrictionLawDescription &
  FrictionLaw::description() const
  {
    return description_;
  }



  const LawData &
  FrictionLaw::data() const
  {
    return data_;
  }



  const GaussianProcess &
  FrictionLaw::process() const
  {
    const auto *const process =
      dynamic_cast<const GaussianProcess *>(regression.get());
    if (process == nullptr)
      throw InputError("The friction law was fitted to measurements; one that "
                       "was trained on runs is expected.");
    return *process;
  }



  const PiecewisePowerRegression *
  FrictionLaw::fitted() const
  {
    return dynamic_cast<const PiecewisePowerRegression *>(regression.get());
  }



  const LawCoordinates &
  FrictionLaw::coordinates() const
  {
    return coordinates_;
  }



  double
  FrictionLaw::offset() const
  {
    return offset_;
  }



  double
  FrictionLaw::factor() const
  {
    return factor_;
  }
} // namespace asperity
