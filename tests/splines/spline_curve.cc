#include <asperity/base/errors.h>
#include <asperity/splines/spline_curve.h>
#include <asperity/splines/spline_fit.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace asperity;
using dealii::Point;
using dealii::Tensor;

namespace
{
  std::vector<Point<2>>
  random_points(const unsigned int n, const unsigned int seed = 1)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    std::vector<Point<2>>                  points;
    for (unsigned int i = 0; i < n; ++i)
      points.emplace_back(i + uniform(generator), uniform(generator));
    return points;
  }



  std::vector<double>
  uneven_breakpoints(const unsigned int n_spans)
  {
    std::vector<double> breakpoints = {0.2};
    for (unsigned int i = 0; i < n_spans; ++i)
      breakpoints.push_back(breakpoints.back() + 0.1 + 0.05 * std::sin(5. * i));
    return breakpoints;
  }



  /** The full circle of nine control points (Piegl and Tiller, example 7.3). */
  SplineCurve
  circle(const double radius)
  {
    const double          w = std::sqrt(0.5);
    std::vector<Point<2>> points;
    std::vector<double>   weights;
    const double          x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1};
    const double          y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    for (unsigned int i = 0; i < 9; ++i)
      {
        points.emplace_back(radius * x[i], radius * y[i]);
        weights.push_back(i % 2 ? w : 1.);
      }
    return SplineCurve(
      KnotVector::from_knots(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}),
      points,
      weights);
  }



  Point<2>
  de_casteljau(const BezierPiece &piece, const double x)
  {
    std::vector<Tensor<1, 3>> points(piece.points.size());
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        const double w = piece.weights.empty() ? 1. : piece.weights[i];
        points[i][0]   = w * piece.points[i][0];
        points[i][1]   = w * piece.points[i][1];
        points[i][2]   = w;
      }
    for (unsigned int k = points.size() - 1; k > 0; --k)
      for (unsigned int i = 0; i < k; ++i)
        points[i] = (1. - x) * points[i] + x * points[i + 1];
    return Point<2>(points[0][0] / points[0][2], points[0][1] / points[0][2]);
  }
} // namespace



TEST(SplineCurve, nurbs_circle_has_exact_radius_and_curvature)
{
  const SplineCurve curve = circle(3.);
  for (double t = 0.; t <= 4.; t += 0.0625)
    {
      const auto C = curve.derivatives(t, 2);
      EXPECT_NEAR(C[0].norm(), 3., 1e-14);
      const double cross = C[1][0] * C[2][1] - C[1][1] * C[2][0];
      EXPECT_NEAR(cross / std::pow(C[1].norm(), 3), 1. / 3., 1e-13);
    }
  EXPECT_NEAR(curve.length(0., 4., 16), 6. * M_PI, 1e-12);
}



TEST(SplineCurve, derivatives_of_any_order_equal_finite_differences)
{
  for (const bool rational : {false, true})
    for (const bool periodic : {false, true})
      {
        const KnotVector    knots(4, uneven_breakpoints(9), periodic);
        std::vector<double> weights;
        for (unsigned int i = 0; rational && i < knots.n_basis(); ++i)
          weights.push_back(1. + 0.5 * std::sin(3. * i));
        Tensor<1, 2> period;
        if (periodic)
          period[0] = 9.;
        const SplineCurve curve(knots,
                                random_points(knots.n_basis()),
                                weights,
                                period);
        const double      h = 1e-5;
        for (const double x : {0.1, 0.45, 0.9})
          {
            const double t =
              (1. - x) * curve.knot_vector().front() + x * knots.back() + 1e-3;
            const auto C     = curve.derivatives(t, 6);
            const auto left  = curve.derivatives(t - h, 5);
            const auto right = curve.derivatives(t + h, 5);
            for (unsigned int k = 0; k < (rational ? 5u : 3u); ++k)
              EXPECT_LT(((right[k] - left[k]) / (2. * h) - C[k + 1]).norm(),
                        1e-5 * (C[k + 1].norm() + C[k].norm()));
          }
      }
}



TEST(SplineCurve, bezier_pieces_equal_the_spline)
{
  for (unsigned int p = 1; p <= 7; ++p)
    for (const bool periodic : {false, true})
      {
        const KnotVector knots(p, uneven_breakpoints(9), periodic);
        Tensor<1, 2>     period;
        if (periodic)
          {
            period[0] = 9.;
            period[1] = 1.;
          }
        std::vector<double> weights(knots.n_basis(), 1.);
        weights[2] = 3.;
        const SplineCurve curve(knots,
                                random_points(knots.n_basis()),
                                p % 2 ? weights : std::vector<double>(),
                                period);
        for (const BezierPiece &piece : curve.bezier_pieces())
          for (const double x : {0., 0.3, 0.8})
            EXPECT_LT((de_casteljau(piece, x) -
                       curve.value((1. - x) * piece.begin + x * piece.end))
                        .norm(),
                      1e-13);
      }
}



TEST(SplineCurve, periodic_graph_goes_on_for_every_x)
{
  const double period = 10e-6;
  const auto   height = [period](const double x) {
    return 1e-7 * std::cos(2. * M_PI * x / period + 0.3);
  };
  const SplineCurve curve =
    interpolate_periodic_function(height, 1e-6, period, 80, 3);
  for (int turn = -1000; turn <= 1000; turn += 250)
    for (double x = 0.; x < period; x += 0.37e-6)
      {
        const auto C = curve.derivatives(turn * period + x, 1);
        EXPECT_NEAR(C[0][0],
                    turn * period + x,
                    1e-13 * period * (1 + std::abs(turn)));
        EXPECT_NEAR(C[0][1], height(x), 1e-7 * 1e-6);
        EXPECT_NEAR(C[1][0], 1., 1e-12);
      }
}



TEST(SplineCurve, contradicting_input_is_refused)
{
  const KnotVector open(2, {0., 1., 2.}), wrapped(2, {0., 1., 2., 3.}, true);
  const auto       points = random_points(4);
  EXPECT_THROW(SplineCurve(open, random_points(3)), InputError);
  EXPECT_THROW(SplineCurve(open, points, {1., 1.}), InputError);
  EXPECT_THROW(SplineCurve(open, points, {1., 1., 0., 1.}), InputError);
  EXPECT_THROW(SplineCurve(open, points, {}, Point<2>(1., 0.)), InputError);
  EXPECT_NO_THROW(SplineCurve(wrapped, random_points(3), {}, Point<2>(1., 0.)));
}



TEST(SplineFit, a_fit_returns_the_spline_it_was_sampled_from)
{
  for (unsigned int p = 1; p <= 5; ++p)
    for (const bool periodic : {false, true})
      {
        const KnotVector knots(p, uneven_breakpoints(20), periodic);
        FitOptions       options;
        if (periodic)
          {
            options.period[0] = 20.;
            options.period[1] = -0.5;
          }
        else
          options.interpolate_ends = (p % 2 == 0);
        const SplineCurve     curve(knots,
                                random_points(knots.n_basis()),
                                {},
                                options.period);
        std::vector<Point<2>> points;
        std::vector<double>   parameters;
        const double          length = knots.back() - knots.front();
        // in periodic cases from several turns
        for (unsigned int i = 0; i <= 200; ++i)
          {
            parameters.push_back(knots.front() +
                                 (periodic ? 3. : 1.) * length * i / 200.);
            points.push_back(curve.value(parameters.back()));
            options.weights.push_back(1. + i % 3);
          }
        const SplineFit fit =
          fit_least_squares(knots, points, parameters, options);
        EXPECT_LT(fit.report.max_error, 1e-13 * 60.);
        EXPECT_EQ(fit.report.n_control_points, knots.n_basis());
        for (unsigned int i = 0; i < knots.n_basis(); ++i)
          EXPECT_LT(
            (fit.curve.control_points()[i] - curve.control_points()[i]).norm(),
            1e-11)
            << p << periodic << i;
      }
}



TEST(SplineFit, interpolation_passes_through_its_points)
{
  for (unsigned int p = 1; p <= 6; ++p)
    {
      const auto      points = random_points(25, p);
      const SplineFit open   = interpolate(points, p);
      const auto      t      = chord_parameters(points);
      for (unsigned int i = 0; i < points.size(); ++i)
        EXPECT_LT((open.curve.value(t[i]) - points[i]).norm(), 1e-11);

      const KnotVector knots(p, uneven_breakpoints(25), true);
      Tensor<1, 2>     period;
      period[0] = 25.;
      const SplineFit turns =
        interpolate(knots, points, knots.greville(), period);
      for (unsigned int i = 0; i < points.size(); ++i)
        EXPECT_LT((turns.curve.value(knots.greville()[i]) - points[i]).norm(),
                  1e-11)
          << p;
    }
}



// Order p + 1 for smooth functions.
TEST(SplineFit, periodic_interpolation_converges_with_order_p_plus_1)
{
  const auto function = [](const double x) { return std::exp(std::sin(x)); };
  for (unsigned int p = 1; p <= 5; ++p)
    {
      double error[2];
      for (const unsigned int level : {0u, 1u})
        {
          const SplineCurve curve = interpolate_periodic_function(
            function, 0.1, 2. * M_PI, 24 << level, p);
          error[level] = 0.;
          for (double x = 0.; x < 2. * M_PI; x += 0.003)
            error[level] =
              std::max(error[level], std::abs(curve.value(x)[1] - function(x)));
        }
      EXPECT_GT(std::log2(error[0] / error[1]), p + 1 - 0.4);
    }
}



TEST(SplineFit, fitted_graph_of_noise_is_the_normal_equation_solution)
{
  // The residual of a least-squares fit is orthogonal to all functions.
  std::vector<double> x, y;
  for (unsigned int i = 0; i < 300; ++i)
    {
      x.push_back(1e-6 + 0.01e-6 * i);
      y.push_back(1e-7 * std::sin(1000. * i * i));
    }
  const SplineFit     fit   = fit_periodic_graph(x, y, 3e-6, 30, 3);
  const auto         &knots = fit.curve.knot_vector();
  std::vector<double> projection(knots.n_basis());
  double              sum = 0.;
  for (unsigned int i = 0; i < x.size(); ++i)
    {
      const double       r    = y[i] - fit.curve.value(x[i])[1];
      const unsigned int span = knots.find_span(x[i]);
      const auto         N    = knots.evaluate(span, knots.wrap(x[i]))[0];
      for (unsigned int j = 0; j < N.size(); ++j)
        projection[knots.span_functions(span)[j]] += N[j] * r;
      EXPECT_NEAR(std::abs(r), fit.report.residuals[i], 1e-18);
      sum += r * r;
    }
  for (const double value : projection)
    EXPECT_NEAR(value, 0., 1e-19);
  EXPECT_NEAR(fit.report.rms_error, std::sqrt(sum / 300.), 1e-19);
}



// A straight line bends nothing, so a heavy bending term leads to the
// regression line.
TEST(SplineFit, heavy_bending_term_gives_the_regression_line)
{
  std::vector<Point<2>> points;
  std::vector<double>   t;
  double                st = 0., sy = 0., stt = 0., sty = 0.;
  for (unsigned int i = 0; i < 50; ++i)
    {
      t.push_back(i / 49.);
      points.emplace_back(t.back(), std::cos(2. * i));
      st += t[i];
      sy += points[i][1];
      stt += t[i] * t[i];
      sty += t[i] * points[i][1];
    }
  const double slope = (50. * sty - st * sy) / (50. * stt - st * st);
  const double start = (sy - slope * st) / 50.;
  FitOptions   options;
  options.bending     = 1e6;
  const SplineFit fit = fit_least_squares(
    KnotVector(3, {0., 0.25, 0.5, 0.75, 1.}), points, t, options);
  for (const double s : {0., 0.3, 0.77, 1.})
    EXPECT_NEAR(fit.curve.value(s)[1], start + slope * s, 1e-6);
}



TEST(SplineFit, data_that_do_not_determine_the_curve_are_refused)
{
  const KnotVector      knots(3, {0., 0.1, 0.2, 0.3, 0.4, 1.});
  std::vector<Point<2>> points;
  std::vector<double>   t;
  for (unsigned int i = 0; i < 40; ++i)
    {
      t.push_back(0.5 + i / 80.);
      points.emplace_back(t.back(), 1.);
    }
  EXPECT_THROW(fit_least_squares(knots, points, t), InputError);
  FitOptions options;
  options.bending = 1e-6;
  EXPECT_NEAR(fit_least_squares(knots, points, t, options).curve.value(0.05)[1],
              1.,
              1e-6);
  EXPECT_THROW(interpolate(knots,
                           {points.begin(), points.begin() + 8},
                           {t.begin(), t.begin() + 8}),
               InputError);
  EXPECT_THROW(fit_periodic_graph({0., 1.}, {0.}, 2., 5, 3), InputError);
  EXPECT_THROW(fit_periodic_graph({0., 1.}, {0., 1.}, -2., 5, 3), InputError);
}
