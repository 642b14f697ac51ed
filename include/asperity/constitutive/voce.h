#ifndef asperity_constitutive_voce_h
#define asperity_constitutive_voce_h

#include <asperity/constitutive/flow_stress.h>
#include <asperity/constitutive/heating_parameters.h>
#include <asperity/constitutive/material_law.h>

#include <memory>

namespace asperity
{
  /** The constants of Voce's flow stress; the defaults of sigma_inf, delta and
   *  H make it perfectly plastic. */
  struct VoceParameters
  {
    static constexpr const char *name = "Voce";
    static constexpr const char *description =
      "finite-strain J2 plasticity with linear and saturating hardening, after "
      "Voce";

    double yield_stress      = 300e6; ///< sigma_0 [Pa]
    double saturation_stress = 300e6; ///< sigma_inf [Pa]
    double saturation_rate   = 0.;    ///< delta
    double linear_hardening  = 0.;    ///< H [Pa]

    /** Declares the subsection "Voce". */
    void
    declare(ParameterDeclarator &parameters);

    /** Nothing to check: the entries are free of each other. */
    void
    check(const ParameterDeclarator &) const
    {}

    /** FiniteStrainJ2 with this flow stress.
     *  @throws InputError if a constant has no physical meaning */
    std::unique_ptr<MaterialLaw>
    make_law(const ElasticParameters &elasticity,
             const HeatingParameters &heating) const;
  };

  /**
   * Isotropic hardening that saturates (Voce 1948) and a linear part, without
   * rate or temperature:
   *   sigma = sigma_0 + (sigma_inf - sigma_0) (1 - exp(-delta eps)) + H eps
   * (Simo and Armero 1992).
   */
  class Voce : public FlowStress<Voce>
  {
  public:
    /**
     * @throws InputError unless the stresses are positive and delta and H
     *   are not negative
     */
    explicit Voce(const VoceParameters &parameters);

    /** See FlowStress. */
    template <class Number>
    Number
    static_value(const Number &plastic_strain, const Number &temperature) const
    {
      return evaluate(plastic_strain, Number(), temperature).value;
    }

    /** See FlowStress. */
    template <class Number>
    BasicFlowStressValue<Number>
    evaluate(const Number &plastic_strain, const Number &, const Number &) const
    {
      const double range =
        parameters.saturation_stress - parameters.yield_stress;
      const Number decay =
        lanes::exp(-parameters.saturation_rate * plastic_strain);
      return {parameters.yield_stress +
                parameters.linear_hardening * plastic_strain +
                range * (1. - decay),
              parameters.linear_hardening +
                range * parameters.saturation_rate * decay,
              Number(),
              Number()};
    }

  private:
    VoceParameters parameters;
  };
} // namespace asperity

#endif
