#include <asperity/base/errors.h>
#include <asperity/contact_zone/scene_choice.h>
#include <asperity/topography/read_height_map.h>

#include <cmath>
#include <functional>
#include <random>

#include "../files.h"

using namespace asperity;

// What is chosen for maps whose pixels, waves, lay, noise and holes are known
// by construction.
namespace
{
  constexpr double micron = 1e-6;

  /** z = f(x, y), as an X3P file. */
  TopographyParameters
  write_map(const unsigned int                           nx,
            const unsigned int                           ny,
            const double                                 pixel,
            const std::function<double(double, double)> &f)
  {
    HeightMap map;
    map.nx = nx;
    map.ny = ny;
    map.dx = map.dy = pixel;
    for (unsigned int j = 0; j < ny; ++j)
      for (unsigned int i = 0; i < nx; ++i)
        map.heights.push_back(f(i * pixel, j * pixel));
    TopographyParameters given;
    given.file = test_folder() + "/map.x3p";
    write_x3p(map, given.file);
    return given;
  }

  double
  wave(const double x, const double length, const double amplitude)
  {
    return amplitude * std::cos(2. * M_PI * x / length);
  }

  /** Noise of a fixed seed. */
  class Noise
  {
  public:
    explicit Noise(const double deviation)
      : distribution(0., deviation)
    {}

    double
    operator()()
    {
      return distribution(generator);
    }

  private:
    std::mt19937               generator = std::mt19937(3);
    std::normal_distribution<> distribution;
  };

  std::string
  text_of(const std::vector<CommentedEntry> &entries, const std::string &path)
  {
    for (const CommentedEntry &entry : entries)
      if (entry.path == path)
        return entry.text;
    return "not chosen";
  }

  bool
  mentions(const std::vector<std::string> &sentences, const std::string &words)
  {
    for (const std::string &sentence : sentences)
      if (sentence.find(words) != std::string::npos)
        return true;
    return false;
  }
} // namespace

TEST(SurfaceChoice, of_a_tilted_lay_runs_across_it_at_three_pixels)
{
  // Waves of 8 um whose normal is at 30 degrees to x, on a tilted specimen.
  const double        angle = M_PI / 6.;
  const SurfaceChoice choice =
    choose_surface(write_map(240, 200, 0.5 * micron, [&](double x, double y) {
      return wave(x * std::cos(angle) + y * std::sin(angle),
                  8. * micron,
                  0.1 * micron) +
             0.02 * x - 0.01 * y;
    }));
  EXPECT_EQ(text_of(choice.entries, "Profile direction"), "30 deg");
  // three pixels are 1.5 um; the next index of the standard is 2 um
  EXPECT_EQ(text_of(choice.entries, "S-filter nesting index"), "2 um");
  EXPECT_NEAR(choice.shortest_wave, 2. * micron, 1e-15);
  EXPECT_EQ(text_of(choice.entries, "F-operator"), "plane");
  EXPECT_EQ(text_of(choice.entries, "L-filter nesting index"), "0 um");
  EXPECT_EQ(text_of(choice.entries, "Crop"), "none");
  // eight autocorrelation lengths acos(0.2)/(2 pi) 8 um are less than ten
  // shortest waves
  EXPECT_NEAR(choice.period, 20. * micron, 1. * micron);
  // what the filter leaves of the wave: exp(-ln 2 (2/8)^2)
  const double left = std::pow(0.5, std::pow(2. / 8., 2));
  EXPECT_NEAR(choice.peak_to_valley, 0.2 * micron * left, 0.1 * 0.2 * micron);
  EXPECT_NEAR(choice.rms_slope,
              0.1 * micron * left * 2. * M_PI / (8. * micron) / std::sqrt(2.),
              0.01);
}

TEST(SurfaceChoice, period_follows_the_correlation_and_long_waves_are_filtered)
{
  // Correlation acos(0.2)/(2 pi) 16 um = 3.49 um: eight of them are 27.9 um.
  const auto short_waves = [](const double x, const double y) {
    return wave(x, 16. * micron, 0.1 * micron) +
           wave(y, 16. * micron, 0.1 * micron);
  };
  // Of cos(x) + cos(y) the correlation along x stays at 1/2 and above.
  const SurfaceChoice one =
    choose_surface(write_map(320, 320, 0.5 * micron, [&](double x, double y) {
      return wave(x, 16. * micron, 0.1 * micron);
    }));
  EXPECT_NEAR(one.period,
              8. * std::acos(0.2) / (2. * M_PI) * 16. * micron,
              1. * micron);
  EXPECT_EQ(text_of(one.entries, "L-filter nesting index"), "0 um");

  // With waves of 160 um over it, the longest period of twenty S-filters, and
  // an L-filter of the next index.
  const SurfaceChoice two =
    choose_surface(write_map(320, 320, 0.5 * micron, [&](double x, double y) {
      return short_waves(x, y) + wave(x, 160. * micron, 1. * micron);
    }));
  EXPECT_NEAR(two.period, 40. * micron, 1. * micron);
  EXPECT_EQ(text_of(two.entries, "L-filter nesting index"), "50 um");
  EXPECT_LT(two.peak_to_valley, 0.6 * micron);
}

TEST(SurfaceChoice, noise_asks_for_a_longer_s_filter)
{
  Noise               noise(20e-9);
  const SurfaceChoice choice =
    choose_surface(write_map(320, 320, 0.5 * micron, [&](double x, double) {
      return wave(x, 20. * micron, 0.1 * micron) + noise();
    }));
  // Slope of the waves 0.1 (2 pi/20)/sqrt(2) = 0.0222. White noise keeps
  // 20 nm sqrt(0.25 um^2/(8 pi))/(0.1874 cutoff)^2: 0.0142 behind 2 um, 0.0091
  // behind 2.5 um, 0.0023 behind 5 um, which is less than a quarter.
  EXPECT_EQ(text_of(choice.entries, "S-filter nesting index"), "5 um");
  EXPECT_TRUE(mentions(choice.findings, "pixel noise of 20"));
}

TEST(SurfaceChoice, steep_flanks_ask_for_a_longer_s_filter)
{
  // 2 pi 1.2/5 = 1.51 is 56 degrees; an S-filter of 5 um halves it.
  const SurfaceChoice choice =
    choose_surface(write_map(320, 100, 0.5 * micron, [&](double x, double) {
      return wave(x, 5. * micron, 1.2 * micron);
    }));
  EXPECT_EQ(text_of(choice.entries, "S-filter nesting index"), "5 um");
  EXPECT_LT(choice.largest_slope, 1.);
  EXPECT_NEAR(choice.largest_slope, 0.5 * 1.51, 0.08);
  EXPECT_TRUE(mentions(choice.findings, "a mesh that is pressed into flanks"));
}

TEST(SurfaceChoice, holes_are_cropped_and_few_spikes_removed)
{
  Noise               noise(5e-9);
  const SurfaceChoice choice =
    choose_surface(write_map(320, 200, 0.5 * micron, [&](double x, double y) {
      if (x < 20. * micron || y > 80. * micron)
        return std::nan("");
      const bool spike = std::abs(x - 90. * micron) < 0.1 * micron &&
                         std::abs(y - 40. * micron) < 0.1 * micron;
      return wave(x, 20. * micron, 0.05 * micron) + (spike ? 3. * micron : 0.) +
             noise();
    }));
  EXPECT_EQ(text_of(choice.entries, "Crop"), "window");
  EXPECT_EQ(text_of(choice.entries, "Crop columns"), "40 .. 319");
  EXPECT_EQ(text_of(choice.entries, "Spike threshold"), "8")
    << choice.entries.front().reason;
  EXPECT_LT(choice.peak_to_valley, 0.15 * micron);
}

TEST(SurfaceChoice, a_curved_form_is_removed)
{
  const SurfaceChoice choice =
    choose_surface(write_map(320, 200, 0.5 * micron, [&](double x, double y) {
      const double u = x - 80. * micron, v = y - 50. * micron;
      return wave(x, 10. * micron, 0.1 * micron) + (u * u + v * v) / 1e-3;
    }));
  EXPECT_EQ(text_of(choice.entries, "F-operator"), "polynomial");
  EXPECT_EQ(text_of(choice.entries, "Polynomial degree"), "2");
}

TEST(SurfaceChoice, coarse_pixels_are_said_to_show_no_fine_asperities)
{
  const SurfaceChoice choice =
    choose_surface(write_map(200, 100, 6. * micron, [](double x, double) {
      return wave(x, 100. * micron, 2. * micron);
    }));
  EXPECT_NEAR(choice.shortest_wave, 20. * micron, 1e-15);
  EXPECT_TRUE(
    mentions(choice.warnings, "shows no asperity shorter than 20 um"));
}

TEST(SurfaceChoice, maps_that_give_no_scene_are_refused)
{
  const auto refusal = [](const TopographyParameters &given) {
    return message_of<InputError>([&]() { choose_surface(given); });
  };
  EXPECT_NE(
    refusal(
      write_map(50, 50, micron, [](double, double) { return 3. * micron; }))
      .find("are equal; a rough surface is expected."),
    std::string::npos);
  EXPECT_NE(refusal(
              write_map(50,
                        50,
                        micron,
                        [](double x, double y) { return 0.1 * x + 0.2 * y; }))
              .find("is a smooth form without roughness"),
            std::string::npos);
  EXPECT_NE(refusal(write_map(7,
                              4,
                              micron,
                              [](double x, double y) {
                                return wave(x + y, 3. * micron, 0.1 * micron);
                              }))
              .find("is too small for a scene"),
            std::string::npos);
  EXPECT_NE(refusal(
              write_map(50,
                        50,
                        1e-3,
                        [](double x, double) { return wave(x, 1e-2, 1e-4); }))
              .find("pixels of 60 um or less are expected"),
            std::string::npos);
}

TEST(SceneSizes, follow_from_the_tool)
{
  SceneScale scale;
  scale.shortest_wave  = 2. * micron;
  scale.period         = 40. * micron;
  scale.peak_to_valley = 0.5 * micron;
  scale.largest_slope  = 0.1;
  scale.velocity       = 1.;
  scale.wave_speed     = 6000.;
  const SceneSizes sizes(scale);
  EXPECT_DOUBLE_EQ(sizes.chip_height, 20. * micron);
  EXPECT_EQ(sizes.spans, 320u); // 16 for each of 20 waves
  EXPECT_EQ(sizes.levels, 4u);  // 20 columns
  EXPECT_DOUBLE_EQ(sizes.strip, 5. * 0.125 * micron);
  EXPECT_DOUBLE_EQ(sizes.initial_gap, 0.015 * micron);
  EXPECT_DOUBLE_EQ(sizes.ramp_time, 0.2e-6); // a tenth of a wave at 1 m/s
  EXPECT_DOUBLE_EQ(sizes.steady_distance, 0.8 * micron);
  EXPECT_DOUBLE_EQ(sizes.maximum_distance, 8. * micron);

  // Twelve transits there and back of the chip.
  scale.velocity = 100.;
  EXPECT_DOUBLE_EQ(SceneSizes(scale).ramp_time, 12. * 40. * micron / 6000.);

  // Eight elements across the steepest asperity, 0.5 um high: 40 um/(0.5/2) 8.
  scale.largest_slope = 2.;
  EXPECT_EQ(SceneSizes(scale).spans, 1280u);
  EXPECT_EQ(SceneSizes(scale).spans % (1u << SceneSizes(scale).levels), 0u);

  // Five times a large peak-to-valley height.
  scale.peak_to_valley = 10. * micron;
  EXPECT_DOUBLE_EQ(SceneSizes(scale).chip_height, 50. * micron);
}

TEST(SceneChoice, is_a_parameter_file_that_says_what_was_chosen)
{
  const TopographyParameters given =
    write_map(320, 200, 0.5 * micron, [](double x, double y) {
      return wave(x, 10. * micron, 0.1 * micron) +
             wave(y, 30. * micron, 0.05 * micron);
    });
  const SceneChoice choice = choose_scene(given,
                                          {{"Load/Pressure", "450 MPa"},
                                           {"Lubrication/Wetting", "0.6"},
                                           {"Lubrication/Model", "automatic"}},
                                          "map");
  const std::string file   = test_folder() + "/map.prm";
  // the folder was emptied: the map is written again
  write_map(320, 200, 0.5 * micron, [](double x, double y) {
    return wave(x, 10. * micron, 0.1 * micron) +
           wave(y, 30. * micron, 0.05 * micron);
  });
  overwrite(file, choice.text);
  const SceneInput input(file);
  EXPECT_EQ(input.parameters.load.pressure, 450e6);
  EXPECT_EQ(input.parameters.lubrication.wetting, 0.6);
  EXPECT_EQ(input.parameters.lubrication.model, LubricantModel::automatic);
  EXPECT_NE(choice.lubricant, LubricantModel::none);
  EXPECT_EQ(input.parameters.output.directory, "output/map");
  EXPECT_EQ(input.parameters.mesh.spans, choice.parameters.mesh.spans);
  EXPECT_EQ(input.parameters.geometry.height,
            choice.parameters.geometry.height);
  EXPECT_NEAR(choice.parameters.geometry.height, 10. * micron, 0.5 * micron);
  // nothing is set without a reason
  std::size_t n_set = 0, n_reasons = 0;
  for (auto at = choice.text.find("set "); at != std::string::npos;
       at      = choice.text.find("  set ", at + 1))
    ++n_set;
  for (auto at = choice.text.find("# Here: "); at != std::string::npos;
       at      = choice.text.find("# Here: ", at + 1))
    ++n_reasons;
  EXPECT_GT(n_set, 20u);
  EXPECT_EQ(n_reasons, choice.entries.size());
}
