#include "shear_limit.h"

#include <cmath>

namespace asperity
{
  ShearLimit
  shear_limit_of(const MaterialParameters &material, const LawParameters &law)
  {
    ShearLimit limit;
    limit.strain = law.shear_strain;
    limit.rate   = law.shear_rate;
    if (material.law == MaterialLawName::johnson_cook)
      {
        const JohnsonCookParameters &constants = material.johnson_cook;
        const JohnsonCook            flow_stress(constants);
        limit.k_0 = flow_stress.hardening(limit.strain).value *
                    flow_stress.rate_factor(limit.rate).value / std::sqrt(3.);
        limit.exponent               = constants.m;
        limit.transition_temperature = constants.transition_temperature;
        limit.melting_temperature    = constants.melting_temperature;
      }
    else if (material.law == MaterialLawName::saturation_hardening)
      {
        const SaturationHardening flow_stress(material.hardening);
        limit.k_0 = flow_stress.evaluate(limit.strain, limit.rate, 0.).value /
                    std::sqrt(3.);
        limit.softens = false;
      }
    return limit;
  }
} // namespace asperity
