#include "turek_fsi.h"

#include <gtest/gtest.h>

using namespace turek_fsi;

TEST(TurekFsi, steady_flag_fsi1)
{
  // Featflow's refined values; the fine mesh is in tools/benchmarks.
  Discretization discretization;
  discretization.refinements = 1;
  discretization.wall_layers = 1;
  TurekFsi                fsi(fsi1, discretization, default_options(fsi1));
  const ConvergenceReport report = fsi.problem->advance(1.);
  ASSERT_TRUE(report.converged) << report.reason;
  EXPECT_LE(report.iterations, 6u);
  EXPECT_NEAR(fsi.tip()[0] / 2.270493e-5, 1., 0.015);
  EXPECT_NEAR(fsi.tip()[1] / 8.208773e-4, 1., 0.015);
  EXPECT_NEAR(fsi.drag_and_lift()[0] / 14.29426, 1., 0.002);
  EXPECT_NEAR(fsi.drag_and_lift()[1] / 0.7637460, 1., 0.005);
}
