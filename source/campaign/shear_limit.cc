#include "shear_limit.h"

#include <cmath>

namespace asperity
{
  ShearLimit
  shear_limit_of(const MaterialParameters &material, const LawParameters &law)
  {
    const auto &constants = material.constants<JohnsonCookParameters>();
    const auto  chip      = material.make_law();
    ShearLimit  limit;
    limit.strain = law.shear_strain;
    limit.rate   = law.shear_rate;
    // A law without a melting point does not know the temperature.
    limit.softens  = material.softest_temperature().has_value();
    const double k = chip->shear_limit(limit.strain,
                                       limit.rate,
                                       constants.transition_temperature);
    if (!std::isfinite(k))
      return {}; // elastic
    limit.k_0 = k;
    if (limit.softens)
      {
        limit.exponent               = constants.m;
        limit.transition_temperature = constants.transition_temperature;
        limit.melting_temperature    = constants.melting_temperature;
      }
    return limit;
  }
} // namespace asperity
