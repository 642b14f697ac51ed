#ifndef asperity_constitutive_johnson_cook_h
#define asperity_constitutive_johnson_cook_h

#include <asperity/constitutive/flow_stress.h>
#include <asperity/constitutive/heating_parameters.h>
#include <asperity/constitutive/material_law.h>

#include <limits>
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
    template <class Number>
    BasicValueAndSlope<Number>
    hardening(const Number &plastic_strain) const;

    /** 1 + C ln max(1, rate/reference_rate), rate in 1/s. */
    template <class Number>
    BasicValueAndSlope<Number>
    rate_factor(const Number &rate) const;

    /** The flow stress at rest [Pa]; see FlowStress. */
    template <class Number>
    Number
    static_value(const Number &plastic_strain, const Number &temperature) const;

    /** The flow stress and its derivatives; see FlowStress. */
    template <class Number>
    BasicFlowStressValue<Number>
    evaluate(const Number &plastic_strain,
             const Number &rate,
             const Number &temperature) const;

    /** See FlowStress. */
    std::optional<PowerHardening>
    hardening_law() const;

    /** The thermal factor; see FlowStress. */
    std::optional<Softening>
    softening() const;

  private:
    JohnsonCookParameters parameters;
    Softening             thermal;
  };



  template <class Number>
  BasicValueAndSlope<Number>
  JohnsonCook::hardening(const Number &plastic_strain) const
  {
    const JohnsonCookParameters &p     = parameters;
    const auto                   begun = plastic_strain > 0.;
    const auto                   ended = plastic_strain > p.strain_limit;
    const Number                 limit = Number() + p.strain_limit;
    const Number                 strain =
      lanes::select(begun, lanes::select(ended, limit, plastic_strain), limit);
    const Number power         = p.B * lanes::pow(strain, p.n);
    const Number initial_slope = lanes::broadcast<Number>(
      p.B == 0. ? 0. : std::numeric_limits<double>::infinity());
    return {p.A + lanes::select(begun, power, Number()),
            lanes::select(begun,
                          lanes::select(ended, Number(), p.n * power / strain),
                          initial_slope)};
  }



  template <class Number>
  BasicValueAndSlope<Number>
  JohnsonCook::rate_factor(const Number &rate) const
  {
    const auto   fast     = rate > parameters.reference_rate;
    const Number slowest  = Number() + parameters.reference_rate;
    const Number relevant = lanes::select(fast, rate, slowest);
    return {1. + parameters.C * lanes::log(relevant / slowest),
            lanes::select(fast, parameters.C / relevant, Number())};
  }



  template <class Number>
  Number
  JohnsonCook::static_value(const Number &plastic_strain,
                            const Number &temperature) const
  {
    return hardening(plastic_strain).value * thermal.factor(temperature).value;
  }



  template <class Number>
  BasicFlowStressValue<Number>
  JohnsonCook::evaluate(const Number &plastic_strain,
                        const Number &rate,
                        const Number &temperature) const
  {
    const BasicValueAndSlope<Number> h = hardening(plastic_strain);
    const BasicValueAndSlope<Number> r = rate_factor(rate);
    const BasicValueAndSlope<Number> t = thermal.factor(temperature);
    return {h.value * r.value * t.value,
            h.slope * r.value * t.value,
            h.value * r.slope * t.value,
            h.value * r.value * t.slope};
  }
} // namespace asperity

#endif
