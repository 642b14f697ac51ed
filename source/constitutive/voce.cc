#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/constitutive/finite_strain_j2.h>
#include <asperity/constitutive/voce.h>

namespace asperity
{
  void
  VoceParameters::declare(ParameterDeclarator &parameters)
  {
    const auto section = parameters.subsection("Voce");
    parameters.quantity("Yield stress",
                        yield_stress,
                        "MPa",
                        Range::between(1e3, 1e11),
                        "Initial flow stress sigma_0.");
    parameters.quantity(
      "Saturation stress",
      saturation_stress,
      "MPa",
      Range::between(1e3, 1e11),
      "Flow stress sigma_inf that the saturating part tends to.");
    parameters.number("Saturation rate",
                      saturation_rate,
                      Range::between(0., 1e6),
                      "Rate delta of 1 - exp(-delta eps), per plastic strain.");
    parameters.quantity("Linear hardening",
                        linear_hardening,
                        "MPa",
                        Range::between(0., 1e12),
                        "Linear hardening modulus H.");
  }



  std::unique_ptr<MaterialLaw>
  VoceParameters::make_law(const ElasticParameters &elasticity,
                           const HeatingParameters &heating) const
  {
    return std::make_unique<FiniteStrainJ2<Voce>>(name,
                                                  elasticity,
                                                  Voce(*this),
                                                  heating);
  }



  Voce::Voce(const VoceParameters &parameters)
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

} // namespace asperity
