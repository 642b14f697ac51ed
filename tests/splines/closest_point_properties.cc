#include <asperity/base/errors.h>
#include <asperity/splines/closest_point.h>
#include <asperity/splines/distance_minimizer.h>
#include <asperity/splines/spline_fit.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace asperity;
using dealii::Point;
using dealii::Tensor;

namespace
{
  SplineCurve
  wavy(const unsigned int degree = 3)
  {
    return interpolate_periodic_function(
      [](const double x) { return 0.5 * std::sin(x) + 0.1 * std::cos(3. * x); },
      0.,
      2. * M_PI,
      40,
      degree);
  }

  /** The local search alone, without seeds and certificate. */
  Projection
  local_minimum(const CurvePieces &pieces,
                const Point<2>    &point,
                const double       guess)
  {
    const DistanceMinimizer minimizer(pieces, point[0], point[1]);
    return minimizer.describe(minimizer.minimize(pieces.locate(guess)),
                              CurveSide::right);
  }
} // namespace



TEST(ClosestPoint, distance_is_positive_on_the_free_side)
{
  const SplineCurve  curve = wavy();
  const ClosestPoint tool(curve, CurveSide::right),
    chip(curve, CurveSide::left);
  for (double x = -20.; x < 20.; x += 0.173)
    {
      const Point<2> foot = curve.value(x);
      for (const double offset : {-0.05, 0.05})
        {
          const Point<2>   point = foot + Point<2>(0., offset);
          const Projection below = tool.project(point, x);
          const Projection above = chip.project(point, x);
          EXPECT_EQ(below.distance > 0., offset < 0.);
          EXPECT_DOUBLE_EQ(below.distance, -above.distance);
          EXPECT_NEAR((below.normal + above.normal).norm(), 0., 1e-15);
          EXPECT_LT(below.normal[1], 0.);
          EXPECT_GT(below.tangent[0], 0.);
          EXPECT_DOUBLE_EQ(below.curvature, -above.curvature);
        }
    }
}



// d(distance)/dP = n and dn/dP = -curvature/(1 - curvature distance) t t^T.
TEST(DistanceMinimizer, normal_and_curvature_are_derivatives_of_the_distance)
{
  const CurvePieces pieces(wavy(5));
  const double      h = 1e-6;
  for (double x = 0.05; x < 6.; x += 0.31)
    for (const double y : {-0.9, 0.05, 0.7})
      {
        const Point<2>   point(x, y);
        const Projection middle = local_minimum(pieces, point, x);
        const double     rate =
          -middle.curvature / (1. - middle.curvature * middle.distance);
        if (std::abs(rate) > 20.)
          continue; // beside the evolute finite differences fail
        for (unsigned int d = 0; d < 2; ++d)
          {
            Point<2> left = point, right = point;
            left[d] -= h;
            right[d] += h;
            const Projection a = local_minimum(pieces, left, middle.parameter);
            const Projection b = local_minimum(pieces, right, middle.parameter);
            EXPECT_NEAR((b.distance - a.distance) / (2. * h),
                        middle.normal[d],
                        1e-8);
            EXPECT_LT(((b.normal - a.normal) / (2. * h) -
                       rate * middle.tangent[d] * middle.tangent)
                        .norm(),
                      1e-6);
          }
      }
}



TEST(DistanceMinimizer, follows_a_moving_point)
{
  const SplineCurve  curve = wavy();
  const CurvePieces  pieces(curve);
  const ClosestPoint search(curve, CurveSide::right);
  double             guess = 0.;
  for (double x = 0.; x < 30.; x += 0.02)
    {
      const Point<2>   point(x, curve.value(x)[1] - 0.03);
      const Projection local  = local_minimum(pieces, point, guess);
      const Projection global = search.project(point);
      EXPECT_TRUE(local.converged);
      EXPECT_FALSE(local.certified);
      EXPECT_EQ(local.method, Projection::Method::newton);
      EXPECT_LE(local.iterations, 6u);
      EXPECT_NEAR(local.parameter, global.parameter, 1e-11);
      guess = local.parameter;
    }
}



// Newton's method fails where the distance is concave; the others must not.
TEST(DistanceMinimizer, fallbacks_find_a_minimum_where_newton_fails)
{
  const SplineCurve curve = wavy();
  const CurvePieces pieces(curve);
  unsigned int      n_sqp = 0;
  for (double x = 0.; x < 2. * M_PI; x += 0.05)
    for (const double guess : {0.3, 1.7, 2.9, 4.4})
      {
        const Point<2>   point(x, -3.);
        const Projection local = local_minimum(pieces, point, guess);
        EXPECT_TRUE(local.converged);
        const auto C = curve.derivatives(local.parameter, 2);
        EXPECT_NEAR((C[0] - point) * C[1], 0., 1e-9);
        EXPECT_GT(C[1] * C[1] + (C[0] - point) * C[2], -1e-9);
        n_sqp += (local.method == Projection::Method::sqp);
      }
  EXPECT_GT(n_sqp, 0u);
}



TEST(ClosestPoint, a_corner_has_a_fan_of_normals)
{
  // An L: along x, then upwards; the outer side of its corner is right.
  const SplineCurve  corner(KnotVector(1, {0., 1., 2.}),
                           {{0., 0.}, {1., 0.}, {1., 1.}});
  const ClosestPoint search(corner, CurveSide::right);
  for (double angle = 0.05; angle < M_PI / 2.; angle += 0.1)
    {
      const Tensor<1, 2> ray     = Point<2>(std::sin(angle), -std::cos(angle));
      const Projection   outside = search.project(Point<2>(1., 0.) + 0.3 * ray);
      EXPECT_EQ(outside.place, Projection::Place::kink);
      EXPECT_NEAR(outside.distance, 0.3, 1e-15);
      EXPECT_NEAR((outside.normal - ray).norm(), 0., 1e-14);
      EXPECT_EQ(outside.parameter, 1.);
    }
  const Projection inside = search.project(Point<2>(0.7, 0.2));
  EXPECT_EQ(inside.place, Projection::Place::smooth);
  EXPECT_NEAR(inside.distance, -0.2, 1e-15);
  const Projection on = search.project(Point<2>(1., 0.));
  EXPECT_EQ(on.distance, 0.);
  EXPECT_NEAR(on.normal[0], std::sqrt(0.5), 1e-15);
}



TEST(ClosestPoint, points_on_the_curve_have_distance_zero)
{
  for (unsigned int degree = 1; degree <= 7; ++degree)
    {
      const SplineCurve  curve = wavy(degree);
      const ClosestPoint search(curve, CurveSide::right);
      for (double x = -9.; x < 9.; x += 0.0371)
        {
          const Projection projection = search.project(curve.value(x));
          // round-off of coordinates up to 9
          EXPECT_NEAR(projection.distance, 0., 1e-13);
          EXPECT_NEAR(projection.parameter, x, 1e-12);
          EXPECT_NEAR(projection.normal.norm(), 1., 1e-14);
        }
    }
}



// SI units: a profile of micrometres must be as accurate as one of metres.
TEST(ClosestPoint, the_unit_of_length_does_not_matter)
{
  const SplineCurve metres = wavy();
  for (const double unit : {1e-6, 1e-9, 1e6})
    {
      std::vector<double> breakpoints, heights;
      for (const double t : metres.knot_vector().breakpoints())
        breakpoints.push_back(unit * t);
      for (const auto &point : metres.control_points())
        heights.push_back(unit * point[1]);
      const SplineCurve curve =
        SplineCurve::graph(KnotVector(3, breakpoints, true), heights);
      const ClosestPoint small(curve), large(metres);
      for (double x = -7.; x < 7.; x += 0.11)
        {
          const Projection a = small.project(Point<2>(unit * x, -unit));
          const Projection b = large.project(Point<2>(x, -1.));
          EXPECT_NEAR(a.distance / unit, b.distance, 1e-13);
          EXPECT_NEAR(a.curvature * unit, b.curvature, 1e-5);
        }
    }
}



TEST(ClosestPoint, a_point_that_is_not_finite_is_not_certified)
{
  const ClosestPoint search(wavy());
  EXPECT_FALSE(search.project(Point<2>(1., NAN), 1.).certified);
  EXPECT_FALSE(search.project(Point<2>(1., NAN), 1.).converged);
  EXPECT_FALSE(
    local_minimum(CurvePieces(wavy()), Point<2>(1., NAN), 1.).converged);
}



TEST(ClosestPoint, too_high_a_degree_is_refused)
{
  const KnotVector knots(11, {0., 1.});
  EXPECT_THROW(ClosestPoint(SplineCurve::graph(knots, knots.greville())),
               InputError);
}
