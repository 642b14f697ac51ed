#include <asperity/base/errors.h>
#include <asperity/campaign/choice_indices.h>
#include <asperity/campaign/scene_sensitivity.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "../files.h"

using namespace asperity;

namespace
{
  /** A flat chip on a flat tool, which slides with mu_0 whatever else is said
   *  of it. */
  const std::string flat_scene = R"(
subsection Tool
  set Kind = flat
end
subsection Mesh
  set Spans             = 16
  set Refinement levels = 0
end
subsection Load
  set Pressure = 100 MPa
end
subsection Protocol
  set Inertia     = quasi-static
  set Ramp steps  = 3
  set Slide steps = 4
end
subsection Interface
  set Shear law            = Coulomb
  set Friction coefficient = 0.3
end
subsection Solver
  set Tolerance = 1e-10
end
)";

  class SceneSensitivityTest : public testing::Test
  {
  protected:
    void
    SetUp() override
    {
      path = test_folder() + "/scene.prm";
    }

    std::string
    file(const std::string &text)
    {
      overwrite(path, text);
      return path;
    }

    std::set<std::string>
    entries(const std::string &text)
    {
      std::set<std::string> result;
      for (const Variation &variation : variations_of(SceneInput(file(text))))
        result.insert(variation.entry);
      return result;
    }

    std::string path;
  };
} // namespace

TEST(SpreadOfScene, adds_the_largest_changes_by_their_squares)
{
  SceneSensitivity s;
  s.mu      = 0.2;
  s.results = {{{"a", "1", ChoiceKind::scene}, 0.26, ""},
               {{"a", "2", ChoiceKind::scene}, 0.21, ""},
               {{"b", "1", ChoiceKind::scene}, 0.28, ""},
               {{"b", "2", ChoiceKind::scene}, 0.19, ""},
               {{"c", "1", ChoiceKind::constants}, 0.08, ""},
               {{"d", "1", ChoiceKind::scene}, 0., "it failed"}};
  EXPECT_NEAR(s.effect("a"), 0.3, 1e-12);
  EXPECT_EQ(s.effect("d"), 0.);
  EXPECT_NEAR(s.spread(ChoiceKind::scene).above, 0.5, 1e-12); // 0.3, 0.4
  EXPECT_NEAR(s.spread(ChoiceKind::scene).below, 0.05, 1e-12);
  EXPECT_NEAR(s.spread().below, std::hypot(0.05, 0.6), 1e-12);
  EXPECT_EQ(s.spread(ChoiceKind::profile).above, 0.);
  std::ostringstream text;
  print_sensitivity(s, text);
  EXPECT_NE(text.str().find("d = 1  no mu: it failed"), std::string::npos);
  EXPECT_NE(text.str().find("scene: -5.0 % +50.0 %, mu = 0.19 to 0.3"),
            std::string::npos);
}

TEST_F(SceneSensitivityTest, varies_what_counts_in_the_scene)
{
  const std::set<std::string> of_flat = entries(flat_scene);
  EXPECT_EQ(of_flat.count("Interface/Friction coefficient"), 1u);
  EXPECT_EQ(of_flat.count("Protocol/End time"), 1u);
  EXPECT_EQ(of_flat.count("Interface/Shear factor"), 0u);
  EXPECT_EQ(of_flat.count("Lubrication/Wetting"), 0u);
  EXPECT_EQ(of_flat.count("Tool/Topography/S-filter nesting index"), 0u);

  const std::set<std::string> of_elastic =
    entries(flat_scene + "subsection Material\n set Law = neo-Hooke\nend\n");
  EXPECT_EQ(of_elastic.count("Load/Plastic strain"), 0u);
  EXPECT_EQ(of_elastic.count("Material/Young's modulus"), 1u);

  const std::string measured =
    std::string("include ") + ASPERITY_SOURCE_DIR +
    "/parameter_files/friction_law/sheared_oily_contact.prm\n";
  const std::vector<Variation> all = variations_of(SceneInput(file(measured)));
  EXPECT_LE(all.size(), 39u);
  const std::set<std::string> of_measured = entries(measured);
  for (const std::string entry : {"Tool/Topography/S-filter nesting index",
                                  "Tool/Topography/Profile position",
                                  "Tool/Topography/Profile length",
                                  "Protocol/Sliding distance",
                                  "Geometry/Chip height",
                                  "Load/Plastic strain",
                                  "Lubrication/Wetting",
                                  "Interface/Shear factor",
                                  "Material/Johnson-Cook/A"})
    EXPECT_EQ(of_measured.count(entry), 1u) << entry;
  // Every one of them is a scene.
  for (const Variation &variation : all)
    {
      EntryValues changes = variation.also;
      changes.emplace_back(variation.entry, variation.value);
      EXPECT_NO_THROW(SceneInput(path, changes)) << variation.entry;
    }
}

// Of a flat chip that slides by Coulomb's law nothing counts but mu_0.
TEST_F(SceneSensitivityTest, finds_the_entry_that_counts)
{
  file(flat_scene);
  const std::vector<Variation> all  = variations_of(SceneInput(path));
  std::size_t                  told = 0;
  const SceneSensitivity       s =
    compute_sensitivity(path, all, [&](std::size_t done, std::size_t) {
      told = done;
    });
  EXPECT_EQ(told, all.size() + 1);
  EXPECT_NEAR(s.mu, 0.3, 1e-7);
  EXPECT_EQ(s.results.front().variation.entry,
            "Interface/Friction coefficient");
  for (const VariationResult &result : s.results)
    {
      EXPECT_EQ(result.reason, "");
      if (result.variation.entry != "Interface/Friction coefficient")
        {
          EXPECT_NEAR(result.mu, 0.3, 1e-7) << result.variation.entry;
        }
    }
  EXPECT_NEAR(s.spread(ChoiceKind::constants).above, 0.1, 1e-6);
  EXPECT_NEAR(s.spread(ChoiceKind::constants).below, 0.1, 1e-6);
  EXPECT_NEAR(s.spread(ChoiceKind::scene).above, 0., 1e-6);
}

TEST_F(SceneSensitivityTest, tells_which_variation_fails)
{
  file(flat_scene);
  const SceneSensitivity s =
    compute_sensitivity(path, {{"Mesh/Spans", "17"}, {"Mesh/Spans", "no"}}, {});
  ASSERT_EQ(s.results.size(), 2u);
  EXPECT_EQ(s.results[0].reason, "");
  EXPECT_NE(s.results[1].reason.find("Mesh/Spans"), std::string::npos);
  const std::string frictionless =
    flat_scene + "subsection Interface\n set Shear law = none\nend\n";
  EXPECT_THROW(compute_sensitivity(file(frictionless), {}, {}),
               ComputationError);
  EXPECT_THROW(compute_sensitivity(
                 file("subsection Load\n set Pressure = no\nend\n"), {}, {}),
               ComputationError);
}

TEST_F(SceneSensitivityTest, takes_ranges_from_what_gave_a_mu)
{
  const SceneInput input(file(flat_scene));
  SceneSensitivity s;
  s.mu      = 0.3;
  s.results = {
    {{"Geometry/Chip height", "40 um", ChoiceKind::scene}, 0.9, ""},
    {{"Geometry/Chip height", "80 um", ChoiceKind::scene}, 0., "it failed"},
    {{"Protocol/End time",
      "1 us",
      ChoiceKind::scene,
      {{"Protocol/Slide steps", "16"}}},
     0.6,
     ""},
    {{"Interface/Friction coefficient", "0.33", ChoiceKind::constants},
     0.33,
     ""}};
  const auto ranges = ranges_of_choices(s, input, 2);
  ASSERT_EQ(ranges.size(), 2u);
  EXPECT_EQ(ranges[0].entry, "Geometry/Chip height");
  EXPECT_NEAR(ranges[0].upper, 40e-6, 1e-18);
  EXPECT_NEAR(ranges[0].lower, input.parameters.geometry.height, 1e-18);
  // The scene has 0.25 us in 4 steps.
  const double      middle[] = {1., 0.5};
  const EntryValues changes  = choice_at(ranges, middle);
  ASSERT_EQ(changes.size(), 3u);
  EXPECT_EQ(changes[0].second, "40 um");
  EXPECT_EQ(changes[1],
            EntryValues::value_type("Protocol/End time", "0.625 us"));
  EXPECT_EQ(changes[2], EntryValues::value_type("Protocol/Slide steps", "10"));
}

// mu = mu_0 whatever the chip's height: all of the variance is of mu_0, and 95
// % of it, evenly between 0.27 and 0.33, lie within 0.2715 and 0.3285.
TEST_F(SceneSensitivityTest, indices_blame_what_counts)
{
  file(flat_scene);
  const auto range = [](const std::string &entry,
                        const std::string &unit,
                        const std::string &lower,
                        const std::string &upper) {
    return ChoiceRange{entry,
                       unit,
                       0.,
                       0.,
                       {entry, lower, ChoiceKind::scene},
                       {entry, upper, ChoiceKind::scene}};
  };
  const ChoiceIndices indices = compute_indices(
    path,
    {range("Geometry/Chip height", "um", "4 um", "8 um"),
     range("Interface/Friction coefficient", "1", "0.27", "0.33")},
    12,
    {});
  EXPECT_EQ(indices.n_runs, 12u);
  EXPECT_NEAR(indices.indices[0].ST, 0., 0.01);
  EXPECT_NEAR(indices.indices[1].S1, 1., 0.02);
  EXPECT_LT(indices.error, 1e-3);
  EXPECT_NEAR(indices.lower, 0.2715, 3e-4);
  EXPECT_NEAR(indices.median, 0.3, 3e-4);
  EXPECT_NEAR(indices.upper, 0.3285, 3e-4);
  std::ostringstream text;
  print_indices(indices, text);
  EXPECT_NE(text.str().find(
              "1.00         1.00  Interface/Friction coefficient from 0.27 to "
              "0.33"),
            std::string::npos)
    << text.str();
  EXPECT_THROW(
    compute_indices(path, {range("Mesh/Spans", "1", "no", "no")}, 12, {}),
    InputError);
}

// What laws are told of it, see Friction law/Sensitivity file.
TEST_F(SceneSensitivityTest, writes_spreads_that_are_read_again)
{
  SceneSensitivity s;
  s.mu      = 0.5;
  s.results = {
    {{"Geometry/Chip height", "40 um", ChoiceKind::scene}, 0.6, ""},
    {{"Tool/Topography/Profile length", "1 um", ChoiceKind::preparation},
     0.4,
     ""}};
  const std::string folder = test_folder() + "/spreads";
  write_sensitivity(s, {}, folder);
  const auto choices = read_spreads(folder + "/sensitivity.json");
  ASSERT_EQ(choices.size(), 2u);
  EXPECT_EQ(choices[0].kind, "preparation");
  EXPECT_NEAR(choices[0].below, 0.2, 1e-12);
  EXPECT_EQ(choices[0].above, 0.);
  EXPECT_EQ(choices[1].kind, "scene");
  EXPECT_NEAR(choices[1].above, 0.2, 1e-12);

  overwrite(path, R"({"spread": {"preparation": {"below": -1, "above": 0}}})");
  try
    {
      read_spreads(path);
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_EQ(std::string(error.what()),
                path + ": no number that is not negative stands at "
                       "'/spread/preparation/below'; expected the "
                       "sensitivity.json that 'asperity sensitivity' writes.");
    }
  EXPECT_THROW(read_spreads(path + ".missing"), InputError);
}
