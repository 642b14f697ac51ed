#include <asperity/contact_zone/scene_heat.h>
#include <asperity/contact_zone/scene_input.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene_examples.h"

using namespace asperity;

namespace
{
  SceneParameters
  conducting_scene()
  {
    SceneParameters parameters = coarse_scene();
    parameters.heat.model      = HeatModel::conducting;
    return parameters;
  }

  double
  mu(const CompleteRun &run)
  {
    return run.run.friction().mu;
  }

  /** rho c of the default chip [J/(m^3 K)]. */
  constexpr double capacity = 7800. * 450.;

  /** Effusivities of the default chip and tool. */
  const double e1 = std::sqrt(45. * capacity),
               e2 = std::sqrt(88. * 15250. * 292.);

  /** Heat in the points of the chip beyond that of the start [J/m]. */
  double
  heat_of_points(const CompleteRun &run)
  {
    const SolidAssembler<2> &chip = *run.scene.chip;
    double                   heat = 0.;
    for (std::size_t q = 0; q < chip.history().size(); ++q)
      heat += chip.table().JxW[q] * capacity *
              (chip.history()[q].temperature - run.parameters.load.temperature);
    return heat;
  }
} // namespace



TEST(SceneHeat, that_comes_in_is_stored_or_given_on)
{
  const CompleteRun run(conducting_scene());
  for (const FrictionRow &row : run.rows())
    EXPECT_LT(row.heat_balance_error, 1e-9) << row.step;
  const FrictionRow &last = run.rows().back();
  EXPECT_GT(last.plastic_heat, 0.);
  EXPECT_GT(last.tool_heat, 0.1 * last.plastic_heat);
  EXPECT_NEAR(last.stored_heat + last.depth_heat + last.tool_heat,
              last.plastic_heat,
              1e-10 * last.plastic_heat);
  EXPECT_NEAR(heat_of_points(run), last.stored_heat, 1e-8 * last.stored_heat);
}



TEST(SceneHeat, stays_where_it_is_done_in_a_chip_that_does_not_conduct)
{
  SceneParameters parameters          = conducting_scene();
  parameters.heat.chip_conductivity   = 1e-6;
  parameters.heat.contact_conductance = 0.;
  const CompleteRun insulating(parameters);
  for (const FrictionRow &row : insulating.rows())
    ASSERT_TRUE(std::isfinite(row.tool_heat)) << row.step;
  parameters.heat.model = HeatModel::adiabatic;
  const CompleteRun adiabatic(parameters);
  const double      heat = heat_of_points(adiabatic);
  EXPECT_NEAR(insulating.rows().back().stored_heat, heat, 1e-3 * heat);
  EXPECT_EQ(insulating.rows().back().tool_heat, 0.);
  EXPECT_NEAR(mu(insulating), mu(adiabatic), 1e-3 * mu(adiabatic));
}



TEST(SceneHeat, lies_between_the_adiabatic_and_the_isothermal_chip)
{
  SceneParameters   parameters = conducting_scene();
  const CompleteRun conducting(parameters);
  parameters.heat.model = HeatModel::adiabatic;
  const CompleteRun adiabatic(parameters);
  parameters.heat.model = HeatModel::isothermal;
  const CompleteRun isothermal(parameters);
  EXPECT_LT(conducting.rows().back().max_temperature,
            adiabatic.rows().back().max_temperature - 5.);
  EXPECT_GT(conducting.rows().back().max_temperature,
            parameters.load.temperature + 1.);
  EXPECT_GT(adiabatic.rows().back().flash_temperature,
            conducting.rows().back().flash_temperature);
  EXPECT_DOUBLE_EQ(isothermal.rows().back().flash_temperature,
                   parameters.load.temperature);
  EXPECT_GT(mu(conducting), std::min(mu(adiabatic), mu(isothermal)));
  EXPECT_LT(mu(conducting), std::max(mu(adiabatic), mu(isothermal)));

  // A chip that conducts without limit has one temperature, that of its depth;
  // in a step its points still feel their own heat.
  parameters.heat.model             = HeatModel::conducting;
  parameters.heat.chip_conductivity = 1e12;
  const CompleteRun perfect(parameters);
  EXPECT_NEAR(perfect.rows().back().max_temperature,
              parameters.load.temperature,
              0.1);
  EXPECT_NEAR(mu(perfect), mu(isothermal), 5e-4 * mu(isothermal));
}



TEST(SceneHeat, leaves_no_trace_of_steps_that_are_cut)
{
  SceneParameters parameters           = conducting_scene();
  parameters.protocol.slide_steps      = 4;
  parameters.solver.maximum_iterations = 4;
  const CompleteRun run(parameters);
  ASSERT_GT(run.run.n_cuts(), 0u);
  const FrictionRow &last = run.rows().back();
  EXPECT_NEAR(last.stored_heat + last.depth_heat + last.tool_heat,
              last.plastic_heat,
              1e-10 * last.plastic_heat);
}



TEST(SceneHeat, of_a_hot_tool_comes_from_it)
{
  SceneParameters parameters                = conducting_scene();
  parameters.heat.tool_temperature          = 700.;
  parameters.material.heating.heat_fraction = 0.;
  const CompleteRun  run(parameters);
  const FrictionRow &last = run.rows().back();
  EXPECT_EQ(run.rows().front().flash_temperature, 700.);
  EXPECT_EQ(last.plastic_heat, 0.);
  EXPECT_LT(last.tool_heat, 0.);
  EXPECT_NEAR(last.stored_heat + last.depth_heat,
              -last.tool_heat,
              1e-10 * last.stored_heat);
  // The bodies meet by their effusivities at first, and at small spots by their
  // conductivities at last; the chip moves on before.
  const std::vector<double> chip = run.scene.heat->chip_temperature();
  EXPECT_LT(*std::max_element(chip.begin(), chip.end()),
            (298.15 * 45. + 700. * 88.) / (45. + 88.));
  EXPECT_GT(*std::max_element(chip.begin(), chip.end()), 350.);
}



TEST(SceneHeat, of_friction_is_shared_by_effusivity)
{
  // All of the interface touches where the tool is flat.
  SceneParameters parameters          = conducting_scene();
  parameters.tool.kind                = SurfaceKind::flat;
  parameters.heat.contact_conductance = 1e12;
  parameters.mesh.refinement          = 3;
  CompleteRun               run(parameters);
  const unsigned int        n      = run.scene.contact->table().JxW.size();
  const HeatAmounts         before = run.scene.heat->amounts();
  const std::vector<double> friction(n, 1e9);
  for (unsigned int i = 0; i < 50; ++i)
    run.scene.heat->advance(run.run.state().u, 2e-9, friction);
  const HeatAmounts gained = run.scene.heat->amounts().since(before);
  EXPECT_NEAR(gained.friction, 1e9 * 1e-7 * 10e-6, 1e-12);
  EXPECT_NEAR(gained.tool / gained.friction, e2 / (e1 + e2), 0.01);
  EXPECT_NEAR(gained.tool + gained.stored + gained.depth,
              gained.friction,
              1e-10 * gained.friction);
}



TEST(SceneHeat, of_the_interface_is_the_work_of_its_shear_on_the_slip)
{
  // Flat on flat the whole chip slides at v under mu_0 p.
  SceneParameters parameters                = conducting_scene();
  parameters.tool.kind                      = SurfaceKind::flat;
  parameters.load.pressure                  = 100e6;
  parameters.interface.law                  = InterfaceShear::coulomb;
  parameters.interface.friction_coefficient = 0.3;
  parameters.heat.contact_conductance       = 1e12;
  const CompleteRun  run(parameters);
  const FrictionRow &last   = run.rows().back();
  const FrictionRow &before = run.rows()[run.rows().size() - 2];
  EXPECT_EQ(last.plastic_heat, 0.);
  EXPECT_NEAR((last.friction_heat - before.friction_heat) /
                (last.time - before.time),
              0.3 * 100e6 * parameters.load.velocity * 10e-6,
              1e-3 * 0.3 * 100e6 * parameters.load.velocity * 10e-6);
  EXPECT_NEAR(share_of_tool(run.rows(), 0., last.time).value(),
              e2 / (e1 + e2),
              0.02);
  EXPECT_LT(last.heat_balance_error, 1e-9);
}



TEST(SceneHeat, crosses_a_gap_through_oil_alone)
{
  SceneParameters parameters       = conducting_scene();
  parameters.heat.tool_temperature = 700.;
  const CompleteRun dry(parameters);
  parameters.lubrication.model   = LubricantModel::pocket;
  parameters.lubrication.wetting = 0.5;
  const CompleteRun oil(parameters);
  parameters.heat.oil_conductivity = 0.;
  const CompleteRun insulating(parameters);
  // A tenth of the period touches; the rest has gaps of some 0.3 um,
  // 0.14/0.3e-6 = 5e5 W/(m^2 K) over 400 K for 0.25 us: 0.5 mJ/m.
  const double more =
    insulating.rows().back().tool_heat - oil.rows().back().tool_heat;
  EXPECT_NEAR(more, 5e-4, 4e-4);
  EXPECT_NEAR(insulating.rows().back().tool_heat,
              dry.rows().back().tool_heat,
              1e-2 * std::abs(dry.rows().back().tool_heat));
  EXPECT_NEAR(oil.run.oil_temperature(),
              0.5 * (oil.scene.heat->mean_tool_temperature() +
                     oil.scene.interface_temperature()),
              1e-10);
}



TEST(SceneHeat, isothermal_overrides_the_material)
{
  SceneParameters parameters = coarse_scene();
  parameters.heat.model      = HeatModel::isothermal;
  const CompleteRun by_model(parameters);
  parameters.heat.model = HeatModel::automatic;
  const CompleteRun adiabatic(parameters);
  parameters.material.heating.adiabatic = false;
  const CompleteRun by_material(parameters);
  parameters.material.heating.adiabatic = true;
  parameters.heat.model                 = HeatModel::adiabatic;
  const CompleteRun chosen(parameters);
  EXPECT_EQ(mu(by_model), mu(by_material));
  EXPECT_EQ(mu(chosen), mu(adiabatic));
  EXPECT_NE(mu(by_model), mu(adiabatic));
  EXPECT_EQ(adiabatic.scene.heat, nullptr);
}



TEST(SceneHeat, automatic_conducts_where_the_interface_shears)
{
  SceneParameters parameters = coarse_scene();
  EXPECT_EQ(parameters.heat_model(), HeatModel::adiabatic);
  parameters.interface.law = InterfaceShear::shear_factor;
  EXPECT_EQ(parameters.heat_model(), HeatModel::conducting);
  parameters.geometry.dimension = 3;
  EXPECT_EQ(parameters.heat_model(), HeatModel::conducting);
  parameters.material.heating.adiabatic = false;
  EXPECT_EQ(parameters.heat_model(), HeatModel::isothermal);
}
