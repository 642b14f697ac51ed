#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_input.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scene_examples.h"

using namespace asperity;

namespace
{
  /** Three levels, of which the finest two may be at contacts only. */
  SceneParameters
  refined_scene()
  {
    SceneParameters parameters      = coarse_scene();
    parameters.mesh.spans           = 128;
    parameters.mesh.refinement      = 3;
    parameters.mesh.strip           = 0.1e-6;
    parameters.protocol.ramp_steps  = 8;
    parameters.protocol.slide_steps = 24;
    return parameters;
  }
} // namespace

// What is far from contacts is smooth, and plasticity is where they are.
TEST(MeshAdaptation, gives_the_mu_of_the_mesh_that_is_fine_everywhere)
{
  SceneParameters   parameters = refined_scene();
  const CompleteRun everywhere(parameters);
  parameters.mesh.adaptive_levels = 2;
  const CompleteRun adaptive(parameters);
  const double      mu = everywhere.run.friction().mu;
  EXPECT_NEAR(adaptive.run.friction().mu, mu, 0.005 * mu);
  EXPECT_LT(adaptive.run.mean_unknowns(), 0.7 * everywhere.run.mean_unknowns());
  for (const FrictionRow &row : adaptive.rows())
    EXPECT_NEAR(row.T_y,
                -adaptive.run.protocol().pressure(row.time) *
                  adaptive.scene.length,
                1e-3 * adaptive.load());
}

TEST(MeshAdaptation, moves_with_the_contacts_and_loses_no_plastic_work)
{
  SceneParameters parameters        = refined_scene();
  parameters.mesh.adaptive_levels   = 2;
  parameters.mesh.remesh_distance   = 0.03e-6;
  parameters.protocol.end_time      = 13e-7;
  parameters.protocol.ramp_fraction = 1. / 13.;
  parameters.protocol.slide_steps   = 60;
  std::set<unsigned int> unknowns;
  Scene<2>               scene(parameters);
  SlidingRun<2>          run(parameters, scene);
  run.run([&](const SlidingRun<2> &) { unknowns.insert(scene.n_unknowns()); });
  const RemeshReport &report = run.state().remeshing;
  EXPECT_GE(report.remeshes, 8u);
  EXPECT_GT(unknowns.size(), 3u);
  EXPECT_EQ(report.most_unknowns, *unknowns.rbegin());
  EXPECT_EQ(report.strain_excess, 0.);
  EXPECT_LE(std::abs(report.work_drift()), 1e-4);
  EXPECT_LE(report.change, 2e-3);
  EXPECT_GT(report.plastic_work, 0.);
}

// The mesh is fine before anything is worked: nothing is to be transferred, and
// all steps but the first are those of the other run.
TEST(MeshAdaptation, that_refines_all_at_once_gives_the_same_steps)
{
  SceneParameters parameters  = coarse_scene();
  parameters.solver.tolerance = 1e-9;
  const CompleteRun everywhere(parameters);
  parameters.mesh.adaptive_levels = 1;
  parameters.mesh.remesh_distance = parameters.geometry.length;
  const CompleteRun adaptive(parameters);
  ASSERT_EQ(adaptive.run.state().remeshing.remeshes, 1u);
  ASSERT_EQ(adaptive.scene.space->n_cells(), everywhere.scene.space->n_cells());
  for (std::size_t i = 0; i < everywhere.rows().size(); ++i)
    EXPECT_NEAR(adaptive.rows()[i].T_x,
                everywhere.rows()[i].T_x,
                1e-7 * everywhere.load());
}

TEST(MeshAdaptation, has_no_more_unknowns_than_it_may)
{
  SceneParameters parameters      = refined_scene();
  parameters.mesh.adaptive_levels = 2;
  // Half as many more as the levels along the whole edge have.
  parameters.mesh.most_unknowns = 3 * Scene<2>(parameters).n_unknowns() / 2;
  const CompleteRun   run(parameters);
  const RemeshReport &report = run.run.state().remeshing;
  EXPECT_LE(report.most_unknowns, parameters.mesh.most_unknowns);
  EXPECT_GT(report.bounded, 0u);
  EXPECT_NE(run.run.coarser_meshes(), "");
}

// Half of the void full of oil, which the audit wants as a film.
TEST(MeshAdaptation, refuses_a_film_that_the_audit_chooses)
{
  SceneParameters parameters      = coarse_scene();
  parameters.mesh.adaptive_levels = 1;
  parameters.lubrication.model    = LubricantModel::automatic;
  parameters.lubrication.wetting  = 0.6;
  parameters.load.velocity        = 22.5 / 60.;
  ASSERT_EQ(audit_scene(parameters, Scene<2>(parameters)).lubricant,
            LubricantModel::reynolds);
  std::string message;
  try
    {
      const AuditedScene<2> scene(parameters, Ranks());
    }
  catch (const InputError &error)
    {
      message = error.what();
    }
  EXPECT_EQ(message,
            "Entry 'Mesh/Adaptive levels': found 1 with a scene for which the "
            "audit chooses the lubricant model `Reynolds`; expected 0, or "
            "Lubrication/Model = pocket or none.");
}

TEST(MeshAdaptation, refuses_what_would_not_go_over_to_another_mesh)
{
  const auto message = [](const EntryValues &entries) {
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    SceneParameters          parameters;
    parameters.declare(declarator);
    declarator.set("Mesh/Adaptive levels", "2");
    for (const auto &[path, value] : entries)
      declarator.set(path, value);
    try
      {
        parameters.check(declarator);
      }
    catch (const InputError &error)
      {
        return std::string(error.what());
      }
    return std::string();
  };
  EXPECT_EQ(message({}), "");
  const std::string found = "entry 'Mesh/Adaptive levels': found 2 with ";
  EXPECT_EQ(message({{"Mesh/Refinement levels", "1"}}),
            found +
              "1 Refinement levels; expected 0, or at most as many as those.");
  EXPECT_EQ(message({{"Lubrication/Model", "pocket"}}), "");
  EXPECT_EQ(message({{"Lubrication/Model", "Reynolds"}}),
            found + "the lubricant model `Reynolds`; expected 0, or "
                    "Lubrication/Model = pocket or none.");
  const std::vector<EntryValues> others = {{{"Chip surface/Kind", "harmonics"},
                                            {"Chip surface/Wave numbers", "2"},
                                            {"Chip surface/Amplitudes",
                                             "0.02 um"},
                                            {"Chip surface/Phases", "1 rad"}},
                                           {{"Protocol/Inertia", "dynamic"}},
                                           {{"Contact/Augmentations", "1"}}};
  for (const EntryValues &entries : others)
    EXPECT_EQ(message(entries).find(found), 0u) << message(entries);
}
