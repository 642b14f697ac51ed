#include <asperity/contact_zone/error_estimate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

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

  /** Members that are known, of mu as a function of their fineness: none is
   *  computed. */
  RunFamily
  known_family(const std::function<double(const Fineness &)> &mu)
  {
    RunFamily family(coarse_scene());
    for (const int mesh : {-1, 0})
      for (const int step : {-1, 0})
        for (const int penalty : {-1, 0})
          for (const int offset : {0, 1})
            {
              const Fineness fineness{mesh, step, penalty, offset};
              family.add(fineness, {mu(fineness), 1, 1});
            }
    return family;
  }

  /** 1 + (C + A cos(pi offset)) h^2 + s dt + e/penalty, where h = dt = penalty
   *  = 1 of the run itself: A is what is left to chance, which changes its sign
   *  on elements that are moved by half of their length. */
  RunFamily
  converging_family(const double C,
                    const double s,
                    const double e,
                    const double A = 0.)
  {
    return known_family([=](const Fineness &at) {
      return 1. + (C + (at.offset == 0 ? A : -A)) * std::pow(4., -at.mesh) +
             s * std::pow(2., -at.step) + e * std::pow(2., -at.penalty);
    });
  }
} // namespace

// Of a change by 0.6 % a sixth of a tenth is taken for what is not resolved.
TEST(ErrorEstimate, is_exact_where_mu_converges_smoothly)
{
  const double        C = 2e-3, s = -2e-3, e = 5e-4, mu = 1. + C + s + e;
  RunFamily           family = converging_family(C, s, e);
  const ErrorEstimate error  = estimate_error(family, {});
  EXPECT_NEAR(error.mesh, C / mu / (1. + 3. * C / mu / 0.1), 1e-12);
  EXPECT_NEAR(error.step, s / mu, 1e-12);
  EXPECT_NEAR(error.penalty, e / mu, 1e-12);
  EXPECT_NEAR(error.chance, 0., 1e-12);
  // Nothing but what was there was needed.
  EXPECT_EQ(family.size(), 16u);
}

TEST(ErrorEstimate, knows_on_which_side_chance_has_put_the_run)
{
  for (const double A : {4e-3, -4e-3})
    {
      const double        C = 1e-3, s = 2e-3, e = -3e-3;
      const double        mu     = 1. + C + A + s + e;
      RunFamily           family = converging_family(C, s, e, A);
      const ErrorEstimate error  = estimate_error(family, {});
      EXPECT_NEAR(error.mesh, (C / (1. + 3. * C / mu / 0.1) + A) / mu, 1e-12);
      EXPECT_NEAR(error.step, s / mu, 1e-12);
      EXPECT_NEAR(error.penalty, e / mu, 1e-12);
      // Of two draws it is less by an order that halves the elements once more.
      EXPECT_NEAR(error.chance, 1e-3 / mu, 1e-12);
      // The true error is that of all sources.
      EXPECT_NEAR(error.total() / std::abs(mu - 1.), 1., 0.15);
    }
}

// Companions with the elements of the run cost three times as much. They are
// needed where elements twice as long change mu by more than 5 %, by 3 C, or
// where what moving them changes is more than 0.4 of the error that they tell.
TEST(ErrorEstimate, varies_steps_on_a_mesh_that_is_fine_enough)
{
  const double s = -2e-3, e = 5e-4;
  for (const auto &[C, A, coarse] : {std::tuple(0.015, 0., true),
                                     std::tuple(0.02, 0., false),
                                     std::tuple(-0.002, 0.0003, true),
                                     std::tuple(-0.002, 0.0005, false)})
    {
      RunFamily all = converging_family(C, s, e, A);
      RunFamily few(all.parameters());
      for (const Fineness &fineness :
           {Fineness{0, 0, 0}, Fineness{-1, 0, 0}, Fineness{-1, 0, 0, 1}})
        few.add(fineness, all.run(fineness));
      if (coarse || std::abs(C) < 0.01)
        for (const Fineness &fineness :
             {Fineness{-1, -1, 0}, Fineness{-1, 0, -1}})
          few.add(fineness, all.run(fineness));
      if (!coarse)
        for (const Fineness &fineness :
             {Fineness{0, 0, 0, 1}, Fineness{0, -1, 0}, Fineness{0, 0, -1}})
          few.add(fineness, all.run(fineness));
      const std::size_t size = few.size();
      EXPECT_EQ(estimate_error(few, {}).total(),
                estimate_error(all, {}).total());
      EXPECT_EQ(few.size(), size); // nothing else was computed
    }
}

// Two draws may agree by chance if the chip slides over few elements.
TEST(ErrorEstimate, trusts_no_two_draws_of_short_ways)
{
  for (const auto &[passed, size] :
       {std::pair(1.9, 6u), std::pair(2.1, 5u), std::pair(0., 5u)})
    {
      RunFamily all = converging_family(-0.002, -2e-3, 5e-4);
      RunFamily few(all.parameters());
      few.add({}, {all.run({}).mu, 1, 1, passed});
      for (const Fineness &fineness :
           {Fineness{-1, 0, 0}, Fineness{-1, 0, 0, 1}})
        few.add(fineness, all.run(fineness));
      const std::vector<Fineness> more =
        passed == 1.9 ?
          std::vector<Fineness>{{0, -1, 0}, {0, 0, -1}, {0, 0, 0, 1}} :
          std::vector<Fineness>{{-1, -1, 0}, {-1, 0, -1}};
      for (const Fineness &fineness : more)
        few.add(fineness, all.run(fineness));
      EXPECT_GT(estimate_error(few, {}).total(), 0.);
      EXPECT_EQ(few.size(), size) << passed;
    }
}

// mu of a chip whose contacts the longer elements miss: an error by C h^2 would
// be a third of what they change.
TEST(ErrorEstimate, takes_less_of_what_is_not_resolved)
{
  for (const double change : {-0.1, -0.4})
    {
      RunFamily family = known_family(
        [&](const Fineness &at) { return at.mesh == 0 ? 1. : 1. + change; });
      const ErrorEstimate error = estimate_error(family, {});
      const double        share = change > -0.2 ? 2. : 5.;
      EXPECT_NEAR(error.mesh, change / 3. / share, 1e-12);
      EXPECT_NEAR(error.unresolved, 0.5 * change * change, 1e-12);
    }
}

// Companions of a patch by hand: elements twice as long along and across,
// moved by half of theirs, half the steps, half the penalty.
TEST(ErrorEstimate, of_a_patch_is_that_of_companions_by_hand)
{
  SceneParameters patch      = narrow_scene();
  patch.mesh.degree          = 1;
  patch.tool.spans           = std::nullopt;
  patch.tool.wave_numbers    = {1., 1.};
  patch.tool.across          = {1., -1.};
  patch.tool.amplitudes      = {0.1e-6, 0.05e-6};
  patch.tool.phases          = {0.3, 1.};
  patch.protocol.ramp_steps  = 2;
  patch.protocol.slide_steps = 4;
  RunFamily           family(patch);
  const ErrorEstimate error = estimate_error(family, {});

  SceneParameters coarse        = patch;
  coarse.mesh.spans             = 8;
  coarse.mesh.across            = 3;
  coarse.mesh.refinement        = 0;
  coarse.contact.penalty_factor = 2. * patch.contact.penalty_factor;
  SceneParameters moved         = coarse;
  moved.mesh.offset             = 0.5;
  const auto mu                 = [](const SceneParameters &parameters) {
    return CompleteRunIn<3>(parameters).run.friction().mu;
  };
  const double of = mu(patch), on_coarse = mu(coarse);
  const double change = (0.5 * (on_coarse + mu(moved)) - of) / of;
  // What decides between cheap and dear companions is tested above.
  const bool   is_cheap = !family.has({0, -1, 0});
  const double draw = is_cheap ? of : mu(with_fineness(patch, {0, 0, 0, 1}));
  const double half = 0.5 * (draw - of) / of;
  EXPECT_NEAR(error.mesh,
              (change - half) / 3. / (1. + std::abs(change - half) / 0.1) -
                half,
              1e-6);
  SceneParameters base = is_cheap ? coarse : patch, fewer = base, softer = base;
  fewer.protocol.ramp_steps  = 1;
  fewer.protocol.slide_steps = 2;
  softer.contact.penalty_factor *= 0.5;
  const double mu_base = is_cheap ? on_coarse : of;
  EXPECT_NEAR(error.step, (mu(fewer) - mu_base) / of, 1e-6);
  EXPECT_NEAR(error.penalty, (mu(softer) - mu_base) / of, 1e-6);
  EXPECT_GT(std::abs(error.mesh), 1e-3);
}

TEST(ErrorEstimate, is_that_of_the_sum_and_of_what_is_not_known_of_it)
{
  const ErrorEstimate same{0.003, 0.004, 0.012};
  EXPECT_NEAR(same.total(), std::hypot(0.019, 0.1 * 0.013), 1e-15);
  const ErrorEstimate cancels{0.003, 0.004, -0.007, 0.002};
  EXPECT_NEAR(cancels.total(), std::sqrt(0.74e-6 + 4e-6), 1e-15);
  EXPECT_EQ(same.largest(), "penalty");
  EXPECT_EQ((ErrorEstimate{-0.02, 0.01, 0.}).largest(), "mesh");
  EXPECT_EQ((ErrorEstimate{-0.002, 0.01, 0., 0.02}).largest(), "mesh");
}

// Errors are relative to |mu| and positive where mu is too large: a mu of 0.2
// that is 2 % too large for 0.196 is corrected to this, one of -0.2 for -0.204.
TEST(ErrorEstimate, corrects_mu_by_the_sum_of_its_sources)
{
  const ErrorEstimate error{0.03, -0.015, 0.005, 0.001};
  EXPECT_NEAR(error.corrected(0.2), 0.196, 1e-15);
  EXPECT_NEAR(error.corrected(-0.2), -0.204, 1e-15);
}

TEST(ErrorEstimate, leaves_uncertain_a_part_of_each_source_after_correction)
{
  // 3, 4 and 12 make 13; signs do not matter.
  for (const double sign : {1., -1.})
    {
      const ErrorEstimate error{0.003, sign * 0.004, 0.012, 0.005, 0.006};
      EXPECT_NEAR(error.uncertainty(),
                  std::sqrt(0.64 * 1.69e-4 + 0.25e-4 + 0.36e-4),
                  1e-15);
    }
}

// The limit is 1; what the correction misses is what is taken for not resolved.
TEST(ErrorEstimate, corrects_mu_to_its_limit_where_it_converges_smoothly)
{
  const double        C = 2e-3, s = -2e-3, e = 5e-4, mu = 1. + C + s + e;
  RunFamily           family = converging_family(C, s, e);
  const ErrorEstimate error  = estimate_error(family, {});
  EXPECT_NEAR(error.corrected(mu),
              1. + C - C / (1. + 3. * C / mu / 0.1),
              1e-12);
  EXPECT_LT(std::abs(error.corrected(mu) - 1.), mu * error.uncertainty());
}

TEST(ErrorEstimate, falls_by_the_orders_of_its_sources)
{
  const ErrorEstimate error =
    ErrorEstimate{0.16, -0.08, 0.02, 0.04, 0.16}.after({1, 2, 1});
  EXPECT_DOUBLE_EQ(error.mesh, 0.04);
  EXPECT_DOUBLE_EQ(error.step, -0.02);
  EXPECT_DOUBLE_EQ(error.penalty, 0.01);
  EXPECT_DOUBLE_EQ(error.chance, 0.01);
  EXPECT_DOUBLE_EQ(error.unresolved, 0.01);
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
  soft.protocol.ramp_steps    = 6;
  soft.protocol.slide_steps   = 12;
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
