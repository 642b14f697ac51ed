#include <asperity/base/errors.h>
#include <asperity/constitutive/flow_stress.h>

#include <cmath>

namespace asperity
{
  SaturationHardening::SaturationHardening(
    const SaturationHardeningParameters &parameters)
    : parameters(parameters)
  {
    if (!(parameters.yield_stress > 0. && parameters.saturation_stress > 0.))
      throw InputError("The yield stress (" +
                       std::to_string(parameters.yield_stress) +
                       " Pa) and the saturation stress (" +
                       std::to_string(parameters.saturation_stress) +
                       " Pa) of the hardening must both be positive.");
    if (!(parameters.saturation_rate >= 0. &&
          parameters.linear_hardening >= 0.))
      throw InputError("The saturation rate (" +
                       std::to_string(parameters.saturation_rate) +
                       ") and the linear hardening (" +
                       std::to_string(parameters.linear_hardening) +
                       " Pa) must not be negative.");
  }



  double
  SaturationHardening::static_value(const double plastic_strain,
                                    const double) const
  {
    return evaluate(plastic_strain, 0., 0.).value;
  }



  FlowStressValue
  SaturationHardening::evaluate(const double plastic_strain,
                                const double,
                                const double) const
  {
    const double range = parameters.saturation_stress - parameters.yield_stress;
    double       value =
      parameters.yield_stress + parameters.linear_hardening * plastic_strain;
    double slope = parameters.linear_hardening;
    if (range != 0.)
      {
        const double decay =
          std::exp(-parameters.saturation_rate * plastic_strain);
        value += range * (1. - decay);
        slope += range * parameters.saturation_rate * decay;
      }
    return {value, slope, 0., 0.};
  }
} // namespace asperity
