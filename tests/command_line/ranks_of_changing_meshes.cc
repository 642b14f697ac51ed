#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

#include "program.h"

// A patch whose mesh follows its contacts, on one rank and on two.

using namespace asperity;

namespace
{
  class RanksOfChangingMeshes : public Program
  {
  protected:
    nlohmann::json
    summary_of(const std::string &directory,
               const std::string &launcher,
               const std::string &of_mesh,
               const std::string &of_solver = "",
               const std::string &further   = "") const
    {
      write(directory + ".prm",
            "subsection Geometry\n set Dimension = 3\n set Period = 5 um\n"
            " set Width = 5 um\n set Chip height = 3 um\nend\n"
            "subsection Tool\n set Kind = harmonics\n"
            " set Wave numbers = 1, 1\n set Wave numbers across = 1, -1\n"
            " set Amplitudes = 0.1 um, 0.1 um\n set Phases = 0 rad, 1 rad\n"
            "end\n"
            "subsection Mesh\n set Degree = 1\n set Spans = 12\n"
            " set Refinement levels = 1\n set Adaptive levels = 1\n"
            " set Row grading = 4\n set Adaptive halo = 1\n"
            " set Remesh distance = 0.1 um\n" +
              of_mesh +
              "end\n"
              "subsection Protocol\n set Inertia = quasi-static\n"
              " set Sliding distance = 1.5 um\n set Ramp steps = 1\n"
              " set Slide steps = 3\nend\n"
              "subsection Solver\n set Tolerance = 1e-10\n" +
              of_solver +
              "end\n"
              "subsection Output\n set Picture interval = 0\n"
              " set Output directory = " +
              directory + "\n" + further + "end\n");
      const Result result = run(directory + ".prm", launcher);
      EXPECT_EQ(result.status, 0) << result.output << result.errors;
      return nlohmann::json::parse(read(directory + "/summary.json"));
    }

    void
    expect_equal(const nlohmann::json &one, const nlohmann::json &two) const
    {
      for (const char *name : {"mu", "mu_end", "T_y"})
        {
          const double expected = one["friction"][name];
          EXPECT_NEAR(two["friction"][name],
                      expected,
                      1e-8 * std::abs(expected))
            << name;
        }
      for (const char *name : {"remeshes", "most_unknowns", "bounded"})
        EXPECT_EQ(two["mesh"]["remeshing"][name],
                  one["mesh"]["remeshing"][name])
          << name;
      EXPECT_EQ(two["cost"]["ranks"], 2);
    }
  };
} // namespace



TEST_F(RanksOfChangingMeshes, divide_each_mesh_anew_and_find_the_same_friction)
{
  const auto one = summary_of("one", "", "");
  expect_equal(one, summary_of("two", "mpirun -np 2", ""));
  EXPECT_GT(one["mesh"]["remeshing"]["remeshes"], 1);
  EXPECT_GT(one["end"]["max_plastic_strain"], 1e-3);
}



TEST_F(RanksOfChangingMeshes, obey_a_bound_and_solve_by_multigrid)
{
  const std::string bound = " set Maximum unknowns = 700\n";
  const auto        one   = summary_of("one", "", bound);
  expect_equal(
    one,
    summary_of("two", "mpirun -np 2", bound, " set Linear solver = krylov\n"));
  EXPECT_LE(one["mesh"]["remeshing"]["most_unknowns"], 700);
  EXPECT_GT(one["mesh"]["remeshing"]["bounded"], 0);
}



// Shear, enclosed oil and conducted heat go over to each mesh, and to another
// number of ranks.
TEST_F(RanksOfChangingMeshes, take_interface_oil_and_heat_with_them_and_go_on)
{
  const std::string further = " set Checkpoint interval = 3\nend\n"
                              "subsection Interface\n"
                              " set Shear law = shear factor\n"
                              " set Shear factor = 0.5\nend\n"
                              "subsection Lubrication\n set Model = pocket\n"
                              " set Wetting = 0.8\n set Sealing gap = 20 nm\n";
  const auto        one     = summary_of("one", "", "", "", further),
             two = summary_of("two", "mpirun -np 2", "", "", further);
  expect_equal(one, two);
  EXPECT_GT(one["mesh"]["remeshing"]["remeshes"], 1);
  EXPECT_GT(one["friction"]["interface_shear"], 0.01);
  EXPECT_LT(one["heat"]["balance_error"], 1e-9);
  EXPECT_NEAR(two["oil"]["load_share"], one["oil"]["load_share"], 1e-8);
  // The last step by one rank, from the checkpoint of two.
  const auto rest =
    summary_of("two", "", "", "", " set Restart = true\n" + further);
  EXPECT_EQ(rest["cost"]["ranks"], 1);
  for (const char *name : {"mu", "interface_shear", "mu_end", "T_y"})
    {
      const double expected = one["friction"][name];
      EXPECT_NEAR(rest["friction"][name], expected, 1e-8 * std::abs(expected))
        << name;
    }
}
