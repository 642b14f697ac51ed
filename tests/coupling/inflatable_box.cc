#include "inflatable_box.h"

#include <asperity/base/errors.h>

#include <gtest/gtest.h>

using namespace inflatable_box;

TEST(InflatableBox, KeepsTheVolumeThatFlowsIn)
{
  InflatableBox box(1, 2, InflatableBox::default_options());
  NavierStokes &flow   = box.problem->flow();
  const double  dt     = 0.02;
  double        volume = flow.volume();
  EXPECT_NEAR(volume, 10.5, 1e-9);
  for (unsigned int i = 1; i <= 10; ++i)
    {
      const ConvergenceReport report = box.problem->advance(dt);
      ASSERT_TRUE(report.converged) << report.reason;
      EXPECT_LE(report.iterations, 8u) << "step " << i;
      // Implicit Euler: the inflow at the end of the step.
      const double inflow = dt * InflatableBox::inflow(i * dt);
      EXPECT_NEAR((flow.volume() - volume) / inflow, 1., 1e-6) << "step " << i;
      volume = flow.volume();
    }
}



TEST(InflatableBox, RefusesDirichletNeumann)
{
  FluidStructureOptions options = InflatableBox::default_options();
  options.coupling.scheme       = CouplingScheme::dirichlet_neumann;
  InflatableBox box(0, 1, options);
  EXPECT_THROW(box.problem->advance(0.02), InputError);
}
