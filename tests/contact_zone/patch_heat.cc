#include <asperity/contact_zone/scene_heat.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene_examples.h"

using namespace asperity;

// Heat of a patch that is conducted in the chip and into the tool. Expected
// values are those of the plane, the balance of heat, symmetries, and flat
// bodies.

namespace
{
  using PatchRun = CompleteRunIn<3>;

  /** Shear of half of the strength of the chip. */
  SceneParameters
  sheared(SceneParameters parameters)
  {
    parameters.interface.law          = InterfaceShear::shear_factor;
    parameters.interface.shear_factor = 0.5;
    return parameters;
  }

  /** Compares heat and temperatures of two rows.
   *  @param width of the first over that of the second
   *  @param start temperature of the chip [K] */
  void
  expect_heat(const FrictionRow &a,
              const FrictionRow &b,
              const double       width,
              const double       start)
  {
    const double heat =
      std::abs(b.plastic_heat) + b.friction_heat + std::abs(b.tool_heat);
    EXPECT_NEAR(a.mu, b.mu, 1e-6 * std::abs(b.mu)) << "step " << a.step;
    EXPECT_NEAR(a.flash_temperature,
                b.flash_temperature,
                1e-6 * (b.flash_temperature - start));
    EXPECT_NEAR(a.max_temperature,
                b.max_temperature,
                1e-5 * (b.max_temperature - start));
    EXPECT_NEAR(a.friction_heat * width, b.friction_heat, 1e-6 * heat);
    EXPECT_NEAR(a.plastic_heat * width, b.plastic_heat, 1e-6 * heat);
    EXPECT_NEAR(a.stored_heat * width, b.stored_heat, 1e-6 * heat);
    EXPECT_NEAR(a.depth_heat * width, b.depth_heat, 1e-6 * heat);
    EXPECT_NEAR(a.tool_heat * width, b.tool_heat, 1e-6 * heat);
    EXPECT_LT(a.heat_balance_error, 1e-9);
  }
} // namespace



namespace
{
  /** Runs a patch under a tool that is extruded along y, and its plane. */
  void
  expect_heat_of_plane(SceneParameters parameters)
  {
    const PatchRun patch(parameters);
    parameters.geometry.dimension = 2;
    const CompleteRun plane(parameters);
    ASSERT_EQ(patch.rows().size(), plane.rows().size());
    for (std::size_t i = 1; i < plane.rows().size(); ++i)
      expect_heat(patch.rows()[i],
                  plane.rows()[i],
                  1.,
                  parameters.load.temperature);
    const FrictionRow &last = plane.rows().back();
    EXPECT_NEAR(share_of_tool(patch.rows(), 0., last.time).value(),
                share_of_tool(plane.rows(), 0., last.time).value(),
                1e-6);
    EXPECT_GT(last.flash_temperature, parameters.load.temperature + 5.);
    EXPECT_NEAR(patch.scene.heat->mean_tool_temperature(),
                plane.scene.heat->mean_tool_temperature(),
                1e-5);
  }
} // namespace



TEST(PatchHeat, under_an_extruded_tool_is_that_of_the_plane)
{
  SceneParameters parameters = sheared(narrow_scene());
  parameters.heat.model      = HeatModel::conducting;
  expect_heat_of_plane(parameters);
}



// It crosses the gap from a hot tool, too.
TEST(PatchHeat, through_oil_under_an_extruded_tool_is_that_of_the_plane)
{
  SceneParameters parameters            = sheared(narrow_scene());
  parameters.lubrication.model          = LubricantModel::pocket;
  parameters.lubrication.wetting        = 0.7;
  parameters.interface.wet_shear_factor = 0.1;
  parameters.heat.tool_temperature      = 400.;
  parameters.protocol.slide_steps       = 1;
  expect_heat_of_plane(parameters);
}



TEST(PatchHeat, that_comes_in_is_stored_or_given_on)
{
  const PatchRun run(sheared(narrow_hills())); // conducting by itself
  for (const FrictionRow &row : run.rows())
    EXPECT_LT(row.heat_balance_error, 1e-9) << row.step;
  const FrictionRow &last = run.rows().back();
  const double       heat = last.plastic_heat + last.friction_heat;
  EXPECT_GT(last.friction_heat, last.plastic_heat);
  EXPECT_GT(last.tool_heat, 0.2 * heat);
  EXPECT_NEAR(last.stored_heat + last.depth_heat + last.tool_heat,
              heat,
              1e-10 * heat);
  // The work of the shear on the slip, which is the way but for what the chip
  // gives way.
  double work = 0.;
  for (std::size_t i = 1; i < run.rows().size(); ++i)
    work +=
      std::abs(run.rows()[i].interface_T_x) *
      (run.rows()[i].sliding_distance - run.rows()[i - 1].sliding_distance);
  EXPECT_NEAR(last.friction_heat, work, 0.3 * work);

  // The points of the chip have it, per metre of the width.
  const SolidAssembler<3> &chip = *run.scene.chip;
  double                   held = 0.;
  for (std::size_t q = 0; q < chip.history().size(); ++q)
    held += chip.table().JxW[q] * 7800. * 450. *
            (chip.history()[q].temperature - run.parameters.load.temperature);
  EXPECT_NEAR(held / run.scene.width,
              last.stored_heat,
              1e-8 * last.stored_heat);
}



TEST(PatchHeat, turned_by_a_right_angle_is_the_same)
{
  SceneParameters parameters       = sheared(narrow_hills());
  parameters.load.direction        = 0.;
  parameters.heat.tool_temperature = 350.;
  const PatchRun along_x(parameters),
    along_y(turned_by_a_right_angle(parameters));
  ASSERT_EQ(along_x.rows().size(), along_y.rows().size());
  // per metre of the width, which is another one
  for (std::size_t i = 1; i < along_x.rows().size(); ++i)
    expect_heat(along_x.rows()[i],
                along_y.rows()[i],
                along_x.scene.width / along_y.scene.width,
                parameters.load.temperature);
}



// Flat on flat the chip slides at v under mu_0 p and shares the heat with the
// tool by effusivity, whatever the direction.
TEST(PatchHeat, of_flat_bodies_is_shared_by_effusivity)
{
  SceneParameters parameters                = narrow_hills();
  parameters.tool.kind                      = SurfaceKind::flat;
  parameters.load.pressure                  = 100e6;
  parameters.interface.law                  = InterfaceShear::coulomb;
  parameters.interface.friction_coefficient = 0.3;
  parameters.heat.contact_conductance       = 1e12;
  parameters.mesh.refinement                = 0;
  parameters.mesh.across                    = 3;
  parameters.mesh.spans                     = 4;
  parameters.protocol.slide_steps           = 12;
  const PatchRun     run(parameters);
  const FrictionRow &last   = run.rows().back(),
                    &before = run.rows()[run.rows().size() - 2];
  const double power        = 0.3 * 100e6 * parameters.load.velocity *
                       parameters.geometry.length; // per metre of the width
  EXPECT_EQ(last.plastic_heat, 0.);
  EXPECT_NEAR((last.friction_heat - before.friction_heat) /
                (last.time - before.time),
              power,
              1e-3 * power);
  const double e1 = std::sqrt(45. * 7800. * 450.),
               e2 = std::sqrt(88. * 15250. * 292.);
  EXPECT_NEAR(share_of_tool(run.rows(), 0., last.time).value(),
              e2 / (e1 + e2),
              0.03);
}
