#include <asperity/constitutive/finite_strain_j2.h>
#include <asperity/constitutive/hencky_elasticity.h>

namespace asperity
{
  std::unique_ptr<MaterialLaw>
  HenckyParameters::make_law(const ElasticParameters &elasticity,
                             const HeatingParameters &) const
  {
    HeatingParameters no_heating;
    no_heating.adiabatic = false;
    return std::make_unique<FiniteStrainJ2<NeverYields>>(name,
                                                         elasticity,
                                                         NeverYields(),
                                                         no_heating);
  }
} // namespace asperity
