#include <asperity/base/errors.h>
#include <asperity/tool_design/commands.h>
#include <asperity/tool_design/law_search.h>

#include <gtest/gtest.h>

#include <cmath>

#include "../files.h"

using namespace asperity;

namespace
{
  // mu = 0.1 + (ln p - ln p_0)^2 + (T - T_0)^2 / (1000 K)^2, which a process of
  // 121 points knows to a few 1e-4.
  class LawSearchTest : public testing::Test
  {
  protected:
    void
    SetUp() override
    {
      folder = test_folder();
      FrictionLawDescription description;
      description.inputs = {
        {"Load/Pressure", "p", "MPa", 1e8, 1e9, Scale::logarithmic, {}},
        {"Load/Temperature", "T", "degC", 300., 900., Scale::linear, {}}};
      description.kernel = KernelKind::matern_5_2;
      std::vector<double> x, mu;
      for (unsigned int i = 0; i <= 10; ++i)
        for (unsigned int j = 0; j <= 10; ++j)
          {
            x.push_back(1e8 * std::pow(10., i / 10.));
            x.push_back(300. + 60. * j);
            mu.push_back(value(x[x.size() - 2], x.back()));
          }
      FrictionLaw::train(description, x, mu).save(folder + "/law.json");
    }

    static double
    value(const double p, const double T)
    {
      return 0.1 + std::pow(std::log(p / best_p), 2) +
             std::pow((T - best_T) / 1000., 2);
    }

    std::string
    law_file(const std::string &further = "") const
    {
      overwrite(folder + "/law.prm",
                "subsection Objective\n set Friction law = law.json\n" +
                  further + "end\nsubsection Output\n set Output directory = " +
                  folder + "/out\nend\n");
      return folder + "/law.prm";
    }

    static constexpr double best_p = 4e8, best_T = 700.;

    std::string folder;
  };
} // namespace

TEST_F(LawSearchTest, finds_the_least_of_a_law)
{
  ToolDesignParameters parameters;
  parameters.friction_law            = folder + "/law.json";
  parameters.directory               = folder + "/out";
  parameters.direct.max_evaluations  = 200;
  parameters.genetic.max_evaluations = 400;
  for (const LeastFriction &least : LawSearch(parameters).run())
    {
      EXPECT_NEAR(least.prediction.mean, 0.1, 1e-3) << least.method;
      EXPECT_NEAR(least.x[0] / best_p, 1., 0.05) << least.method;
      EXPECT_NEAR(least.x[1], best_T, 30.) << least.method;
    }
  parameters.fixed_inputs = "T = 500 K";
  parameters.directory    = folder + "/fixed";
  const auto found        = LawSearch(parameters).run();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_DOUBLE_EQ(found[0].x[1], 500.);
  EXPECT_NEAR(found[0].prediction.mean, value(best_p, 500.), 1e-3);
}

TEST_F(LawSearchTest, is_a_command_and_says_what_is_wrong)
{
  testing::internal::CaptureStdout();
  EXPECT_EQ(optimize_tool(law_file()), 0);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("DIRECT: mu = 0.1"), std::string::npos) << said;
  EXPECT_NE(said.find(" degC, after "), std::string::npos) << said;
  const auto refused = [&](const std::string &further) {
    return message_of<InputError>([&]() { optimize_tool(law_file(further)); });
  };
  EXPECT_EQ(
    refused(" set Fixed inputs = T = 1000 K\n"),
    "Objective/Fixed inputs: 'Load/Temperature' is 726.85 degC; the law "
    "knows 26.85 degC to 626.85 degC.");
  EXPECT_EQ(refused(" set Fixed inputs = T = 500 K, p = 200 MPa\n"),
            "Objective/Fixed inputs: all inputs of the law are fixed; expected "
            "at least one that is not.");
  EXPECT_NE(
    refused(" set Results = mu_end\n").find("found 'mu_end'; expected mu"),
    std::string::npos);
  overwrite(folder + "/scene.prm", "# the default scene\n");
  EXPECT_NE(refused("end\nsubsection Scene\n set Base scene = scene.prm\n")
              .find("expected either a scene or a law at Objective/Friction "
                    "law, not both."),
            std::string::npos);
}
