#include <gtest/gtest.h>

#include "law_tools.h"

using namespace asperity;
using namespace asperity::law_tools;

namespace
{
  constexpr double E  = 205e9;
  constexpr double nu = 0.29;
  constexpr double mu = E / (2. * (1. + nu));

  std::unique_ptr<MaterialLaw>
  linear_hardening(const double sigma_0, const double H)
  {
    MaterialParameters p;
    p.choose(VoceParameters{sigma_0, sigma_0, 0., H});
    p.heating.adiabatic = false;
    return p.make_law();
  }



  std::unique_ptr<MaterialLaw>
  isothermal_johnson_cook()
  {
    MaterialParameters p;
    p.heating.adiabatic = false;
    return p.make_law();
  }



  /** The lateral stretch that leaves axial stress alone (axisymmetric). */
  MaterialResponse
  uniaxial_stress(const MaterialLaw   &law,
                  const double         axial_stretch,
                  const MaterialState &old,
                  const double         dt)
  {
    double           lateral = std::pow(axial_stretch, -0.4);
    MaterialResponse r;
    for (int i = 0; i < 50; ++i)
      {
        r = evaluate(law,
                     plane(axial_stretch, 0., 0., lateral, lateral),
                     old,
                     dt);
        // both lateral directions move together
        const double slope = r.tangent[1][1][1][1] + r.tangent[1][1][2][2];
        lateral -= r.P[1][1] / slope;
      }
    EXPECT_NEAR(r.P[1][1], 0., 1.);
    EXPECT_NEAR(r.P[2][2], 0., 1.);
    return r;
  }



  /** The root of an increasing function. */
  double
  bisect(const std::function<double(double)> &f, double lower, double upper)
  {
    for (int i = 0; i < 200; ++i)
      {
        const double middle              = 0.5 * (lower + upper);
        (f(middle) < 0. ? lower : upper) = middle;
      }
    return lower;
  }
} // namespace



TEST(Voce, starts_at_the_yield_stress_and_tends_to_its_asymptote)
{
  // the steel of Simo and Armero (1992), in GPa there
  const Voce flow({0.45e9, 0.715e9, 16.93, 0.12924e9});
  EXPECT_DOUBLE_EQ(flow.static_value(0., 300.), 0.45e9);
  EXPECT_NEAR(flow.evaluate(0., 1., 300.).d_strain,
              16.93 * 0.265e9 + 0.12924e9,
              1.);
  EXPECT_NEAR(flow.static_value(10., 300.), 0.715e9 + 10. * 0.12924e9, 1.);
  const auto by_strain = [&](const double h) {
    return flow.static_value(0.05 + h, 300.);
  };
  EXPECT_NEAR(derivative_at_zero(by_strain, 1e-3),
              flow.evaluate(0.05, 1., 300.).d_strain,
              1.);
}



TEST(UniaxialStress, linear_hardening_follows_the_closed_form)
{
  const double sigma_0 = 300e6, H = 2e9;
  const auto   law = linear_hardening(sigma_0, H);
  for (const int direction : {1, -1})
    {
      MaterialState state;
      for (int step = 1; step <= 40; ++step)
        {
          const double           strain = direction * 0.01 * step;
          const MaterialResponse r =
            uniaxial_stress(*law, std::exp(strain), state, 1.);
          // E (|strain| - p) = sigma_0 + H p
          const double p = (E * std::abs(strain) - sigma_0) / (E + H);
          EXPECT_TRUE(r.plastic);
          EXPECT_NEAR(r.state.plastic_strain, p, 1e-12);
          EXPECT_NEAR(r.P[0][0] * std::exp(strain),
                      direction * (sigma_0 + H * p),
                      1e-9 * sigma_0);
          state = r.state;
        }
    }
}



TEST(UniaxialStress, johnson_cook_follows_the_scalar_equation)
{
  const auto        law = isothermal_johnson_cook();
  const JohnsonCook flow{JohnsonCookParameters()};
  MaterialState     state;
  state.temperature         = 500.;
  const double rate         = 1e4;
  double       plastic      = 0.;
  const double step         = 0.01;
  double       total_strain = 0.;
  for (int i = 0; i < 50; ++i)
    {
      total_strain += step;
      const double dt = step / rate;
      // implicit Euler for E (strain - p) = sigma(p, p'), by bisection
      const double old_plastic = plastic;
      plastic                  = bisect(
        [&](const double p) {
          return flow.evaluate(p, (p - old_plastic) / dt, 500.).value -
                 E * (total_strain - p);
        },
        old_plastic + 1e-12,
        total_strain);
      const MaterialResponse r =
        uniaxial_stress(*law, std::exp(total_strain), state, dt);
      EXPECT_NEAR(r.state.plastic_strain, plastic, 1e-11);
      EXPECT_NEAR(r.mises / (E * (total_strain - plastic)), 1., 1e-8);
      state = r.state;
    }
}



TEST(PureShear, plastic_stretch_is_independent_of_the_number_of_steps)
{
  const double sigma_0 = 300e6, H = 2e9;
  const auto   law    = linear_hardening(sigma_0, H);
  const double strain = 0.5;
  // 3 mu (strain - p) = sigma_0 + H p
  const double p = (3. * mu * strain - sigma_0) / (3. * mu + H);
  for (const int n_steps : {1, 7, 100})
    {
      MaterialResponse r;
      for (int step = 1; step <= n_steps; ++step)
        r = evaluate(*law,
                     isochoric_stretch(strain * step / n_steps),
                     r.state,
                     1.);
      EXPECT_NEAR(r.state.plastic_strain, p, 1e-12);
      EXPECT_NEAR(r.mises, sigma_0 + H * p, 1e-9 * sigma_0);
      // tau_11 = -tau_22 = q/sqrt 3, tau_33 = 0
      const double k = 0.5 * std::sqrt(3.) * strain;
      EXPECT_NEAR(r.P[0][0] * std::exp(k), r.mises / std::sqrt(3.), 1.);
      EXPECT_NEAR(r.P[1][1] * std::exp(-k), -r.mises / std::sqrt(3.), 1.);
      EXPECT_NEAR(r.P[2][2], 0., 1.);
    }
}



TEST(PureShear, unloading_is_elastic_and_reverse_yield_is_symmetric)
{
  const double           sigma_0 = 300e6, H = 2e9;
  const auto             law    = linear_hardening(sigma_0, H);
  const double           strain = 0.1;
  const MaterialResponse r      = evaluate(*law, isochoric_stretch(strain));
  // isotropic hardening: the elastic range is twice the flow stress
  const double range = 2. * r.mises / (3. * mu);
  EXPECT_FALSE(
    evaluate(*law, isochoric_stretch(strain - 0.999 * range), r.state).plastic);
  EXPECT_TRUE(
    evaluate(*law, isochoric_stretch(strain - 1.001 * range), r.state).plastic);
  EXPECT_NEAR(
    evaluate(*law, isochoric_stretch(strain - 0.5 * range), r.state).mises,
    0.,
    1e-6 * r.mises);
}



TEST(SimpleShear, hencky_elasticity_follows_the_closed_form_without_oscillation)
{
  MaterialParameters parameters;
  parameters.choose(HenckyParameters());
  const auto law       = parameters.make_law();
  double     old_axial = 0.;
  int        n_turns   = 0;
  double     old_shear = 0., old_change = 1.;
  for (int step = 1; step <= 1000; ++step)
    {
      const double           gamma = 0.02 * step;
      const MaterialResponse r = evaluate(*law, plane(1., gamma, 0., 1., 1.));
      const double           tau_11 = r.P[0][0] + r.P[0][1] * gamma;
      const double           tau_12 = r.P[0][1];
      // tau = 2 mu ln V: ln of the stretch is asinh(gamma/2), its direction
      // theta from tan(2 theta) = 2/gamma
      const double principal = 2. * mu * std::asinh(0.5 * gamma);
      const double length    = std::sqrt(4. + gamma * gamma);
      EXPECT_NEAR(tau_12, principal * 2. / length, 1e-11 * E);
      EXPECT_NEAR(tau_11, principal * gamma / length, 1e-11 * E);
      // The Jaumann rate would give mu sin(gamma) and mu (1 - cos(gamma)).
      EXPECT_GT(tau_12, 0.);
      EXPECT_GT(tau_11, old_axial);
      const double change = tau_12 - old_shear;
      n_turns += (change * old_change < 0.);
      old_axial  = tau_11;
      old_shear  = tau_12;
      old_change = change;
    }
  EXPECT_LE(n_turns, 1);
}



TEST(SimpleShear, perfect_plasticity_tends_to_its_shear_yield_stress)
{
  const double     sigma_0 = 300e6;
  const auto       law     = linear_hardening(sigma_0, 0.);
  MaterialResponse r;
  for (int step = 1; step <= 2000; ++step)
    r = evaluate(*law, plane(1., 0.001 * step, 0., 1., 1.), r.state, 1.);
  // elastic strain is of the order of sigma_0/E, so are the axial stresses
  EXPECT_NEAR(r.P[0][1] / (sigma_0 / std::sqrt(3.)), 1., 1e-4);
  EXPECT_NEAR(r.state.plastic_strain,
              2. / std::sqrt(3.) - sigma_0 / (3. * mu),
              1e-4);
}



TEST(NeoHooke, uniaxial_strain_follows_the_closed_form)
{
  MaterialParameters parameters;
  parameters.choose(NeoHookeParameters());
  const auto   law    = parameters.make_law();
  const double lambda = E * nu / ((1. + nu) * (1. - 2. * nu));
  for (const double s : {0.3, 0.9, 1., 1.5, 4.})
    EXPECT_NEAR(evaluate(*law, plane(s, 0., 0., 1., 1.)).P[0][0],
                mu * (s - 1. / s) + lambda * std::log(s) / s,
                1e-13 * E);
}



TEST(StVenantKirchhoff, uniaxial_strain_follows_the_closed_form)
{
  MaterialParameters parameters;
  parameters.choose(StVenantKirchhoffParameters());
  const auto   law    = parameters.make_law();
  const double lambda = E * nu / ((1. + nu) * (1. - 2. * nu));
  for (const double s : {0.6, 0.9, 1., 1.5})
    EXPECT_NEAR(evaluate(*law, plane(1., 0., 0., s, 1.)).P[1][1],
                s * (lambda + 2. * mu) * 0.5 * (s * s - 1.),
                1e-13 * E);
}
