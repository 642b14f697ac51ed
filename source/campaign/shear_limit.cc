#include "shear_limit.h"

#include <cmath>

namespace asperity
{
  ShearLimit
  shear_limit_of(const MaterialParameters &material, const LawParameters &law)
  {
    const auto chip      = material.make_law();
    const auto softening = chip->softening();
    // Without softening the temperature does not matter.
    const Softening thermal = softening.value_or(Softening{1., 0., 0.});
    ShearLimit      limit;
    limit.strain = law.shear_strain;
    limit.rate   = law.shear_rate;
    limit.k_0    = chip->shear_limit(limit.strain,
                                  limit.rate,
                                  thermal.transition_temperature);
    if (!std::isfinite(limit.k_0))
      return {}; // elastic
    limit.softens                = softening.has_value();
    limit.exponent               = thermal.exponent;
    limit.transition_temperature = thermal.transition_temperature;
    limit.melting_temperature    = thermal.melting_temperature;
    if (const auto hardening = chip->hardening_law())
      {
        limit.hardening_ratio    = hardening->ratio;
        limit.hardening_exponent = hardening->exponent;
        limit.strain_limit       = hardening->limit;
      }
    return limit;
  }
} // namespace asperity
