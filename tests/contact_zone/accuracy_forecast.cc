#include <asperity/contact_zone/accuracy_forecast.h>

#include <gtest/gtest.h>

#include <cmath>

#include "scene_examples.h"

using namespace asperity;

namespace
{
  const ForecastNumbers numbers = {10., 0.5, 0.2, 100., 8., 1000.};
}

TEST(AccuracyForecast, follows_the_orders_of_the_sources)
{
  const AccuracyForecast before = forecast(numbers, LubricantModel::none);
  ForecastNumbers        finer  = numbers;
  finer.elements *= 2.;
  finer.penalty_factor *= 0.5; // the same penalty [Pa/m]
  AccuracyForecast after = forecast(finer, LubricantModel::none);
  EXPECT_NEAR(after.error.mesh / before.error.mesh, 0.25, 1e-12);
  EXPECT_NEAR(after.error.penalty / before.error.penalty, 1., 1e-12);

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
            std::hypot(after.error.mesh,
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
  EXPECT_EQ(advice[1].find("Forecast (time good for a factor of 2; "), 0u);
  EXPECT_NE(advice[1].find("numerical error of mu about "), std::string::npos);
  EXPECT_EQ(advice[2].find("For 0.7 %: Mesh/Spans = "), 0u) << advice[2];
  parameters.accuracy.error = 0.;
  EXPECT_EQ(advise(parameters, scene).size(), 2u);
}
