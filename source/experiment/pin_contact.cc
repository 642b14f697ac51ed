#include <asperity/experiment/pin_contact.h>

#include <boost/math/constants/constants.hpp>

#include <cmath>

namespace asperity
{
  PinConditions
  conditions_of(const PinContact &pin)
  {
    constexpr double pi = boost::math::constants::pi<double>();
    PinConditions    result;
    if (pin.end == PinEnd::flat)
      result.radius = pin.radius;
    else
      {
        const double compliance =
          (1. - pin.chip_poisson * pin.chip_poisson) / pin.chip_modulus +
          (1. - pin.tool_poisson * pin.tool_poisson) / pin.tool_modulus;
        result.radius =
          std::cbrt(0.75 * pin.normal_force * pin.radius * compliance);
      }
    result.mean_pressure =
      pin.normal_force / (pi * result.radius * result.radius);
    if (pin.end == PinEnd::ball && result.mean_pressure > pin.hardness)
      {
        result.is_plastic    = true;
        result.mean_pressure = pin.hardness;
        result.radius = std::sqrt((pin.is_open ? 2. : 1.) * pin.normal_force /
                                  (pi * pin.hardness));
      }
    const double of_chip = moving_circle(pin.chip, result.radius, pin.velocity);
    const double of_tool = moving_circle(pin.tool, result.radius, 0.);
    result.heat_to_chip  = of_tool / (of_chip + of_tool);
    result.temperature   = pin.temperature + result.heat_to_chip * of_chip *
                                             pin.mu * result.mean_pressure *
                                             pin.velocity;
    return result;
  }
} // namespace asperity
