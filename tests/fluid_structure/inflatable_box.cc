#include <asperity/base/errors.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "problems.h"

using namespace asperity;

TEST(InflatableBox, keeps_the_volume_that_flows_in)
{
  const FluidStructureParameters parameters =
    read_problem("inflatable_box",
                 "subsection Fluid\n set Refinements = 1\nend\n"
                 "subsection Body\n set Spans along = 2\nend\n");
  const auto    problem = make_problem(parameters);
  NavierStokes &flow    = problem->system->flow();
  const double  dt      = 0.02;
  double        volume  = flow.volume();
  EXPECT_NEAR(volume, 10.5, 1e-9);
  for (unsigned int i = 1; i <= 10; ++i)
    {
      const ConvergenceReport report = problem->system->advance(dt);
      ASSERT_TRUE(report.converged) << report.reason;
      EXPECT_LE(report.iterations, 8u) << "step " << i;
      // Implicit Euler: the inflow at the end of the step.
      const double inflow = dt * inflow_of_box(parameters.problem, i * dt);
      EXPECT_NEAR((flow.volume() - volume) / inflow, 1., 1e-6) << "step " << i;
      volume = flow.volume();
    }
}



// A box that is filled and shut keeps its pressure, however many steps follow,
// and whatever the step, it is the one that belongs to the volume (in
// proportion to what was filled in, as the walls move little). Thick oil, large
// steps and the dissipation of the time integration calm the walls.
TEST(InflatableBox, keeps_its_pressure_when_shut)
{
  const FluidStructureParameters parameters =
    read_problem("inflatable_box",
                 "subsection Problem\n subsection Inflow\n  set End = 0.2 s\n"
                 " end\nend\n"
                 "subsection Fluid\n set Refinements = 0\n set Viscosity = "
                 "48.18 Pa s\nend\n"
                 "subsection Body\n set Spans along = 1\n set Spectral radius "
                 "= 0\nend\n");
  std::array<double, 2> stiffness;
  for (const unsigned int k : {0, 1})
    {
      const double  dt       = k == 0 ? 0.1 : 0.05;
      const auto    problem  = make_problem(parameters);
      NavierStokes &flow     = problem->system->flow();
      const auto    pressure = [&flow] {
        return flow.pressure_at({-1., 2.2 - 1e-9});
      };
      const double       start   = flow.volume();
      const unsigned int n_steps = std::lround(12. / dt);
      double             earlier = 0.;
      for (unsigned int i = 1; i <= n_steps; ++i)
        {
          ASSERT_TRUE(problem->system->advance(dt).converged);
          if (i == n_steps / 2)
            earlier = pressure();
        }
      EXPECT_NEAR(pressure() / earlier, 1., 0.01);
      stiffness[k] = pressure() / (flow.volume() - start);
    }
  EXPECT_NEAR(stiffness[1] / stiffness[0], 1., 0.01);
}



TEST(InflatableBox, refuses_dirichlet_neumann)
{
  EXPECT_THROW(
    make_problem(read_problem(
      "inflatable_box",
      "subsection Coupling\n set Scheme = Dirichlet-Neumann\nend\n")),
    InputError);
}
