#ifndef asperity_constitutive_material_parameters_h
#define asperity_constitutive_material_parameters_h

#include <asperity/constitutive/finite_strain_j2.h>

#include <memory>
#include <optional>

namespace asperity
{
  class ParameterDeclarator;

  /** The point laws there are. */
  enum class MaterialLawName
  {
    johnson_cook,         ///< FiniteStrainJ2 with Johnson-Cook flow stress
    saturation_hardening, ///< FiniteStrainJ2 with linear and Voce hardening
    hencky,
    neo_hooke,
    st_venant_kirchhoff
  };

  /**
   * A material as a parameter file describes it. Each law takes what it needs
   * from it and leaves the rest.
   */
  struct MaterialParameters
  {
    MaterialLawName               law = MaterialLawName::johnson_cook;
    ElasticParameters             elasticity;
    JohnsonCookParameters         johnson_cook;
    SaturationHardeningParameters hardening;
    HeatingParameters             heating;

    /** Declares the subsection "Material". */
    void
    declare(ParameterDeclarator &parameters);

    /** Relations between entries.
     *  @throws InputError if entries contradict each other */
    void
    check(const ParameterDeclarator &parameters) const;

    /** The temperature at which only this part of the strength is left [K]: by
     *  default the floor of the flow stress; empty if the law does not melt. */
    std::optional<double>
    softest_temperature(
      const double strength = JohnsonCook::thermal_floor) const;

    /** Whether plastic work heats the points of this material. */
    bool
    heats_itself() const;
  };

  /** @throws InputError if the parameters have no physical meaning */
  std::unique_ptr<MaterialLaw>
  make_material_law(const MaterialParameters &parameters);
} // namespace asperity

#endif
