#include <asperity/base/errors.h>

#include <gtest/gtest.h>

#include <cmath>

#include "problems.h"

using namespace asperity;

namespace
{
  std::string
  message_of(const std::string &changes)
  {
    try
      {
        make_problem(read_problem("enclosed_domain", changes));
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace



// Between flat surfaces the chip is pressed as a whole by as much as the tool
// moves: uniaxial strain with the stretch s = 1 - d/H, whose pressure is
//   p = mu (1/s - s) - lambda ln s/s, from P = mu (F - 1/F) + lambda ln F/F.
TEST(EnclosedDomain, presses_a_flat_chip_as_the_formula_says)
{
  const FluidStructureParameters parameters =
    read_problem("enclosed_domain",
                 "subsection Tool\n set Kind = flat\nend\n"
                 "subsection Chip surface\n set Kind = flat\nend\n"
                 "subsection Fluid\n set Cells along = 4\n set Cells across = "
                 "2\nend\n"
                 "subsection Coupling\n set Tolerance = 1e-7\nend\n");
  const auto problem = make_problem(parameters);
  for (unsigned int i = 0; i < 10; ++i)
    ASSERT_TRUE(problem->system->advance(0.11e-6).converged);

  const ElasticParameters &steel  = parameters.material.elasticity;
  const double             d      = parameters.problem.wall_displacement;
  const double             s      = 1. - d / parameters.geometry.height;
  const double             lambda = steel.lame_lambda();
  const double             p =
    steel.shear_modulus() * (1. / s - s) - lambda * std::log(s) / s;
  EXPECT_NEAR(problem->displacement()[0] / d, 1., 1e-6);
  EXPECT_NEAR(problem->displacement()[1] / d, 0., 1e-6);
  EXPECT_NEAR(problem->mean_pressure() / p, 1., 1e-6);
  EXPECT_NEAR(problem->system->flow().total_wall_force(problem->loaded)[0] /
                (p * parameters.geometry.length),
              1.,
              1e-6);
}



TEST(EnclosedDomain, keeps_its_volume_between_rough_walls)
{
  const auto problem =
    make_problem(read_problem("enclosed_domain",
                              "subsection Fluid\n set Cells along = 24\n set "
                              "Cells across = 3\nend\n"
                              "subsection Body\n set Spans across = 4\nend\n"));
  const double volume = problem->system->flow().volume();
  for (unsigned int i = 0; i < 4; ++i)
    {
      const ConvergenceReport report = problem->system->advance(0.25e-6);
      ASSERT_TRUE(report.converged) << report.reason;
      EXPECT_LE(report.iterations, 8u);
    }
  // Of the 10 um^2 that the tool sweeps, up to the tolerance of the coupling.
  EXPECT_NEAR(problem->system->flow().volume(), volume, 1e-4 * 10e-12);
}



TEST(EnclosedDomain, refuses_what_cannot_be)
{
  EXPECT_EQ(
    message_of("subsection Coupling\n set Scheme = Dirichlet-Neumann\nend\n"),
    "Dirichlet-Neumann coupling has no solution here, because the fluid is "
    "incompressible and enclosed, so that a prescribed motion of its walls "
    "contradicts its volume; choose Robin-Neumann.");
  EXPECT_EQ(message_of("subsection Geometry\n set Chip height = 0.1 um\nend\n")
              .find("The chip is 0.1 um high; expected more than its "
                    "roughness,"),
            0u);
}
