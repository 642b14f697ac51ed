#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learned_shapes/base_shapes.h>
#include <asperity/learned_shapes/boundary_mesh.h>
#include <asperity/learned_shapes/spline_shape.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../files.h"
#include "exact_distances.h"

using namespace asperity;
using dealii::Point;

namespace
{
  template <int dim>
  Point<dim>
  random_point(RandomNumbers &random, const double half_box = 2.)
  {
    Point<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = half_box * (2. * random.uniform() - 1.);
    return result;
  }

  /** A square with a square hole around the middle. */
  BoundaryMesh<2>
  frame()
  {
    return BoundaryMesh<2>({{-2., -2.},
                            {2., -2.},
                            {2., 2.},
                            {-2., 2.},
                            {-1., -1.},
                            {-1., 1.},
                            {1., 1.},
                            {1., -1.}},
                           {{{0, 1}},
                            {{1, 2}},
                            {{2, 3}},
                            {{3, 0}},
                            {{4, 5}},
                            {{5, 6}},
                            {{6, 7}},
                            {{7, 4}}});
  }
} // namespace



TEST(BoundaryMesh, of_a_square_has_its_exact_distances)
{
  const auto    square = make_shape<2>({BaseShape::square, {}, ""}, 12, false);
  const double  half   = std::sqrt(0.5); // corners lie on the unit circle
  RandomNumbers random(1);
  for (unsigned int i = 0; i < 2000; ++i)
    {
      const auto p = random_point<2>(random);
      ASSERT_NEAR(square.signed_distance(p),
                  distance_to_box(p, {half, half}),
                  1e-14);
    }
  EXPECT_NEAR(square.measure(), 2., 1e-14);
  EXPECT_NEAR(square.surface_measure(), 8. * half, 1e-14);
  EXPECT_TRUE(square.is_closed());
  EXPECT_EQ(square.euler_number(), 1);
}



TEST(BoundaryMesh, of_a_prism_has_its_exact_distances)
{
  const auto    prism = make_shape<3>({BaseShape::square, {}, ""}, 8, false);
  const double  half  = std::sqrt(0.5);
  RandomNumbers random(2);
  for (unsigned int i = 0; i < 2000; ++i)
    {
      const auto p = random_point<3>(random);
      ASSERT_NEAR(prism.signed_distance(p),
                  distance_to_box(p, {half, half, 1.}),
                  1e-14)
        << p;
    }
  EXPECT_NEAR(prism.measure(), 4., 1e-13);
  EXPECT_NEAR(prism.surface_measure(), 2. * 2. + 4. * 2. * 2. * half, 1e-13);
  EXPECT_TRUE(prism.is_closed());
  EXPECT_EQ(prism.euler_number(), 1);
}



TEST(BoundaryMesh, has_the_right_sign_beside_the_point_of_a_star)
{
  // corners that reach in and out, where the sign of a face would be wrong
  std::vector<Point<2>> points;
  for (unsigned int i = 0; i < 10; ++i)
    {
      const double r = i % 2 == 0 ? 1. : 0.3, angle = 0.2 * M_PI * i;
      points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
  const auto    star = polygon(points);
  RandomNumbers random(3);
  for (unsigned int i = 0; i < 2000; ++i)
    {
      const auto p      = random_point<2>(random, 1.2);
      bool       inside = false; // crossings of a ray
      for (unsigned int a = 9, b = 0; b < 10; a = b++)
        if ((points[a][1] > p[1]) != (points[b][1] > p[1]) &&
            p[0] < points[a][0] + (p[1] - points[a][1]) /
                                    (points[b][1] - points[a][1]) *
                                    (points[b][0] - points[a][0]))
          inside = !inside;
      ASSERT_EQ(star.signed_distance(p) < 0., inside) << p;
    }
}



TEST(BoundaryMesh, counts_holes)
{
  EXPECT_EQ(frame().euler_number(), 0);
  EXPECT_NEAR(frame().measure(), 16. - 4., 1e-14);
  EXPECT_NEAR(frame().signed_distance(Point<2>(0.2, 0.)), 0.8, 1e-14);
  EXPECT_NEAR(frame().signed_distance(Point<2>(1.3, 0.)), -0.3, 1e-14);
}



TEST(BoundaryMesh, tells_that_it_is_open)
{
  const BoundaryMesh<2> open({{0., 0.}, {1., 0.}, {0., 1.}},
                             {{{0, 1}}, {{1, 2}}});
  EXPECT_FALSE(open.is_closed());
  const BoundaryMesh<2> turned({{0., 0.}, {1., 0.}, {0., 1.}},
                               {{{0, 1}}, {{1, 2}}, {{0, 2}}});
  EXPECT_FALSE(turned.is_closed());
}



TEST(BoundaryMesh, has_surface_points_everywhere_alike)
{
  const auto    prism = make_shape<3>({BaseShape::square, {}, ""}, 8, false);
  RandomNumbers random(4);
  const unsigned int n      = 20000;
  unsigned int       on_top = 0;
  for (unsigned int i = 0; i < n; ++i)
    {
      const auto p = prism.surface_point(random);
      ASSERT_NEAR(prism.signed_distance(p), 0., 1e-14);
      on_top += p[2] > 1. - 1e-12 && p[0] > 0.;
    }
  // half of the top has the area 1; five standard deviations
  const double share = 1. / prism.surface_measure();
  EXPECT_NEAR(on_top, n * share, 5. * std::sqrt(n * share * (1. - share)));
}



TEST(BoundaryMesh, refuses_what_is_no_surface)
{
  EXPECT_EQ(message_of<InputError>([]() { BoundaryMesh<2> mesh({}, {}); }),
            "A shape has no surface.");
  EXPECT_EQ(message_of<InputError>([]() {
              BoundaryMesh<2> mesh({{0., 0.}}, {{{0, 1}}});
            }),
            "The surface of a shape has no vertex 1.");
}



TEST(SplineShape, of_a_circle_is_exact)
{
  const Point<2>     centre(0.3, -0.2);
  const SplineShape  disc(circle(centre, 0.8));
  RandomNumbers      random(5);
  const unsigned int n      = 4000;
  unsigned int       higher = 0;
  for (unsigned int i = 0; i < n; ++i)
    {
      const auto p = random_point<2>(random);
      ASSERT_NEAR(disc.signed_distance(p), p.distance(centre) - 0.8, 1e-12);
      const auto s = disc.surface_point(random);
      ASSERT_NEAR(s.distance(centre), 0.8, 1e-14);
      // a sixth of the circle lies above this height
      higher += s[1] > centre[1] + 0.8 * std::sqrt(0.75);
    }
  EXPECT_NEAR(higher, n / 6., 5. * std::sqrt(n * 5. / 36.));
}



TEST(SplineShape, has_its_inside_inside_whichever_way_it_runs)
{
  const SplineCurve     curve = circle({}, 1.);
  std::vector<Point<2>> reversed(curve.control_points().rbegin(),
                                 curve.control_points().rend());
  const SplineShape     disc(
    SplineCurve(curve.knot_vector(), reversed, curve.weights()));
  EXPECT_NEAR(disc.signed_distance(Point<2>(0.5, 0.)), -0.5, 1e-14);
}



TEST(SplineShape, refuses_an_open_curve)
{
  const auto refuse = []() {
    SplineShape shape(
      SplineCurve(KnotVector(1, {0., 1., 2.}), {{0., 0.}, {1., 0.}, {1., 1.}}));
  };
  EXPECT_EQ(message_of<InputError>(refuse),
            "The curve around a shape is not closed.");
}
