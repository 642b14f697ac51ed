#include <asperity/contact_zone/load_protocol.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace asperity;

namespace
{
  /** All step ends from 0 to the end. */
  std::vector<double>
  step_ends(const LoadProtocol &protocol)
  {
    std::vector<double> times;
    double              time = 0.;
    while (time < protocol.end_time() * (1. - 1e-12) && times.size() < 100000)
      times.push_back(time = protocol.next_time(time));
    return times;
  }
} // namespace

TEST(LoadProtocol, pressure_is_half_a_cosine_then_constant)
{
  // p/2 (1 - cos(pi t/t_r)): 0, p/4 at t_r/3, p/2 at t_r/2, 3p/4, p
  const LoadParameters     load;
  const ProtocolParameters parameters;
  const LoadProtocol       protocol(load, parameters);
  const double             t_r = protocol.ramp_time();
  EXPECT_DOUBLE_EQ(t_r, 0.2 * 2.5e-7);
  const double p = 300e6;
  EXPECT_EQ(protocol.pressure(0.), 0.);
  EXPECT_NEAR(protocol.pressure(t_r / 3.), 0.25 * p, 1e-6 * p);
  EXPECT_NEAR(protocol.pressure(t_r / 2.), 0.5 * p, 1e-6 * p);
  EXPECT_NEAR(protocol.pressure(2. * t_r / 3.), 0.75 * p, 1e-6 * p);
  EXPECT_EQ(protocol.pressure(t_r), p);
  EXPECT_EQ(protocol.pressure(2.5e-7), p);
}

TEST(LoadProtocol, pressure_starts_and_ends_without_a_jump_of_its_rate)
{
  const LoadProtocol protocol({}, {});
  const double       t_r = protocol.ramp_time(), h = 1e-4 * t_r;
  EXPECT_LT(protocol.pressure(h) / h, 1e-3 * 300e6 / t_r);
  EXPECT_LT((protocol.pressure(t_r) - protocol.pressure(t_r - h)) / h,
            1e-3 * 300e6 / t_r);
}

TEST(LoadProtocol, bottom_moves_with_constant_velocity)
{
  LoadParameters load;
  load.velocity = 22.5 / 60.;
  const LoadProtocol protocol(load, {});
  EXPECT_DOUBLE_EQ(protocol.displacement(2.5e-7), 9.375e-8);
}

TEST(LoadProtocol, chip_turns_back_at_the_end_of_a_step)
{
  LoadParameters load;
  load.velocity = 2.;
  ProtocolParameters parameters;
  parameters.end_time          = 1e-6;
  parameters.slide_steps       = 7;
  parameters.reversal_distance = 0.9e-6;
  const LoadProtocol protocol(load, parameters);
  EXPECT_DOUBLE_EQ(protocol.reversal_time(), 0.45e-6);
  EXPECT_DOUBLE_EQ(protocol.displacement(0.4e-6), 0.8e-6);
  EXPECT_DOUBLE_EQ(protocol.displacement(0.5e-6), 0.8e-6);
  EXPECT_NEAR(protocol.displacement(1e-6), -0.2e-6, 1e-20);
  EXPECT_EQ(protocol.direction(0.45e-6), 1.);
  EXPECT_EQ(protocol.direction(0.46e-6), -1.);
  const std::vector<double> ends = step_ends(protocol);
  EXPECT_EQ(std::count_if(ends.begin(),
                          ends.end(),
                          [](const double time) {
                            return std::abs(time - 0.45e-6) < 1e-20;
                          }),
            1);
  EXPECT_EQ(ends.size(), 24u + 7u + 1u);
  EXPECT_DOUBLE_EQ(ends.back(), 1e-6);
}

TEST(LoadProtocol, steps_hit_the_end_of_the_ramp_and_of_the_run)
{
  for (const unsigned int ramp_steps : {1, 7, 24})
    for (const unsigned int slide_steps : {1, 13, 96})
      for (const double ramp_fraction : {0.2, 1. / 3., 0.07})
        {
          ProtocolParameters parameters;
          parameters.ramp_fraction = ramp_fraction;
          parameters.ramp_steps    = ramp_steps;
          parameters.slide_steps   = slide_steps;
          const LoadProtocol protocol({}, parameters);
          const auto         times = step_ends(protocol);
          ASSERT_EQ(times.size(), ramp_steps + slide_steps);
          EXPECT_DOUBLE_EQ(times[ramp_steps - 1], protocol.ramp_time());
          EXPECT_DOUBLE_EQ(times.back(), 2.5e-7);
          for (std::size_t i = 1; i < times.size(); ++i)
            EXPECT_GT(times[i], times[i - 1]);
        }
}

TEST(LoadProtocol, a_cut_step_returns_to_the_regular_ends)
{
  ProtocolParameters parameters;
  parameters.ramp_steps  = 10;
  parameters.slide_steps = 20;
  const LoadProtocol protocol({}, parameters);
  const auto         times = step_ends(protocol);
  for (std::size_t i = 1; i < times.size(); ++i)
    for (const double part : {0.5, 0.25, 1. / 256.})
      EXPECT_DOUBLE_EQ(protocol.next_time(times[i - 1] +
                                          part * (times[i] - times[i - 1])),
                       times[i]);
}

TEST(LoadProtocol, steady_window_ends_at_the_maximal_distance)
{
  ProtocolParameters parameters;
  parameters.window           = FrictionWindow::steady;
  parameters.maximum_distance = 3e-6;
  parameters.steady_step      = 10e-9;
  parameters.ramp_steps       = 8;
  LoadParameters load;
  load.velocity = 2.;
  const LoadProtocol protocol(load, parameters);
  EXPECT_DOUBLE_EQ(protocol.end_time(), 1.5e-6);
  const auto times = step_ends(protocol);
  // (1.5 us - 0.05 us) * 2 m/s / 10 nm
  EXPECT_EQ(times.size(), 8u + 290u);
  EXPECT_NEAR(protocol.displacement(times[9] - times[8]), 10e-9, 1e-15);
  EXPECT_DOUBLE_EQ(times.back(), 1.5e-6);
}

TEST(LoadProtocol, a_sliding_distance_sets_the_end_time)
{
  SceneParameters parameters;
  parameters.load.velocity             = 2.;
  parameters.protocol.sliding_distance = 1e-6;
  parameters.resolve();
  const LoadProtocol protocol(parameters.load, parameters.protocol);
  EXPECT_DOUBLE_EQ(protocol.end_time(), 0.5e-6);
  EXPECT_DOUBLE_EQ(protocol.displacement(protocol.end_time()), 1e-6);
  EXPECT_DOUBLE_EQ(protocol.ramp_time(), 0.2 * 0.5e-6);
}

TEST(LoadProtocol,
     a_ramp_has_more_steps_where_spots_bear_the_strength_of_the_chip)
{
  const auto steps = [](const InterfaceShear               law,
                        const std::optional<unsigned int> &chosen) {
    SceneParameters parameters;
    parameters.interface.law              = law;
    parameters.protocol.chosen_ramp_steps = chosen;
    parameters.resolve();
    return parameters.protocol.ramp_steps;
  };
  EXPECT_EQ(steps(InterfaceShear::none, {}), 24u);
  EXPECT_EQ(steps(InterfaceShear::coulomb, {}), 24u);
  EXPECT_EQ(steps(InterfaceShear::shear_factor, {}), 36u);
  EXPECT_EQ(steps(InterfaceShear::shear_factor, 7), 7u);
}
