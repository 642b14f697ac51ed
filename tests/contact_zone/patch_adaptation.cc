#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scene_examples.h"

using namespace asperity;

// Meshes that change in three dimensions. Expected values are the plane and
// the mesh that is fine everywhere.

namespace
{
  using PatchRun = CompleteRunIn<3>;

  /** One ridge, one of whose levels is at its contact only. */
  SceneParameters
  ridge()
  {
    SceneParameters parameters      = narrow_scene();
    parameters.mesh.spans           = 48;
    parameters.mesh.adaptive_levels = 1;
    parameters.mesh.degree          = 1;
    parameters.mesh.grading         = 4.;
    parameters.mesh.remesh_distance = 0.1e-6;
    parameters.geometry.width       = 1. / 12. * parameters.geometry.length;
    parameters.tool.wave_numbers    = {1.};
    parameters.tool.amplitudes      = {0.15e-6};
    parameters.tool.phases          = {0.4};
    parameters.load.pressure        = 100e6;
    return parameters;
  }

  /** Hills over a coarse chip, of which a level is at their contacts only. */
  SceneParameters
  hills()
  {
    SceneParameters parameters      = ridge();
    parameters.mesh.spans           = 32;
    parameters.mesh.remesh_distance = 0.2e-6;
    parameters.geometry.width       = parameters.geometry.length;
    parameters.tool.wave_numbers    = {1., 1.};
    parameters.tool.across          = {1., -1.};
    parameters.tool.amplitudes      = {0.15e-6, 0.15e-6};
    parameters.tool.phases          = {0.4, 0.4};
    parameters.tool.spans           = std::nullopt;
    return parameters;
  }
} // namespace



// What touches is the same along y, and so are the cells beside it.
TEST(PatchAdaptation,
     extruded_tool_has_the_meshes_and_the_friction_of_the_plane)
{
  SceneParameters        parameters = ridge();
  std::set<unsigned int> columns;
  const auto             count = [&](const SlidingRun<2> &run) {
    columns.insert(run.state().coverage.size());
  };
  const PatchRun patch(parameters);
  parameters.geometry.dimension = 2;
  const CompleteRun plane(parameters, count);
  EXPECT_GT(columns.size(), 2u); // the mesh has changed on the way, too
  const RemeshReport &a = patch.run.state().remeshing,
                     &b = plane.run.state().remeshing;
  EXPECT_EQ(a.remeshes, b.remeshes);
  EXPECT_LT(plane.run.mean_unknowns(), 0.8 * 49 * 2 * 4);
  ASSERT_EQ(patch.rows().size(), plane.rows().size());
  for (std::size_t i = 1; i < plane.rows().size(); ++i)
    {
      EXPECT_NEAR(patch.rows()[i].mu,
                  plane.rows()[i].mu,
                  1e-6 * std::abs(plane.rows()[i].mu))
        << "step " << i;
      EXPECT_NEAR(patch.rows()[i].max_plastic_strain,
                  plane.rows()[i].max_plastic_strain,
                  1e-5 * plane.rows()[i].max_plastic_strain);
    }
  EXPECT_NEAR(a.plastic_work / patch.scene.width,
              b.plastic_work,
              1e-5 * b.plastic_work);
  EXPECT_GT(plane.run.friction().mu, 0.01);
}



// The first change refines everything: nothing is worked before it.
TEST(PatchAdaptation, that_refines_all_at_once_gives_the_same_steps)
{
  SceneParameters parameters      = hills();
  parameters.mesh.spans           = 16;
  parameters.mesh.remesh_distance = parameters.geometry.length;
  const PatchRun adaptive(parameters);
  parameters.mesh.adaptive_levels = 0;
  const PatchRun even(parameters);
  ASSERT_EQ(adaptive.run.state().remeshing.remeshes, 1u);
  ASSERT_EQ(adaptive.scene.space->n_cells(), even.scene.space->n_cells());
  for (std::size_t i = 0; i < even.rows().size(); ++i)
    EXPECT_NEAR(adaptive.rows()[i].T_x, even.rows()[i].T_x, 1e-7 * even.load());
}



TEST(PatchAdaptation, follows_hills_and_loses_no_plastic_work)
{
  SceneParameters parameters = hills();
  const PatchRun  adaptive(parameters);
  const auto     &report = adaptive.run.state().remeshing;
  EXPECT_GE(report.remeshes, 2u);
  EXPECT_EQ(report.strain_excess, 0.);
  EXPECT_LE(std::abs(report.work_drift()), 1e-4);
  EXPECT_LE(report.change, 2e-3);
  EXPECT_GT(report.plastic_work, 0.);
  EXPECT_EQ(report.bounded, 0u);
  EXPECT_EQ(adaptive.run.coarser_meshes(), "");
  parameters.mesh.adaptive_levels = 0;
  const PatchRun even(parameters);
  const double   mu = even.run.friction().mu;
  EXPECT_NEAR(adaptive.run.friction().mu, mu, 0.005 * mu);
  EXPECT_LT(adaptive.run.mean_unknowns(), 0.9 * even.run.mean_unknowns());
}



TEST(PatchAdaptation, has_no_more_unknowns_than_it_may)
{
  SceneParameters parameters    = hills();
  parameters.mesh.most_unknowns = 3500;
  const PatchRun      run(parameters);
  const RemeshReport &report = run.run.state().remeshing;
  EXPECT_LE(report.most_unknowns, 3500u);
  EXPECT_GT(report.bounded, 0u);
  EXPECT_EQ(run.run.coarser_meshes().find(
              "The contacts want finer meshes than the 3500 unknowns of "
              "Mesh/Most unknowns make: "),
            0u);
  for (const FrictionRow &row : run.rows())
    EXPECT_NEAR(row.T_y,
                -run.run.protocol().pressure(row.time) * run.scene.length,
                1e-7 * run.load());
}
