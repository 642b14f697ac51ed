#include <asperity/contact_zone/scene_input.h>
#include <asperity/lubricant/sheet_pockets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene_examples.h"

using namespace asperity;

// Oil that is enclosed between a patch and its tool. Expected values are those
// of the plane, the balance of forces, and the law of the oil.

namespace
{
  /** Oil in 70 % of the void at the start, heat that stays where it is done.
   *  @param sealing_gap [m] */
  SceneParameters
  oiled(SceneParameters parameters, const double sealing_gap)
  {
    parameters.heat.model                 = HeatModel::adiabatic;
    parameters.lubrication.model          = LubricantModel::pocket;
    parameters.lubrication.wetting        = 0.7;
    parameters.lubrication.sealing_gap    = sealing_gap;
    parameters.interface.law              = InterfaceShear::shear_factor;
    parameters.interface.shear_factor     = 0.5;
    parameters.interface.wet_shear_factor = 0.1;
    return parameters;
  }

  SceneParameters
  oiled_scene(const double sealing_gap)
  {
    return oiled(narrow_scene(), sealing_gap);
  }

  SceneParameters
  hills(const double sealing_gap)
  {
    return oiled(narrow_hills(), sealing_gap);
  }

  std::vector<std::string>
  events_of_both(const std::vector<std::string> &events)
  {
    std::vector<std::string> result;
    for (const std::string &event : events)
      if (event.find("through the period") == std::string::npos)
        result.push_back(event);
    return result;
  }

  /** Compares the steps of a patch under a tool that is extruded along y with
   *  those of the plane.
   *  @param pressure of the load [Pa] */
  void
  expect_rows(const CompleteRunIn<3> &patch,
              const CompleteRun      &plane,
              const double            pressure)
  {
    ASSERT_EQ(patch.rows().size(), plane.rows().size());
    const double small = 1e-6 * pressure;
    for (std::size_t i = 1; i < plane.rows().size(); ++i)
      {
        const FrictionRow &a = patch.rows()[i], &b = plane.rows()[i];
        EXPECT_NEAR(a.mu, b.mu, 1e-6 * std::abs(b.mu)) << "step " << i;
        EXPECT_EQ(a.pockets, b.pockets) << "step " << i;
        EXPECT_NEAR(a.oil_pressure, b.oil_pressure, small);
        EXPECT_NEAR(a.max_oil_pressure, b.max_oil_pressure, small);
        EXPECT_NEAR(a.oil_T_x, b.oil_T_x, 1e-6 * plane.load());
        EXPECT_NEAR(a.T_transverse, 0., 1e-6 * plane.load());
        EXPECT_NEAR(a.interface_shear, b.interface_shear, 1e-6);
        EXPECT_NEAR(a.void_volume, b.void_volume, 1e-6 * b.void_volume);
        EXPECT_NEAR(a.oil_volume, b.oil_volume, 1e-6 * b.oil_volume);
        EXPECT_NEAR(a.oil_reference_volume,
                    b.oil_reference_volume,
                    1e-6 * b.oil_reference_volume);
        EXPECT_NEAR(a.contact_fraction, b.contact_fraction, 1e-6);
      }
  }

  /** Runs both. @return pockets and pressure at the end */
  FrictionRow
  expect_plane(SceneParameters parameters)
  {
    const CompleteRunIn<3> patch(parameters);
    if (parameters.mesh.across)
      // the length of an element of the patch is the mean of both
      parameters.interface.transition *=
        std::sqrt(6. / *parameters.mesh.across);
    parameters.geometry.dimension = 2;
    const CompleteRun plane(parameters);
    expect_rows(patch, plane, parameters.load.pressure);
    EXPECT_EQ(events_of_both(patch.scene.lubricant->events()),
              plane.scene.lubricant->events());
    return plane.rows().back();
  }
} // namespace



TEST(PatchOil, under_an_extruded_tool_is_that_of_the_plane)
{
  const FrictionRow row = expect_plane(oiled_scene(0.));
  EXPECT_GT(row.oil_pressure, 1e7);
  EXPECT_GT(row.contact_fraction, 0.);
}



TEST(PatchOil, of_two_pockets_under_an_extruded_tool_is_that_of_the_plane)
{
  const FrictionRow row = expect_plane(oiled_scene(200e-9));
  EXPECT_EQ(row.pockets, 2u);
  EXPECT_GT(row.max_oil_pressure, 2. * row.oil_pressure); // one has more
}



TEST(PatchOil, floods_the_gap_under_an_extruded_tool_as_in_the_plane)
{
  SceneParameters parameters     = oiled_scene(0.);
  parameters.lubrication.wetting = 1.;
  const FrictionRow row          = expect_plane(parameters);
  EXPECT_NEAR(row.oil_pressure,
              parameters.load.pressure,
              0.01 * parameters.load.pressure);
}



TEST(PatchOil, stays_in_plane_strain_on_finer_elements_across)
{
  SceneParameters parameters      = oiled_scene(200e-9);
  parameters.mesh.across          = 8;
  parameters.protocol.slide_steps = 1;
  EXPECT_EQ(expect_plane(parameters).pockets, 2u);
}



TEST(PatchOil, carries_with_the_contact_and_keeps_its_mass)
{
  for (const double sealing_gap : {0., 100e-9})
    {
      const CompleteRunIn<3> run(hills(sealing_gap));
      const double           oil = run.rows()[1].oil_reference_volume;
      EXPECT_GT(oil, 0.);
      for (std::size_t i = 1; i < run.rows().size(); ++i)
        {
          const FrictionRow &row = run.rows()[i];
          EXPECT_NEAR(row.T_y,
                      -run.run.protocol().pressure(row.time) * run.scene.length,
                      1e-7 * run.load())
            << "step " << i;
          EXPECT_NEAR(row.oil_reference_volume, oil, 1e-12 * oil);
          EXPECT_GT(row.oil_pressure, 0.);
          // one pressure everywhere is level
          EXPECT_NEAR(row.oil_T_x,
                      0.,
                      (sealing_gap == 0. ? 1e-9 : 1.) * run.load());
        }
    }
}



TEST(PatchOil, turned_by_a_right_angle_has_the_same_forces)
{
  SceneParameters parameters    = hills(100e-9);
  parameters.load.direction     = 0.;
  const SceneParameters  turned = turned_by_a_right_angle(parameters);
  const CompleteRunIn<3> along_x(parameters), along_y(turned);
  ASSERT_EQ(along_x.rows().size(), along_y.rows().size());
  const double w = *parameters.geometry.width, l = *turned.geometry.width;
  for (std::size_t i = 1; i < along_x.rows().size(); ++i)
    {
      const FrictionRow &a = along_x.rows()[i], &b = along_y.rows()[i];
      const double       load = along_x.load() * w;
      EXPECT_NEAR(a.mu, b.mu, 1e-6) << "step " << i;
      EXPECT_NEAR(a.T_transverse * w, b.T_transverse * l, 1e-6 * load);
      EXPECT_NEAR(a.oil_T_x * w, b.oil_T_x * l, 1e-6 * load);
      EXPECT_NEAR(a.oil_pressure,
                  b.oil_pressure,
                  1e-6 * parameters.load.pressure);
      EXPECT_NEAR(a.max_oil_pressure,
                  b.max_oil_pressure,
                  1e-6 * parameters.load.pressure);
      EXPECT_NEAR(a.contact_fraction, b.contact_fraction, 1e-6);
      EXPECT_EQ(a.pockets, b.pockets);
    }
  EXPECT_GT(along_x.rows().back().oil_pressure, 0.);
}



// A film is no choice there, and the audit says so.
TEST(PatchOil, is_enclosed_where_the_model_is_chosen)
{
  SceneParameters parameters   = hills(0.);
  parameters.lubrication.model = LubricantModel::automatic;
  const AuditedScene<3> audited(parameters);
  EXPECT_EQ(parameters.lubrication.model, LubricantModel::pocket);
  EXPECT_NE(dynamic_cast<SheetPockets *>(audited.scene->lubricant.get()),
            nullptr);
  const auto &warnings = audited.audit.warnings;
  EXPECT_TRUE(std::any_of(
    warnings.begin(), warnings.end(), [](const std::string &warning) {
      return warning.rfind("The oil would flow as a film in two dimensions (",
                           0) == 0;
    }));
}
