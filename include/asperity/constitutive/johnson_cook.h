#ifndef asperity_constitutive_johnson_cook_h
#define asperity_constitutive_johnson_cook_h

#include <asperity/constitutive/flow_stress.h>
#include <asperity/constitutive/heating_parameters.h>
#include <asperity/constitutive/material_law.h>

#include <memory>

namespace asperity
{
  /**
   * The constants of the Johnson-Cook flow stress. The defaults are the steel
   * of Lee (2025), section 2.3, table 1.
   */
  struct JohnsonCookParameters
  {
    static constexpr const char *name = "Johnson-Cook";
    static constexpr const char *description =
      "finite-strain J2 plasticity whose flow stress hardens with strain and "
      "rate and softens with temperature, after Johnson and Cook";

    double A                      = 288e6;   ///< initial flow stress [Pa]
    double B                      = 695e6;   ///< hardening [Pa]
    double n                      = 0.2835;  ///< hardening exponent
    double C                      = 0.034;   ///< rate sensitivity
    double reference_rate         = 0.004;   ///< epsdot_0 [1/s]
    double m                      = 1.3558;  ///< thermal exponent
    double transition_temperature = 293.15;  ///< softening starts here [K]
    double melting_temperature    = 1773.15; ///< softening ends here [K]
    double strain_limit           = 1e6;     ///< hardening ends here

    /** Declares the subsection "Johnson-Cook". */
    void
    declare(ParameterDeclarator &parameters);

    /** @throws InputError unless melting comes after the start of softening */
    void
    check(const ParameterDeclarator &parameters) const;

    /** FiniteStrainJ2 with this flow stress.
     *  @throws InputError if a constant has no physical meaning */
    std::unique_ptr<MaterialLaw>
    make_law(const ElasticParameters &elasticity,
             const HeatingParameters &heating) const;
  };

  /**
   * The flow stress of G. R. Johnson and W. H. Cook (Proc. 7th Int. Symp. on
   * Ballistics, 1983, 541):
   *   sigma = (A + B eps^n) (1 + C ln max(1, epsdot/epsdot_0)) (1 - T*^m),
   *   T* = (T - T_transition)/(T_melt - T_transition), clamped to [0, 1].
   *
   * Departures from theirs: eps is at most the strain limit, from which on the
   * hardening factor is constant (Lee 2025, section 2.1, with 2); below the
   * reference rate the rate factor is 1 (the logarithm would be negative and
   * the stress at rest -infinity), and the thermal factor has the floor of
   * Softening.
   */
  class JohnsonCook : public FlowStress<JohnsonCook>
  {
  public:
    /** @throws InputError if a constant has no physical meaning */
    explicit JohnsonCook(const JohnsonCookParameters &parameters);

    /**
     * A + B eps^n [Pa]. The slope is infinite at 0 if n < 1, and 0 beyond the
     * strain limit; negative strain (round-off) counts as 0.
     */
    ValueAndSlope
    hardening(const double plastic_strain) const;

    /** 1 + C ln max(1, rate/reference_rate), rate in 1/s. */
    ValueAndSlope
    rate_factor(const double rate) const;

    /** The flow stress at rest [Pa]; see FlowStress. */
    double
    static_value(const double plastic_strain, const double temperature) const;

    /** The flow stress and its derivatives; see FlowStress. */
    FlowStressValue
    evaluate(const double plastic_strain,
             const double rate,
             const double temperature) const;

    /** The thermal factor; see FlowStress. */
    std::optional<Softening>
    softening() const;

  private:
    JohnsonCookParameters parameters;
    Softening             thermal;
  };



  // The functions below are inline since the return map calls them a few
  // times for each quadrature point.

  inline double
  JohnsonCook::static_value(const double plastic_strain,
                            const double temperature) const
  {
    return hardening(plastic_strain).value * thermal.factor(temperature).value;
  }



  inline FlowStressValue
  JohnsonCook::evaluate(const double plastic_strain,
                        const double rate,
                        const double temperature) const
  {
    const ValueAndSlope h = hardening(plastic_strain);
    const ValueAndSlope r = rate_factor(rate);
    const ValueAndSlope t = thermal.factor(temperature);
    return {h.value * r.value * t.value,
            h.slope * r.value * t.value,
            h.value * r.slope * t.value,
            h.value * r.value * t.slope};
  }
} // namespace asperity

#endif
