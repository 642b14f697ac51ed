#include <asperity/base/errors.h>
#include <asperity/topography/form_removal.h>
#include <asperity/topography/gaussian_filter.h>
#include <asperity/topography/missing_data.h>
#include <asperity/topography/roughness.h>
#include <asperity/topography/sanity_report.h>

#include <cmath>

#include "topography_test_tools.h"

using namespace asperity;
using namespace asperity_test;

namespace
{
  const double pi = std::acos(-1.);

  double
  largest(const HeightMap &map)
  {
    double maximum = 0.;
    for (const double z : map.heights)
      if (!std::isnan(z))
        maximum = std::max(maximum, std::abs(z));
    return maximum;
  }
} // namespace

TEST(FormRemoval, plane_leaves_nothing_of_a_plane)
{
  auto map = make_map(40, 30, 1e-6, 2e-6, [](double x, double y) {
    return 1e-3 + 0.1 * x - 0.3 * y;
  });
  remove_form(map, 1);
  EXPECT_LT(largest(map), 1e-18);
}

TEST(FormRemoval, plane_is_fitted_to_valid_points_only)
{
  auto       map = make_map(40, 30, 1e-6, 1e-6, [](double x, double y) {
    return x < 20e-6 && y < 15e-6 ? missing_height : 0.2 * x - 0.1 * y;
  });
  const auto n   = map.n_valid();
  remove_form(map, 1);
  EXPECT_LT(largest(map), 1e-18);
  EXPECT_EQ(map.n_valid(), n);
}

TEST(FormRemoval, polynomial_of_degree_n_leaves_nothing_of_itself)
{
  for (unsigned int degree = 0; degree <= 6; ++degree)
    {
      auto map = make_map(35, 25, 1., 1., [degree](double x, double y) {
        double z = 1.;
        for (unsigned int k = 1; k <= degree; ++k)
          z += std::pow((x - 0.4 * y) / 30., k);
        return z;
      });
      remove_form(map, degree);
      EXPECT_LT(largest(map), 1e-13) << "degree " << degree;
    }
}

TEST(FormRemoval, profile_of_one_row)
{
  auto map =
    make_map(50, 1, 1e-6, 1e-6, [](double x, double) { return 0.1 * x + 1.; });
  remove_form(map, 1);
  EXPECT_LT(largest(map), 1e-15);
}

TEST(FormRemoval, points_on_one_line_do_not_determine_a_plane)
{
  const auto map = make_map(10, 10, 1., 1., [](double x, double y) {
    return x == y ? x : missing_height;
  });
  EXPECT_THROW(
    {
      auto copy = map;
      remove_form(copy, 1);
    },
    InputError);
}

TEST(GaussianFilter, keeps_a_constant_everywhere)
{
  auto       map    = make_map(60, 40, 1., 1., [](double x, double y) {
    return (x > 20 && x < 25 && y > 3) ? missing_height : 7.;
  });
  const auto smooth = gaussian_low_pass(map, 9.);
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    {
      EXPECT_EQ(std::isnan(smooth.heights[i]), std::isnan(map.heights[i]));
      if (!std::isnan(map.heights[i]))
        {
          EXPECT_NEAR(smooth.heights[i], 7., 1e-13);
        }
    }
}

// Transmission exp(-pi (alpha cutoff / wavelength)^2), alpha^2 = ln 2 / pi;
// cutting the weights at one cutoff leaves 0.1 %.
TEST(GaussianFilter, transmits_half_of_a_wave_at_the_cutoff)
{
  const unsigned int n      = 600;
  const double       cutoff = 60.;
  for (const double wavelength : {30., 60., 120., 300.})
    {
      std::vector<double> wave(n);
      for (unsigned int i = 0; i < n; ++i)
        wave[i] = std::cos(2. * pi * i / wavelength);
      const auto   low      = gaussian_low_pass(wave, 1., cutoff, true);
      const double expected = std::exp2(-std::pow(cutoff / wavelength, 2));
      EXPECT_NEAR(low[0], expected, 1.5e-3) << "wavelength " << wavelength;
    }
}

TEST(GaussianFilter, s_and_l_filters_share_a_map_between_them)
{
  const auto map        = make_map(80, 50, 1., 1.5, [](double x, double y) {
    return std::sin(0.7 * x) + std::cos(0.05 * x * y);
  });
  auto       long_waves = map, short_waves = map;
  apply_s_filter(long_waves, 12.);
  apply_l_filter(short_waves, 12.);
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    EXPECT_NEAR(long_waves.heights[i] + short_waves.heights[i],
                map.heights[i],
                1e-14);
}

TEST(GaussianFilter, index_below_two_samples_is_refused)
{
  auto map = make_map(20, 20, 1., 1., [](double, double) { return 1.; });
  EXPECT_THROW(apply_s_filter(map, 2.), InputError);
  EXPECT_THROW(apply_l_filter(map, 0.5), InputError);
}

// Whole waves, many samples: Ra = 2A/pi, Rq = A/sqrt 2, Rsk = 0, Rku = 1.5,
// Rdq = A k/sqrt 2.
TEST(Roughness, of_a_sine)
{
  const double        A = 0.3, k = 2. * pi / 200.;
  std::vector<double> wave(5000);
  for (unsigned int i = 0; i < wave.size(); ++i)
    wave[i] = 4. + A * std::sin(k * i);
  const auto r = profile_roughness(wave, 1.);
  EXPECT_NEAR(r.Ra, 2. * A / pi, 1e-4 * A);
  EXPECT_NEAR(r.Rq, A / std::sqrt(2.), 1e-12);
  EXPECT_NEAR(r.Rz, 2. * A, 1e-12);
  EXPECT_NEAR(r.Rt, 2. * A, 1e-12);
  EXPECT_NEAR(r.Rsk, 0., 1e-10);
  EXPECT_NEAR(r.Rku, 1.5, 1e-10);
  // Three samples at each end have no slope, so the waves are not whole.
  EXPECT_NEAR(r.Rdq, A * k / std::sqrt(2.), 1e-3 * A * k);
}

TEST(Roughness, Rz_is_the_mean_over_five_sections_and_Rt_is_not)
{
  std::vector<double> z(50, 0.);
  for (unsigned int s = 0; s < 5; ++s)
    z[10 * s + 4] = s + 1.; // peaks of 1, 2, 3, 4, 5
  const auto r = profile_roughness(z, 1.);
  EXPECT_NEAR(r.Rz, 3., 1e-14);
  EXPECT_NEAR(r.Rt, 5., 1e-14);
}

TEST(Roughness, areal_parameters_of_an_egg_box)
{
  const double A = 0.2, k = 2. * pi / 100.;
  const auto   map = make_map(300, 200, 1., 1., [=](double x, double y) {
    return A * std::sin(k * x) * std::sin(k * y);
  });
  const auto   a   = areal_roughness(map);
  // Means of sin^2 sin^2 and sin^4 sin^4 over whole waves are 1/4 and 9/64.
  EXPECT_NEAR(a.Sq, A / 2., 1e-12);
  EXPECT_NEAR(a.Sa, A * 4. / (pi * pi), 1e-3 * A);
  EXPECT_NEAR(a.Sz, 2. * A, 1e-12);
  EXPECT_NEAR(a.Ssk, 0., 1e-10);
  EXPECT_NEAR(a.Sku, 9. / 64. * 16., 1e-10);
  EXPECT_NEAR(a.Sdq, A * k / std::sqrt(2.), 0.02 * A * k);
  // sqrt(1 + s^2) - 1 = s^2/2 but for terms of s^4
  EXPECT_NEAR(a.Sdr, 0.5 * a.Sdq * a.Sdq, 1e-4 * a.Sdr);
}

TEST(Roughness, slope_of_a_plane_is_exact_also_beside_missing_points)
{
  auto map     = make_map(20, 20, 0.5, 2., [](double x, double y) {
    return 0.3 * x - 0.4 * y;
  });
  map(10, 10)  = missing_height;
  const auto a = areal_roughness(map);
  EXPECT_NEAR(a.Sdq, 0.5, 1e-13);
  EXPECT_NEAR(a.Sdr, std::sqrt(1.25) - 1., 1e-13);
}

TEST(MissingData, largest_window_agrees_with_brute_force)
{
  unsigned int seed   = 1;
  const auto   random = [&seed]() {
    seed = 1664525u * seed + 1013904223u;
    return seed >> 16;
  };
  for (unsigned int trial = 0; trial < 50; ++trial)
    {
      const unsigned int nx = 2 + random() % 9, ny = 1 + random() % 9;
      auto               map  = make_map(nx, ny, 1., 1., [&](double, double) {
        return random() % 5 == 0 ? missing_height : 1.;
      });
      unsigned int       best = 0;
      for (unsigned int i = 0; i < nx; ++i)
        for (unsigned int j = 0; j < ny; ++j)
          for (unsigned int w = 1; i + w <= nx; ++w)
            for (unsigned int h = 1; j + h <= ny; ++h)
              {
                bool whole = true;
                for (unsigned int a = i; a < i + w; ++a)
                  for (unsigned int b = j; b < j + h; ++b)
                    whole = whole && !std::isnan(map(a, b));
                if (whole)
                  best = std::max(best, w * h);
              }
      const Window window = largest_window_without_holes(map);
      EXPECT_EQ(window.nx * window.ny, best);
      if (window.nx >= 2)
        {
          EXPECT_EQ(crop(map, window).missing_fraction(), 0.);
        }
    }
}

TEST(MissingData, crop_outside_the_map_is_refused)
{
  const auto map = make_map(10, 5, 1., 1., [](double, double) { return 1.; });
  EXPECT_THROW(crop(map, {0, 0, 11, 5}), InputError);
  EXPECT_THROW(crop(map, {4294967295u, 0, 5, 5}), InputError);
  EXPECT_THROW(crop(map, {0, 0, 0, 0}), InputError);
}

TEST(MissingData, spikes_are_found_and_nothing_else)
{
  unsigned int seed = 7;
  auto         map  = make_map(60, 60, 1., 1., [&seed](double x, double y) {
    seed = 1664525u * seed + 1013904223u;
    return 0.1 * std::sin(0.1 * x) + 0.5 * y +
           0.02 * ((seed >> 16) % 1000) / 1000.;
  });
  map(10, 20) += 1.;
  map(59, 0) -= 1.;
  map(30, 31) += 0.8;
  EXPECT_EQ(remove_spikes(map, 20.), 3u);
  EXPECT_TRUE(std::isnan(map(10, 20)));
  EXPECT_TRUE(std::isnan(map(59, 0)));
  EXPECT_TRUE(std::isnan(map(30, 31)));
}

TEST(MissingData, gaps_are_filled_by_straight_lines)
{
  const double        nan = missing_height;
  std::vector<double> z   = {nan, 1., nan, nan, 4., nan};
  EXPECT_EQ(fill_gaps(z), 4u);
  EXPECT_EQ(z, (std::vector<double>{1., 1., 2., 3., 4., 4.}));
  std::vector<double> nothing(3, nan);
  EXPECT_THROW(fill_gaps(nothing), InputError);
}

TEST(SanityReport, warns_of_implausible_units)
{
  const auto has = [](const HeightMap &map, const std::string &word) {
    for (const auto &warning : check_sanity(map).warnings)
      if (warning.find(word) != std::string::npos)
        return true;
    return false;
  };
  const auto wave   = [](double x, double) { return std::sin(1e6 * x); };
  const auto scaled = [&](double dx, double dy, double factor) {
    return make_map(100, 80, dx, dy, [&](double x, double y) {
      return factor * wave(x, y);
    });
  };
  EXPECT_TRUE(check_sanity(scaled(1e-6, 1e-6, 1e-7)).warnings.empty());
  EXPECT_TRUE(has(scaled(1e-6, 1e-6, 1e-1), "1e-6 to 1"));
  EXPECT_TRUE(has(scaled(1e-6, 1e-6, 1e-12), "1e-6 to 1"));
  EXPECT_TRUE(has(scaled(1e-6, 2e-6, 1e-7), "differs between x"));
  EXPECT_TRUE(has(scaled(1., 1., 1e-2), "lateral unit"));
}
