#include <asperity/contact_zone/friction_judgement.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace asperity;

// Histories by formula: the chip slides at 1 m/s for 1 s under a pressure of
// 100 Pa over a period of 2 m, which is 200 N/m once the ramp of 0.2 s is over.

namespace
{
  using History = std::function<double(double)>;

  /** The verdict on the last half of the time, in `n` steps.
   *  @param T_y vertical force over the load, of the time [s]
   *  @param mu of the time */
  FrictionJudgement
  judged(const History &T_y, const History &mu, const unsigned int n = 100)
  {
    LoadParameters load;
    load.pressure = 100.;
    load.velocity = 1.;
    ProtocolParameters protocol;
    protocol.end_time      = 1.;
    protocol.ramp_fraction = 0.2;
    const LoadProtocol       course(load, protocol);
    std::vector<FrictionRow> rows(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      {
        const double t           = static_cast<double>(i) / n;
        rows[i].step             = i;
        rows[i].time             = t;
        rows[i].sliding_distance = t;
        rows[i].T_y              = -2. * course.pressure(t) * T_y(t);
        rows[i].T_x              = mu(t) * rows[i].T_y;
      }
    return judge_friction(rows, average_friction(rows, 0.5, 1.), course, 2.);
  }

  double
  one(const double)
  {
    return 1.;
  }

  double
  a_tenth(const double)
  {
    return 0.1;
  }
} // namespace

TEST(FrictionJudgement, a_load_that_is_carried_makes_a_result)
{
  const FrictionJudgement judgement = judged(one, a_tenth);
  EXPECT_EQ(judgement.status, FrictionStatus::valid);
  EXPECT_NEAR(judgement.carried_load, 1., 1e-12);
  EXPECT_TRUE(judgement.warnings.empty());
}

TEST(FrictionJudgement, half_of_the_load_makes_none)
{
  const auto judgement = judged([](const double) { return 0.47; }, a_tenth);
  EXPECT_EQ(judgement.status, FrictionStatus::load_not_carried);
  EXPECT_NEAR(judgement.carried_load, 0.47, 1e-12);
  ASSERT_EQ(judgement.warnings.size(), 1u);
  EXPECT_EQ(judgement.warnings[0].find("Tool and oil carry 47 % of the load"),
            0u)
    << judgement.warnings[0];
}

TEST(FrictionJudgement, a_chip_that_never_touches_has_no_friction)
{
  const auto judgement = judged([](const double) { return 0.; }, a_tenth);
  EXPECT_EQ(judgement.status, FrictionStatus::load_not_carried);
  EXPECT_EQ(judgement.carried_load, 0.);
}

TEST(FrictionJudgement, deviations_of_the_load_that_cancel_are_allowed)
{
  // Ten full oscillations of a bouncing chip in the window.
  const auto judgement =
    judged([](const double t) { return 1. + 0.5 * std::sin(40. * M_PI * t); },
           a_tenth);
  EXPECT_EQ(judgement.status, FrictionStatus::valid);
}

TEST(FrictionJudgement, contact_that_is_lost_in_the_window_makes_none)
{
  // No force at the moments 0.7 to 0.72: three rows, 3 % of the impulse.
  const auto judgement =
    judged([](const double t) { return t > 0.695 && t < 0.725 ? 0. : 1.; },
           a_tenth);
  EXPECT_EQ(judgement.status, FrictionStatus::load_not_carried);
  const auto shorter =
    judged([](const double t) { return t > 0.695 && t < 0.705 ? 0. : 1.; },
           a_tenth);
  EXPECT_EQ(shorter.status, FrictionStatus::contact_lost);
  ASSERT_EQ(shorter.warnings.size(), 1u);
  EXPECT_EQ(shorter.warnings[0].find("Contact is lost: nothing carries the "
                                     "chip in 1 steps"),
            0u)
    << shorter.warnings[0];
}

TEST(FrictionJudgement, contact_that_is_lost_before_the_window_does_not_matter)
{
  const auto judgement =
    judged([](const double t) { return t > 0.25 && t < 0.4 ? 0. : 1.; },
           a_tenth);
  EXPECT_EQ(judgement.status, FrictionStatus::valid);
}

TEST(FrictionJudgement, a_tool_that_pushes_along_the_way_makes_none)
{
  const auto judgement = judged(one, [](const double) { return -0.02; });
  EXPECT_EQ(judgement.status, FrictionStatus::along_the_motion);
  ASSERT_EQ(judgement.warnings.size(), 1u);
  EXPECT_NE(judgement.warnings[0].find("along its way instead of against it, "
                                       "mu = -0.02"),
            std::string::npos)
    << judgement.warnings[0];
}

TEST(FrictionJudgement, a_spread_beyond_the_mean_makes_none)
{
  // A sine about its mean has the standard deviation amplitude/sqrt(2).
  const auto varying = [](const double amplitude) {
    return judged(
      one,
      [amplitude](const double t) {
        return 0.1 + amplitude * std::sin(40. * M_PI * t);
      },
      1000);
  };
  EXPECT_EQ(varying(0.13).status, FrictionStatus::valid);
  const auto judgement = varying(0.15);
  EXPECT_EQ(judgement.status, FrictionStatus::scattered);
  ASSERT_EQ(judgement.warnings.size(), 1u);
  EXPECT_EQ(judgement.warnings[0].find("mu varies by 0.106 over its window, "
                                       "more than its mean of 0.1"),
            0u)
    << judgement.warnings[0];
}

TEST(FrictionJudgement, round_off_about_zero_is_no_friction_but_a_result)
{
  const auto judgement =
    judged(one, [](const double t) { return 1e-8 * std::sin(99. * t) - 1e-9; });
  EXPECT_EQ(judgement.status, FrictionStatus::valid);
}

TEST(FrictionJudgement, everything_that_is_wrong_is_said)
{
  const auto judgement =
    judged([](const double) { return 0.3; }, [](const double) { return -0.2; });
  EXPECT_EQ(judgement.status, FrictionStatus::load_not_carried);
  EXPECT_EQ(judgement.warnings.size(), 2u);
}
