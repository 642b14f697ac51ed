#include <gtest/gtest.h>

#include "problems.h"

using namespace asperity;

TEST(TurekHron, steady_flag_fsi1)
{
  // Featflow's refined values; the fine mesh is in tools/benchmarks.
  const auto              problem = make_problem(read_problem("fsi1"));
  const ConvergenceReport report  = problem->system->advance(1.);
  ASSERT_TRUE(report.converged) << report.reason;
  EXPECT_LE(report.iterations, 6u);
  EXPECT_NEAR(problem->displacement()[0] / 2.270493e-5, 1., 0.015);
  EXPECT_NEAR(problem->displacement()[1] / 8.208773e-4, 1., 0.015);
  const auto force = problem->system->flow().total_wall_force(problem->loaded);
  EXPECT_NEAR(force[0] / 14.29426, 1., 0.002);
  EXPECT_NEAR(force[1] / 0.7637460, 1., 0.005);
}



// Until the inflow is there all forces grow; the first steps of the swinging
// flags on the coarsest mesh.
TEST(TurekHron, starts_the_swinging_flags)
{
  for (const std::string name : {"fsi2", "fsi3"})
    {
      const auto problem =
        make_problem(read_problem(name,
                                  "subsection Fluid\n set Degree = 2\n"
                                  " set Wall layers = 0\n set Corner layers = "
                                  "0\nend\n"));
      double drag = 0.;
      for (unsigned int i = 0; i < 4; ++i)
        {
          const ConvergenceReport report = problem->system->advance(0.005);
          ASSERT_TRUE(report.converged) << name << ": " << report.reason;
          const double now =
            problem->system->flow().total_wall_force(problem->loaded)[0];
          EXPECT_GT(now, drag) << name;
          drag = now;
        }
    }
}
