#include "piston.h"

#include <asperity/base/errors.h>

#include <gtest/gtest.h>

using namespace piston;

namespace
{
  /** Impedances given, the solid without spring, step 1 s. */
  void
  set_impedances(Piston      &solid,
                 Chamber     &fluid,
                 const double Z_s,
                 const double Z_f)
  {
    solid.mass   = Z_s;
    solid.spring = 0.;
    fluid.leak   = 1. / Z_f;
  }

  CouplingParameters
  plain_iteration()
  {
    CouplingParameters parameters;
    parameters.acceleration.kind  = AccelerationKind::relaxation;
    parameters.tolerance          = 1e-14;
    parameters.maximum_iterations = 8;
    return parameters;
  }

  /** Ratio of successive residuals of the force in the last step, that of the
   *  first pair, which has least of round-off. */
  double
  measured_contraction(const Chamber &fluid)
  {
    return std::abs(fluid.outputs[1] - fluid.inputs[1]) /
           std::abs(fluid.outputs[0] - fluid.inputs[0]);
  }
} // namespace



TEST(Piston, robin_neumann_contracts_as_the_formula_says)
{
  // q = Z_f |Z_s - alpha| / (Z_s (Z_f + alpha))
  const double Z_s = 1.;
  for (const double Z_f : {0.1, 1., 10., 1e3, infinity})
    for (const double alpha : {1e-3, 1e-2, .1, .5, .9, 1.5, 2.1, 10., 1e3})
      {
        Piston  solid;
        Chamber fluid;
        set_impedances(solid, fluid, Z_s, Z_f);
        solid.drive                   = [](double) { return 1.; };
        CouplingParameters parameters = plain_iteration();
        parameters.robin_coefficient  = alpha;
        PartitionedStep step(solid, fluid, parameters);
        step.advance(1.);
        const double q = std::isfinite(Z_f) ?
                           Z_f * std::abs(Z_s - alpha) / (Z_s * (Z_f + alpha)) :
                           std::abs(1. - alpha / Z_s);
        EXPECT_NEAR(measured_contraction(fluid) / q, 1., 1e-6)
          << "alpha " << alpha << ", Z_f " << Z_f;
      }
}



TEST(Piston, robin_neumann_with_the_solids_impedance_is_exact_at_once)
{
  for (const double Z_f : {0.1, 10., infinity})
    {
      Piston  solid;
      Chamber fluid;
      set_impedances(solid, fluid, 3., Z_f);
      solid.drive = [](double) { return 1.; };
      PartitionedStep         step(solid, fluid, plain_iteration());
      const ConvergenceReport report = step.advance(1.);
      EXPECT_TRUE(report.converged) << report.reason;
      EXPECT_LE(report.iterations, 2u);
      EXPECT_DOUBLE_EQ(step.robin_coefficient(), 3.);
    }
}



TEST(Piston, dirichlet_neumann_contracts_by_the_ratio_of_impedances)
{
  for (const double Z_f : {0.01, 0.1, 0.9, 1.1, 10., 1e3})
    {
      Piston  solid;
      Chamber fluid;
      set_impedances(solid, fluid, 1., Z_f);
      solid.drive                   = [](double) { return 1.; };
      CouplingParameters parameters = plain_iteration();
      parameters.scheme             = CouplingScheme::dirichlet_neumann;
      parameters.maximum_iterations = 1000;
      parameters.tolerance          = 1e-10;
      PartitionedStep         step(solid, fluid, parameters);
      const ConvergenceReport report = step.advance(1.);
      EXPECT_NEAR(measured_contraction(fluid) / Z_f, 1., 1e-6);
      EXPECT_EQ(report.converged, Z_f < 1.) << Z_f;
    }
}



TEST(Piston, dirichlet_neumann_on_a_sealed_pocket_is_refused)
{
  Piston             solid;
  Chamber            fluid;
  CouplingParameters parameters;
  parameters.scheme = CouplingScheme::dirichlet_neumann;
  try
    {
      PartitionedStep step(solid, fluid, parameters);
      FAIL() << "no exception";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("choose Robin-Neumann"),
                std::string::npos);
    }
}



TEST(Piston, sealed_pocket_carries_the_whole_load_and_does_not_move)
{
  Piston  solid;
  Chamber fluid;
  solid.drive = [](const double t) { return std::sin(t); };
  CouplingParameters parameters;
  parameters.tolerance = 1e-9;
  PartitionedStep step(solid, fluid, parameters);
  for (unsigned int i = 1; i <= 20; ++i)
    {
      const ConvergenceReport report = step.advance(0.3);
      ASSERT_TRUE(report.converged) << report.reason;
      EXPECT_NEAR(fluid.p, std::sin(0.3 * i), 1e-8);
      EXPECT_NEAR(step.displacement()(0), 0., 1e-8);
    }
}



TEST(Piston, compressible_pocket_is_a_spring)
{
  // With K/V in series, m d'' + k d = f - A^2 K/V d by implicit Euler, in
  // closed form step by step.
  Piston  solid;
  Chamber fluid;
  solid.mass       = 0.7;
  solid.spring     = 2.;
  fluid.area       = 1.5;
  fluid.elasticity = 0.25;
  solid.drive      = [](double) { return 1.; };
  CouplingParameters parameters;
  parameters.tolerance = 1e-11;
  PartitionedStep step(solid, fluid, parameters);
  const double    dt = 0.1, k = 2. + 1.5 * 1.5 / 0.25;
  double          d = 0., v = 0.;
  for (unsigned int i = 0; i < 30; ++i)
    {
      const double v_new = (0.7 * v / dt + 1. - k * d) / (0.7 / dt + k * dt);
      d += dt * v_new;
      v = v_new;
      ASSERT_TRUE(step.advance(dt).converged);
      EXPECT_NEAR(step.displacement()(0), d, 1e-9);
    }
}



TEST(Piston, tunes_itself_without_a_number)
{
  // Five iterations a step at most, over eight orders of mass and six of
  // stiffness, with linear springs and with such that the static deflection
  // makes four times as stiff.
  CouplingParameters parameters;
  parameters.tolerance      = 1e-6;
  unsigned int n_iterations = 0, n_steps = 0;
  for (const double mass : {1e-4, 1., 1e4})
    for (const double spring : {1e-2, 1., 1e4})
      for (const double hardening : {0., 1.})
        for (const double dt : {1e-4, 1e-2, 1.})
          for (const double Z_ratio : {0.1, 1., 1e3, infinity})
            {
              Piston  solid;
              Chamber fluid;
              solid.mass   = mass;
              solid.spring = spring;
              solid.cubic  = hardening * spring * spring * spring;
              fluid.leak   = 1. / (Z_ratio * solid.impedance(dt));
              solid.drive  = [&](const double t) {
                return std::sin(0.2 * t / dt);
              };
              PartitionedStep step(solid, fluid, parameters);
              for (unsigned int i = 0; i < 10; ++i)
                {
                  const ConvergenceReport report = step.advance(dt);
                  EXPECT_TRUE(report.converged) << report.reason;
                  EXPECT_LE(report.iterations, 5u)
                    << "m " << mass << ", k " << spring << ", hardening "
                    << hardening << ", dt " << dt << ", Z_f/Z_s " << Z_ratio
                    << ", step " << i;
                  n_iterations += report.iterations;
                  ++n_steps;
                }
            }
  EXPECT_LT(double(n_iterations) / n_steps, 4.);
}



TEST(Piston, without_a_tangent_secants_take_over)
{
  struct BlackBox : public Piston
  {
    bool
    compliance(const Vector &, Vector &) override
    {
      return false;
    }
  };
  BlackBox solid;
  Chamber  fluid;
  solid.drive = [](const double t) { return std::sin(t); };
  // Nothing to go by: said, not guessed.
  PartitionedStep         blind(solid, fluid, CouplingParameters());
  const ConvergenceReport report = blind.advance(0.1);
  EXPECT_FALSE(report.converged);
  EXPECT_NE(report.reason.find("Robin coefficient"), std::string::npos);
  // Two iterations are a secant; the impedance is 1/dt + dt.
  RobinCoefficient robin;
  solid.begin_step(0.1);
  fluid.begin_step(0.1);
  Vector d;
  for (const double force : {1., 2.})
    {
      solid.solve(scalar(force), d);
      robin.observe(solid, fluid, scalar(force), d);
    }
  EXPECT_TRUE(robin.begin_step(solid, fluid));
  EXPECT_NEAR(robin.value(), 10.1, 1e-10);
}



TEST(Piston, failed_step_is_retried_from_the_same_start)
{
  Piston  solid;
  Chamber fluid;
  set_impedances(solid, fluid, 1., 10.);
  solid.drive                   = [](double) { return 1.; };
  CouplingParameters parameters = plain_iteration();
  parameters.robin_coefficient  = 0.9;
  parameters.maximum_iterations = 3;
  parameters.tolerance          = 1e-12;
  PartitionedStep step(solid, fluid, parameters);
  EXPECT_FALSE(step.advance(1.).converged);
  EXPECT_EQ(step.displacement()(0), 0.);
  EXPECT_EQ(step.residuals().size(), 3u);
  EXPECT_EQ(solid.time, 0.);
}
