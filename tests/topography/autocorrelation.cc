#include <asperity/topography/autocorrelation.h>

#include <algorithm>
#include <complex>
#include <random>

#include "topography_test_tools.h"

using namespace asperity;
using namespace asperity_test;

// Lateral parameters on maps whose autocorrelation function is known.
namespace
{
  constexpr double dx         = 0.5e-6;
  constexpr double wavelength = 10e-6;
  constexpr double k          = 2. * M_PI / wavelength;

  HeightMap
  wave_at(const double angle)
  {
    return make_map(200, 160, dx, dx, [angle](const double x, const double y) {
      return std::cos(k * (x * std::cos(angle) + y * std::sin(angle)));
    });
  }

  /**
   * A surface with the autocorrelation exp(-(s/a)^2 - (t/b)^2), s and t along
   * axes turned by @p angle: cosines of random phase whose wave numbers are
   * normally distributed with the deviations sqrt(2)/a and sqrt(2)/b, here
   * evenly rather than by chance.
   */
  HeightMap
  gaussian_surface(const double a,
                   const double b,
                   const double angle,
                   const double dy = dx)
  {
    constexpr int                    n_waves = 256, n = 300;
    std::mt19937                     generator(3);
    std::uniform_real_distribution<> phases(0., 2. * M_PI);
    HeightMap map = make_map(n, n, dx, dy, [](double, double) { return 0.; });
    for (int wave = 0; wave < n_waves; ++wave)
      {
        double reversed = 0., digit = 0.5; // bits of the number, mirrored
        for (int rest = wave; rest > 0; rest /= 2, digit /= 2.)
          reversed += (rest % 2) * digit;
        const double radius = std::sqrt(-2. * std::log((wave + 0.5) / n_waves));
        const double ks =
          std::sqrt(2.) / a * radius * std::cos(2. * M_PI * reversed);
        const double kt =
          std::sqrt(2.) / b * radius * std::sin(2. * M_PI * reversed);
        const double kx    = ks * std::cos(angle) - kt * std::sin(angle);
        const double ky    = ks * std::sin(angle) + kt * std::cos(angle);
        const double phase = phases(generator);
        const std::complex<double> step = std::polar(1., kx * dx);
        for (int j = 0; j < n; ++j)
          {
            std::complex<double> z = std::polar(1e-7, phase + ky * j * dy);
            for (int i = 0; i < n; ++i, z *= step)
              map(i, j) += z.real();
          }
      }
    return map;
  }

  constexpr double short_length = 2e-6;

  /** Where exp(-(r/a)^2) = 0.2, in units of a. */
  const double decay_of_gaussian = std::sqrt(std::log(5.));
} // namespace

TEST(Autocorrelation, is_the_mean_product_of_points_a_lag_apart)
{
  std::mt19937                     generator(1);
  std::uniform_real_distribution<> height(-1e-6, 2e-6);
  HeightMap map = make_map(13, 8, dx, 2. * dx, [&](double, double) {
    return height(generator);
  });
  map(3, 2) = map(12, 7) = map(0, 5) = missing_height;
  double mean = 0., variance = 0.;
  for (const double z : map.heights)
    mean += std::isnan(z) ? 0. : z / map.n_valid();
  for (const double z : map.heights)
    variance += std::isnan(z) ? 0. : std::pow(z - mean, 2) / map.n_valid();

  const Autocorrelation correlation(map);
  for (int lag_x = -6; lag_x <= 6; ++lag_x)
    for (int lag_y = -4; lag_y <= 4; ++lag_y)
      {
        double sum = 0.;
        int    n   = 0;
        for (int j = std::max(0, -lag_y); j < 8 - std::max(0, lag_y); ++j)
          for (int i = std::max(0, -lag_x); i < 13 - std::max(0, lag_x); ++i)
            {
              const double product =
                (map(i, j) - mean) * (map(i + lag_x, j + lag_y) - mean);
              sum += std::isnan(product) ? 0. : product;
              n += !std::isnan(product);
            }
        EXPECT_NEAR(correlation(lag_x * dx, lag_y * 2. * dx),
                    sum / n / variance,
                    1e-12);
      }
  EXPECT_NEAR(correlation(0.5 * dx, 0.),
              0.5 * (1. + correlation(dx, 0.)),
              1e-12);
  EXPECT_TRUE(std::isnan(correlation(7. * dx, 0.)));
  EXPECT_TRUE(std::isnan(correlation(0., -9. * dx)));
}

TEST(Autocorrelation, of_a_wave_decays_where_its_cosine_is_0_2)
{
  const double expected = std::acos(0.2) / k;
  for (const double degrees : {0., 30., 60., 90., 150.})
    {
      const double angle = degrees * M_PI / 180.;
      const auto   decay = Autocorrelation(wave_at(angle)).decay(angle);
      EXPECT_TRUE(decay.is_found);
      EXPECT_NEAR(decay.lag, expected, 0.03 * expected) << degrees;
    }
  const auto along = Autocorrelation(wave_at(0.)).decay(M_PI / 2.);
  EXPECT_FALSE(along.is_found);
  EXPECT_NEAR(along.lag, 80. * dx, 1.01 * dx);
}

TEST(ArealTexture, of_ridges_across_the_map_has_only_a_bound_near_0)
{
  const double expected = std::acos(0.2) / k;
  for (const double degrees : {0., 25., 90., 120.})
    {
      const ArealTexture texture =
        areal_texture(wave_at(degrees * M_PI / 180.));
      EXPECT_NEAR(texture.Sal, expected, 0.03 * expected) << degrees;
      EXPECT_TRUE(std::isnan(texture.Str));
      // along the ridges at least half of the smaller side is seen
      EXPECT_LT(texture.Str_bound, 1.05 * expected / (80. * dx)) << degrees;
      EXPECT_GT(texture.Str_bound, 0.);
    }
}

TEST(ArealTexture, of_crossed_waves_follows_their_cosines)
{
  // (cos(k x) + cos(k y))/2 falls to 0.2 first on the diagonals, at
  // cos(k r/sqrt(2)) = 0.2, and last on the axes, at cos(k r) = -0.6.
  const HeightMap    map = make_map(300, 300, dx, dx, [](double x, double y) {
    return std::cos(k * x) + std::cos(k * y);
  });
  const ArealTexture texture = areal_texture(map);
  const double       fastest = std::sqrt(2.) * std::acos(0.2);
  const double       slowest = std::acos(-0.6);
  EXPECT_NEAR(texture.Sal, fastest / k, 0.02 * fastest / k);
  EXPECT_NEAR(texture.Str, fastest / slowest, 0.02);
  EXPECT_EQ(texture.Str_bound, texture.Str);
}

TEST(ArealTexture, of_gaussian_surfaces_is_the_ratio_of_their_lengths)
{
  for (const double ratio : {0.2, 0.5})
    for (const double degrees : {0., 30., 77.})
      {
        const ArealTexture texture = areal_texture(gaussian_surface(
          short_length, short_length / ratio, degrees * M_PI / 180.));
        const double       Sal     = decay_of_gaussian * short_length;
        EXPECT_NEAR(texture.Sal, Sal, 0.1 * Sal) << degrees;
        EXPECT_NEAR(texture.Str, ratio, 0.2 * ratio) << degrees;
      }
}

TEST(ArealTexture, of_an_isotropic_surface_has_Str_near_1)
{
  const HeightMap map = gaussian_surface(short_length, short_length, 0.);
  EXPECT_GT(areal_texture(map).Str, 0.8);
  EXPECT_LE(areal_texture(map).Str, 1.);
}

TEST(ArealTexture, knows_no_axes_no_pixels_and_no_units_of_height)
{
  const HeightMap    map      = gaussian_surface(2e-6, 6e-6, 0.3);
  const ArealTexture expected = areal_texture(map);

  HeightMap turned = map;
  for (unsigned int j = 0; j < map.ny; ++j)
    for (unsigned int i = 0; i < map.nx; ++i)
      turned(map.ny - 1 - j, i) = map(i, j);
  EXPECT_NEAR(areal_texture(turned).Sal, expected.Sal, 1e-9 * expected.Sal);
  EXPECT_NEAR(areal_texture(turned).Str, expected.Str, 1e-9);

  HeightMap scaled = map;
  for (double &z : scaled.heights)
    z = 10. * z + 1e-3;
  EXPECT_NEAR(areal_texture(scaled).Sal, expected.Sal, 1e-9 * expected.Sal);
  EXPECT_NEAR(areal_texture(scaled).Str, expected.Str, 1e-9);

  const ArealTexture oblong =
    areal_texture(gaussian_surface(2e-6, 6e-6, 0.3, 0.7 * dx));
  EXPECT_NEAR(oblong.Sal, expected.Sal, 0.1 * expected.Sal);
  EXPECT_NEAR(oblong.Str, expected.Str, 0.2 * expected.Str);

  HeightMap                   holes = map;
  std::mt19937                generator(5);
  std::bernoulli_distribution is_missing(0.1);
  for (double &z : holes.heights)
    if (is_missing(generator))
      z = missing_height;
  EXPECT_NEAR(areal_texture(holes).Sal, expected.Sal, 0.02 * expected.Sal);
  EXPECT_NEAR(areal_texture(holes).Str, expected.Str, 0.02 * expected.Str);
}

TEST(ArealTexture, is_unknown_where_the_map_does_not_show_it)
{
  const HeightMap line =
    make_map(200, 1, dx, dx, [](double x, double) { return std::cos(k * x); });
  const ArealTexture of_one = areal_texture(line);
  EXPECT_NEAR(of_one.Sal, std::acos(0.2) / k, 0.03 * of_one.Sal);
  EXPECT_TRUE(std::isnan(of_one.Str));
  EXPECT_EQ(of_one.Str_bound, 1.);

  const HeightMap flat =
    make_map(20, 20, dx, dx, [](double, double) { return 1e-6; });
  const ArealTexture none = areal_texture(flat);
  EXPECT_TRUE(std::isnan(none.Sal));
  EXPECT_TRUE(std::isnan(none.Str));
  EXPECT_EQ(none.Str_bound, 1.);
}
