#ifndef asperity_constitutive_finite_strain_j2_h
#define asperity_constitutive_finite_strain_j2_h

#include <asperity/constitutive/heating_parameters.h>
#include <asperity/constitutive/hencky_kinematics.h>
#include <asperity/constitutive/material_law.h>
#include <asperity/constitutive/return_map.h>

#include <cmath>

namespace asperity
{
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
   *
   * @tparam Flow the flow stress, a class as FlowStress describes it
   */
  template <class Flow>
  class FiniteStrainJ2 final : public MaterialLaw
  {
  public:
    /** @throws InputError if a constant has no physical meaning */
    FiniteStrainJ2(const std::string       &name,
                   const ElasticParameters &elasticity,
                   const Flow              &flow_stress,
                   const HeatingParameters &heating);

    void
    evaluate(const dealii::Tensor<2, 3> &F,
             const MaterialState        &old,
             const double                dt,
             const bool                  with_tangent,
             MaterialResponse           &response) const override;

    std::string
    name() const override;

    double
    shear_limit(const double plastic_strain,
                const double rate,
                const double temperature) const override;

    std::optional<Softening>
    softening() const override;

  private:
    /** A returned state lies on the yield surface up to round-off, which must
     *  not count as yielding when it is evaluated again. */
    static constexpr double yield_tolerance = 1e-11;

    std::string law_name;
    Flow        flow_stress;
    double      shear_modulus;       ///< mu [Pa]
    double      bulk_modulus;        ///< K [Pa]
    double      heating_coefficient; ///< chi/(rho c_p) [K/Pa], 0 if isothermal
  };



  template <class Flow>
  FiniteStrainJ2<Flow>::FiniteStrainJ2(const std::string       &name,
                                       const ElasticParameters &elasticity,
                                       const Flow              &flow_stress,
                                       const HeatingParameters &heating)
    : MaterialLaw(elasticity)
    , law_name(name)
    , flow_stress(flow_stress)
    , shear_modulus(elasticity.shear_modulus())
    , bulk_modulus(elasticity.bulk_modulus())
    , heating_coefficient(heating.temperature_per_work(elasticity.density))
  {}



  template <class Flow>
  void
  FiniteStrainJ2<Flow>::evaluate(const dealii::Tensor<2, 3> &F,
                                 const MaterialState        &old,
                                 const double                dt,
                                 const bool                  with_tangent,
                                 MaterialResponse           &response) const
  {
    const double guess = response.state.plastic_strain - old.plastic_strain;
    const auto   t     = hencky::trial_strain(F, old.Cp_inverse);
    response.plastic   = false;
    response.state     = old;
    response.status    = t.valid ? LawStatus::ok : LawStatus::inverted;
    if (!t.valid)
      return;

    const hencky::SymmetricPlane e = hencky::deviator(t);
    // q = sqrt(3/2) |2 mu dev eps|
    const double trial_stress =
      shear_modulus * std::sqrt(6. * hencky::contract(e, e));
    double ratio   = 1.; // q/q_trial
    double slope   = 1.; // dq/dq_trial
    response.mises = trial_stress;

    const double static_flow_stress =
      flow_stress.static_value(old.plastic_strain, old.temperature);
    if (trial_stress > (1. + yield_tolerance) * static_flow_stress)
      {
        const ReturnSolution solution =
          solve_return(flow_stress,
                       ReturnProblem{trial_stress,
                                     3. * shear_modulus,
                                     old.plastic_strain,
                                     old.temperature,
                                     (dt > 0.) ? 1. / dt : 0.,
                                     heating_coefficient,
                                     guess},
                       static_flow_stress);
        if (!solution.found)
          {
            response.status = LawStatus::no_return;
            return;
          }
        ratio            = solution.stress / trial_stress;
        slope            = solution.slope;
        response.mises   = solution.stress;
        response.plastic = true;
        response.state.plastic_strain += solution.increment;
        response.state.temperature = solution.temperature;
        response.state.Cp_inverse  = hencky::updated_Cp_inverse(t, e, ratio);
      }

    hencky::fill_stress(hencky::isotropic_stress(bulk_modulus * t.trace,
                                                 2. * shear_modulus * ratio,
                                                 e),
                        t,
                        response.P);
    if (with_tangent)
      hencky::fill_tangent(
        hencky::radial_return_tangent(
          {bulk_modulus, shear_modulus}, e, trial_stress, ratio, slope),
        t,
        response.P,
        response.tangent);
  }



  template <class Flow>
  std::string
  FiniteStrainJ2<Flow>::name() const
  {
    return law_name;
  }



  template <class Flow>
  double
  FiniteStrainJ2<Flow>::shear_limit(const double plastic_strain,
                                    const double rate,
                                    const double temperature) const
  {
    return flow_stress.shear_limit(plastic_strain, rate, temperature);
  }



  template <class Flow>
  std::optional<Softening>
  FiniteStrainJ2<Flow>::softening() const
  {
    return flow_stress.softening();
  }
} // namespace asperity

#endif
