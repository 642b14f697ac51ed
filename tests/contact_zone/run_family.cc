#include <asperity/contact_zone/run_family.h>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "scene_examples.h"

using namespace asperity;

TEST(RunFamily, members_differ_in_one_thing_each)
{
  SceneParameters parameters           = coarse_scene();
  parameters.protocol.slide_steps      = 15;
  parameters.protocol.strain_increment = 0.1;
  const Scene<2> scene(parameters),
    coarse(with_fineness(parameters, {-1, 0, 0})),
    fine(with_fineness(parameters, {1, 0, 0})),
    soft(with_fineness(parameters, {0, 0, -1}));
  EXPECT_NEAR(coarse.contact_element_length(),
              2. * scene.contact_element_length(),
              1e-12 * scene.length);
  EXPECT_NEAR(fine.contact_element_length(),
              0.5 * scene.contact_element_length(),
              1e-12 * scene.length);
  EXPECT_NEAR(coarse.penalty(), scene.penalty(), 1e-12 * scene.penalty());
  EXPECT_NEAR(fine.penalty(), scene.penalty(), 1e-12 * scene.penalty());
  EXPECT_NEAR(soft.penalty(), 0.5 * scene.penalty(), 1e-12 * scene.penalty());
  EXPECT_EQ(soft.space->n_cells(), scene.space->n_cells());
  const ProtocolParameters longer =
    with_fineness(parameters, {0, -1, 0}).protocol;
  EXPECT_EQ(longer.slide_steps, 8u);
  EXPECT_EQ(longer.end_time, parameters.protocol.end_time);
  EXPECT_EQ(longer.steady_step, 2. * parameters.protocol.steady_step);
  EXPECT_EQ(longer.strain_increment, 0.2);
  EXPECT_EQ(with_fineness(parameters, {0, 2, 0}).protocol.ramp_steps, 20u);
  // A penalty that is given stays on any mesh.
  parameters.contact.penalty = 1e16;
  EXPECT_EQ(Scene<2>(with_fineness(parameters, {-1, 0, 0})).penalty(), 1e16);
  EXPECT_EQ(Scene<2>(with_fineness(parameters, {0, 0, -1})).penalty(), 5e15);
}

TEST(RunFamily, moves_the_surfaces_by_halves_of_an_element)
{
  SceneParameters parameters   = coarse_scene();
  parameters.chip.kind         = SurfaceKind::harmonics;
  parameters.chip.wave_numbers = {2};
  parameters.chip.amplitudes   = {0.03e-6};
  parameters.chip.phases       = {0.4};
  const Scene<2> scene(parameters);
  const double   h = scene.contact_element_length();
  for (const int mesh : {0, -1})
    {
      const Scene<2> moved(with_fineness(parameters, {mesh, 0, 0, 1}));
      const double   distance = mesh == 0 ? 0.5 * h : h;
      for (const double x : {0., 0.3 * h, 0.77 * scene.length})
        {
          EXPECT_NEAR(moved.tool_surface.height(x),
                      scene.tool_surface.height(x - distance),
                      1e-17);
          EXPECT_NEAR(moved.chip_surface.height(x),
                      scene.chip_surface.height(x - distance),
                      1e-17);
        }
    }
  // Elements that are moved stay where they are on other meshes.
  parameters.mesh.offset = 0.5;
  EXPECT_EQ(with_fineness(parameters, {-1, 0, 0}).mesh.offset, 0.25);
  EXPECT_EQ(with_fineness(parameters, {1, 0, 0}).mesh.offset, 1.);
}

TEST(RunFamily, members_of_a_patch_differ_across_too)
{
  SceneParameters parameters = narrow_scene();
  for (const auto &across :
       {std::optional<unsigned int>(), std::optional<unsigned int>(8)})
    {
      parameters.mesh.across = across;
      const Scene<3> scene(parameters);
      for (const int mesh : {-1, 1})
        {
          const SceneParameters other = with_fineness(parameters, {mesh, 0, 0});
          const Scene<3>        finer(other);
          const double          ratio = std::ldexp(1., mesh);
          EXPECT_EQ(other.mesh.n_spans_across(scene.length, scene.width),
                    ratio * (across ? 8 : 6));
          EXPECT_NEAR(finer.contact_element_length(),
                      scene.contact_element_length() / ratio,
                      1e-12 * scene.length);
          EXPECT_NEAR(finer.penalty(),
                      scene.penalty(),
                      1e-12 * scene.penalty());
        }
      EXPECT_FALSE(has_mesh(parameters, -2)); // of 4 spans
    }
  parameters.mesh.refinement = 0;
  EXPECT_TRUE(has_mesh(parameters, -1));
  for (const auto &across :
       {std::optional<unsigned int>(), std::optional<unsigned int>(9)})
    {
      parameters.mesh.across = across;
      EXPECT_FALSE(has_mesh(parameters, -1));
    }
}

// Contacts do not pass elements across the motion, so the other draw is moved
// across, too.
TEST(RunFamily, moves_sheets_by_halves_of_an_element_along_and_across)
{
  SceneParameters parameters   = narrow_scene();
  parameters.tool.across       = {0., 1., 0., -1., 2., 0.};
  parameters.tool.spans        = std::nullopt;
  parameters.chip.kind         = SurfaceKind::harmonics;
  parameters.chip.wave_numbers = {2};
  parameters.chip.across       = {1};
  parameters.chip.amplitudes   = {0.03e-6};
  parameters.chip.phases       = {0.4};
  const Scene<3> scene(parameters);
  for (const int mesh : {0, -1})
    {
      const Scene<3>         moved(with_fineness(parameters, {mesh, 0, 0, 1}));
      const double           part = mesh == 0 ? 0.5 : 1.;
      const dealii::Point<2> distance(part * scene.length / 16,
                                      part * scene.width / 6);
      for (const dealii::Point<2> &at :
           {dealii::Point<2>(0., 0.), dealii::Point<2>(0.3e-6, 3.1e-6)})
        {
          EXPECT_NEAR(moved.tool_surface.sheet.value(at + distance),
                      scene.tool_surface.sheet.value(at),
                      1e-17);
          EXPECT_NEAR(moved.chip_surface.sheet.value(at + distance),
                      scene.chip_surface.sheet.value(at),
                      1e-17);
        }
    }
}

// On a mesh of one level the scene is the same again after a whole element.
TEST(RunFamily, offsets_change_nothing_but_the_mesh)
{
  SceneParameters parameters      = coarse_scene();
  parameters.mesh.spans           = 20;
  parameters.mesh.refinement      = 0;
  parameters.protocol.ramp_steps  = 3;
  parameters.protocol.slide_steps = 2;
  parameters.solver.tolerance     = 1e-9;
  RunFamily    family(parameters);
  const double mu = family.run({}).mu;
  EXPECT_NEAR(family.run({0, 0, 0, 2}).mu, mu, 1e-6 * mu);
  EXPECT_GT(std::abs(family.run({0, 0, 0, 1}).mu - mu), 1e-4 * mu);
}

TEST(RunFamily, knows_which_meshes_there_are)
{
  // 40 spans, one level: 20, 10, but 5 is odd.
  const SceneParameters parameters = coarse_scene();
  EXPECT_TRUE(has_mesh(parameters, -2));
  EXPECT_FALSE(has_mesh(parameters, -3));
  // Five levels more make six, of which 40 2^5 spans need no more.
  EXPECT_TRUE(has_mesh(parameters, 5));
  EXPECT_FALSE(has_mesh(parameters, 6));
}

TEST(RunFamily, computes_each_run_once)
{
  SceneParameters parameters      = coarse_scene();
  parameters.protocol.ramp_steps  = 2;
  parameters.protocol.slide_steps = 2;
  unsigned int told               = 0;
  RunFamily    family(parameters, [&](const Fineness &) { ++told; });
  family.add({1, 0, 0}, {0.5, 10, 20});
  EXPECT_EQ(family.run({1, 0, 0}).mu, 0.5);
  EXPECT_EQ(told, 0u);
  const double mu = family.run({}).mu;
  EXPECT_EQ(family.run({}).mu, mu);
  EXPECT_EQ(told, 1u);
  EXPECT_EQ(mu, CompleteRun(parameters).run.friction().mu);
  // The costs are unknowns times Newton iterations.
  EXPECT_EQ(family.cost(),
            200. +
              1. * family.run({}).unknowns * family.run({}).newton_iterations);
  EXPECT_EQ(family.run({}).unknowns, Scene<2>(parameters).n_unknowns());
}
