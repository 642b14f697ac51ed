#include <asperity/base/errors.h>
#include <asperity/splines/closest_point.h>
#include <asperity/splines/closest_point_on_sheet.h>
#include <asperity/splines/sheet_fit.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "sheet_test_tools.h"

using namespace asperity;
using namespace asperity_test;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** Random coefficients, as high as its largest slope asks for. */
  SplineSheet
  rough_sheet(const unsigned int  degree_x,
              const unsigned int  degree_y,
              const double        slope,
              const unsigned long seed)
  {
    const SplineSheet sheet({{uneven_knots(degree_x, 9, -0.3, seed + 1),
                              uneven_knots(degree_y, 7, 2., seed + 2)}},
                            random_numbers(63, seed));
    return sheet.mapped(slope / sheet.largest_slope(), 0.);
  }

  std::vector<Point<3>>
  random_points(const SplineSheet &sheet,
                const unsigned int n,
                const double       reach)
  {
    std::mt19937                           generator(5);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    std::vector<Point<3>>                  points;
    for (unsigned int i = 0; i < n; ++i)
      {
        const Point<2> place(sheet.period(0) * uniform(generator),
                             sheet.period(1) * uniform(generator));
        points.emplace_back(place[0],
                            place[1],
                            sheet.value(place) + reach * uniform(generator));
      }
    return points;
  }

  /** The independent answer: the nearest of many samples, then a compass search
   *  around every sample that is nearer than its neighbours. */
  class BruteForce
  {
  public:
    explicit BruteForce(const SplineSheet &sheet)
      : sheet(sheet)
      , n{{20 * sheet.knot_vector(0).n_spans(),
           20 * sheet.knot_vector(1).n_spans()}}
    {
      for (unsigned int d = 0; d < 2; ++d)
        h[d] = sheet.period(d) / n[d];
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int i = 0; i < n[0]; ++i)
          heights.push_back(sheet.value(Point<2>(i * h[0], j * h[1])));
    }

    double
    distance(const Point<3> &point) const
    {
      std::vector<double> squares(heights.size());
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int i = 0; i < n[0]; ++i)
          squares[j * n[0] + i] = std::pow(offset(0, i, point), 2) +
                                  std::pow(offset(1, j, point), 2) +
                                  std::pow(heights[j * n[0] + i] - point[2], 2);
      double best = 1e300;
      for (unsigned int j = 0; j < n[1]; ++j)
        for (unsigned int i = 0; i < n[0]; ++i)
          {
            const double here     = squares[j * n[0] + i];
            bool         is_least = true;
            for (const int dj : {-1, 0, 1})
              for (const int di : {-1, 0, 1})
                is_least =
                  is_least && here <= squares[(j + n[1] + dj) % n[1] * n[0] +
                                              (i + n[0] + di) % n[0]];
            if (is_least)
              best = std::min(best,
                              refined(point,
                                      point[0] + offset(0, i, point),
                                      point[1] + offset(1, j, point)));
          }
      return std::sqrt(best);
    }

  private:
    /** The nearest image of sample i along a direction. */
    double
    offset(const unsigned int d, const unsigned int i, const Point<3> &p) const
    {
      const double way = i * h[d] - p[d], period = sheet.period(d);
      return way - period * std::round(way / period);
    }

    double
    refined(const Point<3> &point, double x, double y) const
    {
      const auto at = [&](const double u, const double v) {
        const double z = sheet.value(Point<2>(u, v)) - point[2];
        return (u - point[0]) * (u - point[0]) +
               (v - point[1]) * (v - point[1]) + z * z;
      };
      double best = at(x, y);
      for (double step = h[0]; step > 1e-7;)
        {
          bool moved = false;
          for (const auto &way : {std::make_pair(1., 0.),
                                  std::make_pair(-1., 0.),
                                  std::make_pair(0., 1.),
                                  std::make_pair(0., -1.)})
            {
              const double u = x + step * way.first, v = y + step * way.second;
              const double there = at(u, v);
              if (there < best)
                {
                  best = there, x = u, y = v, moved = true;
                  break;
                }
            }
          if (!moved)
            step /= 2.;
        }
      return best;
    }

    const SplineSheet          &sheet;
    std::array<unsigned int, 2> n;
    double                      h[2];
    std::vector<double>         heights;
  };
} // namespace

TEST(ClosestPointOnSheet, is_as_near_as_the_nearest_of_all_samples)
{
  for (const unsigned int degree : {2u, 3u, 5u})
    {
      const SplineSheet sheet =
        rough_sheet(degree, degree == 5 ? 4 : degree, std::sqrt(3.), degree);
      const ClosestPointOnSheet closest(sheet);
      const BruteForce          brute_force(sheet);
      for (const Point<3> &point : random_points(sheet, 60, 2.5))
        {
          const auto found = closest.project(point);
          EXPECT_TRUE(found.converged);
          EXPECT_TRUE(found.certified);
          EXPECT_NEAR(std::abs(found.distance),
                      brute_force.distance(point),
                      1e-11);
          EXPECT_NEAR(found.point.distance(point),
                      std::abs(found.distance),
                      1e-13);
          EXPECT_NEAR(found.point[2], sheet.value(found.parameters), 1e-13);
          // positive below
          EXPECT_EQ(found.distance > 0.,
                    point[2] < sheet.value(Point<2>(point[0], point[1])));
        }
    }
}

TEST(ClosestPointOnSheet, is_that_of_the_curve_it_is_extruded_from)
{
  const SplineCurve curve =
    SplineCurve::graph(uneven_knots(3, 12, 0., 7), random_numbers(12));
  const ClosestPoint        on_curve(curve);
  const SplineSheet         sheet = extrude(curve, 4., 5);
  const ClosestPointOnSheet on_sheet(sheet);
  for (const Point<3> &point : random_points(sheet, 200, 2.))
    {
      const auto two   = on_curve.project(Point<2>(point[0], point[2]));
      const auto three = on_sheet.project(point);
      ASSERT_TRUE(two.certified && three.certified);
      EXPECT_NEAR(three.distance, two.distance, 1e-12);
      EXPECT_NEAR(three.normal[0], two.normal[0], 1e-12);
      EXPECT_NEAR(three.normal[1], 0., 1e-12);
      EXPECT_NEAR(three.normal[2], two.normal[1], 1e-12);
      EXPECT_NEAR(three.parameters[0], two.parameter, 1e-11);
      EXPECT_NEAR(three.parameters[1], point[1], 1e-12);
      const double bend  = -two.curvature / (1. - two.curvature * two.distance);
      const double scale = 1e-10 * (1. + bend * bend);
      EXPECT_NEAR(three.normal_gradient()[0][0],
                  bend * two.tangent[0] * two.tangent[0],
                  scale);
      EXPECT_NEAR(three.normal_gradient()[0][2],
                  bend * two.tangent[0] * two.tangent[1],
                  scale);
      EXPECT_NEAR(three.normal_gradient()[2][2],
                  bend * two.tangent[1] * two.tangent[1],
                  scale);
    }
}

TEST(ClosestPointOnSheet, repeats_after_the_periods)
{
  const SplineSheet         sheet = rough_sheet(3, 2, 1., 8);
  const ClosestPointOnSheet closest(sheet);
  for (const Point<3> &point : random_points(sheet, 40, 1.5))
    {
      const Tensor<1, 3> turn =
        Point<3>(3. * sheet.period(0), -2. * sheet.period(1), 0.);
      const auto here = closest.project(point);
      const auto there =
        closest.project(point + turn, Point<2>(here.parameters));
      EXPECT_TRUE(there.certified);
      EXPECT_NEAR(there.distance, here.distance, 1e-12);
      EXPECT_NEAR((there.point - here.point - turn).norm(), 0., 1e-7);
    }
}

TEST(ClosestPointOnSheet, does_not_depend_on_the_guess)
{
  const SplineSheet         sheet = rough_sheet(3, 3, std::sqrt(3.), 9);
  const ClosestPointOnSheet closest(sheet);
  for (const Point<3> &point : random_points(sheet, 40, 2.5))
    {
      const auto without = closest.project(point);
      for (const double way : {1e-3, 0.4, 3.7, 21.})
        {
          const auto with =
            closest.project(point,
                            Point<2>(without.parameters[0] - way,
                                     without.parameters[1] + 0.7 * way));
          EXPECT_TRUE(with.certified);
          EXPECT_NEAR(with.distance, without.distance, 1e-12);
        }
    }
}

TEST(ClosestPointOnSheet, is_proved_from_far_away)
{
  const SplineSheet         sheet = rough_sheet(3, 3, 1., 10);
  const ClosestPointOnSheet closest(sheet);
  const double              highest = sheet.maximum();
  for (const double z : {20., 100.})
    {
      const auto found = closest.project(Point<3>(1., 2., z));
      EXPECT_TRUE(found.certified);
      EXPECT_LT(found.distance, highest - z + 1.);
      EXPECT_GE(-found.distance, z - highest - 1e-8);
    }
  EXPECT_FALSE(closest.project(Point<3>(0., 0., NAN)).certified);
  EXPECT_FALSE(closest.project(Point<3>(0., 0., 1e9)).certified);
}

TEST(ClosestPointOnSheet, has_a_normal_that_is_the_gradient_of_the_distance)
{
  for (const unsigned int degree : {3u, 4u})
    {
      const SplineSheet         sheet = rough_sheet(degree, degree, 1.7, 11);
      const ClosestPointOnSheet closest(sheet);
      const double              h = 1e-5;
      unsigned int              n = 0;
      for (const Point<3> &point : random_points(sheet, 60, 0.4))
        {
          const auto here = closest.project(point);
          // Not where closest points are about to split.
          if (here.normal_gradient().norm() > 10.)
            continue;
          ++n;
          EXPECT_NEAR(here.normal.norm(), 1., 1e-14);
          EXPECT_NEAR((here.normal_gradient() * here.normal).norm(), 0., 1e-12);
          for (unsigned int d = 0; d < 3; ++d)
            {
              Tensor<1, 3> step;
              step[d]           = h;
              const auto after  = closest.project(point + step);
              const auto before = closest.project(point - step);
              EXPECT_NEAR(here.normal[d],
                          (after.distance - before.distance) / (2. * h),
                          1e-7);
              for (unsigned int e = 0; e < 3; ++e)
                EXPECT_NEAR(here.normal_gradient()[e][d],
                            (after.normal[e] - before.normal[e]) / (2. * h),
                            2e-3);
            }
        }
      EXPECT_GT(n, 40u);
    }
}

TEST(ClosestPointOnSheet, has_the_other_sign_above)
{
  const SplineSheet         sheet = rough_sheet(3, 3, 1., 12);
  const ClosestPointOnSheet below(sheet), above(sheet, SheetSide::above);
  for (const Point<3> &point : random_points(sheet, 10, 1.))
    {
      const auto a = above.project(point), b = below.project(point);
      EXPECT_EQ(a.distance, -b.distance);
      EXPECT_EQ((a.normal + b.normal).norm(), 0.);
      EXPECT_NEAR((a.normal_gradient() + b.normal_gradient()).norm(),
                  0.,
                  1e-13);
    }
}

TEST(ClosestPointOnSheet, keeps_to_a_plane_and_to_points_of_the_sheet)
{
  const KnotVector  knots = KnotVector::uniform_periodic(3, 8, 0., 2e-6);
  const SplineSheet plane({{knots, knots}}, std::vector<double>(64, 1e-6));
  const ClosestPointOnSheet closest(plane);
  const auto found = closest.project(Point<3>(0.3e-6, 5.1e-6, 0.4e-6));
  EXPECT_TRUE(found.certified);
  EXPECT_NEAR(found.distance, 0.6e-6, 1e-20);
  EXPECT_NEAR(found.normal[2], -1., 1e-14);
  EXPECT_NEAR(found.normal_gradient().norm(), 0., 1e-6);

  const SplineSheet         rough = rough_sheet(3, 3, 1.7, 13);
  const ClosestPointOnSheet on_rough(rough);
  for (const Point<3> &point : random_points(rough, 20, 0.))
    {
      const auto itself = on_rough.project(point);
      EXPECT_TRUE(itself.certified);
      EXPECT_NEAR(itself.distance, 0., 1e-14);
    }
}

TEST(ClosestPointOnSheet, chooses_between_equally_close_points)
{
  // Over the middle of a hill, and of a ridge, two or four places are closest.
  const auto hills = [](const double x, const double y) {
    return 0.2 * std::cos(2. * M_PI * x) * std::cos(2. * M_PI * y);
  };
  const SplineSheet sheet =
    interpolate_periodic_sheet(sampled(hills, {{16, 16}}, {{1., 1.}}), 3).sheet;
  const ClosestPointOnSheet closest(sheet);
  const BruteForce          brute_force(sheet);
  for (const double z : {-0.6, -0.2, 0., 0.2, 0.25, 0.6})
    for (const double x : {0., 0.25, 0.5})
      {
        const Point<3> point(x, 0.5, z);
        const auto     found = closest.project(point);
        EXPECT_TRUE(found.certified);
        EXPECT_NEAR(std::abs(found.distance),
                    brute_force.distance(point),
                    1e-11);
      }
}

// Nothing is proved of points that no contact asks for, but a foot is there.
TEST(ClosestPointOnSheet, gives_no_proof_beyond_a_thousand_periods)
{
  const auto hills = [](const double x, const double y) {
    return 0.2 * std::cos(2. * M_PI * x) * std::cos(2. * M_PI * y);
  };
  const ClosestPointOnSheet closest(
    interpolate_periodic_sheet(sampled(hills, {{16, 16}}, {{1., 1.}}), 3)
      .sheet);
  for (const double depth : {900., 1100.})
    {
      const auto found = closest.project(Point<3>(0.3, 0.4, -depth));
      EXPECT_EQ(found.certified, depth < 1000.);
      // within the height of the sheet
      EXPECT_NEAR(std::abs(found.distance), depth, 0.21);
    }
}

TEST(ClosestPointOnSheet, refuses_edges_and_high_degrees)
{
  for (const unsigned int degree : {1u, 8u})
    {
      const KnotVector knots = KnotVector::uniform_periodic(degree, 10, 0., 1.);
      const SplineSheet sheet({{knots, knots}}, std::vector<double>(100));
      EXPECT_THROW(ClosestPointOnSheet{sheet}, InputError);
    }
}
