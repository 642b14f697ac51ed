#include <asperity/base/errors.h>
#include <asperity/contact_zone/friction_result.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace asperity;

namespace
{
  /** T_x = 0, -2, -6 N/m and T_y = 0, -10, -10 N/m at t = 0, 1, 3 s; sliding
   *  at 2 m/s. */
  std::vector<FrictionRow>
  three_rows()
  {
    std::vector<FrictionRow> rows(3);
    const double             t[] = {0., 1., 3.}, x[] = {0., -2., -6.},
                 y[] = {0., -10., -10.}, fraction[] = {0., 0.2, 0.4};
    for (unsigned int i = 0; i < 3; ++i)
      {
        rows[i].step             = i;
        rows[i].time             = t[i];
        rows[i].sliding_distance = 2. * t[i];
        rows[i].T_x              = x[i];
        rows[i].T_y              = y[i];
        rows[i].contact_fraction = fraction[i];
      }
    return rows;
  }
} // namespace

TEST(AverageFriction, window_inside_steps_is_the_hand_computed_trapezoid)
{
  // Between the rows T_x(0.5) = -1, T_y(0.5) = -5, T_x(2) = -4, T_y(2) = -10:
  // int T_x = -(1 + 2)/4 - (2 + 4)/2, int T_y = -(5 + 10)/4 - 10.
  const FrictionResult result = average_friction(three_rows(), 0.5, 2.);
  EXPECT_NEAR(result.T_x, -3.75 / 1.5, 1e-14);
  EXPECT_NEAR(result.T_y, -13.75 / 1.5, 1e-14);
  EXPECT_NEAR(result.mu, 3. / 11., 1e-14);
  EXPECT_NEAR(result.mu_end, 0.6, 1e-14);
  // (0.1 + 0.2)/4 + (0.2 + 0.3)/2
  EXPECT_NEAR(result.contact_fraction, 0.325 / 1.5, 1e-14);
  // mu is 0.2, 0.2, 0.4 at the ends of the two pieces: mean 4/15, square 2/25.
  EXPECT_NEAR(result.spread, std::sqrt(0.08 - 16. / 225.), 1e-13);
}

TEST(AverageFriction, window_beyond_the_rows_ends_with_them)
{
  const FrictionResult result = average_friction(three_rows(), 1., 7.);
  EXPECT_EQ(result.window_begin, 1.);
  EXPECT_EQ(result.window_end, 3.);
  EXPECT_NEAR(result.mu, 0.4, 1e-14);
}

TEST(AverageFriction, does_not_depend_on_the_sense_of_sliding)
{
  auto rows = three_rows();
  for (auto &row : rows)
    {
      row.T_x *= -1.;
      row.sliding_distance *= -1.;
    }
  const FrictionResult result = average_friction(rows, 0.5, 2.);
  EXPECT_NEAR(result.T_x, 3.75 / 1.5, 1e-14);
  EXPECT_NEAR(result.mu, 3. / 11., 1e-14);
}

TEST(AverageFriction, is_negative_where_the_tool_pushes_the_chip_along_its_way)
{
  auto rows = three_rows();
  for (auto &row : rows)
    row.T_x *= -1.;
  const FrictionResult result = average_friction(rows, 0.5, 2.);
  EXPECT_NEAR(result.mu, -3. / 11., 1e-14);
  EXPECT_NEAR(result.mu_end, -0.6, 1e-14);
  EXPECT_NEAR(result.spread, std::sqrt(0.08 - 16. / 225.), 1e-13);
}

TEST(AverageFriction, a_finer_partition_of_the_same_history_changes_nothing)
{
  // A row on the straight line between two others adds no information to the
  // forces.
  auto        rows   = three_rows();
  FrictionRow middle = rows[2];
  middle.time        = 2.;
  middle.T_x         = -4.;
  rows.insert(rows.begin() + 2, middle);
  EXPECT_NEAR(average_friction(rows, 0.5, 3.).mu,
              average_friction(three_rows(), 0.5, 3.).mu,
              1e-14);
}

TEST(AverageFriction, empty_windows_are_refused)
{
  EXPECT_THROW(average_friction(three_rows(), 3., 4.), ComputationError);
  EXPECT_THROW(average_friction(three_rows(), 2., 2.), ComputationError);
  EXPECT_THROW(average_friction({FrictionRow()}, 0., 1.), ComputationError);
}

TEST(MeansOverDistance, windows_follow_each_other_from_zero)
{
  const auto means = means_over_distance(three_rows(), 2.);
  ASSERT_EQ(means.size(), 3u);
  // [0, 1] s: 1/5; [1, 2] s: 3/10; [2, 3] s: 5/10
  const double mu[] = {0.2, 0.3, 0.5};
  for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(means[i].from, 2. * i);
      EXPECT_EQ(means[i].to, 2. * (i + 1.));
      EXPECT_NEAR(means[i].mu, mu[i], 1e-14);
    }
}

TEST(MeansOverDistance, an_incomplete_last_window_is_left_out)
{
  const auto means = means_over_distance(three_rows(), 2.5);
  ASSERT_EQ(means.size(), 2u);
  // [0, 1.25] s: int T_x = -1 - 0.25 (2 + 2.5)/2, int T_y = -5 - 2.5
  EXPECT_NEAR(means[0].mu, 1.5625 / 7.5, 1e-14);
  EXPECT_TRUE(means_over_distance(three_rows(), 7.).empty());
  EXPECT_TRUE(means_over_distance({FrictionRow()}, 1.).empty());
}



TEST(ShareOfTool, is_that_of_the_heat_in_the_window)
{
  // Heat of friction 0, 10, 30 and of the tool 0, 2, 14 J/m at t = 0, 1, 3 s;
  // between 0.5 and 2 s come 20 - 5 and 8 - 1.
  auto         rows       = three_rows();
  const double friction[] = {0., 10., 30.}, tool[] = {0., 2., 14.};
  for (unsigned int i = 0; i < 3; ++i)
    {
      rows[i].friction_heat = friction[i];
      rows[i].tool_heat     = tool[i];
    }
  EXPECT_NEAR(share_of_tool(rows, 0.5, 2.).value(), 7. / 15., 1e-14);
  EXPECT_NEAR(share_of_tool(rows, 0., 9.).value(), 14. / 30., 1e-14);
  EXPECT_FALSE(share_of_tool(three_rows(), 0., 3.));
}
