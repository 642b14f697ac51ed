#include <asperity/base/errors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scene_examples.h"

using namespace asperity;

// Expected values are balances, limits and the conditions of the model.

namespace
{
  SceneParameters
  pocket_scene(const double wetting, const double pressure)
  {
    SceneParameters parameters     = coarse_scene();
    parameters.lubrication.model   = LubricantModel::pocket;
    parameters.lubrication.wetting = wetting;
    parameters.load.pressure       = pressure;
    parameters.solver.tolerance    = 1e-8;
    return parameters;
  }

  void
  expect_balance(const CompleteRun &run)
  {
    for (const FrictionRow &row : run.rows())
      {
        EXPECT_NEAR(row.T_y,
                    -run.run.protocol().pressure(row.time) * run.scene.length,
                    1e-6 * run.load())
          << "step " << row.step;
        // p >= 0, V - V_oil >= 0, p (V - V_oil) = 0
        EXPECT_GE(row.oil_pressure, 0.);
        EXPECT_GE(row.void_volume, row.oil_volume * (1. - 1e-12));
        if (row.pockets == 1 && row.oil_pressure > 0.)
          {
            EXPECT_NEAR(row.oil_volume,
                        row.void_volume,
                        1e-9 * row.void_volume);
          }
      }
    // The first row is of the scene before anything has been computed.
    const double mass = run.rows()[1].oil_reference_volume;
    for (std::size_t i = 1; i < run.rows().size(); ++i)
      EXPECT_NEAR(run.rows()[i].oil_reference_volume, mass, 1e-14 * mass);
  }
} // namespace

TEST(PocketScene, contact_and_oil_carry_the_load_together)
{
  for (const double wetting : {0.6, 1.})
    {
      const CompleteRun run(pocket_scene(wetting, 1300e6));
      expect_balance(run);
      EXPECT_GT(run.rows().back().oil_pressure, 100e6);
      EXPECT_GT(run.rows().back().contact_fraction, 0.);
      // One pressure on a periodic edge has no lateral force.
      EXPECT_LT(std::abs(run.rows().back().oil_T_x), 1e-9 * run.load());
    }
}

TEST(PocketScene, oil_that_finds_room_changes_nothing)
{
  const CompleteRun wet(pocket_scene(0.01, 300e6));
  SceneParameters   parameters = pocket_scene(0.01, 300e6);
  parameters.lubrication.model = LubricantModel::none;
  const CompleteRun dry(parameters);
  ASSERT_EQ(wet.rows().size(), dry.rows().size());
  // But for the last digits: another start of the step lets the return of a
  // point end elsewhere within its tolerance.
  for (std::size_t i = 0; i < wet.rows().size(); ++i)
    EXPECT_NEAR(wet.rows()[i].T_x, dry.rows()[i].T_x, 1e-9 * wet.load()) << i;
}

TEST(PocketScene, chip_floats_on_incompressible_oil)
{
  SceneParameters parameters                     = pocket_scene(1., 300e6);
  parameters.lubrication.oil.compressibility.law = DensityLaw::incompressible;
  const CompleteRun run(parameters);
  expect_balance(run);
  for (std::size_t i = 1; i < run.rows().size(); ++i)
    {
      const FrictionRow &row = run.rows()[i];
      EXPECT_NEAR(row.oil_pressure,
                  run.run.protocol().pressure(row.time),
                  1e-6 * parameters.load.pressure);
      EXPECT_EQ(row.contact_fraction, 0.);
      EXPECT_NEAR(row.void_volume,
                  row.oil_reference_volume,
                  1e-9 * row.void_volume);
    }
}

TEST(PocketScene, oil_keeps_its_mass_while_pockets_split_and_merge)
{
  SceneParameters parameters         = pocket_scene(0.3, 1300e6);
  parameters.load.temperature        = 948.15;
  parameters.lubrication.sealing_gap = 20e-9;
  const CompleteRun run(parameters);
  expect_balance(run);
  unsigned int most = 0;
  for (const FrictionRow &row : run.rows())
    most = std::max(most, row.pockets);
  EXPECT_GE(most, 2u);
  EXPECT_FALSE(run.scene.lubricant->events().empty());
}

TEST(PocketScene, surfaces_that_seal_everywhere_do_not_stop_the_run)
{
  // Everything is closer than the sealing gap: there is no pocket.
  SceneParameters parameters         = pocket_scene(0.5, 300e6);
  parameters.lubrication.sealing_gap = 5e-6;
  const CompleteRun run(parameters);
  for (const FrictionRow &row : run.rows())
    {
      EXPECT_EQ(row.pockets, 0u);
      EXPECT_EQ(row.oil_pressure, 0.);
    }
}

namespace
{
  SceneParameters
  film_scene(const double wetting)
  {
    SceneParameters parameters   = pocket_scene(wetting, 300e6);
    parameters.lubrication.model = LubricantModel::reynolds;
    return parameters;
  }
} // namespace

TEST(FilmScene, film_and_contact_carry_the_load_and_no_oil_is_lost)
{
  for (const double wetting : {0.6, 1.})
    {
      const CompleteRun run(film_scene(wetting));
      const double      mass = run.rows()[1].oil_reference_volume;
      for (std::size_t i = 1; i < run.rows().size(); ++i)
        {
          const FrictionRow &row = run.rows()[i];
          EXPECT_NEAR(row.T_y,
                      -run.run.protocol().pressure(row.time) * run.scene.length,
                      1e-6 * run.load())
            << "step " << row.step;
          EXPECT_NEAR(row.oil_reference_volume, mass, 1e-12 * mass);
          EXPECT_LT(row.shear_T_x, 0.);
        }
      EXPECT_GT(run.rows().back().max_oil_pressure, 0.);
    }
}

TEST(FilmScene, slow_and_thin_oil_is_a_pocket)
{
  // Without flow the pressure is one: that of the connected pocket.
  SceneParameters parameters                     = film_scene(1.);
  parameters.lubrication.oil.viscosity.viscosity = 1e-7;
  const CompleteRun film(parameters);
  parameters.lubrication.model = LubricantModel::pocket;
  const CompleteRun  pocket(parameters);
  const FrictionRow &a = film.rows().back(), &b = pocket.rows().back();
  EXPECT_NEAR(a.oil_pressure, b.oil_pressure, 0.01 * b.oil_pressure);
  EXPECT_NEAR(a.void_volume, b.void_volume, 0.01 * b.void_volume);
}

TEST(FilmScene, thin_oil_in_part_of_the_void_gives_way_like_a_pocket)
{
  // Oil that has to leave the closing gaps holds them apart the longer the
  // thicker it is; without viscosity what is left is the volume that it needs.
  SceneParameters parameters = film_scene(0.6);
  parameters.load.velocity   = 22.5 / 60.;
  const auto mean_mu         = [&]() {
    return CompleteRun(parameters).run.friction().mu;
  };
  parameters.lubrication.model = LubricantModel::pocket;
  const double pocket          = mean_mu();
  parameters.lubrication.model = LubricantModel::reynolds;
  double last                  = 1.;
  for (const double factor : {1., 0.03, 0.001})
    {
      parameters.lubrication.oil.viscosity.viscosity = 0.032 * factor;
      const double error = std::abs(mean_mu() - pocket) / pocket;
      EXPECT_LT(error, 0.5 * last) << factor;
      last = error;
    }
  EXPECT_LT(last, 0.01);
}

TEST(FilmScene, chip_with_inertia_starts_and_carries_the_load)
{
  SceneParameters parameters  = film_scene(0.6);
  parameters.protocol.inertia = Inertia::dynamic;
  const CompleteRun dynamic(parameters);
  const double      mass = dynamic.rows()[1].oil_reference_volume;
  double            T_y  = 0.;
  for (std::size_t i = 1; i < dynamic.rows().size(); ++i)
    {
      EXPECT_NEAR(dynamic.rows()[i].oil_reference_volume, mass, 1e-12 * mass);
      T_y = dynamic.rows()[i].T_y;
    }
  // The waves of the ramp of 50 ns have died down, and the chip is where one
  // without mass is.
  EXPECT_NEAR(T_y, -dynamic.load(), 0.05 * dynamic.load());
  parameters.protocol.inertia = Inertia::quasi_static;
  const CompleteRun still(parameters);
  EXPECT_NEAR(dynamic.run.friction().mu,
              still.run.friction().mu,
              0.05 * still.run.friction().mu);
}

TEST(FilmScene, pressure_that_runs_away_ends_the_run_with_a_sentence)
{
  // Barus at 1.3 GPa on full voids: exp(19 * 1.3) times the viscosity.
  SceneParameters parameters                        = film_scene(1.);
  parameters.load.pressure                          = 1300e6;
  parameters.lubrication.oil.viscosity.pressure_law = PressureLaw::barus;
  try
    {
      const CompleteRun run(parameters);
      ADD_FAILURE() << "expected a ComputationError";
    }
  catch (const ComputationError &error)
    {
      const std::string message = error.what();
      EXPECT_NE(message.find("the lubricant's viscosity"), std::string::npos)
        << message;
      EXPECT_NE(message.find("its pressure runs away"), std::string::npos)
        << message;
    }
}

TEST(WarmOil, at_its_reference_temperature_is_the_oil_without_a_law)
{
  for (const LubricantModel model :
       {LubricantModel::pocket, LubricantModel::reynolds})
    {
      SceneParameters parameters            = pocket_scene(0.9, 300e6);
      parameters.lubrication.model          = model;
      parameters.material.heating.adiabatic = false;
      const CompleteRun without(parameters);
      parameters.lubrication.oil.temperature.law = TemperatureLaw::vogel;
      const CompleteRun with(parameters);
      for (std::size_t i = 0; i < with.rows().size(); ++i)
        EXPECT_EQ(with.rows()[i].T_x, without.rows()[i].T_x) << i;
    }
}

TEST(WarmOil, shears_as_its_viscosity)
{
  // Flooded, the film carries the load and shears by eta v/h.
  SceneParameters parameters            = film_scene(1.);
  parameters.material.heating.adiabatic = false;
  parameters.load.temperature           = 348.15;
  const CompleteRun     cold(parameters);
  LubricantTemperature &law = parameters.lubrication.oil.temperature;
  law.law                   = TemperatureLaw::vogel;
  law.modulus_decay         = 0.;
  const CompleteRun hot(parameters);
  EXPECT_NEAR(hot.rows().back().shear_T_x / cold.rows().back().shear_T_x,
              law.viscosity(0.032, 348.15) / 0.032,
              0.05);
  EXPECT_NEAR(hot.run.oil_temperature(), 348.15, 1e-10);
}

TEST(WarmOil, is_as_warm_as_the_mean_of_its_walls)
{
  SceneParameters parameters                 = film_scene(0.3);
  parameters.lubrication.oil.temperature.law = TemperatureLaw::roelands;
  parameters.load.pressure                   = 1300e6;
  const CompleteRun run(parameters);
  // Plastic work heats the chip alone.
  const double chip = run.scene.interface_temperature();
  EXPECT_GT(chip, parameters.load.temperature + 1.);
  EXPECT_LT(chip, run.rows().back().max_temperature);
  EXPECT_NEAR(run.run.oil_temperature(),
              0.5 * (parameters.load.temperature + chip),
              1e-10);
}
