#include <asperity/contact_zone/accuracy_forecast.h>

#include <gtest/gtest.h>

#include <cmath>

#include "scene_examples.h"

using namespace asperity;

namespace
{
  const ForecastNumbers numbers =
    {10., 0.5, 0.2, 100., 8., 1000., 12., 0.4, 5., 1e-3};
}

TEST(AccuracyForecast, follows_the_orders_of_the_sources)
{
  const AccuracyForecast before = forecast(numbers, LubricantModel::none);
  ForecastNumbers        finer  = numbers;
  finer.elements *= 2.;
  finer.elements_in_spot *= 2.;
  finer.elements_passed *= 2.;
  finer.penalty_factor *= 0.5; // the same penalty [Pa/m]
  AccuracyForecast after = forecast(finer, LubricantModel::none);
  EXPECT_NEAR(after.error.mesh / before.error.mesh, 0.25, 1e-12);
  EXPECT_NEAR(after.error.chance / before.error.chance,
              std::pow(2., -1.4),
              1e-12);
  EXPECT_NEAR(after.error.penalty / before.error.penalty, 1., 1e-12);

  finer = numbers;
  finer.softness *= 0.5;
  after = forecast(finer, LubricantModel::none);
  EXPECT_NEAR(after.error.penalty / before.error.penalty,
              std::pow(2., -0.82),
              1e-12);

  finer = numbers;
  finer.steps *= 2.;
  after = forecast(finer, LubricantModel::none);
  EXPECT_NEAR(after.error.step / before.error.step, 0.5, 1e-12);
  // Shorter steps need fewer iterations each.
  EXPECT_GT(after.time / before.time, 1.);
  EXPECT_LT(after.time / before.time, 2.);

  finer = numbers;
  finer.unknowns *= 3.;
  after = forecast(finer, LubricantModel::none);
  EXPECT_NEAR(after.time / before.time, 3., 1e-12);
  EXPECT_EQ(after.total(),
            std::hypot(std::hypot(after.error.mesh, after.error.chance),
                       after.error.step,
                       after.error.penalty));
  EXPECT_GT(forecast(numbers, LubricantModel::navier_stokes).time, before.time);
}

// Counted by hand.
TEST(AccuracyForecast, reads_its_numbers_off_the_scene)
{
  SceneParameters parameters      = coarse_scene();
  parameters.load.velocity        = 2.;
  parameters.protocol.slide_steps = 15;
  const Scene<2>        scene(parameters);
  const ForecastNumbers found = forecast_numbers(parameters, scene);
  const Surface        &tool  = scene.tool_surface;
  const double          length =
    (tool.maximum() - tool.minimum()) / tool.largest_slope();
  EXPECT_NEAR(found.elements, length / (scene.length / 40.), 1e-9);
  EXPECT_NEAR(found.way, 2. * parameters.protocol.end_time / length, 1e-9);
  EXPECT_EQ(found.steps, 20.);
  EXPECT_NEAR(found.penalty_factor, parameters.contact.penalty_factor, 1e-9);
  EXPECT_EQ(found.unknowns, scene.n_unknowns());
  EXPECT_GT(found.contact, 0.05);
  EXPECT_LT(found.contact, 0.25);
  parameters.load.pressure *= 2.;
  EXPECT_NEAR(forecast_numbers(parameters, scene).contact,
              2. * found.contact,
              1e-12);
}

// A cosine that is cut off where half of it touches: a spot of L / 2, and a
// mean depth of (2/pi) a.
TEST(AccuracyForecast, measures_the_spots_of_a_wave)
{
  const double    a            = 0.2e-6;
  SceneParameters parameters   = coarse_scene();
  parameters.tool.wave_numbers = {2};
  parameters.tool.amplitudes   = {a};
  parameters.tool.phases       = {0.7};
  const double contact =
    forecast_numbers(parameters, Scene<2>(parameters)).contact;
  const double pressure = parameters.load.pressure;
  parameters.load.pressure *= 0.5 / contact;
  const Scene<2>        scene(parameters);
  const ForecastNumbers found = forecast_numbers(parameters, scene);
  const double          h = scene.contact_element_length(), L = scene.length;
  // Two waves, of which each has a spot.
  EXPECT_NEAR(found.elements_in_spot, L / 4. / h, 0.01 * L / 4. / h);
  EXPECT_NEAR(found.elements_passed,
              found.way_over_spot * found.elements_in_spot,
              1e-9);
  EXPECT_NEAR(found.elements_passed,
              parameters.load.velocity * parameters.protocol.end_time / h,
              1e-9);
  // The pressure on what touches is p over its share.
  EXPECT_NEAR(found.softness,
              pressure / contact / scene.penalty() / (2. / M_PI * a),
              0.01 * found.softness);
}

// A load that hardly anything carries, and tools without any depth.
TEST(AccuracyForecast, is_finite_or_silent_where_next_to_nothing_touches)
{
  SceneParameters parameters   = coarse_scene();
  parameters.mesh.spans        = 80;
  parameters.mesh.refinement   = 2;
  parameters.load.pressure     = 1e4;
  parameters.tool.wave_numbers = {2};
  parameters.tool.amplitudes   = {0.2e-6};
  parameters.tool.phases       = {0.};
  const Scene<2>        wavy(parameters);
  const ForecastNumbers found = forecast_numbers(parameters, wavy);
  EXPECT_TRUE(std::isfinite(found.softness));
  EXPECT_LT(forecast(found, LubricantModel::none).total(), 100.);
  for (const std::string &sentence : advise(parameters, wavy))
    EXPECT_EQ(sentence.find("inf"), std::string::npos) << sentence;
  parameters.tool.amplitudes = {1e-20};
  EXPECT_TRUE(advise(parameters, Scene<2>(parameters)).empty());
}

TEST(AccuracyForecast, advises_settings_for_the_wanted_error)
{
  SceneParameters parameters = coarse_scene();
  parameters.mesh.spans      = 80;
  parameters.mesh.refinement = 2;
  const Scene<2> scene(parameters);
  const auto     advice = advise(parameters, scene);
  ASSERT_EQ(advice.size(), 3u);
  // Heat gets 2 (45/(7800 450) 0.25e-6)^(1/2) m = 3.6 um far, the tool is
  // 0.68 um rough.
  EXPECT_EQ(advice[0], "Recommended models: dry, quasi-static, conducting.");
  EXPECT_EQ(advice[1].find("Forecast (good for a factor of 2: time "), 0u);
  EXPECT_NE(advice[1].find("numerical error of mu about "), std::string::npos);
  EXPECT_EQ(advice[2].find("For 0.7 %: Mesh/Spans = "), 0u) << advice[2];
  parameters.accuracy.error = 0.;
  EXPECT_EQ(advise(parameters, scene).size(), 2u);
}
