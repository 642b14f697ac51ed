#include <asperity/base/errors.h>
#include <asperity/constitutive/finite_strain_j2.h>
#include <asperity/constitutive/hencky_kinematics.h>
#include <asperity/constitutive/return_map.h>

#include <cmath>

namespace asperity
{
  using hencky::SymmetricPlane;
  using hencky::TrialStrain;

  namespace
  {
    // A returned state lies on the yield surface up to round-off, which must
    // not count as yielding when it is evaluated again.
    constexpr double yield_tolerance = 1e-11;
  } // namespace



  template <class FlowStress>
  FiniteStrainJ2<FlowStress>::FiniteStrainJ2(
    const std::string       &name,
    const ElasticParameters &elasticity,
    const FlowStress        &flow_stress,
    const HeatingParameters &heating)
    : MaterialLaw(elasticity)
    , law_name(name)
    , flow_stress(flow_stress)
    , shear_modulus(elasticity.shear_modulus())
    , bulk_modulus(elasticity.bulk_modulus())
    , heating_coefficient(0.)
  {
    if (heating.adiabatic)
      {
        if (!(heating.heat_capacity > 0.))
          throw InputError("The heat capacity must be positive, but it is " +
                           std::to_string(heating.heat_capacity) +
                           " J/(kg K).");
        if (!(heating.heat_fraction >= 0. && heating.heat_fraction <= 1.))
          throw InputError("The share of the plastic work that becomes heat "
                           "must lie between 0 and 1, but it is " +
                           std::to_string(heating.heat_fraction) + ".");
        heating_coefficient =
          heating.heat_fraction / (elasticity.density * heating.heat_capacity);
      }
  }



  template <class FlowStress>
  void
  FiniteStrainJ2<FlowStress>::evaluate(const PlaneTensor   &F,
                                       const MaterialState &old,
                                       const double         dt,
                                       const bool           with_tangent,
                                       MaterialResponse    &response) const
  {
    const TrialStrain t = hencky::trial_strain(F, old.Cp_inverse);
    response.plastic    = false;
    response.state      = old;
    response.status     = t.valid ? LawStatus::ok : LawStatus::inverted;
    if (!t.valid)
      return;

    const SymmetricPlane e = hencky::deviator(t);
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
                                     heating_coefficient},
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

    response.P = hencky::first_piola_kirchhoff(
      hencky::isotropic_stress(bulk_modulus * t.trace,
                               2. * shear_modulus * ratio,
                               e),
      t);
    if (with_tangent)
      hencky::fill_tangent(
        hencky::radial_return_tangent(
          {bulk_modulus, shear_modulus}, e, trial_stress, ratio, slope),
        t,
        response.P,
        response.tangent);
  }



  template <class FlowStress>
  std::string
  FiniteStrainJ2<FlowStress>::name() const
  {
    return law_name;
  }



  template class FiniteStrainJ2<JohnsonCook>;
  template class FiniteStrainJ2<SaturationHardening>;
  template class FiniteStrainJ2<NeverYields>;
} // namespace asperity
