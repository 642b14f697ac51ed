#include <asperity/contact_zone/error_estimate.h>

#include <gtest/gtest.h>

#include <algorithm>
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
   *  run itself, which need not be computed. */
  RunFamily
  smooth_family(const double C, const double s, const double e)
  {
    RunFamily family(coarse_scene());
    for (int mesh = -2; mesh <= 0; ++mesh)
      for (int step = -1; step <= 0; ++step)
        for (int penalty = -1; penalty <= 0; ++penalty)
          {
            const double mu = 1. + C * std::pow(4., -mesh) +
                              s * std::pow(2., -step) +
                              e * std::pow(2., -penalty);
            family.add({mesh, step, penalty}, {mu, 1, 1});
          }
    return family;
  }
} // namespace

TEST(ErrorEstimate, is_exact_where_mu_converges_smoothly)
{
  const double        C = 1e-3, s = -2e-3, e = 5e-4, mu = 1. + C + s + e;
  RunFamily           family = smooth_family(C, s, e);
  const ErrorEstimate error  = estimate_error(family, {});
  EXPECT_NEAR(error.mesh, C / mu, 1e-12);
  EXPECT_NEAR(error.step, s / mu, 1e-12);
  EXPECT_NEAR(error.penalty, e / mu, 1e-12);
  // Nothing but what was there was needed.
  EXPECT_EQ(family.size(), 12u);
}

// Companions of the same mesh as the run cost thrice as much. They are needed
// where elements twice as long change mu by more than 5 %: by 3 C.
TEST(ErrorEstimate, varies_steps_on_a_mesh_that_is_fine_enough)
{
  for (const double C : {0.015, 0.02})
    {
      const int mesh = 3. * C / (1. + C - 1.5e-3) < 0.05 ? -1 : 0;
      RunFamily all  = smooth_family(C, -2e-3, 5e-4);
      RunFamily few(all.parameters());
      for (const Fineness &fineness : {Fineness{0, 0, 0},
                                       Fineness{-1, 0, 0},
                                       Fineness{-2, 0, 0},
                                       Fineness{mesh, -1, 0},
                                       Fineness{mesh, 0, -1}})
        few.add(fineness, all.run(fineness));
      EXPECT_EQ(estimate_error(few, {}).total(),
                estimate_error(all, {}).total());
      EXPECT_EQ(few.size(), 5u); // nothing else was computed
      EXPECT_EQ(mesh, C < 0.017 ? -1 : 0);
    }
}

// The change by the longest elements is made 16 times what order 2 expects,
// then a sixteenth of it.
TEST(ErrorEstimate, takes_the_smaller_of_two_changes_by_the_mesh)
{
  for (const double factor : {16., 1. / 16., -1. / 16.})
    {
      RunFamily    family  = smooth_family(-1e-3, 0., 0.);
      FamilyMember coarser = family.run({-2, 0, 0});
      const double before  = family.run({-1, 0, 0}).mu;
      coarser.mu           = before + factor * (coarser.mu - before);
      family.add({-2, 0, 0}, coarser);
      // The sign is that of the finer change.
      EXPECT_NEAR(estimate_error(family, {}).mesh,
                  -1e-3 / (1. - 1e-3) * std::min(1., std::abs(factor)),
                  1e-12);
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
