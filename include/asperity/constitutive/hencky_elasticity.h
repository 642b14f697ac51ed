#ifndef asperity_constitutive_hencky_elasticity_h
#define asperity_constitutive_hencky_elasticity_h

#include <asperity/constitutive/flow_stress.h>
#include <asperity/constitutive/heating_parameters.h>
#include <asperity/constitutive/material_law.h>

#include <limits>
#include <memory>

namespace asperity
{
  /** The flow stress of a body that stays elastic. */
  class NeverYields : public FlowStress<NeverYields>
  {
  public:
    /** See FlowStress. */
    template <class Number>
    Number
    static_value(const Number &, const Number &) const
    {
      return lanes::broadcast<Number>(std::numeric_limits<double>::infinity());
    }

    /** See FlowStress. */
    template <class Number>
    BasicFlowStressValue<Number>
    evaluate(const Number &, const Number &, const Number &) const
    {
      return {lanes::broadcast<Number>(std::numeric_limits<double>::infinity()),
              Number(),
              Number(),
              Number()};
    }
  };

  /** Hencky's elasticity, tau = K tr(eps) 1 + 2 mu dev(eps) with the
   * logarithmic strain eps = 1/2 ln(F F^T); it needs no further constants. */
  struct HenckyParameters
  {
    static constexpr const char *name = "Hencky";
    static constexpr const char *description =
      "elasticity, linear in the logarithmic strain";

    /** Declares nothing. */
    void
    declare(ParameterDeclarator &)
    {}

    /** Nothing to check. */
    void
    check(const ParameterDeclarator &) const
    {}

    /** FiniteStrainJ2 that never yields.
     *  @throws InputError if a constant has no physical meaning */
    std::unique_ptr<MaterialLaw>
    make_law(const ElasticParameters &elasticity,
             const HeatingParameters &heating) const;
  };
} // namespace asperity

#endif
