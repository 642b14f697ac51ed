#include <asperity/topography/autocorrelation.h>
#include <asperity/topography/gaussian_filter.h>
#include <asperity/topography/texture.h>
#include <asperity/topography/typical_profile.h>

#include <random>

#include "topography_test_tools.h"

using namespace asperity;
using namespace asperity_test;

// What is measured of a map before a profile is taken of it, on maps whose lay,
// noise and correlation are known by construction.
namespace
{
  constexpr double dx         = 0.5e-6;
  constexpr double wavelength = 10e-6;
  constexpr double amplitude  = 0.2e-6;
  constexpr double k          = 2. * M_PI / wavelength;

  HeightMap
  wave_at(const double angle)
  {
    return make_map(200, 160, dx, dx, [angle](const double x, const double y) {
      return amplitude *
             std::cos(k * (x * std::cos(angle) + y * std::sin(angle)));
    });
  }

  HeightMap
  white_noise(const double deviation)
  {
    std::mt19937               generator(7);
    std::normal_distribution<> noise(0., deviation);
    return make_map(300, 300, dx, dx, [&](double, double) {
      return noise(generator);
    });
  }

  double
  ratio_of_slopes(const HeightMap &map)
  {
    const Texture texture = measure_texture(map);
    return texture.smallest_slope / texture.largest_slope;
  }
} // namespace

TEST(Texture, of_a_wave_points_along_its_wave_vector)
{
  for (const double degrees : {-60., 0., 25., 90.})
    {
      const double  angle   = degrees * M_PI / 180.;
      const Texture texture = measure_texture(wave_at(angle));
      EXPECT_NEAR(std::cos(2. * (texture.direction - angle)), 1., 1e-3);
      // over whole waves and half ones the mean square of the sine is 1/2
      EXPECT_NEAR(texture.largest_slope,
                  amplitude * k / std::sqrt(2.),
                  0.03 * amplitude * k);
      EXPECT_LT(texture.smallest_slope / texture.largest_slope, 0.05);
    }
}

TEST(Texture, of_equal_waves_in_x_and_y_is_isotropic)
{
  const HeightMap map = make_map(200, 200, dx, dx, [](double x, double y) {
    return amplitude * (std::cos(k * x) + std::cos(k * y));
  });
  EXPECT_NEAR(ratio_of_slopes(map), 1., 0.02);
}

// Along the ridges nothing decays; white noise decays within a pixel.
TEST(Texture, has_a_lay_where_it_decays_much_slower_one_way)
{
  EXPECT_TRUE(areal_texture(wave_at(M_PI / 6.)).has_lay());
  HeightMap noise = white_noise(1e-7);
  apply_s_filter(noise, 10. * dx);
  EXPECT_FALSE(areal_texture(noise).has_lay());
}

TEST(Texture, of_a_single_profile_is_along_it)
{
  const HeightMap map = make_map(200, 1, dx, dx, [](double x, double) {
    return amplitude * std::cos(k * x);
  });
  EXPECT_EQ(measure_texture(map).direction, 0.);
  EXPECT_EQ(ratio_of_slopes(map), 0.);
}

TEST(PixelNoise, is_the_deviation_of_white_noise_and_knows_no_waves)
{
  const double deviation = 5e-9;
  HeightMap    map       = white_noise(deviation);
  EXPECT_NEAR(pixel_noise(map), deviation, 0.02 * deviation);
  for (unsigned int j = 0; j < map.ny; ++j)
    for (unsigned int i = 0; i < map.nx; ++i)
      map(i, j) += 1e-3 * i * dx + amplitude * std::cos(0.1 * k * i * dx);
  map(17, 3) = missing_height;
  EXPECT_NEAR(pixel_noise(map), deviation, 0.02 * deviation);
}

TEST(PixelNoise, keeps_the_slope_of_the_formula_behind_a_filter)
{
  const double deviation = 5e-9;
  HeightMap    map       = white_noise(deviation);
  const double cutoff    = 10. * dx;
  apply_s_filter(map, cutoff);
  const Texture texture = measure_texture(map);
  const double  slope   = filtered_noise_slope(map, deviation, cutoff);
  EXPECT_NEAR(texture.largest_slope, slope, 0.05 * slope);
  EXPECT_NEAR(texture.smallest_slope, slope, 0.05 * slope);
}

TEST(NestingIndex, is_the_next_of_the_standard)
{
  for (const auto &[length, index] : {std::pair(0.3, 0.5),
                                      std::pair(0.5, 0.5),
                                      std::pair(0.51, 0.8),
                                      std::pair(0.81, 1.),
                                      std::pair(1.5, 2.),
                                      std::pair(2.1, 2.5),
                                      std::pair(2.6, 5.),
                                      std::pair(7.74, 8.),
                                      std::pair(8.1, 10.),
                                      std::pair(19.35, 20.),
                                      std::pair(81., 100.)})
    EXPECT_NEAR(nesting_index_of_at_least(1e-6 * length), 1e-6 * index, 1e-15)
      << length;
}

TEST(TypicalProfile, is_where_the_amplitude_is_the_median)
{
  // The amplitude grows from row to row; whole waves have Rq = a/sqrt(2).
  const auto a   = [](const double y) { return amplitude * (1. + y / 40e-6); };
  HeightMap  map = make_map(200, 161, dx, dx, [&](double x, double y) {
    return a(y) * std::cos(k * x) + 0.01 * x;
  });
  const TypicalProfile typical =
    find_typical_profile(map, 0., 4. * wavelength, 5e-6);
  EXPECT_FALSE(typical.along_y);
  EXPECT_NEAR(typical.length, 4. * wavelength, 1.01 * dx);
  EXPECT_EQ(typical.n_missing, 0u);
  const double median = a(40e-6) / std::sqrt(2.);
  EXPECT_NEAR(typical.median_Rq, median, 0.02 * median);
  EXPECT_NEAR(typical.Rq, median, 0.05 * median);
  EXPECT_NEAR(typical.median_Rdq, k * median, 0.03 * k * median);
  EXPECT_NEAR(typical.line, 80, 8);
  EXPECT_GE(typical.start, 5e-6);

  // Without the rows around it, another one stands in for it.
  for (unsigned int j = 60; j <= 100; ++j)
    for (unsigned int i = 0; i < map.nx; i += 10)
      map(i, j) = missing_height;
  const TypicalProfile beside =
    find_typical_profile(map, 0., 4. * wavelength, 5e-6);
  EXPECT_EQ(beside.n_missing, 0u);
  EXPECT_TRUE(beside.line < 60 || beside.line > 100) << beside.line;
}

TEST(TypicalProfile, along_y_crosses_a_column)
{
  const HeightMap      map = wave_at(M_PI / 2.);
  const TypicalProfile typical =
    find_typical_profile(map, M_PI / 2., 4. * wavelength, 5e-6);
  EXPECT_TRUE(typical.along_y);
  EXPECT_LE(typical.start + typical.length, 160.01 * dx);
  EXPECT_NEAR(length_through_middle(map, M_PI / 2.), 159 * dx, 1e-12);
  EXPECT_NEAR(length_through_middle(map, 0.), 199 * dx, 1e-12);
}

TEST(TypicalProfile, of_a_map_that_is_too_short_is_all_of_it)
{
  const HeightMap      map     = make_map(60, 1, dx, dx, [](double x, double) {
    return amplitude * std::cos(k * x);
  });
  const TypicalProfile typical = find_typical_profile(map, 0., 1., 5e-6);
  EXPECT_NEAR(typical.length, 60 * dx, 1e-12);
  EXPECT_EQ(typical.start, 0.);
}
