#include <asperity/base/errors.h>
#include <asperity/splines/sheet_fit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sheet_test_tools.h"

using namespace asperity;
using namespace asperity_test;
using dealii::Point;

namespace
{
  double
  smooth(const double x, const double y)
  {
    return std::sin(M_PI * x) * std::cos(2. * M_PI * y / 3. - 0.4) +
           0.3 * std::cos(M_PI * x + 2. * M_PI * y / 3.);
  }
} // namespace

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
