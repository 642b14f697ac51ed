#include <asperity/contact_zone/scene_computation.h>
#include <asperity/contact_zone/scene_input.h>

#include <gtest/gtest.h>

#include <fstream>
#include <string>

using namespace asperity;

// Three of the reference scenes on the default mesh, with the default steps and
// tolerance, against the table of parameter_files/reference_scenes/README.md,
// whose runs are four times as fine.

namespace
{
  const std::string folder =
    ASPERITY_SOURCE_DIR "/parameter_files/reference_scenes/";

  struct Case
  {
    std::string scene, pressure, velocity, temperature;
  };

  /** The coefficient in the row of the table. */
  double
  published_mu(const Case &load)
  {
    const std::string start = "| " + load.scene + " | " + load.pressure +
                              " | " + load.velocity + " | " + load.temperature +
                              " | ";
    std::ifstream page(folder + "README.md");
    for (std::string line; std::getline(page, line);)
      if (line.compare(0, start.size(), start) == 0)
        return std::stod(line.substr(start.size()));
    ADD_FAILURE() << "no row " << start;
    return 0.;
  }

  class ReferenceScene : public testing::TestWithParam<Case>
  {};
} // namespace

TEST_P(ReferenceScene, default_settings_are_within_their_published_error)
{
  const Case load = GetParam();
  SceneInput input(folder + "dry_" + load.scene + "_p" + load.pressure + "_v" +
                   load.velocity + "_T" + load.temperature + ".prm");
  SceneParameters         &parameters = input.parameters;
  const ProtocolParameters defaults;
  parameters.mesh                 = MeshParameters();
  parameters.solver               = SolverParameters();
  parameters.protocol.ramp_steps  = defaults.ramp_steps;
  parameters.protocol.slide_steps = defaults.slide_steps;
  const SceneResult result        = compute_scene(parameters);
  const double      mu            = published_mu(load);
  EXPECT_NEAR(result.friction.mu, mu, 0.007 * mu);
  EXPECT_EQ(result.status, FrictionStatus::valid);
}

INSTANTIATE_TEST_SUITE_P(Dry,
                         ReferenceScene,
                         testing::Values(Case{"R0", "300", "22.5", "25"},
                                         Case{"R0", "300", "200", "25"},
                                         Case{"R1", "300", "22.5", "25"}),
                         [](const testing::TestParamInfo<Case> &info) {
                           return info.param.scene +
                                  (info.param.velocity == "200" ? "_fast" :
                                                                  "_slow");
                         });
