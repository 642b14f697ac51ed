#include <asperity/base/errors.h>
#include <asperity/splines/sheet_fit.h>
#include <asperity/splines/spline_sheet.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

using namespace asperity;
using dealii::Point;
using dealii::Tensor;

namespace
{
  KnotVector
  uneven_knots(const unsigned int  degree,
               const unsigned int  n_spans,
               const double        begin,
               const unsigned long seed)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> uniform(0.6, 1.4);
    std::vector<double>                    breakpoints = {begin};
    for (unsigned int i = 0; i < n_spans; ++i)
      breakpoints.push_back(breakpoints.back() + uniform(generator));
    return KnotVector(degree, breakpoints, true);
  }

  std::vector<double>
  random_numbers(const std::size_t n)
  {
    std::mt19937                           generator(11);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    std::vector<double>                    numbers(n);
    for (double &number : numbers)
      number = uniform(generator);
    return numbers;
  }

  /** Uneven knots, different degrees and periods. */
  SplineSheet
  random_sheet(const unsigned int degree_x = 3, const unsigned int degree_y = 2)
  {
    return SplineSheet({{uneven_knots(degree_x, 9, -0.3, 1),
                         uneven_knots(degree_y, 7, 2., 2)}},
                       random_numbers(63));
  }

  PeriodicHeights
  sampled(const std::function<double(double, double)> &function,
          const std::array<unsigned int, 2>           &n,
          const std::array<double, 2>                 &period)
  {
    PeriodicHeights data;
    data.n      = n;
    data.period = period;
    for (unsigned int j = 0; j < n[1]; ++j)
      for (unsigned int i = 0; i < n[0]; ++i)
        data.heights.push_back(
          function(i * period[0] / n[0], j * period[1] / n[1]));
    return data;
  }

  double
  smooth(const double x, const double y)
  {
    return std::sin(M_PI * x) * std::cos(2. * M_PI * y / 3. - 0.4) +
           0.3 * std::cos(M_PI * x + 2. * M_PI * y / 3.);
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

TEST(SheetFit, reproduces_a_sheet_of_its_space)
{
  for (const unsigned int degree : {2u, 3u, 4u})
    {
      const SplineSheet given(
        {{KnotVector::uniform_periodic(degree, 9, 0., 2.),
          KnotVector::uniform_periodic(degree, 7, 0., 5.)}},
        random_numbers(63));
      const auto values = [&](const double x, const double y) {
        return given.value(Point<2>(x, y));
      };
      const SheetFit fit =
        fit_periodic_sheet(sampled(values, {{21, 16}}, {{2., 5.}}),
                           {{9, 7}},
                           degree);
      EXPECT_LT(fit.report.max_error, 1e-14);
      EXPECT_EQ(fit.report.n_control_points, 63u);
      for (unsigned int i = 0; i < 63; ++i)
        EXPECT_NEAR(fit.sheet.coefficients()[i],
                    given.coefficients()[i],
                    1e-13);
    }
}

TEST(SheetFit, is_that_of_the_profile_where_nothing_depends_on_y)
{
  const std::vector<double> heights = random_numbers(30);
  std::vector<double>       x;
  PeriodicHeights           data;
  data.n      = {{30, 12}};
  data.period = {{3., 1.}};
  for (unsigned int i = 0; i < 30; ++i)
    x.push_back(0.1 * i);
  for (unsigned int j = 0; j < 12; ++j)
    data.heights.insert(data.heights.end(), heights.begin(), heights.end());
  for (const double bending : {0., 1e-4})
    {
      FitOptions options;
      options.bending = bending;
      const SplineFit profile =
        fit_periodic_graph(x, heights, 3., 13, 3, options);
      const SheetFit fit = fit_periodic_sheet(data, {{13, 6}}, 3, bending);
      EXPECT_NEAR(fit.report.rms_error, profile.report.rms_error, 1e-13);
      EXPECT_NEAR(fit.report.max_error, profile.report.max_error, 1e-13);
      for (unsigned int i = 0; i < 50; ++i)
        EXPECT_NEAR(fit.sheet.value(Point<2>(0.07 * i, -0.2 * i)),
                    profile.curve.value(0.07 * i)[1],
                    1e-13);
    }
}

TEST(SheetFit, leaves_residuals_orthogonal_to_all_functions)
{
  PeriodicHeights data;
  data.n             = {{14, 12}};
  data.period        = {{2., 3.}};
  data.heights       = random_numbers(14 * 12);
  const SheetFit fit = fit_periodic_sheet(data, {{6, 5}}, 3);
  double         sum = 0., largest = 0.;
  for (unsigned int k = 0; k < 30; ++k)
    {
      std::vector<double> unit(30);
      unit[k] = 1.;
      const SplineSheet function(
        {{fit.sheet.knot_vector(0), fit.sheet.knot_vector(1)}}, unit);
      double product = 0.;
      for (unsigned int j = 0; j < 12; ++j)
        for (unsigned int i = 0; i < 14; ++i)
          {
            const Point<2> place(2. * i / 14., 3. * j / 12.);
            const double   residual =
              data.heights[14 * j + i] - fit.sheet.value(place);
            product += function.value(place) * residual;
            if (k == 0)
              sum += residual * residual;
            largest = std::max(largest, std::abs(residual));
          }
      EXPECT_NEAR(product, 0., 1e-13);
    }
  EXPECT_NEAR(fit.report.rms_error, std::sqrt(sum / (14 * 12)), 1e-14);
  EXPECT_NEAR(fit.report.max_error, largest, 1e-14);
}

TEST(SheetFit, converges_with_the_order_of_its_degree)
{
  for (const unsigned int degree : {2u, 3u, 4u})
    {
      std::vector<double> errors;
      for (const unsigned int n : {8u, 16u})
        {
          const SheetFit fit =
            fit_periodic_sheet(sampled(smooth, {{6 * n, 6 * n}}, {{2., 3.}}),
                               {{n, n}},
                               degree);
          double error = 0.;
          for (unsigned int j = 0; j < 50; ++j)
            for (unsigned int i = 0; i < 50; ++i)
              {
                const Point<2> place(0.04 * i, 0.06 * j);
                error = std::max(error,
                                 std::abs(fit.sheet.value(place) -
                                          smooth(place[0], place[1])));
              }
          errors.push_back(error);
        }
      EXPECT_GT(std::log2(errors[0] / errors[1]), degree + 0.8) << degree;
    }
}

TEST(SheetFit, passes_through_its_data_if_it_interpolates)
{
  PeriodicHeights data;
  data.n             = {{17, 12}};
  data.period        = {{2., 3.}};
  data.heights       = random_numbers(17 * 12);
  const SheetFit fit = interpolate_periodic_sheet(data, 5);
  EXPECT_LT(fit.report.max_error, 1e-13);
  for (unsigned int j = 0; j < 12; ++j)
    for (unsigned int i = 0; i < 17; ++i)
      EXPECT_NEAR(fit.sheet.value(Point<2>(2. * i / 17. - 4., 3. * j / 12.)),
                  data.heights[17 * j + i],
                  1e-12);
}

TEST(SheetFit, refuses_what_does_not_determine_it)
{
  PeriodicHeights data = sampled(smooth, {{16, 12}}, {{2., 3.}});
  EXPECT_THROW(fit_periodic_sheet(data, {{20, 8}}, 3), InputError);
  EXPECT_NO_THROW(fit_periodic_sheet(data, {{20, 8}}, 3, 1e-6));
  EXPECT_THROW(fit_periodic_sheet(data, {{8, 2}}, 3), InputError);
  EXPECT_THROW(interpolate_periodic_sheet(data, 2), InputError);
  EXPECT_THROW(interpolate_periodic_sheet(data, 7), InputError);
  data.heights[5] = NAN;
  EXPECT_THROW(interpolate_periodic_sheet(data, 3), InputError);
  data.heights.pop_back();
  EXPECT_THROW(interpolate_periodic_sheet(data, 3), InputError);
}
