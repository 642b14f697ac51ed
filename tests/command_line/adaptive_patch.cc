#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

#include "program.h"

// Settings that a patch chooses by the error of its mu.

using namespace asperity;

namespace
{
  class AdaptivePatch : public Program
  {
  protected:
    /** A wave over a coarse chip.
     *  @param geometry further entries of it
     *  @param tool how the wave lies */
    nlohmann::json
    accuracy(const std::string &geometry,
             const std::string &tool,
             const std::string &mesh,
             const double       error,
             const std::string &launcher = "") const
    {
      write(
        "scene.prm",
        "subsection Geometry\n set Period = 5 um\n set Chip height = 3 um\n" +
          geometry + "end\nsubsection Tool\n set Kind = harmonics\n" +
          " set Amplitudes = 0.1 um, 0.05 um\n set Phases = 0 rad, 1 rad\n" +
          tool + "end\nsubsection Mesh\n set Refinement levels = 1\n" +
          " set Row grading = 2.5\n" + mesh +
          "end\nsubsection Load\n set Pressure = 1000 MPa\n" +
          "end\nsubsection Protocol\n set Inertia = quasi-static\n" +
          " set Ramp steps = 2\n set Slide steps = 4\n" +
          "end\nsubsection Solver\n set Tolerance = 1e-8\n" +
          "end\nsubsection Accuracy\n set Control = adaptive\n" +
          " set Error = " + std::to_string(error) +
          "\nend\nsubsection Output\n set Picture interval = 0\n" +
          " set Checkpoint interval = 0\n set Output directory = run\nend\n");
      const Result result = run("scene.prm", launcher);
      EXPECT_EQ(result.status, 0) << result.output << result.errors;
      return nlohmann::json::parse(read("run/summary.json"))["accuracy"];
    }
  };

  void
  expect_same_rounds(const nlohmann::json &a,
                     const nlohmann::json &b,
                     const double          tolerance)
  {
    EXPECT_EQ(a["runs"], b["runs"]);
    ASSERT_EQ(a["rounds"].size(), b["rounds"].size());
    for (std::size_t i = 0; i < a["rounds"].size(); ++i)
      {
        const nlohmann::json &of_a = a["rounds"][i], &of_b = b["rounds"][i];
        for (const char *name : {"spans", "ramp_steps", "penalty_factor"})
          EXPECT_EQ(of_a[name], of_b[name]) << name;
        for (const char *name : {"mu", "mesh", "step", "penalty", "chance"})
          EXPECT_NEAR(of_a[name], of_b[name], tolerance) << name;
      }
  }
} // namespace



TEST_F(AdaptivePatch, of_an_extruded_tool_finds_the_errors_of_the_plane)
{
  const std::string waves = " set Wave numbers = 1, 2\n";
  const auto        plane = accuracy("", waves, " set Spans = 16\n", 0.5);
  const auto        patch = accuracy(" set Dimension = 3\n set Width = 1 um\n",
                              waves + " set Wave numbers across = 0, 0\n",
                              " set Spans = 16\n set Spans across = 6\n",
                              0.5);
  expect_same_rounds(patch, plane, 1e-6);
  for (const char *source : {"mesh", "step", "penalty"})
    EXPECT_GT(double(plane[source]), 1e-4) << source;
}



TEST_F(AdaptivePatch, has_the_same_rounds_on_two_ranks)
{
  const auto of = [&](const std::string &launcher) {
    return accuracy(" set Dimension = 3\n set Width = 5 um\n",
                    " set Wave numbers = 1, 1\n"
                    " set Wave numbers across = 1, -1\n",
                    " set Degree = 1\n set Spans = 8\n set Spans across = 8\n",
                    0.2,
                    launcher);
  };
  const auto one = of("");
  EXPECT_GE(one["rounds"].size(), 2u);
  EXPECT_EQ(one["met_by"].back(), "corrected_mu");
  expect_same_rounds(of("mpirun -np 2"), one, 1e-6);
}
