#ifndef asperity_constitutive_finite_strain_j2_h
#define asperity_constitutive_finite_strain_j2_h

#include <asperity/base/vector_widths.h>
#include <asperity/constitutive/heating_parameters.h>
#include <asperity/constitutive/hencky_kinematics.h>
#include <asperity/constitutive/material_law.h>
#include <asperity/constitutive/point_pack.h>
#include <asperity/constitutive/principal_strain.h>
#include <asperity/constitutive/return_map.h>

#include <algorithm>
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
   * Otherwise it is taken of the principal values, one point at a time.
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

    void
    evaluate_points(const unsigned int          n_points,
                    const dealii::Tensor<2, 3> *F,
                    const MaterialState        *old,
                    const double                dt,
                    const bool                  with_tangent,
                    MaterialResponse           *responses) const override;

    void
    evaluate_general(const unsigned int          n_points,
                     const dealii::Tensor<2, 3> *F,
                     const MaterialState        *old,
                     const double                dt,
                     const bool                  with_tangent,
                     MaterialResponse           *responses) const override;

    std::string
    name() const override;

    double
    shear_limit(const double plastic_strain,
                const double rate,
                const double temperature) const override;

    std::optional<PowerHardening>
    hardening_law() const override;

    std::optional<Softening>
    softening() const override;

  private:
    using Pack = lanes::Pack;

    /** Up to lanes::width points, side by side. */
    static void
    evaluate_pack(const FiniteStrainJ2       &law,
                  const unsigned int          n_points,
                  const dealii::Tensor<2, 3> *F,
                  const MaterialState        *old,
                  const double                dt,
                  const bool                  with_tangent,
                  MaterialResponse           *responses);

    /** One point of evaluate_general(). */
    void
    evaluate_principal(const dealii::Tensor<2, 3> &F,
                       const MaterialState        &old,
                       const double                dt,
                       const bool                  with_tangent,
                       MaterialResponse           &response) const;

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
    evaluate_pack(*this, 1, &F, &old, dt, with_tangent, &response);
  }



  template <class Flow>
  void
  FiniteStrainJ2<Flow>::evaluate_points(const unsigned int          n_points,
                                        const dealii::Tensor<2, 3> *F,
                                        const MaterialState        *old,
                                        const double                dt,
                                        const bool        with_tangent,
                                        MaterialResponse *responses) const
  {
    for (unsigned int q = 0; q < n_points; q += lanes::width)
      evaluate_pack(*this,
                    std::min(lanes::width, n_points - q),
                    F + q,
                    old + q,
                    dt,
                    with_tangent,
                    responses + q);
  }



  template <class Flow>
  ASPERITY_ALL_VECTOR_WIDTHS ASPERITY_INLINE_ALL void
  FiniteStrainJ2<Flow>::evaluate_pack(const FiniteStrainJ2       &law,
                                      const unsigned int          n_points,
                                      const dealii::Tensor<2, 3> *F,
                                      const MaterialState        *old,
                                      const double                dt,
                                      const bool                  with_tangent,
                                      MaterialResponse           *responses)
  {
    const PointPack points = load_points(n_points, F, old, responses);
    const auto      t      = hencky::trial_strain(points.F, points.Cp_inverse);
    const auto      e      = hencky::deviator(t);
    // q = sqrt(3/2) |2 mu dev eps|
    const Pack trial_stress =
      law.shear_modulus * lanes::sqrt(6. * hencky::contract(e, e));
    const Pack static_flow_stress =
      law.flow_stress.static_value(points.plastic_strain, points.temperature);

    PointPackResponse r;
    r.valid = t.valid;
    r.plastic =
      t.valid & (trial_stress > (1. + yield_tolerance) * static_flow_stress);
    r.found    = !r.plastic;
    r.mises    = trial_stress;
    Pack ratio = lanes::broadcast<Pack>(1.); // q/q_trial
    Pack slope = ratio;                      // dq/dq_trial
    if (lanes::any(r.plastic))
      {
        const auto solution = solve_return(
          law.flow_stress,
          ReturnProblem<Pack>{lanes::select(r.plastic, trial_stress, Pack()),
                              3. * law.shear_modulus,
                              points.plastic_strain,
                              points.temperature,
                              (dt > 0.) ? 1. / dt : 0.,
                              law.heating_coefficient,
                              points.guess},
          static_flow_stress);
        r.found = r.found | solution.found;
        r.mises = lanes::select(r.plastic, solution.stress, r.mises);
        slope   = lanes::select(r.plastic, solution.slope, slope);
        ratio   = lanes::select(r.plastic, r.mises / trial_stress, ratio);
        r.plastic_strain = points.plastic_strain + solution.increment;
        r.temperature    = solution.temperature;
        r.Cp_inverse     = hencky::updated_Cp_inverse(t, e, ratio);
      }
    const auto tau =
      hencky::isotropic_stress<Pack>(law.bulk_modulus * t.trace,
                                     2. * law.shear_modulus * ratio,
                                     e);
    r.P = hencky::nominal_stress(tau, t);
    store_points(n_points, r, old, responses);
    if (!with_tangent)
      return;
    const auto c = hencky::radial_return_tangent<Pack>(
      {law.bulk_modulus, law.shear_modulus}, e, trial_stress, ratio, slope);
    store_tangents(n_points, hencky::nominal_tangent(c, t, r.P), responses);
  }



  template <class Flow>
  void
  FiniteStrainJ2<Flow>::evaluate_general(const unsigned int          n_points,
                                         const dealii::Tensor<2, 3> *F,
                                         const MaterialState        *old,
                                         const double                dt,
                                         const bool        with_tangent,
                                         MaterialResponse *responses) const
  {
    for (unsigned int q = 0; q < n_points; ++q)
      evaluate_principal(F[q], old[q], dt, with_tangent, responses[q]);
  }



  template <class Flow>
  void
  FiniteStrainJ2<Flow>::evaluate_principal(const dealii::Tensor<2, 3> &F,
                                           const MaterialState        &old,
                                           const double                dt,
                                           const bool        with_tangent,
                                           MaterialResponse &response) const
  {
    const double guess = response.state.plastic_strain - old.plastic_strain;
    const auto   t     = hencky::principal_strain(F, old.Cp_inverse);
    response.state     = old;
    response.plastic   = false;
    response.status    = t.valid ? LawStatus::ok : LawStatus::inverted;
    if (!t.valid)
      return;

    const auto   e            = hencky::deviator(t);
    const double trial_stress = shear_modulus * std::sqrt(6. * (e * e));
    const double static_flow_stress =
      flow_stress.static_value(old.plastic_strain, old.temperature);
    response.plastic =
      trial_stress > (1. + yield_tolerance) * static_flow_stress;
    response.mises = trial_stress;
    double ratio = 1., slope = 1.; // q/q_trial and dq/dq_trial
    if (response.plastic)
      {
        const auto solution =
          solve_return(flow_stress,
                       ReturnProblem<>{trial_stress,
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
        response.mises                = solution.stress;
        response.state.plastic_strain = old.plastic_strain + solution.increment;
        response.state.temperature    = solution.temperature;
        slope                         = solution.slope;
        ratio                         = solution.stress / trial_stress;
        response.state.Cp_inverse     = hencky::updated_Cp_inverse(t, e, ratio);
      }
    dealii::Tensor<1, 3> tau = 2. * shear_modulus * ratio * e;
    for (unsigned int a = 0; a < 3; ++a)
      tau[a] += bulk_modulus * t.trace;
    response.P = hencky::nominal_stress(tau, t);
    if (with_tangent)
      response.tangent = hencky::nominal_tangent(
        hencky::radial_return_tangent(
          {bulk_modulus, shear_modulus}, e, trial_stress, ratio, slope),
        tau,
        t);
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
  std::optional<PowerHardening>
  FiniteStrainJ2<Flow>::hardening_law() const
  {
    return flow_stress.hardening_law();
  }



  template <class Flow>
  std::optional<Softening>
  FiniteStrainJ2<Flow>::softening() const
  {
    return flow_stress.softening();
  }
} // namespace asperity

#endif
