#include <asperity/contact_zone/error_estimate.h>

#include <gtest/gtest.h>

#include <cmath>

#include "scene_examples.h"

using namespace asperity;

namespace
{
  ErrorEstimate
  estimated(const SceneParameters &parameters)
  {
    return estimate_error(parameters,
                          CompleteRun(parameters).run.friction().mu);
  }
} // namespace

TEST(ErrorEstimate, companions_differ_in_one_thing_each)
{
  SceneParameters parameters      = coarse_scene();
  parameters.protocol.slide_steps = 15;
  const Scene scene(parameters), coarse(with_coarser_mesh(parameters)),
    soft(with_softer_contact(parameters));
  EXPECT_NEAR(coarse.contact_element_length(),
              2. * scene.contact_element_length(),
              1e-12 * scene.length);
  EXPECT_NEAR(coarse.penalty(), scene.penalty(), 1e-12 * scene.penalty());
  EXPECT_NEAR(soft.penalty(), 0.5 * scene.penalty(), 1e-12 * scene.penalty());
  EXPECT_EQ(soft.space->n_cells(), scene.space->n_cells());
  const ProtocolParameters longer = with_longer_steps(parameters).protocol;
  EXPECT_EQ(longer.slide_steps, 8u);
  EXPECT_EQ(longer.end_time, parameters.protocol.end_time);
  EXPECT_EQ(longer.steady_step, 2. * parameters.protocol.steady_step);
  // A penalty that is given stays on the coarser mesh.
  parameters.contact.penalty = 1e16;
  EXPECT_EQ(Scene(with_coarser_mesh(parameters)).penalty(), 1e16);
  EXPECT_EQ(Scene(with_softer_contact(parameters)).penalty(), 5e15);
}

TEST(ErrorEstimate, adds_the_squares)
{
  const ErrorEstimate error{0.003, 0.004, 0.012};
  EXPECT_NEAR(error.total(), 0.013, 1e-15);
  EXPECT_EQ(error.largest(), "penalty");
}

// One source at a time is made so coarse that it has to be the largest, and the
// estimate is compared with what a much finer choice of it changes.
TEST(ErrorEstimate, finds_the_source_that_dominates)
{
  EXPECT_EQ(estimated(coarse_scene()).largest(), "mesh");

  SceneParameters few_steps      = coarse_scene();
  few_steps.mesh.spans           = 80;
  few_steps.mesh.refinement      = 2;
  few_steps.protocol.ramp_steps  = 4;
  few_steps.protocol.slide_steps = 4;
  EXPECT_EQ(estimated(few_steps).largest(), "step");

  SceneParameters soft         = few_steps;
  soft.protocol.ramp_steps     = 10;
  soft.protocol.slide_steps    = 20;
  soft.contact.penalty_factor  = 0.1;
  const double        mu       = CompleteRun(soft).run.friction().mu;
  const ErrorEstimate estimate = estimate_error(soft, mu);
  EXPECT_EQ(estimate.largest(), "penalty");
  soft.contact.penalty_factor = 8.;
  const double error = std::abs(mu / CompleteRun(soft).run.friction().mu - 1.);
  EXPECT_GT(estimate.penalty, 0.5 * error);
  EXPECT_LT(estimate.penalty, 2. * error);
}

TEST(ErrorEstimate, tells_which_companion_runs)
{
  SceneParameters           parameters = coarse_scene();
  std::vector<unsigned int> told;
  estimate_error(parameters, 0.1, [&](const unsigned int companion) {
    told.push_back(companion);
  });
  EXPECT_EQ(told, (std::vector<unsigned int>{1, 2, 3}));
}
