#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <string>

#include "../postprocess/vtu_reader.h"
#include "program.h"

// A scene in three dimensions on several ranks, with contact, shear of the
// interface, plastic flow and conduction of heat. Expected is what one rank
// finds.

using namespace asperity;

namespace
{
  class RanksOfScene : public Program
  {
  protected:
    std::string mesh = " set Spans = 6\n";
    std::string oil;

    /** Hills over a coarse chip. */
    std::string
    scene(const std::string &directory, const std::string &further = "") const
    {
      return "subsection Geometry\n set Dimension = 3\n set Period = 5 um\n"
             " set Width = 5 um\n set Chip height = 3 um\nend\n"
             "subsection Tool\n set Kind = harmonics\n"
             " set Wave numbers = 1, 1\n set Wave numbers across = 1, -1\n"
             " set Amplitudes = 0.1 um, 0.05 um\n set Phases = 0 rad, 1 rad\n"
             "end\n" +
             oil + "subsection Mesh\n" + mesh +
             " set Refinement levels = 0\n"
             " set Row grading = 2.5\nend\n"
             "subsection Interface\n set Shear law = Coulomb\n"
             " set Friction coefficient = 0.1\nend\n"
             "subsection Protocol\n set Inertia = quasi-static\n"
             " set Ramp steps = 1\n set Slide steps = 2\nend\n"
             "subsection Solver\n set Tolerance = 1e-7\n" +
             further + "end\nsubsection Output\n set Picture interval = 0\n" +
             " set Checkpoint interval = 2\n set Output directory = " +
             directory + "\n";
    }

    nlohmann::json
    summary(const std::string &directory) const
    {
      return nlohmann::json::parse(read(directory + "/summary.json"));
    }

    /** The run of a new scene or of a restart. */
    void
    compute(const std::string &directory,
            const std::string &launcher,
            const std::string &further = "",
            const std::string &output  = "") const
    {
      write(directory + ".prm", scene(directory, further) + output + "end\n");
      const Result result = run(directory + ".prm", launcher);
      ASSERT_EQ(result.status, 0) << result.output << result.errors;
    }

    /** Pictures of the last step, of which each rank has drawn a piece; cells
     *  come in another order. */
    void
    expect_equal_pictures(const std::string &several,
                          const std::string &one) const
    {
      const VtuReader a(read(several + "/chip_000003.vtu")),
        b(read(one + "/chip_000003.vtu"));
      EXPECT_EQ(a.n_pieces, 2u);
      EXPECT_EQ(b.n_pieces, 1u);
      EXPECT_EQ(a.n_points, b.n_points);
      EXPECT_EQ(a.n_cells, b.n_cells);
      EXPECT_EQ(a.time(), b.time());
      const auto sum = [](const std::vector<float> &values) {
        double result = 0.;
        for (const float value : values)
          result += std::abs(value);
        return result;
      };
      EXPECT_NEAR(sum(a.points()), sum(b.points()), 1e-6 * sum(b.points()));
      for (const char *name : {"displacement [m]",
                               "equivalent plastic strain [-]",
                               "von Mises stress [Pa]"})
        EXPECT_NEAR(sum(a.field(name)),
                    sum(b.field(name)),
                    1e-5 * sum(b.field(name)))
          << name;
    }

    void
    expect_equal(const nlohmann::json &a,
                 const nlohmann::json &b,
                 const double          tolerance) const
    {
      for (const char *name : {"mu", "interface_shear", "mu_end", "T_y"})
        {
          const double expected = b["friction"][name];
          EXPECT_NEAR(a["friction"][name],
                      expected,
                      tolerance * std::abs(expected))
            << name;
        }
      for (const char *name : {"to_tool", "flash_temperature"})
        {
          const double expected = b["heat"][name];
          EXPECT_NEAR(a["heat"][name], expected, tolerance * expected) << name;
        }
    }
  };
} // namespace



TEST_F(RanksOfScene, find_the_friction_of_one_and_go_on_in_another_number)
{
  compute("one", "");
  const auto one = summary("one");
  EXPECT_GT(one["friction"]["mu"], 0.1);
  EXPECT_GT(one["end"]["max_plastic_strain"], 1e-3);
  EXPECT_GT(one["heat"]["to_tool"], 0.1);
  EXPECT_LT(one["heat"]["balance_error"], 1e-9);
  EXPECT_EQ(one["cost"]["linear_solver"], "cholmod");
  compute("two", "mpirun -np 2");
  const auto two = summary("two");
  expect_equal(two, one, 1e-8);
  EXPECT_EQ(two["cost"]["ranks"], 2);
  EXPECT_EQ(two["cost"]["linear_solver"], "mumps");
  expect_equal_pictures("two", "one");

  // The checkpoint of two ranks is that of the last step but one, which four
  // ranks take on two cores: they wait for each other, so it is but one.
  for (const std::string launcher : {"", "mpirun -np 4"})
    {
      std::filesystem::remove_all(folder / "further");
      std::filesystem::copy(folder / "two",
                            folder / "further",
                            std::filesystem::copy_options::recursive);
      compute("further", launcher, "", " set Restart = true\n");
      expect_equal(summary("further"), two, 1e-8);
      EXPECT_EQ(summary("further")["cost"]["ranks"], launcher.empty() ? 1 : 4);
    }
}



TEST_F(RanksOfScene, tell_the_numerical_error_of_mu_together)
{
  mesh = " set Degree = 1\n set Spans = 8\n set Spans across = 8\n";
  const std::string further =
    "end\nsubsection Accuracy\n set Control = estimate\n";
  compute("one", "", further);
  compute("two", "mpirun -np 2", further);
  const auto one = summary("one")["accuracy"], two = summary("two")["accuracy"];
  for (const char *source : {"mesh", "step", "penalty", "chance"})
    EXPECT_NEAR(two["by_source"][source], one["by_source"][source], 1e-6)
      << source;
  EXPECT_EQ(two["runs"], one["runs"]);
  EXPECT_NEAR(two["error"], one["error"], 1e-6);
  EXPECT_GT(std::abs(double(one["by_source"]["mesh"])), 1e-4);
  EXPECT_GT(std::abs(double(one["by_source"]["penalty"])), 1e-4);
}



TEST_F(RanksOfScene, find_the_same_friction_by_multigrid)
{
  compute("one", "");
  compute("krylov", "mpirun -np 2", " set Linear solver = krylov\n");
  expect_equal(summary("krylov"), summary("one"), 1e-8);
  EXPECT_EQ(summary("krylov")["cost"]["linear_solver"], "krylov");
}



TEST_F(RanksOfScene, find_the_same_pressure_of_enclosed_oil)
{
  oil = "subsection Lubrication\n set Model = pocket\n"
        " set Wetting = 0.7\n set Sealing gap = 20 nm\nend\n";
  compute("one", "");
  compute("two", "mpirun -np 2");
  const auto one = summary("one"), two = summary("two");
  expect_equal(two, one, 1e-8);
  EXPECT_EQ(two["cost"]["linear_solver"], "mumps");
  const double share = one["oil"]["load_share"];
  EXPECT_GT(share, 0.1); // and the contact carries, too
  EXPECT_LT(share, 0.9);
  EXPECT_NEAR(two["oil"]["load_share"], share, 1e-8);
  // The last step by one rank, from the checkpoint of two.
  compute("two", "", "", " set Restart = true\n");
  expect_equal(summary("two"), one, 1e-8);
  EXPECT_NEAR(summary("two")["oil"]["load_share"], share, 1e-8);
}



TEST_F(RanksOfScene, refuse_a_solver_for_one_rank_together)
{
  write("scene.prm", scene("out", " set Linear solver = umfpack\n") + "end\n");
  const Result      result   = run("scene.prm", "mpirun -np 2");
  const std::string sentence = "found one that runs on one rank, on 2 ranks; "
                               "expected automatic, mumps or krylov.";
  EXPECT_EQ(result.status, 2);
  const auto place = result.errors.find(sentence);
  ASSERT_NE(place, std::string::npos) << result.errors;
  EXPECT_EQ(result.errors.find(sentence, place + 1), std::string::npos);
}



TEST_F(RanksOfScene, end_when_one_of_them_alone_finds_a_wrong_input)
{
  write("scene.prm", scene("out") + "end\n");
  const Result result = run("scene.prm : -np 1 '" ASPERITY_PROGRAM "' none.prm",
                            "timeout 60 mpirun -np 1");
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("The parameter file 'none.prm' does not exist"),
            std::string::npos)
    << result.errors;
}
