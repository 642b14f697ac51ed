#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_input.h>
#include <asperity/tool_design/texture_family.h>
#include <asperity/tool_design/texture_space.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "../files.h"

using namespace asperity;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  std::vector<double>
  sampled(const std::function<double(double)> &f, const std::size_t n)
  {
    std::vector<double> heights(n);
    for (std::size_t i = 0; i < n; ++i)
      heights[i] = f(static_cast<double>(i) / n);
    return heights;
  }

  double
  largest_difference(const std::vector<double> &a, const std::vector<double> &b)
  {
    EXPECT_EQ(a.size(), b.size());
    double largest = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
  }

  double
  rms(const std::vector<double> &heights)
  {
    return std::sqrt(
      std::inner_product(heights.begin(), heights.end(), heights.begin(), 0.) /
      heights.size());
  }
} // namespace

TEST(Harmonics, are_those_that_a_profile_is_made_of)
{
  const auto h = sampled(
    [](const double x) {
      return 5. + 2. * std::cos(2. * pi * x + 0.3) +
             0.5 * std::cos(6. * pi * x - 2.);
    },
    64);
  const Harmonics waves = harmonics_of(h, 4);
  EXPECT_NEAR(waves.amplitudes[0], 2., 1e-13);
  EXPECT_NEAR(waves.phases[0], 0.3, 1e-13);
  EXPECT_NEAR(waves.amplitudes[1], 0., 1e-13);
  EXPECT_NEAR(waves.amplitudes[2], 0.5, 1e-13);
  EXPECT_NEAR(waves.phases[2], -2., 1e-12);
  EXPECT_NEAR(waves.rms(), std::sqrt(0.5 * (4. + 0.25)), 1e-13);
  std::vector<double> again = waves.heights(64);
  for (double &z : again)
    z += 5.; // the mean is none of the waves
  EXPECT_LT(largest_difference(again, h), 1e-12);
}

TEST(Harmonics, are_not_more_than_heights_determine)
{
  EXPECT_EQ(message_of<InputError>(
              []() { harmonics_of(std::vector<double>(8, 1.), 4); }),
            "A profile of 8 heights does not determine 4 waves.");
}

TEST(GaussianTransmission, is_half_at_the_nesting_index)
{
  EXPECT_DOUBLE_EQ(gaussian_transmission(1.), 0.5);
  EXPECT_DOUBLE_EQ(gaussian_transmission(0.5), 1. / 16.);
  EXPECT_GT(gaussian_transmission(10.), 0.99);
}

TEST(Normalized, refuses_a_flat_profile)
{
  EXPECT_EQ(message_of<InputError>(
              []() { normalized(std::vector<double>(8, 3.)); }),
            "A profile whose heights are all the same has no texture.");
}

TEST(AnalyticTexture, has_its_plateaus_floors_and_flanks)
{
  AnalyticTexture t;
  t.n_repeats = 2;
  t.width     = 0.4; // valleys in 0.3 .. 0.7 of a repeat
  t.flank     = 0.25;
  EXPECT_DOUBLE_EQ(t.height(0.), 1.);
  EXPECT_DOUBLE_EQ(t.height(0.14), 1.);
  EXPECT_NEAR(t.height(0.175), 0.5, 1e-12); // amid the first flank
  EXPECT_NEAR(t.height(0.25), 0., 1e-12);
  EXPECT_NEAR(t.height(0.75), 0., 1e-12);
  t.skew = 0.6; // flanks of 0.4 and 0.1 of the width
  EXPECT_NEAR(t.height(0.15 + 0.5 * 0.4 * 0.2), 0.5, 1e-12);
  EXPECT_NEAR(t.height(0.35 - 0.5 * 0.1 * 0.2), 0.5, 1e-12);
  t.kind = AnalyticTexture::Kind::ridges;
  EXPECT_DOUBLE_EQ(t.height(0.), 0.);
  EXPECT_NEAR(t.height(0.25), 1., 1e-12);
  t.kind = AnalyticTexture::Kind::dimples; // lowest at 0.8 of the width
  EXPECT_NEAR(t.height(0.15 + 0.8 * 0.2), 0., 1e-12);
  EXPECT_NEAR(t.height(0.15 + 0.4 * 0.2), 0.25, 1e-12);
  t.kind = AnalyticTexture::Kind::waves;
  EXPECT_DOUBLE_EQ(t.height(0.5), 1.);
}

/** Fourier's coefficients of a symmetric trapezium by hand, times the filter.
 */
TEST(MakeTexture, filters_grooves_as_a_measured_profile)
{
  AnalyticTexture groove;
  groove.width = 0.5;
  groove.flank = 0.2;
  TextureFamily family;
  family.shortest_wave  = 0.15;
  const Harmonics waves = harmonics_of(make_texture(groove, family).heights, 8);
  const auto      expected = [&](const unsigned int k) {
    // A trapezium is the convolution of two rectangles: of its mean width
    // and of its flank.
    const double mean = groove.width * (1. - groove.flank),
                 edge = groove.width * groove.flank;
    return std::abs(std::sin(pi * k * mean) / (pi * k) *
                    std::sin(pi * k * edge) / (pi * k * edge)) *
           gaussian_transmission(1. / (k * family.shortest_wave));
  };
  for (unsigned int k = 2; k <= 8; ++k)
    EXPECT_NEAR(waves.amplitudes[k - 1] / waves.amplitudes[0],
                expected(k) / expected(1),
                2e-5)
      << k;
  EXPECT_EQ(family.n_waves(), 20u);
}

TEST(MakeTextures, takes_pieces_of_the_map_of_a_measured_tool)
{
  const SceneInput input(ASPERITY_SOURCE_DIR
                         "/parameter_files/measured_surfaces/blasted_tool.prm");
  TextureFamily    family;
  family.n_per_kind              = 2;
  family.n_measured              = 3;
  family.n_held_out              = 1;
  family.shortest_wave           = 5. / 40.5;
  const auto [trained, held_out] = make_textures(family, input.parameters);
  ASSERT_EQ(trained.size(), 11u);
  ASSERT_EQ(held_out.size(), 5u);
  EXPECT_EQ(trained.front().kind, "grooves");
  EXPECT_EQ(trained.back().kind, "measured");
  EXPECT_EQ(held_out.back().kind, "measured");
  for (const ToolTexture &texture : trained)
    EXPECT_NEAR(rms(texture.heights), 1., 1e-12) << texture.kind;
  EXPECT_GT(largest_difference(trained[9].heights, trained[10].heights), 0.5);
  // the same numbers for the same seed
  EXPECT_EQ(make_textures(family, input.parameters).first.back().heights,
            trained.back().heights);
}

TEST(FreeFormTextures, without_moves_are_the_base_profile)
{
  const auto base = normalized(
    sampled([](const double x) { return std::cos(2. * pi * x) + x * (1. - x); },
            128));
  const FreeFormTextures space(base, 5, 2.);
  EXPECT_EQ(space.box().size(), 10u);
  EXPECT_EQ(space.box().names[5], "upper1");
  EXPECT_LT(largest_difference(space.heights(std::vector<double>(10, 0.)),
                               base),
            1e-12);
}

/** Partition of unity: moving all control points alike is a translation, and
 *  moving the rows apart a scaling; neither changes the texture. */
TEST(FreeFormTextures, do_not_see_translation_and_scaling)
{
  const auto base = normalized(
    sampled([](const double x) { return std::cos(2. * pi * x) + x * (1. - x); },
            128));
  const FreeFormTextures space(base, 5, 2.);
  std::vector<double>    moves(10, 1.5);
  EXPECT_LT(largest_difference(space.heights(moves), base), 1e-12);
  std::fill(moves.begin(), moves.begin() + 5, -0.7);
  EXPECT_LT(largest_difference(space.heights(moves), base), 1e-12);
  moves[0] = 1.;
  EXPECT_GT(largest_difference(space.heights(moves), base), 0.05);
}

TEST(ModalTextures, are_exact_for_as_many_waves_as_there_are_modes)
{
  std::vector<ToolTexture> textures;
  for (unsigned int i = 0; i < 9; ++i)
    textures.push_back(
      {"waves",
       normalized(sampled(
         [&](const double x) { return std::cos(2. * pi * x + 0.7 * i); },
         64))});
  // all cosines of one wave number: two modes
  const ModalTextures space(textures, 2);
  const auto         &modes = space.modes();
  EXPECT_LT(largest_difference(space.heights(
                                 modes.project(textures[4].heights, 2)),
                               textures[4].heights),
            1e-12);
  for (std::size_t i = 0; i < 2; ++i)
    {
      const double c = modes.project(textures[4].heights, 2)[i];
      EXPECT_LE(space.box().lower[i], c);
      EXPECT_GE(space.box().upper[i], c);
    }
}
