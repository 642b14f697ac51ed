#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_input.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

#include "scene_examples.h"

using namespace asperity;

namespace
{
  /** A scene by its entries; all of them are set. */
  struct GivenScene
  {
    explicit GivenScene(const EntryValues &values)
      : declarator(handler)
    {
      parameters.declare(declarator);
      std::ostringstream defaults;
      declarator.write_prm(defaults);
      declarator.read_text(defaults.str(), "complete.prm");
      const EntryValues coarse = {{"Mesh/Spans", "40"},
                                  {"Mesh/Refinement levels", "1"},
                                  {"Protocol/Ramp steps", "3"},
                                  {"Protocol/Slide steps", "4"},
                                  {"Protocol/Inertia", "quasi-static"}};
      for (const EntryValues &list : {coarse, values})
        for (const auto &[path, value] : list)
          declarator.set(path, value);
    }

    std::vector<std::string>
    unused() const
    {
      std::vector<std::string> paths;
      for (const UnusedEntry &entry : unused_entries(parameters, declarator))
        paths.push_back(entry.path);
      return paths;
    }

    /** T_x of all steps. */
    std::vector<double>
    forces()
    {
      parameters.check(declarator);
      parameters.resolve();
      const CompleteRun   run(parameters);
      std::vector<double> T_x;
      for (const FrictionRow &row : run.rows())
        T_x.push_back(row.T_x);
      return T_x;
    }

    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator;
    SceneParameters          parameters;
  };

  /** Another value of an entry, if one is found. */
  bool
  change(ParameterDeclarator &declarator, const ParameterEntry &entry)
  {
    const std::string        path = entry.path(), old = entry.value;
    std::vector<std::string> candidates = {"true", "false", "0", "10", "1 um"};
    char                    *end        = nullptr;
    const double             number     = std::strtod(old.c_str(), &end);
    for (const double factor : {0.9, 1.2, 2.})
      candidates.insert(candidates.begin(),
                        std::to_string(factor * number) + end);
    const auto colon = entry.kind.find(": ");
    if (entry.kind.rfind("choice", 0) == 0)
      {
        candidates.clear();
        std::istringstream choices(entry.kind.substr(colon + 2));
        for (std::string choice; std::getline(choices, choice, ',');)
          candidates.push_back(choice.substr(choice.find_first_not_of(' ')));
      }
    for (const std::string &candidate : candidates)
      try
        {
          declarator.set(path, candidate);
          if (declarator.get(path) != old)
            return true;
        }
      catch (const InputError &)
        {}
    declarator.set(path, old);
    return false;
  }

  const EntryValues dry = {}, pocket = {{"Lubrication/Model", "pocket"}},
                    film      = {{"Lubrication/Model", "Reynolds"},
                                 {"Lubrication/Oil amount", "film thickness"},
                                 {"Lubricant/Temperature law", "Vogel"}},
                    elastic   = {{"Material/Law", "neo-Hooke"},
                                 {"Contact/Penalty", "1e19 Pa/m"}},
                    two_waves = {{"Chip surface/Kind", "harmonics"},
                                 {"Chip surface/Wave numbers", "2"},
                                 {"Chip surface/Amplitudes", "0.02 um"},
                                 {"Chip surface/Phases", "1 rad"},
                                 {"Material/Law", "Voce"},
                                 {"Material/Adiabatic heating", "false"},
                                 {"Mesh/Refinement levels", "0"}},
                    warm      = {{"Heat/Model", "conducting"}},
                    warm_oil  = {{"Heat/Model", "conducting"},
                                 {"Lubrication/Model", "pocket"},
                                 {"Heat/Tool temperature", "100 degC"}},
                    cold      = {{"Heat/Model", "isothermal"}},
                    patch     = {{"Geometry/Dimension", "3"},
                                 {"Chip surface/Kind", "harmonics"}};
} // namespace

TEST(UnusedEntries, have_no_influence_on_the_forces)
{
  for (const EntryValues &values :
       {dry, pocket, film, elastic, two_waves, warm, cold})
    {
      GivenScene   scene(values), changed(values);
      unsigned int n = 0;
      for (const std::string &path : scene.unused())
        for (const ParameterEntry &entry : changed.declarator.entries())
          if (entry.path() == path)
            n += change(changed.declarator, entry) ? 1 : 0;
      EXPECT_GT(n, 30u);
      EXPECT_EQ(scene.forces(), changed.forces()) << scene.unused().front();
    }
}

TEST(UnusedEntries, of_every_subsection_are_used_somewhere)
{
  const std::vector<EntryValues> scenes = {
    dry,
    pocket,
    film,
    elastic,
    two_waves,
    warm_oil,
    patch,
    {{"Mesh/Adaptive levels", "1"}},
    {{"Lubrication/Model", "Navier-Stokes"},
     {"Flow/Mesh update", "elastic"},
     {"Flow/Boundary left", "resistance"},
     {"Flow/Boundary right", "resistance"},
     {"Protocol/Inertia", "dynamic"},
     {"Lubricant/Shear law", "Carreau"},
     {"Lubricant/Pressure law", "Barus"},
     {"Lubricant/Temperature law", "Roelands"}},
    {{"Lubrication/Model", "Stokes"},
     {"Lubrication/Sealing gap", "20 nm"},
     {"Interface/Shear law", "limited Coulomb"},
     {"Lubricant/Pressure law", "Roelands"},
     {"Protocol/Friction window", "steady"},
     {"Contact/Augmentations", "2"},
     {"Accuracy/Control", "adaptive"},
     {"Tool/Kind", "measured"},
     {"Tool/Topography/Crop", "window"},
     {"Tool/Topography/F-operator", "polynomial"},
     {"Chip surface/Kind", "measured"},
     {"Chip surface/Topography/Crop", "window"},
     {"Chip surface/Topography/F-operator", "polynomial"}}};
  std::set<std::string> always_unused;
  const GivenScene      all(dry);
  for (const ParameterEntry &entry : all.declarator.entries())
    always_unused.insert(entry.path());
  for (const EntryValues &values : scenes)
    {
      const auto            unused = GivenScene(values).unused();
      std::set<std::string> remaining;
      for (const std::string &path : unused)
        if (always_unused.count(path) != 0)
          remaining.insert(path);
      always_unused = remaining;
    }
  EXPECT_TRUE(always_unused.empty()) << *always_unused.begin();
}

TEST(UnusedEntries, of_each_model_are_those_that_it_does_not_read)
{
  const auto is_unused = [](const EntryValues &values,
                            const std::string &path) {
    const auto list = GivenScene(values).unused();
    return std::find(list.begin(), list.end(), path) != list.end();
  };
  const EntryValues stokes = {{"Lubrication/Model", "Stokes"}};
  EXPECT_TRUE(is_unused(stokes, "Lubricant/Density law"));
  EXPECT_FALSE(
    is_unused({{"Lubrication/Model", "Stokes"}, {"Flow/Compressible", "true"}},
              "Lubricant/Density law"));
  EXPECT_TRUE(
    is_unused({{"Lubrication/Model", "none"}, {"Flow/Compressible", "true"}},
              "Flow/Compressible"));
  EXPECT_FALSE(is_unused(stokes, "Lubrication/Sealing gap"));
  EXPECT_FALSE(is_unused(stokes, "Lubrication/Residual film"));
  EXPECT_TRUE(is_unused({{"Lubrication/Model", "Stokes"},
                         {"Lubrication/Sealing gap", "20 nm"}},
                        "Lubrication/Residual film"));
  const EntryValues open = {{"Lubrication/Model", "Stokes"},
                            {"Flow/Boundary left", "pressure"},
                            {"Flow/Boundary right", "resistance"}};
  EXPECT_TRUE(is_unused(stokes, "Flow/Pressure left"));
  EXPECT_FALSE(is_unused(open, "Flow/Pressure left"));
  EXPECT_TRUE(is_unused(open, "Flow/Resistance left"));
  EXPECT_FALSE(is_unused(open, "Flow/Resistance right"));
  EXPECT_TRUE(is_unused(dry, "Lubrication/Sealing gap"));
  EXPECT_FALSE(is_unused(stokes, "Lubricant/Viscosity"));
  EXPECT_FALSE(is_unused(stokes, "Film mesh/Rows"));
  EXPECT_TRUE(is_unused(pocket, "Lubricant/Viscosity"));
  EXPECT_TRUE(is_unused(pocket, "Film mesh/Rows"));
  EXPECT_FALSE(is_unused(pocket, "Lubricant/Density law"));
  EXPECT_FALSE(is_unused(pocket, "Lubrication/Sealing gap"));
  EXPECT_TRUE(is_unused(pocket, "Lubrication/Oil film"));
  EXPECT_TRUE(is_unused(film, "Lubrication/Wetting"));
  EXPECT_TRUE(is_unused(film, "Solver/Linear solver"));
  EXPECT_TRUE(is_unused(dry, "Lubricant/Temperature law"));
  EXPECT_TRUE(is_unused(elastic, "Load/Temperature"));
  EXPECT_TRUE(is_unused(elastic, "Load/Plastic strain"));
  EXPECT_FALSE(is_unused(dry, "Load/Temperature"));
  EXPECT_TRUE(is_unused(dry, "Tool/Topography/File"));
  EXPECT_FALSE(is_unused(dry, "Tool/Topography/Scale z"));
  EXPECT_TRUE(is_unused(dry, "Chip surface/Topography/Scale z"));

  EXPECT_TRUE(is_unused(dry, "Heat/Tool density"));
  EXPECT_FALSE(is_unused(warm, "Heat/Tool density"));
  EXPECT_TRUE(is_unused(warm, "Heat/Oil conductivity"));
  EXPECT_FALSE(is_unused(warm_oil, "Heat/Oil conductivity"));
  EXPECT_TRUE(is_unused(cold, "Material/Adiabatic heating"));
  EXPECT_TRUE(is_unused(cold, "Material/Heat capacity"));
  EXPECT_FALSE(is_unused(warm, "Material/Heat capacity"));

  // Any of them may be chosen.
  EXPECT_FALSE(
    is_unused({{"Lubrication/Model", "automatic"}}, "Lubricant/Density law"));
}

TEST(UnusedEntries, are_those_that_are_set)
{
  dealii::ParameterHandler handler;
  ParameterDeclarator      declarator(handler);
  SceneParameters          parameters;
  parameters.declare(declarator);
  EXPECT_TRUE(unused_entries(parameters, declarator).empty());
  declarator.set("Lubricant/Bulk modulus", "2 GPa");
  const auto unused = unused_entries(parameters, declarator);
  ASSERT_EQ(unused.size(), 1u);
  EXPECT_EQ(unused[0].path, "Lubricant/Bulk modulus");
  EXPECT_EQ(unused[0].counts_with, "a lubricant model other than none");
}
