#include <asperity/base/errors.h>
#include <asperity/topography/periodic_continuation.h>
#include <asperity/topography/profile.h>

#include <numeric>

#include "topography_test_tools.h"

using namespace asperity;
using namespace asperity_test;

namespace
{
  const double pi = std::acos(-1.);

  Profile
  sample(const unsigned int                   n,
         const double                         spacing,
         const std::function<double(double)> &f)
  {
    Profile profile;
    profile.spacing = spacing;
    for (unsigned int i = 0; i < n; ++i)
      profile.heights.push_back(f(i * spacing));
    return profile;
  }

  double
  mean(const std::vector<double> &values)
  {
    return std::accumulate(values.begin(), values.end(), 0.) / values.size();
  }

  WrappedSplineOptions
  without_blend(const unsigned int degree)
  {
    WrappedSplineOptions options;
    options.degree           = degree;
    options.blend_fraction   = 0.;
    options.samples_per_knot = 2.;
    return options;
  }
} // namespace

TEST(ExtractProfile, along_rows_and_columns_holds_the_samples_themselves)
{
  const auto  map = make_map(30, 20, 1., 2., [](double x, double y) {
    return x * x + 100. * y;
  });
  ProfileLine line;
  line.y         = 8.3; // row 4
  const auto row = extract_profile(map, line);
  EXPECT_EQ(row.spacing, 1.);
  ASSERT_EQ(row.heights.size(), 30u);
  for (unsigned int i = 0; i < 30; ++i)
    EXPECT_EQ(row.heights[i], map(i, 4));

  line.angle        = 0.5 * pi;
  line.x            = 7.;
  const auto column = extract_profile(map, line);
  EXPECT_EQ(column.spacing, 2.);
  ASSERT_EQ(column.heights.size(), 20u);
  for (unsigned int j = 0; j < 20; ++j)
    EXPECT_EQ(column.heights[j], map(7, j));
}

// Bilinear interpolation is exact on a plane.
TEST(ExtractProfile, oblique_line_on_a_plane_is_straight)
{
  const auto map = make_map(60, 40, 0.5, 0.7, [](double x, double y) {
    return 0.3 * x - 0.2 * y;
  });
  for (const double degrees : {10., 45., 80., 120., -30., 180.})
    {
      ProfileLine line;
      line.angle           = degrees * pi / 180.;
      line.x               = 15.;
      line.y               = 14.;
      const auto   profile = extract_profile(map, line);
      const double slope =
        0.3 * std::cos(line.angle) - 0.2 * std::sin(line.angle);
      EXPECT_GT(profile.heights.size(), 50u);
      for (std::size_t i = 1; i < profile.heights.size(); ++i)
        EXPECT_NEAR(profile.heights[i] - profile.heights[0],
                    slope * i * profile.spacing,
                    1e-12)
          << degrees;
    }
}

TEST(ExtractProfile, a_part_of_a_line)
{
  const auto map = make_map(100, 3, 1., 1., [](double x, double) { return x; });
  ProfileLine line;
  line.from          = 20.;
  line.to            = 50.;
  const auto profile = extract_profile(map, line);
  ASSERT_EQ(profile.heights.size(), 31u);
  EXPECT_EQ(profile.heights.front(), 20.);
  EXPECT_EQ(profile.length(), 30.);
  line.to = 500.;
  EXPECT_THROW(extract_profile(map, line), InputError);
}

TEST(ExtractProfile, lines_outside_the_map_are_refused)
{
  const auto map =
    make_map(100, 50, 1., 1., [](double x, double) { return x; });
  ProfileLine line;
  line.y = 60.;
  EXPECT_THROW(extract_profile(map, line), InputError);
  line.angle = 0.3;
  line.y     = 1000.;
  EXPECT_THROW(extract_profile(map, line), InputError);
}

TEST(ExtractProfile, a_missing_corner_without_weight_does_not_count)
{
  auto map   = make_map(30, 30, 1., 1., [](double, double) { return 1.; });
  map(10, 9) = missing_height;
  ProfileLine line;
  line.angle         = 0.25 * pi;
  line.x             = 10.;
  line.y             = 10.; // through samples (k, k) only when s is whole
  const auto profile = extract_profile(map, line);
  EXPECT_FALSE(std::isnan(profile.heights.front()));
  unsigned int n_missing = 0;
  for (const double z : profile.heights)
    n_missing += std::isnan(z);
  EXPECT_GE(n_missing, 1u);
  EXPECT_LE(n_missing, 4u);
}

TEST(PeriodicContinuation, periodic_waves_pass_the_wrapped_spline)
{
  const unsigned int n = 200;
  for (const unsigned int degree : {2, 3, 4, 5})
    {
      // Symmetric about the middle sample, so that its trend is zero.
      const auto         wave = sample(n, 0.5, [&](double x) {
        const double t = 2. * pi * x / (0.5 * n);
        return std::cos(t - 2. * pi * 0.5 * (n - 1.) / n) +
               0.3 * std::cos(3. * (t - 2. * pi * 0.5 * (n - 1.) / n));
      });
      ContinuationReport report;
      const auto         result = make_periodic(wave,
                                        Continuation::wrapped_spline,
                                        without_blend(degree),
                                        report);
      EXPECT_TRUE(result.periodic);
      EXPECT_EQ(result.length(), 0.5 * n);
      EXPECT_EQ(report.n_knots, n / 2);
      const double shift = mean(wave.heights) - mean(result.heights);
      for (unsigned int i = 0; i < n; ++i)
        EXPECT_NEAR(result.heights[i] + shift, wave.heights[i], 2e-5)
          << "degree " << degree;
      EXPECT_NEAR(report.Rq_after, report.Rq_before, 1e-5);
    }
}

// Cubic splines: fourth order in the knot spacing.
TEST(PeriodicContinuation, fit_converges_with_the_order_of_the_spline)
{
  double previous = 0.;
  for (const unsigned int n : {100u, 200u, 400u})
    {
      const auto         wave = sample(n, 1., [n](double x) {
        return std::cos(8. * 2. * pi * (x - 0.5 * (n - 1.)) / n);
      });
      ContinuationReport report;
      make_periodic(wave,
                    Continuation::wrapped_spline,
                    without_blend(3),
                    report);
      if (previous > 0.)
        {
          EXPECT_GT(previous / report.fit_rms, 12.);
          EXPECT_LT(previous / report.fit_rms, 24.);
        }
      previous = report.fit_rms;
    }
}

TEST(PeriodicContinuation, a_straight_line_becomes_flat)
{
  const auto line = sample(100, 1e-6, [](double x) { return 5e-6 + 0.25 * x; });
  ContinuationReport report;
  const auto         result =
    make_periodic(line, Continuation::wrapped_spline, {}, report);
  EXPECT_NEAR(report.removed_trend, 0.25, 1e-12);
  for (const double z : result.heights)
    EXPECT_NEAR(z, 0., 1e-17);
}

TEST(PeriodicContinuation, seam_of_a_rough_profile_is_bridged_smoothly)
{
  // Waves that do not fit into the length: a jump in height and slope.
  const auto         rough = sample(400, 0.1e-6, [](double x) {
    return 0.2e-6 * std::sin(2. * pi * x / 7.3e-6) +
           0.05e-6 * std::sin(2. * pi * x / 1.9e-6 + 1.);
  });
  ContinuationReport report;
  const auto         result =
    make_periodic(rough, Continuation::wrapped_spline, {}, report);
  EXPECT_GT(std::abs(report.jump_before), 0.03e-6);
  EXPECT_LT(std::abs(report.jump_after), 0.002e-6);
  EXPECT_LT(std::abs(report.slope_jump_after), 0.03);
  EXPECT_LT(report.max_slope_after, 1.2 * report.max_slope_before);
  // Away from the seam nothing happens.
  EXPECT_LT(report.fit_rms, 1e-10);
  EXPECT_NEAR(report.Rq_after, report.Rq_before, 0.1 * report.Rq_before);
  EXPECT_EQ(result.heights.size(), rough.heights.size());
}

TEST(PeriodicContinuation, mirror_keeps_heights_and_closes)
{
  const auto         curve = sample(50, 2., [](double x) { return x * x; });
  ContinuationReport report;
  const auto result = make_periodic(curve, Continuation::mirror, {}, report);
  ASSERT_EQ(result.heights.size(), 98u);
  EXPECT_EQ(result.length(), 2. * curve.length());
  for (unsigned int i = 0; i < 50; ++i)
    {
      EXPECT_EQ(result.heights[i], curve.heights[i]);
      EXPECT_EQ(result.heights[(98 - i) % 98], curve.heights[i]);
    }
}

TEST(PeriodicContinuation, none_keeps_everything_and_reports_the_jump)
{
  const auto         line = sample(50, 1., [](double x) { return 2. * x; });
  ContinuationReport report;
  const auto result = make_periodic(line, Continuation::none, {}, report);
  EXPECT_EQ(result.heights, line.heights);
  EXPECT_EQ(result.length(), 50.);
  EXPECT_NEAR(report.jump_after, 100., 1e-12);
}

TEST(PeriodicContinuation, too_short_a_profile_is_refused)
{
  ContinuationReport report;
  EXPECT_THROW(make_periodic(sample(5, 1., [](double x) { return x; }),
                             Continuation::wrapped_spline,
                             {},
                             report),
               InputError);
}
