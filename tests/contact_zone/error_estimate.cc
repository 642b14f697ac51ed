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
    RunFamily family(parameters);
    return estimate_error(family, {});
  }

  /** Runs of mu = 1 + C h^2 + s dt + e/penalty, h = dt = penalty = 1 of the
   *  run itself, which need not be computed.
   *  @param elements that the chip passes */
  RunFamily
  smooth_family(const double C,
                const double s,
                const double e,
                const double elements)
  {
    RunFamily family(coarse_scene());
    for (int mesh = -2; mesh <= 0; ++mesh)
      for (int step = -1; step <= 0; ++step)
        for (int penalty = -1; penalty <= 0; ++penalty)
          {
            const double mu = 1. + C * std::pow(4., -mesh) +
                              s * std::pow(2., -step) +
                              e * std::pow(2., -penalty);
            family.add({mesh, step, penalty}, {mu, 1, 1, elements});
          }
    return family;
  }
} // namespace

// The constants are met up to the factors that leave room for errors whose
// signs are left to chance: 3 and 1 over sqrt(3 sqrt(17)) and sqrt(sqrt(5)).
TEST(ErrorEstimate, measures_the_constants_of_a_smooth_error)
{
  const double C = 1e-3, s = -2e-3, e = 5e-4;
  for (const double elements : {1., 100.})
    {
      RunFamily           family = smooth_family(C, s, e, elements);
      const ErrorEstimate error  = estimate_error(family, {});
      const double        mu     = 1. + C + s + e;
      EXPECT_NEAR(error.mesh,
                  C / mu * 3. / std::sqrt(3. * std::sqrt(17.)),
                  1e-12);
      EXPECT_NEAR(error.step, s / mu / std::pow(5., 0.25), 1e-12);
      EXPECT_NEAR(error.penalty, e / mu / std::pow(5., 0.25), 1e-12);
      // Nothing but what was there was needed.
      EXPECT_EQ(family.size(), 12u);
    }
}

// Where the chip passes few elements, steps and penalty are varied on the mesh
// of the run; otherwise on the coarser one, where they are wrong here.
TEST(ErrorEstimate, varies_steps_on_a_mesh_that_is_fine_enough)
{
  for (const double elements : {1., 100.})
    {
      RunFamily      family = smooth_family(0., 1e-3, 0., elements);
      const Fineness coarse_and_long{-1, -1, 0};
      FamilyMember   wrong = family.run(coarse_and_long);
      wrong.mu += 0.1;
      family.add(coarse_and_long, wrong);
      EXPECT_EQ(estimate_error(family, {}).step > 0.01, elements > 10.);
    }
}

TEST(ErrorEstimate, lies_between_errors_of_one_sign_and_of_any)
{
  const ErrorEstimate same{0.003, 0.004, 0.012};
  EXPECT_NEAR(same.total(), std::hypot(0.013, 0.019) / std::sqrt(2.), 1e-15);
  const ErrorEstimate cancels{0.003, 0.004, -0.007};
  EXPECT_NEAR(cancels.total(), std::sqrt(74e-6 / 2.), 1e-15);
  EXPECT_EQ(same.largest(), "penalty");
  EXPECT_EQ((ErrorEstimate{-0.02, 0.01, 0.}).largest(), "mesh");
}

TEST(ErrorEstimate, falls_by_the_orders_of_its_sources)
{
  const ErrorEstimate error = ErrorEstimate{0.16, -0.08, 0.02}.after({1, 2, 1});
  EXPECT_DOUBLE_EQ(error.mesh, 0.04);
  EXPECT_DOUBLE_EQ(error.step, -0.02);
  EXPECT_DOUBLE_EQ(error.penalty, 0.01);
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

  SceneParameters soft        = few_steps;
  soft.protocol.ramp_steps    = 10;
  soft.protocol.slide_steps   = 20;
  soft.contact.penalty_factor = 0.1;
  RunFamily           family(soft);
  const double        mu       = family.run({}).mu;
  const ErrorEstimate estimate = estimate_error(family, {});
  EXPECT_EQ(estimate.largest(), "penalty");
  soft.contact.penalty_factor = 8.;
  const double error          = mu / CompleteRun(soft).run.friction().mu - 1.;
  EXPECT_GT(estimate.penalty / error, 0.5);
  EXPECT_LT(estimate.penalty / error, 2.);
}
