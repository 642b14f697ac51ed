#include <asperity/base/errors.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <numeric>

#include "scene_examples.h"

using namespace asperity;

namespace
{
  const double L = 10e-6;

  /** s(x) of the reference scene R0 [m]. */
  double
  R0_height(const double x)
  {
    const double a[]   = {0.16, 0.12, 0.09, 0.06, 0.04, 0.02},
                 phi[] = {0.3, 1.9, 4.1, 5.2, 0.9, 2.6};
    double y           = 0.;
    for (unsigned int k = 1; k <= 6; ++k)
      y += 1e-6 * a[k - 1] * std::cos(2. * M_PI * k * x / L + phi[k - 1]);
    return y;
  }

  SurfaceParameters
  harmonic(const double k, const double amplitude, const double phase)
  {
    SurfaceParameters parameters;
    parameters.kind         = SurfaceKind::harmonics;
    parameters.wave_numbers = {k};
    parameters.amplitudes   = {amplitude};
    parameters.phases       = {phase};
    return parameters;
  }
} // namespace

TEST(Surface, harmonics_follow_their_formula)
{
  const Surface tool = make_surface(SceneParameters().tool, L);
  EXPECT_EQ(tool.period, L);
  for (unsigned int i = 0; i <= 1000; ++i)
    {
      const double x = L * i / 1000;
      EXPECT_NEAR(tool.height(x), R0_height(x), 2e-12) << x;
    }
}

TEST(Surface, moves_as_a_whole)
{
  const Surface tool     = make_surface(SceneParameters().tool, L);
  const double  distance = 0.037e-6;
  const Surface moved    = tool.moved(distance);
  for (unsigned int i = 0; i <= 100; ++i)
    {
      // Beyond the ends of a period as well.
      const double x = 2. * L * i / 100 - 0.5 * L;
      EXPECT_NEAR(moved.height(x), tool.height(x - distance), 1e-18) << x;
      EXPECT_NEAR(moved.curve.value(x)[0], x, 1e-19);
    }
  EXPECT_EQ(moved.period, L);
}

TEST(Surface, harmonics_are_scaled_in_height)
{
  SurfaceParameters parameters  = SceneParameters().tool;
  parameters.topography.scale_z = 5.;
  const Surface tool            = make_surface(parameters, L);
  for (unsigned int i = 0; i <= 100; ++i)
    EXPECT_NEAR(tool.height(L * i / 100), 5. * R0_height(L * i / 100), 1e-11);
}

TEST(Surface, R0_has_the_published_height_and_slope)
{
  const Surface tool = make_surface(SceneParameters().tool, L);
  EXPECT_NEAR(tool.maximum() - tool.minimum(), 0.682e-6, 0.0005e-6);
  EXPECT_NEAR(tool.largest_slope(), 0.75, 0.005);
}

TEST(Surface, extremes_and_slope_of_a_wave_are_exact)
{
  // a cos(k x): +-a, and the slope a 2 pi k/L
  const Surface surface = make_surface(harmonic(3., 0.2e-6, 1.), L);
  EXPECT_NEAR(surface.maximum(), 0.2e-6, 1e-12);
  EXPECT_NEAR(surface.minimum(), -0.2e-6, 1e-12);
  const double slope = 0.2e-6 * 2. * M_PI * 3. / L;
  EXPECT_NEAR(surface.largest_slope(), slope, 1e-4 * slope);
}

TEST(Surface, mapping_turns_and_lifts_it)
{
  const Surface surface = make_surface(SceneParameters().tool, L);
  const Surface mapped  = surface.mapped(-1., 3e-6);
  EXPECT_NEAR(mapped.maximum(), 3e-6 - surface.minimum(), 1e-16);
  EXPECT_NEAR(mapped.height(2e-6), 3e-6 - surface.height(2e-6), 1e-18);
}

TEST(SmallestGap, of_two_waves_follows_from_their_difference)
{
  // a cos(k x) - b cos(k x + pi) = (a + b) cos(k x)
  const Surface upper = make_surface(harmonic(2., 0.3e-6, 0.4), L),
                lower = make_surface(harmonic(2., 0.1e-6, 0.4 + M_PI), L);
  EXPECT_NEAR(smallest_gap(lower, upper), -0.4e-6, 1e-12);
  EXPECT_NEAR(smallest_gap(lower, lower), 0., 1e-20);
}

TEST(Scene, tool_starts_the_initial_gap_above_the_chip)
{
  // The scene R1: neither surface is flat.
  SceneParameters parameters      = coarse_scene();
  parameters.chip                 = harmonic(2., 0.03e-6, 1.);
  parameters.chip.wave_numbers    = {2., 3., 5.};
  parameters.chip.amplitudes      = {0.03e-6, 0.03e-6, 0.02e-6};
  parameters.chip.phases          = {1., 2., 3.};
  parameters.geometry.initial_gap = 0.05e-6;
  const Scene<2> scene(parameters);
  double         smallest = 1.;
  for (unsigned int i = 0; i < 20000; ++i)
    {
      const double x           = L * i / 20000;
      double       chip_height = 5e-6;
      for (unsigned int k = 0; k < 3; ++k)
        chip_height +=
          parameters.chip.amplitudes[k] *
          std::cos(2. * M_PI * parameters.chip.wave_numbers[k] * x / L +
                   parameters.chip.phases[k]);
      EXPECT_NEAR(scene.chip_surface.height(x), chip_height, 2e-12);
      smallest = std::min(smallest, scene.tool_surface.height(x) - chip_height);
    }
  EXPECT_NEAR(smallest, 0.05e-6, 2e-12);
}

TEST(Scene, bottom_load_is_the_period)
{
  const Scene<2> scene(coarse_scene());
  double         sum = 0.;
  for (const double value : scene.bottom_load())
    sum += value;
  EXPECT_NEAR(sum, L, 1e-12 * L);
}

namespace
{
  /** A text matrix of cos(2 pi x/5 um) 0.1 um; x of the samples in um. */
  SurfaceParameters
  measured_wave(const std::string &name,
                const double       pixel,
                const unsigned int n_pixels)
  {
    SurfaceParameters parameters;
    parameters.kind = SurfaceKind::measured;
    parameters.topography.file =
      testing::TempDir() + name + "_" + std::to_string(getpid()) + ".txt";
    std::ofstream file(parameters.topography.file);
    file.precision(12);
    for (unsigned int j = 0; j < 12; ++j)
      for (unsigned int i = 0; i < n_pixels; ++i)
        file << 0.1 * std::cos(2. * M_PI * pixel * i / 5.)
             << (i + 1 < n_pixels ? " " : "\n");
    parameters.topography.lateral_unit = "um";
    parameters.topography.height_unit  = "um";
    parameters.topography.spacing_x    = pixel * 1e-6;
    parameters.topography.form         = FormChoice::none;
    parameters.topography.continuation = Continuation::none;
    parameters.fit                     = SurfaceFit::interpolation;
    return parameters;
  }

  bool
  says(const Surface &surface, const std::string &sentence)
  {
    for (const std::string &step : surface.topography->steps)
      if (step.find(sentence) == 0)
        return true;
    return false;
  }
} // namespace

TEST(Surfaces, of_two_instruments_are_cut_to_the_shorter_one)
{
  const SurfaceParameters fine   = measured_wave("fine", 0.25, 80),
                          coarse = measured_wave("coarse", 0.4, 70);
  for (const bool tool_is_fine : {true, false})
    {
      SceneParameters parameters;
      parameters.tool          = tool_is_fine ? fine : coarse;
      parameters.chip          = tool_is_fine ? coarse : fine;
      const auto [tool, chip]  = make_surfaces(parameters);
      const Surface    &longer = tool_is_fine ? chip : tool;
      const std::string whose  = tool_is_fine ? "tool" : "chip";
      EXPECT_NEAR(tool.period, 20e-6, 1e-18);
      EXPECT_NEAR(chip.period, 20e-6, 1e-18);
      EXPECT_TRUE(says(longer,
                       "Common period: 20 um of the " + whose +
                         " instead of 28 um, 71.4 % of the length; Rq "));
      // Pixels of 0.4 um: (2 pi 0.4/5)^4/384 of the amplitude are missed.
      for (unsigned int i = 0; i <= 100; ++i)
        {
          const double x = 20e-6 * i / 100;
          EXPECT_NEAR(longer.height(x),
                      0.1e-6 * std::cos(2. * M_PI * x / 5e-6),
                      0.1e-6 * 4e-4)
            << i;
        }
    }
}

TEST(Surfaces, of_odd_pixels_are_resampled_to_the_period_of_the_other)
{
  SceneParameters parameters;
  parameters.tool         = measured_wave("tool", 0.25, 80);
  parameters.chip         = measured_wave("chip", 0.3, 90);
  const auto [tool, chip] = make_surfaces(parameters);
  EXPECT_NEAR(chip.period, tool.period, 1e-18);
  EXPECT_TRUE(says(chip, "Resampled from 0.3 um to 0.30303 um"));
  for (unsigned int i = 0; i <= 100; ++i)
    {
      const double x = 20e-6 * i / 100;
      EXPECT_NEAR(chip.height(x),
                  0.1e-6 * std::cos(2. * M_PI * x / 5e-6),
                  0.1e-6 * 1e-3)
        << i;
    }
}

TEST(Surface, interpolation_passes_through_the_measured_points)
{
  const Surface surface = make_surface(measured_wave("points", 0.25, 80), 0.);
  const auto   &heights = surface.topography->profile.heights;
  ASSERT_EQ(heights.size(), 80u);
  for (unsigned int i = 0; i < 80; ++i)
    EXPECT_NEAR(surface.height(0.25e-6 * i), heights[i], 1e-20);
  EXPECT_LT(surface.fit_rms, 1e-20);
}

TEST(Scene, chip_of_a_shorter_period_than_the_tool_is_refused)
{
  SceneParameters parameters = coarse_scene();
  parameters.geometry.length = 200e-6;
  parameters.chip.kind       = SurfaceKind::measured;
  parameters.chip.topography.file =
    ASPERITY_SOURCE_DIR "/parameter_files/surfaces/polished_tool.x3p";
  try
    {
      Scene<2> scene(parameters);
      FAIL() << "a chip of 160 um under a tool of 200 um";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(
        std::string(error.what()).find("expected that of the tool, 200 um"),
        std::string::npos)
        << error.what();
    }
}

TEST(Scene, measured_heights_point_out_of_the_tool)
{
  // The tool is above: its highest asperity is the lowest point of the scene.
  SceneParameters parameters = coarse_scene();
  parameters.tool.kind       = SurfaceKind::measured;
  auto &topography           = parameters.tool.topography;
  topography.file =
    ASPERITY_SOURCE_DIR "/parameter_files/surfaces/blasted_tool.x3p";
  topography.s_filter = 5e-6;
  topography.length   = 40e-6;
  const Scene<2> scene(parameters);
  const Surface  measured = make_surface(parameters.tool, 1.);
  EXPECT_NEAR(scene.length, measured.period, 1e-15);
  double highest = 0.;
  for (unsigned int i = 0; i < 4000; ++i)
    if (measured.height(scene.length * i / 4000) > measured.height(highest))
      highest = scene.length * i / 4000;
  EXPECT_NEAR(scene.tool_surface.height(highest),
              scene.tool_surface.minimum(),
              1e-11);
}

TEST(GradedRows, fill_the_height_and_grow_downwards)
{
  for (const double grading : {1., 1.3, 2.})
    {
      const auto rows = graded_rows(5e-6, 0.25e-6, grading);
      EXPECT_EQ(rows.front(), 0.);
      EXPECT_EQ(rows.back(), 5e-6);
      for (std::size_t i = 2; i < rows.size(); ++i)
        EXPECT_NEAR((rows[i - 1] - rows[i - 2]) / (rows[i] - rows[i - 1]),
                    grading,
                    1e-9);
      // Scaled by less than a row to fit.
      const double top = rows.back() - rows[rows.size() - 2];
      EXPECT_GT(top, 0.5 * 0.25e-6);
      EXPECT_LT(top, 2. * 0.25e-6);
    }
  EXPECT_EQ(graded_rows(5e-6, 0.25e-6, 1.).size(), 21u);
}
