#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/surrogate/law_coordinates.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    double
    on_scale(const Scale scale, const double x)
    {
      return scale == Scale::logarithmic ? std::log(x) : x;
    }

    std::optional<std::size_t>
    find(const std::vector<LawInput> &inputs, const std::string &name)
    {
      for (std::size_t i = 0; i < inputs.size(); ++i)
        if (inputs[i].name == name)
          return i;
      return {};
    }

    /** Within the range of an input; NaN stays. */
    double
    clamped(const double x, const LawInput &input)
    {
      return x < input.lower ? input.lower : x > input.upper ? input.upper : x;
    }

    bool
    is_inside(const double x, const LawInput &input)
    {
      return x > input.lower && x < input.upper;
    }
  } // namespace



  std::string
  to_string(const Scale scale)
  {
    return scale == Scale::linear ? "linear" : "logarithmic";
  }



  double
  ShearLimit::operator()(const double temperature) const
  {
    if (!softens || temperature <= transition_temperature)
      return k_0;
    if (temperature >= melting_temperature)
      return 0.;
    return k_0 *
           (1. - std::pow((temperature - transition_temperature) /
                            (melting_temperature - transition_temperature),
                          exponent));
  }



  double
  ShearLimit::slope(const double temperature) const
  {
    if (!softens || temperature <= transition_temperature ||
        temperature >= melting_temperature)
      return 0.;
    const double range = melting_temperature - transition_temperature;
    return -k_0 * exponent / range *
           std::pow((temperature - transition_temperature) / range,
                    exponent - 1.);
  }



  double
  ShearLimit::hardening(const double plastic_strain) const
  {
    const auto factor = [&](const double eps) {
      return 1. + hardening_ratio *
                    std::pow(std::min(eps, strain_limit), hardening_exponent);
    };
    return factor(plastic_strain + strain_of_indentation) / factor(strain);
  }



  double
  ShearLimit::hardening_slope(const double plastic_strain) const
  {
    const double eps = plastic_strain + strain_of_indentation;
    if (eps >= strain_limit)
      return 0.;
    return hardening_ratio * hardening_exponent *
           std::pow(eps, hardening_exponent - 1.) /
           (1. + hardening_ratio * std::pow(std::min(strain, strain_limit),
                                            hardening_exponent));
  }



  LawCoordinates::LawCoordinates(const std::vector<LawInput> &inputs,
                                 const ShearLimit            &limit,
                                 const bool                   over_strength,
                                 const std::string           &origin)
    : inputs(inputs)
    , limit(limit)
  {
    std::vector<double> lowest, highest;
    for (const LawInput &input : inputs)
      {
        lowest.push_back(input.lower);
        highest.push_back(input.upper);
      }
    if (over_strength)
      {
        pressure    = find(inputs, "Load/Pressure");
        temperature = find(inputs, "Load/Temperature");
        strain      = find(inputs, "Load/Plastic strain");
        if (!pressure || !(limit.k_0 > 0.))
          throw InputError(origin +
                           ": The law is to see the pressure over the shear "
                           "strength of the chip, but " +
                           (pressure ?
                              "that is not known, since the chip stays "
                              "elastic." :
                              "Load/Pressure is none of its inputs."));
        if (temperature && !(limit(inputs[*temperature].upper) > 0.))
          throw InputError(origin +
                           ": The law is to see the pressure over the shear "
                           "strength of the chip, which has none at the upper "
                           "end of the temperature; a range that ends below "
                           "melting is expected.");
        // The strongest chip is cold and strained.
        std::vector<double> weak = lowest, strong = highest;
        if (temperature)
          std::swap(weak[*temperature], strong[*temperature]);
        double by_temperature, by_strain;
        lowest[*pressure] /= strength(strong.data(), by_temperature, by_strain);
        highest[*pressure] /= strength(weak.data(), by_temperature, by_strain);
      }
    for (std::size_t i = 0; i < inputs.size(); ++i)
      {
        start_.push_back(on_scale(inputs[i].scale, lowest[i]));
        extent_.push_back(on_scale(inputs[i].scale, highest[i]) - start_[i]);
      }
  }



  LawCoordinates
  LawCoordinates::logarithm(const LawInput &input)
  {
    LawCoordinates result;
    result.inputs  = {input};
    result.start_  = {0.};
    result.extent_ = {1.};
    return result;
  }



  double
  LawCoordinates::strength(const double *x,
                           double       &by_temperature,
                           double       &by_strain) const
  {
    double k       = limit.k_0;
    by_temperature = by_strain = 0.;
    if (temperature)
      {
        const LawInput &input = inputs[*temperature];
        const double    T     = clamped(x[*temperature], input);
        k                     = limit(T);
        if (is_inside(x[*temperature], input))
          by_temperature = limit.slope(T) / k;
      }
    if (strain)
      {
        const LawInput &input = inputs[*strain];
        const double    eps   = clamped(x[*strain], input);
        const double    h     = limit.hardening(eps);
        k *= h;
        if (is_inside(x[*strain], input))
          by_strain = limit.hardening_slope(eps) / h;
      }
    return k;
  }



  void
  LawCoordinates::transform(const double *x, double *z) const
  {
    for (std::size_t i = 0; i < inputs.size(); ++i)
      {
        const bool is_logarithmic = inputs[i].scale == Scale::logarithmic;
        double     q = is_logarithmic && x[i] <= 0. ? inputs[i].lower : x[i];
        double     by_temperature, by_strain;
        if (i == pressure)
          q /= strength(x, by_temperature, by_strain);
        z[i] = (on_scale(inputs[i].scale, q) - start_[i]) / extent_[i];
      }
  }



  std::vector<double>
  LawCoordinates::transform(const std::vector<double> &x) const
  {
    std::vector<double> z(x.size());
    for (std::size_t j = 0; j < x.size(); j += inputs.size())
      transform(&x[j], &z[j]);
    return z;
  }



  // With q = p / k: dz_p/dp = dz_p/dq / k, and dz_p/dT = -dz_p/dq q (dk/dT)/k.
  void
  LawCoordinates::pull_back(const double *x, double *gradient) const
  {
    for (std::size_t i = 0; i < inputs.size(); ++i)
      gradient[i] /= extent_[i];
    const double by_pressure = pressure ? gradient[*pressure] : 0.;
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (inputs[i].scale == Scale::logarithmic)
        gradient[i] = x[i] > 0. ? gradient[i] / x[i] : 0.;
    if (by_pressure == 0.) // q may be infinite then
      return;

    double       by_temperature, by_strain;
    const double k         = strength(x, by_temperature, by_strain);
    const bool   is_linear = inputs[*pressure].scale == Scale::linear;
    const double by_k =
      is_linear ? -by_pressure * x[*pressure] / k : -by_pressure;
    if (is_linear)
      gradient[*pressure] /= k;
    if (temperature)
      gradient[*temperature] += by_k * by_temperature;
    if (strain)
      gradient[*strain] += by_k * by_strain;
  }



  double
  LawCoordinates::start(const std::size_t i) const
  {
    return start_[i];
  }



  double
  LawCoordinates::extent(const std::size_t i) const
  {
    return extent_[i];
  }
} // namespace asperity
