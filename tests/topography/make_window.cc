#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/topography/make_window.h>
#include <asperity/topography/read_height_map.h>

#include <deal.II/base/parameter_handler.h>

#include "topography_test_tools.h"

using namespace asperity;
using namespace asperity_test;
using dealii::Point;

namespace
{
  const double pi = std::acos(-1.);

  using Surface = std::function<double(double, double)>;

  /** Repeats after 40 um along x and 30 um along y; its mean is zero. */
  double
  waves(const double x, const double y)
  {
    return 0.4e-6 * std::cos(2. * pi * (2. * x / 40e-6 + y / 30e-6) + 0.3) +
           0.2e-6 * std::sin(2. * pi * (x / 40e-6 - 2. * y / 30e-6));
  }

  TopographyParameters
  parameters_of(const HeightMap &map, const std::string &entries)
  {
    const auto file = write_bytes("window.x3p", "");
    write_x3p(map, file);
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    TopographyParameters     parameters;
    parameters.declare(declarator);
    declarator.read_text("set File = " + file + "\n" + entries, "test.prm");
    return parameters;
  }

  /** 160 x 90 um, samples 0.5 um apart along x and 0.25 um along y. */
  HeightMap
  large_map(const Surface &surface)
  {
    return make_map(320, 360, 0.5e-6, 0.25e-6, surface);
  }

  WindowChoice
  part(const double extent_x, const double extent_y)
  {
    WindowChoice choice;
    choice.extent = {{extent_x, extent_y}};
    return choice;
  }

  struct Result
  {
    SplineSheet      sheet;
    TopographyReport report;
    WindowReport     window;
  };

  Result
  window_of(const HeightMap    &map,
            const WindowChoice &choice,
            const std::string  &entries = "set F-operator = none\n")
  {
    Result result;
    result.sheet = make_window(parameters_of(map, entries),
                               choice,
                               result.report,
                               result.window);
    return result;
  }

  std::string
  refusal(const WindowChoice &choice,
          const std::string  &entries = "",
          const Surface      &surface = waves)
  {
    return message_of<InputError>([&]() {
      window_of(make_map(100, 80, 0.5e-6, 0.5e-6, surface), choice, entries);
    });
  }

  /** Largest difference to a surface in the window that begins at (x, y). */
  double
  largest_difference(const SplineSheet &sheet,
                     const Surface     &surface,
                     const double       x,
                     const double       y)
  {
    double largest = 0.;
    for (unsigned int j = 0; j < 40; ++j)
      for (unsigned int i = 0; i < 40; ++i)
        {
          const Point<2> place(sheet.period(0) * i / 40.,
                               sheet.period(1) * j / 40.);
          largest = std::max(largest,
                             std::abs(sheet.value(place) -
                                      surface(x + place[0], y + place[1])));
        }
    return largest;
  }
} // namespace

TEST(MakeWindow, returns_a_periodic_surface)
{
  const auto result = window_of(large_map(waves), part(40e-6, 30e-6));
  EXPECT_NEAR(result.sheet.period(0), 40e-6, 1e-18);
  EXPECT_NEAR(result.sheet.period(1), 30e-6, 1e-18);
  // in the middle of the map
  EXPECT_EQ(result.window.window.column, 120u);
  EXPECT_EQ(result.window.window.row, 120u);
  EXPECT_LT(largest_difference(result.sheet, waves, 60e-6, 30e-6), 1e-9);
  EXPECT_LT(result.window.fit_max, 1e-9);
  EXPECT_FALSE(result.window.bridged[0] || result.window.bridged[1]);
  EXPECT_LT(result.window.largest_jump[0], 2e-9);
  EXPECT_LT(result.window.largest_jump[1], 2e-9);
  EXPECT_NEAR(result.window.Sq_before, std::sqrt(0.1) * 1e-6, 1e-9);
  EXPECT_NEAR(result.window.Sq_after, result.window.Sq_before, 1e-10);
  EXPECT_NEAR(result.window.Sdq_after, result.window.Sdq_before, 1e-4);
  EXPECT_TRUE(result.report.warnings.empty());
}

TEST(MakeWindow, begins_where_it_is_told_to)
{
  WindowChoice choice = part(40e-6, 30e-6);
  choice.origin       = std::array<double, 2>{{7e-6, 42e-6}};
  const auto result   = window_of(large_map(waves), choice);
  EXPECT_EQ(result.window.window.column, 14u);
  EXPECT_EQ(result.window.window.row, 168u);
  EXPECT_LT(largest_difference(result.sheet, waves, 7e-6, 42e-6), 1e-9);
}

TEST(MakeWindow, is_level)
{
  // The plane of the map is removed as form, or that of the window's seams.
  const auto tilted = [](const double x, const double y) {
    return 3e-6 + 0.02 * x - 0.01 * y + waves(x, y);
  };
  for (const std::string form : {"none", "plane"})
    {
      const auto result = window_of(large_map(tilted),
                                    part(40e-6, 30e-6),
                                    "set F-operator = " + form + "\n");
      EXPECT_LT(largest_difference(result.sheet, waves, 60e-6, 30e-6), 1e-9);
      if (form == "none")
        {
          EXPECT_NEAR(result.window.removed_tilt[0], 0.02, 2e-5);
          EXPECT_NEAR(result.window.removed_tilt[1], -0.01, 2e-5);
        }
      EXPECT_NEAR(result.sheet.mean(), 0., 1e-12);
    }
}

TEST(MakeWindow, meets_an_extent_between_samples)
{
  // 40 um are no multiple of 0.47 um.
  const auto   map    = make_map(300, 360, 0.47e-6, 0.25e-6, waves);
  WindowChoice choice = part(40e-6, 30e-6);
  choice.origin       = std::array<double, 2>{{4.7e-6, 5e-6}};
  const auto result   = window_of(map, choice);
  EXPECT_EQ(result.window.window.nx, 85u);
  EXPECT_NEAR(result.sheet.period(0), 40e-6, 1e-18);
  EXPECT_LT(largest_difference(result.sheet, waves, 4.7e-6, 5e-6), 2e-8);
  EXPECT_EQ(result.report.steps[1].find("Resampled to 0.47059 um"), 0u)
    << result.report.steps[1];
}

TEST(MakeWindow, bridges_the_seams_of_a_surface_that_does_not_repeat)
{
  // Along x a wave that is half a length too long, level at both ends, from
  // 0.2 um to -0.2 um; along y it repeats.
  const auto surface = [](const double x, const double y) {
    return 0.2e-6 * std::cos(2. * pi * 1.5 * (x - 60e-6) / 40e-6) +
           0.1e-6 * std::cos(2. * pi * y / 30e-6);
  };
  const auto result = window_of(large_map(surface), part(40e-6, 30e-6));
  // A tilt makes its ends meet.
  EXPECT_NEAR(result.window.removed_tilt[0], -0.01, 1e-4);
  EXPECT_LT(result.window.rms_jump[0], 1e-9);

  // No tilt does if it goes down at half of the width and up at the other.
  const auto turning = [&](const double x, const double y) {
    return surface(x, y) * std::cos(2. * pi * y / 30e-6);
  };
  const auto turned = window_of(large_map(turning), part(40e-6, 30e-6));
  EXPECT_NEAR(turned.window.largest_jump[0], 0.4e-6, 0.01e-6);
  EXPECT_NEAR(turned.window.rms_jump[0], 0.4e-6 / std::sqrt(2.), 0.01e-6);
  EXPECT_LT(turned.window.largest_jump[1], 2e-9);
  EXPECT_TRUE(turned.window.bridged[0]);
  EXPECT_FALSE(turned.window.bridged[1]);
  // Away from the seam it is the measured surface, about its mean.
  EXPECT_LT(turned.window.fit_max, 2e-9);
  EXPECT_GT(turned.window.Sq_before, 0.);
  EXPECT_NEAR(turned.window.Sq_after, turned.window.Sq_before, 0.02e-6);
  // The bridge does not overshoot.
  EXPECT_LT(turned.sheet.maximum(), 0.35e-6);
  EXPECT_NE(turned.report.steps.back().find("(bridged)"), std::string::npos);

  // A sheet has no jump: neighbours across the seam are as near as others.
  const double across = turned.sheet.value(Point<2>(0.1e-6, 0.)) -
                        turned.sheet.value(Point<2>(-0.1e-6, 0.));
  EXPECT_LT(std::abs(across), 0.2e-6 * turned.sheet.largest_slope());
}

TEST(MakeWindow, takes_a_surface_as_periodic_if_told_so)
{
  // A sawtooth along x: its jump stays, but for what the spline smooths.
  const auto sawtooth = [](const double x, const double) {
    return 0.01 * (x - 60e-6) - 0.2e-6;
  };
  const auto result = window_of(large_map(sawtooth),
                                part(40e-6, 30e-6),
                                "set F-operator = none\n"
                                "set Periodic continuation = none\n");
  EXPECT_EQ(result.window.removed_tilt[0], 0.);
  EXPECT_FALSE(result.window.bridged[0]);
  EXPECT_NEAR(result.window.rms_jump[0], 0.4e-6, 1e-9);
  EXPECT_NEAR(result.sheet.value(Point<2>(10e-6, 3e-6)), -0.1e-6, 3e-9);
  EXPECT_NEAR(result.sheet.value(Point<2>(30e-6, 3e-6)), 0.1e-6, 3e-9);
}

TEST(MakeWindow, fills_few_gaps_and_scales)
{
  HeightMap map     = large_map(waves);
  map(150, 170)     = missing_height;
  map(151, 170)     = missing_height;
  const auto result = window_of(map,
                                part(40e-6, 30e-6),
                                "set F-operator = none\nset Scale x = 2\n"
                                "set Scale z = 3\n");
  EXPECT_EQ(result.window.n_filled, 2u);
  EXPECT_NEAR(result.sheet.period(0), 80e-6, 1e-18);
  EXPECT_NEAR(result.sheet.period(1), 60e-6, 1e-18);
  const auto scaled = [](const double x, const double y) {
    return 3. * waves(x / 2., y / 2.);
  };
  EXPECT_LT(largest_difference(result.sheet, scaled, 120e-6, 60e-6), 5e-8);
}

TEST(MakeWindow, says_what_is_wrong)
{
  // A map of 50 x 40 um.
  EXPECT_NE(refusal(part(60e-6, 30e-6))
              .find("A window of 60 um x 30 um does not fit into the map of 50 "
                    "um x 40 um in "),
            std::string::npos)
    << refusal(part(60e-6, 30e-6));
  WindowChoice choice = part(40e-6, 30e-6);
  choice.origin       = std::array<double, 2>{{5e-6, 15e-6}};
  EXPECT_NE(refusal(choice).find(
              "The window from 15 um to 45 um along y leaves "
              "the map of 50 um x 40 um in "),
            std::string::npos)
    << refusal(choice);
  EXPECT_NE(refusal(part(0., 30e-6)).find("along x is 0 um"), std::string::npos)
    << refusal(part(0., 30e-6));
  EXPECT_NE(refusal(part(4e-6, 30e-6)).find("holds 8 samples"),
            std::string::npos)
    << refusal(part(4e-6, 30e-6));
  EXPECT_NE(refusal(part(40e-6, 30e-6), "set Periodic continuation = mirror\n")
              .find("mirror image"),
            std::string::npos);
  const auto holes = [](const double x, const double y) {
    return x > 20e-6 && x < 28e-6 ? missing_height : waves(x, y);
  };
  EXPECT_NE(refusal(part(40e-6, 30e-6), "", holes)
              .find("of the window's points are missing"),
            std::string::npos)
    << refusal(part(40e-6, 30e-6), "", holes);
}
