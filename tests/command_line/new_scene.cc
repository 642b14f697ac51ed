#include <cmath>
#include <sstream>

#include "program.h"

using namespace asperity;

// From a height map to mu with two commands.
class NewScene : public Program
{
protected:
  const std::string surfaces =
    std::string(ASPERITY_SOURCE_DIR) + "/parameter_files/surfaces/";

  /** Measured maps, which are no part of the repository. */
  const std::string measured =
    std::string(ASPERITY_SOURCE_DIR) + "/../shared/surfaces/";

  std::string
  refusal(const std::string &arguments) const
  {
    const Result result = run("new " + arguments);
    EXPECT_EQ(result.status, 2) << result.output;
    EXPECT_EQ(result.output, "");
    return result.errors;
  }

  /** A matrix of heights in um, waves of 20 points. */
  std::string
  matrix() const
  {
    std::ostringstream out;
    for (unsigned int j = 0; j < 60; ++j)
      for (unsigned int i = 0; i < 120; ++i)
        out << 0.1 * std::cos(2. * M_PI * i / 20.) << (i < 119 ? ' ' : '\n');
    return out.str();
  }
};

TEST_F(NewScene, a_map_becomes_mu_with_two_commands)
{
  std::filesystem::create_directories(folder / "maps");
  std::filesystem::copy(surfaces + "blasted_tool.x3p", folder / "maps");
  const Result made = run("new maps/blasted_tool.x3p -p 450MPa -v 100m/min "
                          "-T 300degC");
  ASSERT_EQ(made.status, 0) << made.errors;
  EXPECT_NE(made.output.find("S-filter 2 um"), std::string::npos)
    << made.output;
  EXPECT_NE(made.output.find("Load: 450 MPa, 100 m/min, 300 degC, dry."),
            std::string::npos);
  const std::string text = read("blasted_tool.prm");
  for (const std::string entry : {"set Pressure = 450MPa",
                                  "set Velocity = 100m/min",
                                  "set Temperature = 300degC",
                                  "set File = maps/blasted_tool.x3p",
                                  "set Output directory = output/blasted_tool"})
    EXPECT_NE(text.find(entry), std::string::npos) << entry;

  const Result checked = run("check blasted_tool.prm");
  EXPECT_EQ(checked.status, 0) << checked.errors;
  // A blasted surface has hills, for which ridges stand; nothing else is wrong.
  const std::size_t warning = checked.output.find("Warning: ");
  EXPECT_EQ(checked.output.find(
              "Warning: Tool surface: its texture aspect ratio"),
            warning)
    << checked.output;
  EXPECT_EQ(checked.output.find("Warning", warning + 1), std::string::npos)
    << checked.output;

  // The same scene on a coarse mesh over a short way, for time.
  write("short.prm",
        "include blasted_tool.prm\n"
        "subsection Mesh\n  set Spans = 112\n  set Refinement levels = 2\nend\n"
        "subsection Protocol\n  set Ramp steps = 8\n"
        "  set Steady step = 100 nm\nend\n");
  const Result sliding = run("short.prm");
  EXPECT_EQ(sliding.status, 0) << sliding.errors;
  const auto at = sliding.output.rfind("mu = ");
  ASSERT_NE(at, std::string::npos) << sliding.output;
  // more than nothing, less than the slopes of the tool allow
  const double mu = std::stod(sliding.output.substr(at + 5));
  EXPECT_GT(mu, 0.03);
  EXPECT_LT(mu, 0.3);
  const std::string summary = read("output/blasted_tool/summary.json");
  for (const std::string key : {"\"Sal\": ", "\"Str\": 0."})
    EXPECT_NE(summary.find(key), std::string::npos) << key;
}

TEST_F(NewScene, a_file_that_is_there_stays)
{
  write("polished_tool.prm", "mine");
  EXPECT_EQ(refusal(surfaces + "polished_tool.x3p"),
            "Error: The file 'polished_tool.prm' is here already and is not "
            "overwritten; rename or remove it, or start in another folder.\n");
  EXPECT_EQ(read("polished_tool.prm"), "mine");
}

TEST_F(NewScene, oil_goes_into_the_void_by_the_model_of_the_audit)
{
  write("map.txt", matrix());
  const Result made = run("new map.txt --spacing 0.5um --unit um --oil 0.6");
  ASSERT_EQ(made.status, 0) << made.errors;
  EXPECT_NE(made.output.find("oil in 60 % of the void"), std::string::npos);
  EXPECT_NE(made.output.find("as the audit chooses"), std::string::npos);
  const std::string text = read("map.prm");
  EXPECT_NE(text.find("set Model = automatic"), std::string::npos);
  EXPECT_NE(text.find("set Wetting = 0.6"), std::string::npos);
  EXPECT_NE(text.find("set Spacing x = 0.5 um"), std::string::npos);
  EXPECT_NE(text.find("set Height unit = um"), std::string::npos);
  const Result checked = run("check map.prm");
  EXPECT_EQ(checked.status, 0) << checked.errors;

  std::filesystem::remove(folder / "map.prm");
  const Result dry = run("new map.txt --spacing 0.5um --unit um --oil 0");
  ASSERT_EQ(dry.status, 0) << dry.errors;
  EXPECT_NE(read("map.prm").find("set Model = none"), std::string::npos);
}

TEST_F(NewScene, a_text_without_units_asks_for_the_options)
{
  write("map.txt", matrix());
  for (const std::string options : {"", " --unit um", " --spacing 0.5um"})
    EXPECT_NE(refusal("map.txt" + options)
                .find("'asperity new' takes them as --spacing 0.5um and "
                      "--unit um."),
              std::string::npos)
      << options;
  EXPECT_FALSE(std::filesystem::exists(folder / "map.prm"));
}

TEST_F(NewScene, the_name_of_the_map_may_hold_what_means_something_in_a_file)
{
  for (const std::string name : {"tool #1", "#1 \"tool\"", "tool#1"})
    {
      write(name + ".txt", matrix());
      const std::string map = "'" + name + ".txt'";
      EXPECT_EQ(run("new " + map + " --spacing 0.5um --unit um").status, 0);
      EXPECT_EQ(run("check '" + name + ".prm'").status, 0) << name;
    }
  write("two\nlines.txt", matrix());
  EXPECT_NE(refusal("'two\nlines.txt' --spacing 0.5um --unit um")
              .find("has a line break, which a parameter file cannot hold"),
            std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "two\nlines.prm"));
}

TEST_F(NewScene, wrong_command_lines_are_refused)
{
  const std::string map = surfaces + "polished_tool.x3p";
  EXPECT_EQ(refusal(""),
            "Error: 'asperity new' takes one height map, as in 'asperity new "
            "tool.x3p -p 300MPa -v 100m/min -T 300degC'.\n");
  EXPECT_NE(refusal(map + " -q 3").find("'asperity new' has no option '-q'"),
            std::string::npos);
  EXPECT_NE(refusal(map + " -p 300")
              .find("Error: Option '-p', entry 'Load/Pressure': "),
            std::string::npos);
  EXPECT_NE(refusal(map + " -v -3m/min")
              .find("Error: Option '-v', entry 'Load/Velocity': "),
            std::string::npos);
  EXPECT_NE(refusal(map + " --oil 1.5")
              .find("Error: Option '--oil', entry 'Lubrication/Wetting': "),
            std::string::npos);
  EXPECT_NE(refusal(map + " --spacing 0um").find("Error: Option '--spacing'"),
            std::string::npos);
  EXPECT_NE(refusal("none.x3p").find("none.x3p"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder / "polished_tool.prm"));
}

TEST_F(NewScene, measured_maps_become_valid_scenes)
{
  if (!std::filesystem::exists(measured))
    GTEST_SKIP() << measured << " is not here";
  for (const std::string name :
       {"alicona_al3d-1.al3d", "wire_cut_aluminium.x3p"})
    {
      const Result made = run("new " + measured + name);
      ASSERT_EQ(made.status, 0) << name << made.errors;
      const std::string prm     = name.substr(0, name.rfind('.')) + ".prm";
      const Result      checked = run("check " + prm);
      EXPECT_EQ(checked.status, 0) << name << checked.errors;
    }
  for (const auto &entry :
       std::filesystem::directory_iterator(measured + "format_fixtures"))
    refusal(entry.path().string());
}
