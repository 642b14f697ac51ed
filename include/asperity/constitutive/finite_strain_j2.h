#ifndef asperity_constitutive_finite_strain_j2_h
#define asperity_constitutive_finite_strain_j2_h

#include <asperity/constitutive/flow_stress.h>
#include <asperity/constitutive/johnson_cook.h>
#include <asperity/constitutive/material_law.h>

namespace asperity
{
  /** How plastic work heats the point. */
  struct HeatingParameters
  {
    bool   adiabatic     = true; ///< false: the temperature stays
    double heat_capacity = 450.; ///< c_p [J/(kg K)]
    double heat_fraction = 0.9;  ///< share of the plastic work that heats
  };

  /**
   * Finite-strain J2 plasticity with multiplicative split F = F_e F_p,
   * isotropic hardening, logarithmic (Hencky) elasticity and the exponential
   * return of J. C. Simo (Comput. Methods Appl. Mech. Eng. 99 (1992) 61).
   *
   * With b = F C_p^{-1} F^T of the trial state and eps = 1/2 ln b,
   *   tau = K tr(eps) 1 + 2 mu dev(eps) - 2 mu dgamma sqrt(3/2) n,
   *   q = sqrt(3/2) |dev tau| = sigma(eps_p + dgamma, dgamma/dt, T),
   *   T = T_n + chi q dgamma/(rho c_p),
   * all at the end of the step (implicit Euler), dgamma being the increment
   * of the equivalent plastic strain. The flow stress sigma is compared with
   * the equivalent *Kirchhoff* stress q. Plastic work and density are both
   * per reference volume. The elastic constants do not depend on temperature
   * and there is no thermal expansion.
   *
   * Since q = q_trial - 3 mu dgamma, the temperature is an explicit function
   * of dgamma, and one scalar equation remains. It always has a root in
   * (0, q_trial/(3 mu)), found by a Newton method in ln(dgamma) within a
   * bracket; see return_map.h.
   *
   * In plane kinematics ln b has a closed form without eigenvectors, which
   * is analytic where the in-plane stretches coincide; so is the tangent.
   *
   * A step of length dt <= 0 counts as infinitely slow: no rate effect.
   */
  template <class FlowStress>
  class FiniteStrainJ2 final : public MaterialLaw
  {
  public:
    /** @throws InputError if a constant has no physical meaning */
    FiniteStrainJ2(const std::string       &name,
                   const ElasticParameters &elasticity,
                   const FlowStress        &flow_stress,
                   const HeatingParameters &heating);

    void
    evaluate(const PlaneTensor   &F,
             const MaterialState &old,
             const double         dt,
             const bool           with_tangent,
             MaterialResponse    &response) const override;

    std::string
    name() const override;

  private:
    std::string law_name;
    FlowStress  flow_stress;
    double      shear_modulus;
    double      bulk_modulus;
    /** chi/(rho c_p) [K/Pa], 0 if isothermal. */
    double heating_coefficient;
  };

  /** Johnson-Cook steel. */
  using JohnsonCookJ2 = FiniteStrainJ2<JohnsonCook>;

  /** Linear and saturating hardening; perfect plasticity. */
  using SaturationJ2 = FiniteStrainJ2<SaturationHardening>;

  /** Hencky's elasticity. */
  using HenckyElastic = FiniteStrainJ2<NeverYields>;
} // namespace asperity

#endif
