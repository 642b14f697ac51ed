#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/topography/commands.h>
#include <asperity/topography/make_profile.h>
#include <asperity/topography/png_image.h>
#include <asperity/topography/read_height_map.h>
#include <asperity/topography/report_output.h>

#include <deal.II/base/parameter_handler.h>

#include <nlohmann/json.hpp>

#include "topography_test_tools.h"

using namespace asperity;
using namespace asperity_test;

namespace
{
  const double pi = std::acos(-1.);

  /** Tilted waves of 10 um along x, 100 x 60 um, with one hole. */
  std::string
  wavy_file()
  {
    auto map    = make_map(200, 120, 0.5e-6, 0.5e-6, [](double x, double y) {
      return 1e-3 + 0.05 * x - 0.02 * y +
             0.4e-6 * std::sin(2. * pi * x / 10e-6);
    });
    map(3, 110) = missing_height;
    const auto file = write_bytes("wavy.x3p", "");
    write_x3p(map, file);
    return file;
  }

  TopographyParameters
  parse(const std::string &entries)
  {
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    TopographyParameters     parameters;
    parameters.declare(declarator);
    declarator.read_text(entries, "test.prm");
    // The declarator's pointers must not outlive this function.
    return parameters;
  }

  std::string
  refusal(const std::string &entries)
  {
    return message_of<InputError>([&]() {
      TopographyReport report;
      make_profile(parse(entries), report);
    });
  }
} // namespace

TEST(MakeProfile, of_a_wavy_surface)
{
  const auto       p = parse("set File = " + wavy_file() + "\n");
  TopographyReport report;
  const Profile    profile = make_profile(p, report);
  EXPECT_TRUE(profile.periodic);
  EXPECT_EQ(profile.heights.size(), 200u);
  EXPECT_NEAR(profile.length(), 100e-6, 1e-12);
  // The plane of whole sines is not quite zero (6/pi^2 a/N), hence the 2 %.
  EXPECT_NEAR(report.measured_roughness.Rq, 0.4e-6 / std::sqrt(2.), 6e-9);
  EXPECT_NEAR(report.measured_roughness.Rz, 0.8e-6, 30e-9);
  EXPECT_NEAR(report.areal.Sq, 0.4e-6 / std::sqrt(2.), 6e-9);
  EXPECT_EQ(report.n_filled, 0u);
  const std::vector<std::string> steps = {"F-operator: plane",
                                          "L-filter: none",
                                          "Profile: 200 samples",
                                          "Periodic continuation: "};
  ASSERT_EQ(report.steps.size(), steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
    EXPECT_EQ(report.steps[i].find(steps[i]), 0u) << report.steps[i];
}

namespace
{
  /** Of a map of 200 x 40 points of 0.1 um that is z(x) with a noise of 10 nm
   *  and a spike of this height on row 20. */
  std::vector<std::string>
  warnings_of(const std::function<double(double)> &z,
              const double                         spike,
              const std::string                   &entries)
  {
    unsigned int seed = 7;
    auto map = make_map(200, 40, 0.1e-6, 0.1e-6, [&](const double x, double) {
      seed = 1664525u * seed + 1013904223u;
      return z(x) + 1e-8 * ((seed >> 16) % 1000) / 1000.;
    });
    map(60, 20) += spike;
    const auto file = write_bytes("doubtful.x3p", "");
    write_x3p(map, file);
    TopographyReport report;
    make_profile(parse("set File = " + file + "\nset F-operator = none\n" +
                       entries),
                 report);
    return report.warnings;
  }

  double
  symmetric_wave(const double x)
  {
    return 0.3e-6 * std::cos(2. * pi * x / 5e-6);
  }
} // namespace

TEST(MakeProfile, warns_of_spikes_that_nothing_removes)
{
  const std::string row = "set Profile position = row 20\n";
  const auto        found =
    warnings_of(symmetric_wave, 0.5e-6, row + "set Spike threshold = 0\n");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].find("Spike threshold = 0 leaves 1 point in the profile "
                          "that stands out of the neighbours by more than 8 "
                          "robust standard deviations"),
            0u)
    << found[0];
  EXPECT_TRUE(
    warnings_of(symmetric_wave, 0.5e-6, row + "set Spike threshold = 8\n")
      .empty());
  EXPECT_TRUE(warnings_of(symmetric_wave, 0., row).empty());
  // beside the profile
  EXPECT_TRUE(
    warnings_of(symmetric_wave, 0.5e-6, "set Profile position = row 10\n")
      .empty());
  // and after a crop
  EXPECT_EQ(warnings_of(symmetric_wave,
                        0.5e-6,
                        "set Crop = window\nset Crop rows = 15 .. 30\n"
                        "set Profile position = row 5\n")
              .size(),
            1u);
}

TEST(MakeProfile, warns_of_a_trend_that_the_ends_do_not_have)
{
  const auto tilt = [](const std::function<double(double)> &z,
                       const std::string                   &entries) {
    std::string found;
    for (const std::string &warning : warnings_of(z, 0., entries))
      if (warning.find("The periodic continuation tilts the profile by ") == 0)
        found = warning;
    return found;
  };
  // The least-squares line of one period of a sine rises by -6/pi a over it,
  // 95 % of its peak to valley, although it fits its own start.
  const auto sine = [](const double x) {
    return 0.3e-6 * std::sin(2. * pi * x / 20e-6);
  };
  EXPECT_NE(tilt(sine, "").find(" % of peak to valley, although its ends meet "
                                "without"),
            std::string::npos)
    << tilt(sine, "");
  EXPECT_EQ(tilt(sine, "set Periodic continuation = none\n"), "");
  EXPECT_EQ(tilt(symmetric_wave, ""), "");
  // A ramp has one.
  EXPECT_EQ(tilt([](const double x) { return symmetric_wave(x) + 0.1 * x; },
                 ""),
            "");
}

TEST(MakeProfile, crop_by_lengths_and_by_samples_agree)
{
  const std::string common =
    "set File = " + wavy_file() + "\nset Crop = window\n";
  TopographyReport first, second;
  make_profile(parse(common + "set Crop columns = 20 .. 119\n"
                              "set Crop rows = 10 .. 49\n"),
               first);
  make_profile(parse(common + "set Crop columns = 10 um .. 59.5 um\n"
                              "set Crop rows = 5 um .. 24.5 um\n"),
               second);
  EXPECT_EQ(first.map.nx, 100u);
  EXPECT_EQ(first.map.ny, 40u);
  EXPECT_EQ(first.profile.heights, second.profile.heights);
}

TEST(MakeProfile, scaling_comes_last)
{
  const std::string common = "set File = " + wavy_file() + "\n";
  TopographyReport  plain, scaled;
  make_profile(parse(common), plain);
  make_profile(parse(common + "set Scale x = 0.1\nset Scale z = 0.5\n"),
               scaled);
  EXPECT_NEAR(scaled.profile.length(), 10e-6, 1e-15);
  for (std::size_t i = 0; i < plain.profile.heights.size(); ++i)
    EXPECT_DOUBLE_EQ(scaled.profile.heights[i], 0.5 * plain.profile.heights[i]);
  EXPECT_EQ(scaled.measured_roughness.Rq, plain.measured_roughness.Rq);
}

TEST(MakeProfile, row_column_and_length_name_the_same_line)
{
  const std::string common =
    "set File = " + wavy_file() + "\nset Profile length = 40 um\n";
  TopographyReport row, length, column;
  make_profile(parse(common + "set Profile position = row 30\n"), row);
  make_profile(parse(common + "set Profile position = 15 um\n"), length);
  EXPECT_EQ(row.measured.heights, length.measured.heights);
  EXPECT_EQ(row.measured.heights[5], row.map(5, 30));
  EXPECT_EQ(row.measured.heights.size(), 80u);
  make_profile(parse(common + "set Profile direction = 90 deg\n"
                              "set Profile position = column 7\n"),
               column);
  EXPECT_EQ(column.measured.heights[5], column.map(7, 5));
}

TEST(MakeProfile, the_length_of_a_profile_is_its_period)
{
  // Samples 0.5 um apart: 80 of them, or 80 that are 0.50375 um apart.
  const std::string common = "set File = " + wavy_file() + "\n";
  TopographyReport  exact, resampled, mirrored;
  make_profile(parse(common + "set Profile length = 40 um\n"), exact);
  EXPECT_NEAR(exact.profile.length(), 40e-6, 1e-18);
  EXPECT_EQ(exact.measured.heights[79], exact.map(79, exact.map.ny / 2));

  make_profile(parse(common + "set Profile length = 40.3 um\n"), resampled);
  EXPECT_NEAR(resampled.profile.length(), 40.3e-6, 1e-18);
  EXPECT_EQ(resampled.profile.heights.size(), 80u);
  EXPECT_EQ(resampled.measured.heights[0], exact.measured.heights[0]);
  bool said = false;
  for (const std::string &step : resampled.steps)
    said = said || step.find("Resampled from 0.5 um to 0.50375 um by a cubic "
                             "spline, so that the length is 40.3 um, Rq ") == 0;
  EXPECT_TRUE(said);

  make_profile(parse(common + "set Profile length = 40.3 um\n"
                              "set Periodic continuation = mirror\n"),
               mirrored);
  EXPECT_NEAR(mirrored.profile.length(), 80.6e-6, 1e-18);
}

TEST(Resample, keeps_a_cubic)
{
  const auto cubic = [](const double x) {
    return 1. + x * (2. - x * (0.5 - 0.1 * x));
  };
  Profile profile;
  profile.spacing = 0.5;
  for (unsigned int i = 0; i < 21; ++i)
    profile.heights.push_back(cubic(0.5 * i));
  const Profile other = resample(profile, 0.37, 27);
  EXPECT_EQ(other.spacing, 0.37);
  for (unsigned int i = 0; i < 27; ++i)
    EXPECT_NEAR(other.heights[i], cubic(0.37 * i), 1e-11) << i;
}

TEST(MakeProfile, holes_are_filled_reported_and_limited)
{
  const std::string common =
    "set File = " + wavy_file() + "\nset Profile position = row 110\n";
  TopographyReport report;
  make_profile(parse(common), report);
  EXPECT_EQ(report.n_filled, 1u);
  EXPECT_NE(refusal(common + "set Largest missing fraction = 0.001\n")
              .find("Crop = hole-free"),
            std::string::npos);
  make_profile(parse("set File = " + wavy_file() + "\nset Crop = hole-free\n"),
               report);
  EXPECT_EQ(report.map.missing_fraction(), 0.);
  EXPECT_EQ(report.window.nx * report.window.ny, 196u * 120u);
}

TEST(MakeProfile, warns_of_missing_points_only_where_they_are_used)
{
  auto       map  = make_map(100, 40, 1e-6, 1e-6, [](double x, double y) {
    return x < 29.5e-6 ? missing_height : 1e-6 * std::sin(3e5 * x + 2e5 * y);
  });
  const auto file = write_bytes("half_measured.x3p", "");
  write_x3p(map, file);
  const auto warned = [](const TopographyReport &report) {
    for (const auto &warning : report.warnings)
      if (warning.find("30 % of the points used are missing") == 0)
        return true;
    return false;
  };
  TopographyReport report;
  make_profile(parse("set File = " + file + "\n"), report);
  EXPECT_TRUE(warned(report));
  EXPECT_NEAR(report.sanity.missing_fraction, 0.3, 1e-12);
  make_profile(parse("set File = " + file + "\nset Crop = hole-free\n"),
               report);
  EXPECT_FALSE(warned(report));
  EXPECT_TRUE(report.sanity.warnings.empty());
}

TEST(MakeProfile, wrong_entries_are_named)
{
  const std::string file = "set File = " + wavy_file() + "\n";
  const auto expect = [&](const std::string &entries, const std::string &part) {
    const auto message = refusal(entries);
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  expect("", "'File'");
  expect(file + "set Lateral unit = parsec\n", "'Lateral unit' = 'parsec'");
  expect(file + "set Crop = window\nset Crop rows = 30\n", "is no range");
  expect(file + "set Crop = window\nset Crop rows = 0 .. 120\n",
         "leaves the map");
  expect(file + "set Crop = window\nset Crop columns = 9 .. 3\n", "is empty");
  expect(file + "set Crop = window\nset Crop rows = 1 kg .. 2 kg\n",
         "'Crop rows'");
  expect(file + "set Profile position = somewhere\n", "'Profile position'");
  expect(file + "set Profile position = 200 um\n", "lie in the map");
  expect(file + "set Profile length = 1 mm\n", "lie in the map");
  expect(file + "set S-filter nesting index = 0.5 um\n", "two sample spacings");
}

TEST(MakeProfile, file_without_unit_needs_both_units)
{
  const auto        matrix = write_bytes("matrix.txt", [] {
    std::string text;
    for (unsigned int j = 0; j < 20; ++j)
      {
        for (unsigned int i = 0; i < 30; ++i)
          text += std::to_string(std::sin(i + 0.1 * j)) + " ";
        text += "\n";
      }
    return text;
  }());
  const std::string entry  = "set File = " + matrix + "\n";
  EXPECT_NE(refusal(entry).find("carries no unit"), std::string::npos);
  TopographyReport report;
  make_profile(parse(entry + "set Height unit = nm\nset Spacing x = 1 um\n"),
               report);
  EXPECT_EQ(report.sanity.unit_source, "given by the user");
  EXPECT_NEAR(report.areal.Sz, 2e-9, 0.3e-9);

  const auto gsf =
    write_bytes("unitless.gsf",
                "Gwyddion Simple Field 1.0\nXRes = 2\nYRes = 2\n" +
                  std::string(4, '\0') + std::string(16, '\1'));
  EXPECT_NE(refusal("set File = " + gsf + "\n").find("set both Lateral unit"),
            std::string::npos);
}

TEST(TopographyCommand, writes_report_profile_and_picture)
{
  const auto folder = std::string(ASPERITY_BINARY_DIR) + "/test_topography/out";
  const auto prm =
    write_bytes("command.prm",
                "set Output directory = " + folder +
                  "\nsubsection Topography\n  set File = " + wavy_file() +
                  "\n  set L-filter nesting index = 25 um\nend\n");
  testing::internal::CaptureStdout();
  EXPECT_EQ(topography_report(prm), 0);
  const auto screen = testing::internal::GetCapturedStdout();
  for (const char *word : {"X3P",
                           "ISO 25178-2",
                           "ISO 4287",
                           "L-filter",
                           "Sq",
                           "Sal",
                           "Str                   at most 0.0"})
    EXPECT_NE(screen.find(word), std::string::npos) << word;

  const auto json = nlohmann::json::parse(read_bytes(folder + "/report.json"));
  EXPECT_EQ(json["surface"]["format"], "X3P");
  EXPECT_NEAR(json["profile"]["period"].get<double>(), 100e-6, 1e-12);
  EXPECT_GT(json["areal"]["Sq"].get<double>(), 0.2e-6);
  // a sine of 10 um, whose ridges cross the map
  const double Sal = std::acos(0.2) * 10e-6 / (2. * pi);
  EXPECT_NEAR(json["areal"]["Sal"].get<double>(), Sal, 0.05 * Sal);
  EXPECT_TRUE(json["areal"]["Str"].is_null());
  EXPECT_LT(json["areal"]["Str_bound"].get<double>(), 0.1);

  const auto csv = read_bytes(folder + "/profile.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 202);
  const auto svg = read_bytes(folder + "/topography.svg");
  EXPECT_NE(svg.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  const auto map = read_height_map(folder + "/surface.x3p");
  EXPECT_EQ(map.nx, 200u);
}

// RFC 4648, section 10.
TEST(Picture, base64_test_vectors)
{
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}
