#include <asperity/base/errors.h>
#include <asperity/splines/sheet_fit.h>
#include <asperity/splines/spline_sheet.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sheet_test_tools.h"

using namespace asperity;
using namespace asperity_test;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** Uneven knots, different degrees and periods. */
  SplineSheet
  random_sheet(const unsigned int degree_x = 3, const unsigned int degree_y = 2)
  {
    return SplineSheet({{uneven_knots(degree_x, 9, -0.3, 1),
                         uneven_knots(degree_y, 7, 2., 2)}},
                       random_numbers(63));
  }
} // namespace

TEST(SplineSheet, of_equal_coefficients_is_flat)
{
  const SplineSheet sheet({{uneven_knots(4, 8, 0., 1),
                            uneven_knots(1, 6, 0., 2)}},
                          std::vector<double>(48, 2.5));
  for (unsigned int i = 0; i < 50; ++i)
    {
      const SheetJet jet = sheet.jet(Point<2>(-9. + 0.7 * i, 4. - 0.41 * i));
      EXPECT_NEAR(jet.height, 2.5, 1e-14);
      EXPECT_NEAR(jet.gradient.norm(), 0., 1e-13);
      EXPECT_NEAR(jet.hessian.norm(), 0., 1e-12);
    }
  EXPECT_NEAR(sheet.minimum(), 2.5, 1e-14);
  EXPECT_NEAR(sheet.maximum(), 2.5, 1e-14);
  EXPECT_NEAR(sheet.mean(), 2.5, 1e-14);
  EXPECT_NEAR(sheet.largest_slope(), 0., 1e-13);
}

TEST(SplineSheet, of_products_is_the_product_of_two_graphs)
{
  const KnotVector          x_knots = uneven_knots(3, 9, -0.3, 1);
  const KnotVector          y_knots = uneven_knots(2, 7, 2., 2);
  const std::vector<double> numbers = random_numbers(16);
  const std::vector<double> a(numbers.begin(), numbers.begin() + 9);
  const std::vector<double> b(numbers.begin() + 9, numbers.end());
  std::vector<double>       coefficients;
  for (const double bj : b)
    for (const double ai : a)
      coefficients.push_back(ai * bj);
  const SplineSheet sheet({{x_knots, y_knots}}, coefficients);
  const SplineCurve f = SplineCurve::graph(x_knots, a);
  const SplineCurve g = SplineCurve::graph(y_knots, b);
  for (unsigned int i = 0; i < 60; ++i)
    {
      const double x = -20. + 0.77 * i, y = 15. - 0.53 * i;
      const auto   fx = f.derivatives(x, 2), gy = g.derivatives(y, 2);
      const auto   jet = sheet.jet(Point<2>(x, y));
      EXPECT_NEAR(sheet.value(Point<2>(x, y)), fx[0][1] * gy[0][1], 1e-14);
      EXPECT_NEAR(jet.gradient[0], fx[1][1] * gy[0][1], 1e-13);
      EXPECT_NEAR(jet.gradient[1], fx[0][1] * gy[1][1], 1e-13);
      EXPECT_NEAR(jet.hessian[0][0], fx[2][1] * gy[0][1], 1e-12);
      EXPECT_NEAR(jet.hessian[0][1], fx[1][1] * gy[1][1], 1e-12);
      EXPECT_NEAR(jet.hessian[1][1], fx[0][1] * gy[2][1], 1e-12);
    }
}

TEST(SplineSheet, has_the_derivatives_of_finite_differences)
{
  const SplineSheet sheet = random_sheet(3, 4);
  const double      h     = 1e-5;
  for (unsigned int i = 0; i < 40; ++i)
    {
      const Point<2> place(-7. + 0.61 * i, 9. - 0.37 * i);
      const SheetJet jet = sheet.jet(place);
      for (unsigned int d = 0; d < 2; ++d)
        {
          Tensor<1, 2> step;
          step[d]           = h;
          const auto before = sheet.jet(place - step);
          const auto after  = sheet.jet(place + step);
          EXPECT_NEAR(jet.gradient[d],
                      (after.height - before.height) / (2. * h),
                      1e-8);
          for (unsigned int e = 0; e < 2; ++e)
            EXPECT_NEAR(jet.hessian[d][e],
                        (after.gradient[e] - before.gradient[e]) / (2. * h),
                        1e-4);
        }
    }
}

TEST(SplineSheet, repeats_after_its_periods)
{
  const SplineSheet sheet = random_sheet();
  for (unsigned int i = 0; i < 40; ++i)
    {
      const Point<2> place(0.23 * i, 2. + 0.17 * i);
      const SheetJet here = sheet.jet(place);
      for (const int turn_x : {-3, 1})
        for (const int turn_y : {-1, 2})
          {
            const SheetJet there =
              sheet.jet(place + Point<2>(turn_x * sheet.period(0),
                                         turn_y * sheet.period(1)));
            EXPECT_NEAR(there.height, here.height, 1e-13);
            EXPECT_NEAR((there.gradient - here.gradient).norm(), 0., 1e-12);
          }
    }
}

TEST(SplineSheet, lies_in_the_convex_hull_of_its_pieces)
{
  const SplineSheet sheet  = random_sheet();
  const auto        pieces = sheet.bezier_pieces();
  ASSERT_EQ(pieces.size(), 63u);
  for (const SheetPiece &piece : pieces)
    {
      ASSERT_EQ(piece.heights.size(), 12u);
      const auto range =
        std::minmax_element(piece.heights.begin(), piece.heights.end());
      EXPECT_NEAR(piece.heights[0], sheet.value(piece.begin), 1e-14);
      // The Bernstein polynomials 1 8 of degree 3 and 1 2 1 of degree 2.
      double middle = 0.;
      for (unsigned int j = 0; j < 3; ++j)
        for (unsigned int i = 0; i < 4; ++i)
          middle += (i == 0 || i == 3 ? 1. : 3.) / 8. * (j == 1 ? 2. : 1.) /
                    4. * piece.heights[4 * j + i];
      const Point<2> centre((piece.begin[0] + piece.end[0]) / 2.,
                            (piece.begin[1] + piece.end[1]) / 2.);
      EXPECT_NEAR(middle, sheet.value(centre), 1e-14);
      EXPECT_LE(*range.first, middle);
      EXPECT_GE(*range.second, middle);
    }
}

TEST(SplineSheet, has_no_point_beyond_its_extremes)
{
  for (const unsigned int degree : {1u, 2u, 3u, 5u})
    {
      const SplineSheet  sheet = random_sheet(degree, 3);
      const unsigned int n     = 300;
      double             low = 1e300, high = -1e300, slope = 0., sum = 0.;
      for (unsigned int j = 0; j < n; ++j)
        for (unsigned int i = 0; i < n; ++i)
          {
            const auto jet = sheet.jet(
              Point<2>(sheet.period(0) * i / n, sheet.period(1) * j / n));
            low   = std::min(low, jet.height);
            high  = std::max(high, jet.height);
            slope = std::max(slope, jet.gradient.norm());
            sum += jet.height / (n * n);
          }
      const double minimum = sheet.minimum(), maximum = sheet.maximum();
      EXPECT_LE(minimum, low + 1e-8);
      EXPECT_GE(minimum, low - 5e-3);
      EXPECT_GE(maximum, high - 1e-8);
      EXPECT_LE(maximum, high + 5e-3);
      EXPECT_GE(sheet.largest_slope(), slope - 1e-8);
      EXPECT_LE(sheet.largest_slope(), slope * 1.02);
      EXPECT_NEAR(sheet.mean(), sum, 1e-3);
    }
}

TEST(SplineSheet, finds_the_extremes_of_a_product_of_cosines)
{
  const auto product = [](const double x, const double y) {
    return std::cos(2. * M_PI * x) * std::cos(2. * M_PI * y);
  };
  const SplineSheet sheet =
    interpolate_periodic_sheet(sampled(product, {{40, 32}}, {{1., 1.}}), 5)
      .sheet;
  EXPECT_NEAR(sheet.minimum(), -1., 1e-7);
  EXPECT_NEAR(sheet.maximum(), 1., 1e-7);
  // |grad|^2 = (2 pi)^2 (sin^2 cos^2 + cos^2 sin^2) has its maximum (2 pi)^2
  // where one sine is one and the other zero.
  EXPECT_NEAR(sheet.largest_slope(), 2. * M_PI, 1e-5);
  EXPECT_NEAR(sheet.mean(), 0., 1e-12);
}

TEST(SplineSheet, tells_slopes_along_and_across_apart)
{
  const auto waves = [](const double x, const double y) {
    return 0.3 * std::cos(2. * M_PI * x) + 0.5 * std::sin(2. * M_PI * y / 4.);
  };
  const SplineSheet sheet =
    interpolate_periodic_sheet(sampled(waves, {{40, 40}}, {{1., 4.}}), 5).sheet;
  EXPECT_NEAR(sheet.largest_slope(0), 0.6 * M_PI, 1e-5);
  EXPECT_NEAR(sheet.largest_slope(1), 0.25 * M_PI, 1e-5);
}

TEST(SplineSheet, follows_a_linear_map_of_its_heights)
{
  const SplineSheet sheet  = random_sheet();
  const SplineSheet mapped = sheet.mapped(-2., 0.7);
  const Point<2>    place(1.3, 3.1);
  EXPECT_NEAR(mapped.value(place), 0.7 - 2. * sheet.value(place), 1e-14);
  EXPECT_NEAR(mapped.maximum(), 0.7 - 2. * sheet.minimum(), 1e-8);
  EXPECT_NEAR(mapped.largest_slope(), 2. * sheet.largest_slope(), 1e-8);
}

TEST(SplineSheet, is_extruded_from_a_graph)
{
  const KnotVector  knots = uneven_knots(3, 9, -0.3, 1);
  const SplineCurve curve = SplineCurve::graph(knots, random_numbers(9));
  const SplineSheet sheet = extrude(curve, 2.5, 6);
  EXPECT_EQ(sheet.period(0), curve.period()[0]);
  EXPECT_EQ(sheet.period(1), 2.5);
  for (unsigned int i = 0; i < 60; ++i)
    {
      const double x   = -8. + 0.31 * i;
      const auto   y   = curve.derivatives(x, 2);
      const auto   jet = sheet.jet(Point<2>(x, 1.9 - 0.23 * i));
      EXPECT_NEAR(jet.height, y[0][1], 1e-15);
      EXPECT_NEAR(jet.gradient[0], y[1][1], 1e-14);
      EXPECT_NEAR(jet.gradient[1], 0., 1e-14);
      EXPECT_NEAR(jet.hessian[0][0], y[2][1], 1e-13);
    }
}

TEST(SplineSheet, refuses_what_is_none)
{
  const KnotVector knots = uneven_knots(3, 9, 0., 1);
  EXPECT_THROW(SplineSheet({{knots, KnotVector(3, {0., 1., 2.})}},
                           std::vector<double>(45)),
               InputError);
  EXPECT_THROW(SplineSheet({{knots, knots}}, std::vector<double>(80)),
               InputError);
  const SplineCurve closed(knots, std::vector<Point<2>>(9));
  EXPECT_THROW(extrude(closed, 1., 6), InputError);
  const SplineCurve graph = SplineCurve::graph(knots, random_numbers(9));
  EXPECT_THROW(extrude(graph, 1., 3), InputError);
  EXPECT_THROW(extrude(graph, -1., 6), InputError);
}
