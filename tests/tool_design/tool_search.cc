#include <asperity/base/errors.h>
#include <asperity/base/progress.h>
#include <asperity/contact_zone/scene_input.h>
#include <asperity/contact_zone/surface.h>
#include <asperity/tool_design/commands.h>
#include <asperity/tool_design/tool_search.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "../files.h"

using namespace asperity;

namespace
{
  const std::string small_scene = R"(
subsection Tool
  set Wave numbers = 1, 2
  set Amplitudes   = 0.2 um, 0.1 um
  set Phases       = 0.3 rad, 1.9 rad
end
subsection Mesh
  set Spans             = 32
  set Refinement levels = 1
end
subsection Protocol
  set Inertia          = quasi-static
  set Sliding distance = 0.05 um
  set Ramp steps       = 3
  set Slide steps      = 4
end
)";

  class ToolSearchTest : public testing::Test
  {
  protected:
    void
    SetUp() override
    {
      folder = test_folder();
      overwrite(folder + "/scene.prm", small_scene);
    }

    /** Parameters of a search of a few runs. */
    std::string
    text(const std::string &further, const std::string &filter) const
    {
      return "subsection Scene\n set Base scene = scene.prm\nend\n"
             "subsection Search\n set Space = free form\n"
             " set Evaluations of DIRECT = 5\n set Methods = DIRECT\nend\n"
             "subsection Textures\n set S-filter nesting index = " +
             filter +
             "\nend\n"
             "subsection Output\n set Output directory = " +
             folder + "/out\nend\n" + further;
    }

    std::string
    file(const std::string &further = "",
         const std::string &filter  = "2 um") const
    {
      overwrite(folder + "/search.prm", text(further, filter));
      return folder + "/search.prm";
    }

    std::string
    refusal(const std::string &further,
            const std::string &filter = "2 um") const
    {
      return message_of<InputError>(
        [&]() { optimize_tool(file(further, filter)); });
    }

    std::string folder;
  };

  RunRecord
  record(const double mu, const double pressure)
  {
    RunRecord run;
    run.done         = true;
    run.mu           = mu;
    run.oil_pressure = pressure;
    return run;
  }
} // namespace

TEST(ToolExchange, gives_a_scene_its_own_tool_back)
{
  for (const std::string file :
       {"measured_surfaces/blasted_tool.prm", "dry_contact/dry_contact.prm"})
    {
      const std::string  path = ASPERITY_SOURCE_DIR "/parameter_files/" + file;
      const SceneInput   base(path);
      const ToolExchange tool(base.parameters, 256, 60);
      const SceneInput   again(path, tool.entries(tool.base()));
      const auto         as_it_is = tool_heights(base.parameters, 200),
                 as_waves         = tool_heights(again.parameters, 200);
      double mean                 = 0.;
      for (std::size_t i = 0; i < 200; ++i)
        mean += (as_it_is[i] - as_waves[i]) / 200.;
      for (std::size_t i = 0; i < 200; ++i)
        EXPECT_NEAR(as_it_is[i] - mean, as_waves[i], 2e-3 * tool.rms())
          << file << ", " << i;
      EXPECT_DOUBLE_EQ(again.parameters.geometry.length, tool.period());
    }
}

/** Which way its heights point and it slides is right only if mu is the same;
 *  the tool of the blasted map turned over has another one. */
TEST(ToolExchange, leaves_mu_as_it_is)
{
  const std::string path = test_folder() + "/scene.prm";
  overwrite(
    path,
    "include " ASPERITY_SOURCE_DIR "/parameter_files/tool_design/contact.prm\n"
    "subsection Mesh\n set Spans = 80\n set Refinement levels = 3\nend\n"
    "subsection Protocol\n set Sliding distance = 1 um\n"
    " set Slide steps = 25\nend\n");
  const ToolExchange  tool(SceneInput(path).parameters, 256, 24);
  std::vector<double> turned = tool.base();
  for (double &h : turned)
    h = -h;
  RunOrder as_it_is, as_waves, upside_down;
  as_waves.changes    = tool.entries(tool.base());
  upside_down.changes = tool.entries(turned);
  const double mu     = execute(path, as_it_is).mu;
  EXPECT_NEAR(execute(path, as_waves).mu, mu, 0.01 * mu);
  EXPECT_GT(std::abs(execute(path, upside_down).mu / mu - 1.), 0.1);
}

TEST(ToolExchange, keeps_the_root_mean_square_height)
{
  const SceneInput   base(ASPERITY_SOURCE_DIR
                        "/parameter_files/dry_contact/dry_contact.prm");
  const ToolExchange tool(base.parameters, 256, 10);
  // Rq of harmonics: half the sum of the squares of their amplitudes
  double sum = 0.;
  for (const double a : base.parameters.tool.amplitudes)
    sum += 0.5 * a * a;
  EXPECT_NEAR(tool.rms(), std::sqrt(sum), 1e-4 * std::sqrt(sum));
  std::vector<double> sine(256);
  for (std::size_t i = 0; i < 256; ++i)
    sine[i] = std::sqrt(2.) * std::sin(2. * M_PI * 3. * i / 256.);
  const SceneInput other(base.file, tool.entries(sine));
  EXPECT_NEAR(other.parameters.tool.amplitudes[2],
              std::sqrt(2.) * tool.rms(),
              1e-12 * tool.rms());
}

TEST(DesignObjective, is_a_weighted_sum_of_what_the_base_scene_has)
{
  const DesignObjective objective(
    {{"mu", &RunRecord::mu, 0.75},
     {"oil_pressure", &RunRecord::oil_pressure, -0.25}},
    record(0.2, 4e8));
  EXPECT_DOUBLE_EQ(objective.evaluate(record(0.1, 8e8)).value,
                   0.75 * 0.5 - 0.25 * 2.);
  RunRecord failed;
  failed.reason = "Newton's method fails.";
  EXPECT_EQ(objective.evaluate(failed).failure, failed.reason);
  RunRecord lifted = record(0.1, 1e8);
  lifted.no_result = "contact was lost";
  EXPECT_EQ(objective.evaluate(lifted).failure,
            "The run has no friction coefficient: contact was lost");
}

TEST(DesignObjective, wants_a_base_scene_that_has_the_results)
{
  const std::vector<DesignGoal> goals = {
    {"oil_pressure", &RunRecord::oil_pressure, 1.}};
  EXPECT_EQ(message_of<ComputationError>(
              [&]() { DesignObjective(goals, record(0.2, 0.)); }),
            "The result 'oil_pressure' of the base scene is zero, so that "
            "others cannot be measured by it.");
  RunRecord failed;
  failed.reason = "Newton's method fails.";
  EXPECT_EQ(message_of<ComputationError>(
              [&]() { DesignObjective(goals, failed); }),
            "The base scene has no friction coefficient: Newton's method "
            "fails.");
}

TEST_F(ToolSearchTest, learns_a_few_textures)
{
  TextureFamily            family;
  std::vector<ToolTexture> textures;
  family.n_places      = 32;
  family.shortest_wave = 0.5;
  for (unsigned int i = 0; i < 3; ++i)
    textures.push_back(
      make_texture({AnalyticTexture::Kind::waves, i + 1}, family));
  TextureTraining training;
  training.network.n_code            = 2;
  training.network.width             = 24;
  training.options.points_per_sample = 32;
  training.options.n_epochs          = 2000;
  training.options.weights.interval = training.options.codes.interval = 500;
  std::ostringstream sink;
  ProgressLine       progress(sink, ProgressLine::Mode::silent);
  const AutoDecoder  network =
    train_textures(textures, family, training, "", progress);
  const auto errors = judge_textures(network, textures, textures, family);
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors.back().n, 3u);
  EXPECT_LT(errors.back().network, 0.05);
  // three textures about their mean are two modes
  EXPECT_LT(errors.back().modes, 1e-12);
  const LatentTextures     space(network, family.n_places, family.n_waves());
  const std::vector<float> code = network.code(1);
  const auto               heights =
    space.heights(std::vector<double>(code.begin(), code.end()));
  for (std::size_t i = 0; i < heights.size(); ++i)
    EXPECT_NEAR(heights[i], textures[1].heights[i], 0.2);
}

TEST_F(ToolSearchTest, repeats_no_run_when_it_goes_on)
{
  testing::internal::CaptureStdout();
  optimize_tool(file());
  const std::string first = testing::internal::GetCapturedStdout();
  EXPECT_NE(first.find("DIRECT: objective"), std::string::npos);
  const std::string run = folder + "/out/DIRECT/runs/0005.json";
  ASSERT_TRUE(std::filesystem::exists(run));
  const auto        written = std::filesystem::last_write_time(run);
  const std::string summary = content(folder + "/out/summary.json");
  testing::internal::CaptureStdout();
  optimize_tool(file());
  testing::internal::GetCapturedStdout();
  EXPECT_EQ(std::filesystem::last_write_time(run), written);
  EXPECT_EQ(content(folder + "/out/summary.json"), summary);
  // The scene that it leaves has the tool that it names.
  const SceneInput   best(folder + "/out/DIRECT/best.prm");
  const ToolExchange tool(SceneInput(folder + "/scene.prm").parameters,
                          256,
                          15);
  EXPECT_NEAR(ToolExchange(best.parameters, 256, 15).rms(),
              tool.rms(),
              1e-3 * tool.rms());
}

TEST_F(ToolSearchTest, is_drawn)
{
  if (std::system("/usr/bin/python3 -c 'import matplotlib' > /dev/null 2>&1") !=
      0)
    GTEST_SKIP() << "matplotlib is not installed";
  testing::internal::CaptureStdout();
  optimize_tool(file());
  testing::internal::GetCapturedStdout();
  const std::string draw = ASPERITY_SOURCE_DIR "/tools/plot_tools.py " + folder,
                    said = folder + "/said.txt";
  ASSERT_EQ(std::system((draw + "/out > " + said + " 2>&1").c_str()), 0)
    << content(said);
  const std::string picture = content(folder + "/out/tools.png");
  EXPECT_EQ(picture.substr(1, 3), "PNG");
  EXPECT_GT(picture.size(), 15000u);
  EXPECT_NE(std::system((draw + "/none > " + said + " 2>&1").c_str()), 0);
  EXPECT_NE(content(said).find("is not the summary of 'asperity optimize'"),
            std::string::npos)
    << content(said);
}

TEST_F(ToolSearchTest, does_not_go_on_with_another_scene)
{
  testing::internal::CaptureStdout();
  optimize_tool(file());
  testing::internal::GetCapturedStdout();
  overwrite(folder + "/scene.prm",
            small_scene + "subsection Load\n set Pressure = 500 MPa\nend\n");
  EXPECT_EQ(refusal(""),
            folder +
              "/search.prm, line 13, entry 'Output/Output directory': '" +
              folder +
              "/out' holds a search with another base or check scene; expected "
              "another folder.");
}

TEST_F(ToolSearchTest, does_not_go_on_with_another_objective)
{
  testing::internal::CaptureStdout();
  optimize_tool(file());
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("ploughing"), std::string::npos) << said;
  testing::internal::CaptureStdout();
  const std::string other =
    refusal("subsection Objective\n set Results = contact_fraction\nend\n");
  testing::internal::GetCapturedStdout();
  EXPECT_NE(other.find("evaluations.csv"), std::string::npos) << other;
}

TEST_F(ToolSearchTest, says_what_is_wrong_with_its_file)
{
  const std::string wrong_result =
    refusal("subsection Objective\n set Results = my\nend\n");
  EXPECT_NE(wrong_result.find("found 'my'; expected some of mu, mu_end,"),
            std::string::npos)
    << wrong_result;
  const std::string wrong_weights =
    refusal("subsection Objective\n set Weights = 1, 2\nend\n");
  EXPECT_NE(wrong_weights.find("found 2 weights for 1 results; expected one "
                               "for each."),
            std::string::npos)
    << wrong_weights;
  const std::string no_weight =
    refusal("subsection Objective\n set Weights = 0\nend\n");
  EXPECT_NE(no_weight.find("all are zero; expected one that is not."),
            std::string::npos)
    << no_weight;
  const std::string fine = refusal("", "0.1 um");
  EXPECT_NE(fine.find("expected at least four Textures/Places for each"),
            std::string::npos)
    << fine;
  overwrite(folder + "/scene.prm", "subsection Tool\n set Kind = flat\nend\n");
  EXPECT_EQ(refusal(""),
            "The base scene has a flat tool (Tool/Kind = flat); expected "
            "harmonics or a measured one.");
}
