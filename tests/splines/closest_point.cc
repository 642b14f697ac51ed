#include <asperity/base/errors.h>
#include <asperity/splines/closest_point.h>
#include <asperity/splines/spline_fit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "brute_force.h"

using namespace asperity;
using dealii::Point;
using dealii::Tensor;

namespace
{
  struct Counts
  {
    unsigned int queries = 0, wrong = 0, inconsistent = 0, uncertified = 0,
                 worse_with_guess = 0, unconverged = 0;
  };



  /** A projection must describe a point of the curve, with the distance of it,
   *  and a unit normal along which the point lies. */
  bool
  is_consistent(const SplineCurve &curve,
                const Point<2>    &point,
                const Projection  &projection,
                const double       scale)
  {
    const double tolerance =
      1e-11 * (scale + std::abs(point[0]) + std::abs(projection.distance));
    return (curve.value(projection.parameter) - projection.point).norm() <
             tolerance &&
           std::abs(projection.point.distance(point) -
                    std::abs(projection.distance)) < tolerance &&
           // At points on the evolute the parameter is defined to the cube root
           // of round-off only.
           (projection.point + projection.distance * projection.normal - point)
               .norm() < 1e-7 * scale + 1e-6 * std::abs(projection.distance) &&
           std::abs(projection.normal.norm() - 1.) < 1e-12;
  }



  Counts
  compare(const SplineCurve           &curve,
          const std::vector<Point<2>> &points,
          const unsigned int           samples_per_span = 16)
  {
    const ClosestPoint search(curve, CurveSide::right);
    BruteForce         brute(curve, samples_per_span);
    const double       scale =
      curve.length(curve.knot_vector().front(), curve.knot_vector().back()) /
      curve.knot_vector().n_spans();
    Counts counts;
    double guess = curve.knot_vector().front();
    for (const Point<2> &point : points)
      {
        const double     exact  = brute.distance(point);
        const Projection global = search.project(point);
        const Projection warm   = search.project(point, guess);
        guess                   = global.parameter;
        const double tolerance  = 1e-11 * (scale + exact + std::abs(point[0]));

        ++counts.queries;
        counts.wrong += !(std::abs(global.distance) < exact + tolerance);
        counts.worse_with_guess +=
          !(std::abs(warm.distance) < exact + tolerance);
        counts.uncertified += !global.certified || !warm.certified;
        counts.inconsistent += !is_consistent(curve, point, global, scale) ||
                               !is_consistent(curve, point, warm, scale);
        counts.unconverged += (global.method == Projection::Method::none) +
                              (warm.method == Projection::Method::none);
      }
    return counts;
  }



  void
  expect_all_right(const Counts &counts)
  {
    EXPECT_EQ(counts.wrong, 0u) << "of " << counts.queries;
    EXPECT_EQ(counts.worse_with_guess, 0u);
    EXPECT_EQ(counts.uncertified, 0u);
    EXPECT_EQ(counts.unconverged, 0u);
    EXPECT_EQ(counts.inconsistent, 0u);
  }



  // Unoptimized code with sanitizers is slow: a sample suffices there.
#ifdef DEBUG
  constexpr unsigned int thinning = 20;
#else
  constexpr unsigned int thinning = 1;
#endif



  std::vector<Point<2>>
  random_points(const unsigned int n,
                const Point<2>    &low,
                const Point<2>    &high,
                const unsigned int seed = 1)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> uniform(0., 1.);
    std::vector<Point<2>>                  points;
    for (unsigned int i = 0; i < n / thinning; ++i)
      {
        const double x = uniform(generator), y = uniform(generator);
        points.emplace_back(low[0] + x * (high[0] - low[0]),
                            low[1] + y * (high[1] - low[1]));
      }
    return points;
  }



  /** The rough tool profile of six harmonics, in micrometres. */
  SplineCurve
  rough_profile(const unsigned int n_spans, const unsigned int degree)
  {
    const auto height = [](const double x) {
      const double a[]   = {0.16, 0.12, 0.09, 0.06, 0.04, 0.02};
      const double phi[] = {0.3, 1.9, 4.1, 5.2, 0.9, 2.6};
      double       sum   = 0.;
      for (unsigned int k = 0; k < 6; ++k)
        sum += a[k] * std::cos(2. * M_PI * (k + 1) * x / 10. + phi[k]);
      return sum;
    };
    return interpolate_periodic_function(height, 0., 10., n_spans, degree);
  }



  SplineCurve
  sine(const unsigned int n_spans,
       const double       amplitude,
       const unsigned int degree)
  {
    return interpolate_periodic_function(
      [amplitude](const double x) { return amplitude * std::cos(x); },
      0.,
      2. * M_PI,
      n_spans,
      degree);
  }



  /** Open, cubic, with knots doubled (C1), tripled (corner) and simple. */
  SplineCurve
  kinked_curve()
  {
    const KnotVector knots = KnotVector::from_knots(
      3, {0, 0, 0, 0, 1, 1, 2, 2, 2, 3, 4, 4, 4, 5, 6, 6, 6, 6});
    return SplineCurve(knots,
                       {{0., 0.},
                        {0.5, 0.4},
                        {1., 0.5},
                        {1.5, 0.6},
                        {1.8, 1.2},
                        {2., 0.3},
                        {2.3, -0.4},
                        {2.8, -0.5},
                        {3.2, -0.4},
                        {3.5, 0.8},
                        {3.7, 0.2},
                        {4.4, 0.3},
                        {4.9, -0.6},
                        {5.3, -0.1}});
  }
} // namespace



TEST(ClosestPoint, random_points_around_a_rough_profile)
{
  for (const unsigned int degree : {2u, 3u, 4u})
    {
      const Counts counts =
        compare(rough_profile(80, degree),
                random_points(60000, {0., -2.}, {10., 2.}, degree),
                8);
      expect_all_right(counts);
    }
}



TEST(ClosestPoint, points_close_to_the_surface)
{
  const SplineCurve     curve = rough_profile(160, 3);
  std::vector<Point<2>> points =
    random_points(100000, {0., -0.05}, {10., 0.05});
  for (Point<2> &point : points)
    point[1] += curve.value(point[0])[1];
  expect_all_right(compare(curve, points, 6));
}



// On the line of symmetry of a valley two points are closest, or one, or, at
// the centre of curvature, the minimum is flat to fourth order.
TEST(ClosestPoint, valley_centre)
{
  for (const unsigned int degree : {2u, 3u, 5u})
    {
      const SplineCurve     curve = sine(24, 1., degree);
      std::vector<Point<2>> points;
      for (unsigned int i = 0; i < 50000; i += thinning)
        {
          const double eps = (i % 5) * 1e-9 * std::cos(i);
          points.emplace_back(M_PI + eps, -1.2 + 6. * i / 50000.);
        }
      expect_all_right(compare(curve, points));
    }
}



TEST(ClosestPoint, points_on_and_beside_the_evolute)
{
  for (const unsigned int degree : {3u, 4u})
    {
      const SplineCurve     curve = rough_profile(60, degree);
      std::vector<Point<2>> points;
      for (unsigned int i = 0; i < 100000; i += thinning)
        {
          const auto   C     = curve.derivatives(10. * i / 100000., 2);
          const double speed = C[1].norm();
          const double cross = C[1][0] * C[2][1] - C[1][1] * C[2][0];
          const double radius =
            std::max(-50., std::min(50., speed * speed * speed / cross)) *
            (1. + (i % 3 - 1.) * std::pow(10., -2. - i % 11));
          points.emplace_back(C[0][0] - radius * C[1][1] / speed,
                              C[0][1] + radius * C[1][0] / speed);
        }
      expect_all_right(compare(curve, points, 8));
    }
}



TEST(ClosestPoint, sharp_asperity)
{
  // A peak a hundred times narrower than the period, three spans wide.
  const auto peak = [](const double x) {
    return -std::exp(-std::pow((x - 5.) / 0.05, 2));
  };
  const SplineCurve curve =
    interpolate_periodic_function(peak, 0., 10., 300, 3);
  auto       points = random_points(40000, {4.5, -1.5}, {5.5, 0.3});
  const auto tip    = random_points(40000, {4.95, -1.1}, {5.05, -0.8}, 2);
  points.insert(points.end(), tip.begin(), tip.end());
  expect_all_right(compare(curve, points, 6));
}



TEST(ClosestPoint, kinks_and_ends_of_an_open_curve)
{
  const SplineCurve curve  = kinked_curve();
  auto              points = random_points(120000, {-2., -2.}, {7., 2.});
  for (const double t : {0., 1., 2., 4., 6.})
    for (const Point<2> &offset : random_points(8000, {-0.1, -0.1}, {0.1, 0.1}))
      points.push_back(curve.value(t) + offset);
  const Counts counts = compare(curve, points, 64);
  expect_all_right(counts);

  const ClosestPoint search(curve, CurveSide::left);
  const Projection   end = search.project(Point<2>(-3., -1.));
  EXPECT_EQ(end.place, Projection::Place::end);
  EXPECT_EQ(end.parameter, 0.);
  EXPECT_NEAR(std::abs(end.distance), std::hypot(3., 1.), 1e-14);
  EXPECT_EQ(search.project(Point<2>(2., 3.)).place, Projection::Place::smooth);
}



TEST(ClosestPoint, any_number_of_turns_away)
{
  const SplineCurve curve = rough_profile(80, 3);
  expect_all_right(
    compare(curve, random_points(40000, {-1000., -1.}, {1000., 1.}), 8));
  expect_all_right(
    compare(curve, random_points(20000, {-0.5, -1.}, {0.5, 1.}), 8));
  expect_all_right(
    compare(curve, random_points(2000, {-30., -80.}, {30., 80.}), 8));
}



TEST(ClosestPoint, flat_stretches)
{
  // Straight segments, then a bump: the second derivative vanishes on spans.
  std::vector<double> heights(40, 0.);
  heights[20] = 1.;
  heights[21] = 1.;
  std::vector<double> breakpoints;
  for (unsigned int i = 0; i <= 40; ++i)
    breakpoints.push_back(0.25 * i);
  for (const unsigned int degree : {1u, 2u, 3u})
    {
      const SplineCurve curve =
        SplineCurve::graph(KnotVector(degree, breakpoints, true), heights);
      expect_all_right(
        compare(curve, random_points(40000, {-1., -1.}, {11., 2.}), 8));
      const Projection flat =
        ClosestPoint(curve).project(Point<2>(0.8, -0.25), 0.3);
      EXPECT_NEAR(flat.parameter, 0.8, 1e-14);
      EXPECT_NEAR(flat.distance, 0.25, 1e-15);
      EXPECT_NEAR(flat.curvature, 0., 1e-13);
    }
}



TEST(ClosestPoint, nurbs_circle_from_everywhere)
{
  const double          w = std::sqrt(0.5);
  std::vector<Point<2>> control;
  std::vector<double>   weights;
  const double          x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1};
  const double          y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
  for (unsigned int i = 0; i < 9; ++i)
    {
      control.emplace_back(2. * x[i], 2. * y[i]);
      weights.push_back(i % 2 ? w : 1.);
    }
  const SplineCurve circle(
    KnotVector::from_knots(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}),
    control,
    weights);
  const ClosestPoint search(circle, CurveSide::left);
  unsigned int       wrong = 0;
  for (const Point<2> &point : random_points(100000, {-5., -5.}, {5., 5.}))
    {
      const double     exact      = 2. - point.norm(); // inside is left
      const Projection projection = search.project(point);
      const Projection warm       = search.project(point, 3.99);
      wrong += !(std::abs(projection.distance - exact) < 1e-12) ||
               !(std::abs(warm.distance - exact) < 1e-12) ||
               !projection.certified ||
               !(std::abs(projection.curvature - 0.5) < 1e-10) ||
               !((projection.normal + point / point.norm()).norm() < 1e-7) ||
               projection.place != Projection::Place::smooth;
    }
  EXPECT_EQ(wrong, 0u);
  const Projection centre = search.project(Point<2>(0., 0.));
  EXPECT_TRUE(centre.certified);
  EXPECT_NEAR(centre.distance, 2., 1e-14);
}
