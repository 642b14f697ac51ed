#include <asperity/base/errors.h>
#include <asperity/constitutive/johnson_cook.h>

#include <cmath>

namespace asperity
{
  JohnsonCook::JohnsonCook(const JohnsonCookParameters &parameters)
    : parameters(parameters)
    , inverse_temperature_range(1. / (parameters.melting_temperature -
                                      parameters.transition_temperature))
  {
    const auto require =
      [](const bool condition, const std::string &what, const double found) {
        if (!condition)
          throw InputError("The Johnson-Cook constant " + what +
                           ", but it is " + std::to_string(found) + ".");
      };
    require(parameters.A > 0., "A must be positive", parameters.A);
    require(parameters.B >= 0., "B must not be negative", parameters.B);
    require(parameters.n > 0., "n must be positive", parameters.n);
    require(parameters.C >= 0., "C must not be negative", parameters.C);
    require(parameters.m > 0., "m must be positive", parameters.m);
    require(parameters.reference_rate > 0.,
            "reference rate must be positive",
            parameters.reference_rate);
    require(parameters.melting_temperature > parameters.transition_temperature,
            "melting temperature must lie above the transition temperature (" +
              std::to_string(parameters.transition_temperature) + " K)",
            parameters.melting_temperature);
  }



  ValueAndSlope
  JohnsonCook::hardening(const double plastic_strain) const
  {
    if (plastic_strain <= 0.)
      return {parameters.A,
              parameters.B == 0. ? 0. :
                                   std::numeric_limits<double>::infinity()};
    const double power = parameters.B * std::pow(plastic_strain, parameters.n);
    return {parameters.A + power, parameters.n * power / plastic_strain};
  }



  ValueAndSlope
  JohnsonCook::rate_factor(const double rate) const
  {
    if (rate <= parameters.reference_rate)
      return {1., 0.};
    return {1. + parameters.C * std::log(rate / parameters.reference_rate),
            parameters.C / rate};
  }



  ValueAndSlope
  JohnsonCook::thermal_factor(const double temperature) const
  {
    const double homologous =
      (temperature - parameters.transition_temperature) *
      inverse_temperature_range;
    if (homologous <= 0.)
      return {1., 0.};
    if (homologous >= 1.)
      return {thermal_floor, 0.};
    const double power = std::pow(homologous, parameters.m);
    if (1. - power <= thermal_floor)
      return {thermal_floor, 0.};
    return {1. - power,
            -parameters.m * power / homologous * inverse_temperature_range};
  }
} // namespace asperity
