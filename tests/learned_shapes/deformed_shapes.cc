#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learned_shapes/base_shapes.h>
#include <asperity/learned_shapes/chamfer_distance.h>
#include <asperity/learned_shapes/distance_samples.h>
#include <asperity/learned_shapes/isosurface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "../files.h"
#include "exact_distances.h"

using namespace asperity;
using dealii::Point;

namespace
{
  ShapeDeformation
  only(double ShapeDeformation::*deformation, const double magnitude)
  {
    ShapeDeformation result;
    result.*deformation = magnitude;
    return result;
  }

  /** A square prism whose corners have the coordinates +- sqrt(0.5), +- 1. */
  double
  volume(const ShapeDeformation &deformation)
  {
    return make_shape<3>({BaseShape::square, deformation, ""}, 80, false)
      .measure();
  }

  /** Values of a function of a point. */
  template <int dim, typename Function>
  BatchFunction
  in_batches(const Function &function)
  {
    return [function](const std::vector<double> &x) {
      std::vector<double> result;
      for (std::size_t i = 0; i < x.size(); i += dim)
        {
          Point<dim> p;
          for (unsigned int d = 0; d < dim; ++d)
            p[d] = x[i + d];
          result.push_back(function(p));
        }
      return result;
    };
  }
} // namespace



TEST(FreeFormDeformation, reproduces_every_point_until_it_is_changed)
{
  const FreeFormDeformation<3> identity({-1., 0., 2.},
                                        {1., 3., 4.},
                                        {{KnotVector(1, {0., 1.}),
                                          KnotVector(2, {0., 0.4, 1.}),
                                          KnotVector(3, {0., 0.5, 1.})}});
  RandomNumbers                random(1);
  for (unsigned int i = 0; i < 100; ++i)
    {
      const Point<3> p(2. * random.uniform() - 1.,
                       3. * random.uniform(),
                       2. + 2. * random.uniform());
      ASSERT_LT(identity.value(p).distance(p), 1e-14);
    }
}



TEST(FreeFormDeformation, moves_points_by_its_basis_functions)
{
  // the middle of three control points upwards by 0.4: 2 t (1 - t) of it
  FreeFormDeformation<2> deformation(
    {0., 0.}, {1., 2.}, {{KnotVector(1, {0., 1.}), KnotVector(2, {0., 1.})}});
  for (std::size_t i = 0; i < deformation.control_points().size(); ++i)
    if (deformation.row(i, 1) == 1)
      deformation.control_points()[i][1] += 0.4;
  for (const double t : {0., 0.25, 0.5, 0.9, 1.})
    {
      const Point<2> p = deformation.value(Point<2>(0.3, 2. * t));
      EXPECT_NEAR(p[0], 0.3, 1e-15);
      EXPECT_NEAR(p[1], 2. * t + 0.4 * 2. * t * (1. - t), 1e-15);
    }
}



TEST(ShapeDeformation, changes_volumes_as_integrals_over_the_height_say)
{
  // sections of the area 2 over the height 2, scaled along one or both
  // directions by 1 - s, 1 + 2 t (1 - t) m and 1 + t^2 m; t in [0, 1]
  EXPECT_NEAR(volume({}), 4., 1e-12);
  EXPECT_NEAR(volume(only(&ShapeDeformation::shrink_x, 0.25)), 3., 1e-12);
  EXPECT_NEAR(volume(only(&ShapeDeformation::translate_top_x, 0.5)), 4., 1e-12);
  EXPECT_NEAR(volume(only(&ShapeDeformation::translate_top_y, -0.3)),
              4.,
              1e-12);
  // 1 + 2 m / 3 + 4 m^2 / 30 and 1 + 2 m / 3 + m^2 / 5, but for the flat
  // pieces of the height h = 1/20, which cut off h^2 / 12 of the second
  // derivatives of the width, 4 m and 2 m
  const double m   = 0.3;
  const double cut = 4. * 2. * 4. * m / 12. / 400.;
  EXPECT_NEAR(volume(only(&ShapeDeformation::expand_middle, m)),
              4. * (1. + 2. * m / 3. + 4. * m * m / 30.) - cut,
              0.2 * cut);
  EXPECT_NEAR(volume(only(&ShapeDeformation::expand_top, m)),
              4. * (1. + 2. * m / 3. + m * m / 5.) + 0.5 * cut,
              0.2 * cut);
  // the top turns as a whole, and what is between shrinks on the way
  EXPECT_LT(volume(only(&ShapeDeformation::rotate_top, 0.5)), 3.99);
}



TEST(ShapeDeformation, leaves_shapes_closed_and_of_one_piece)
{
  for (const ShapeRecipe &recipe : shape_recipes(30, 1, 0.4, 7))
    {
      const auto plane = make_shape<2>(recipe, 48);
      EXPECT_TRUE(plane.is_closed()) << recipe.name;
      EXPECT_EQ(plane.euler_number(), 1) << recipe.name;
      EXPECT_GT(plane.measure(), 0.3) << recipe.name;
      const auto space = make_shape<3>(recipe, 24);
      EXPECT_TRUE(space.is_closed()) << recipe.name;
      EXPECT_EQ(space.euler_number(), 1) << recipe.name;
      EXPECT_GT(space.measure(), 0.3) << recipe.name;
      double radius = 0.;
      for (const Point<3> &p : space.vertices())
        radius = std::max(radius, p.norm());
      EXPECT_NEAR(radius, 1. / 1.03, 1e-12);
    }
}



TEST(ShapeRecipes, are_as_many_as_wanted_and_all_different)
{
  const auto            recipes = shape_recipes(40, 2, 0.3, 1);
  std::set<std::string> names;
  for (const ShapeRecipe &recipe : recipes)
    names.insert(recipe.name);
  EXPECT_EQ(recipes.size(), 160u);
  EXPECT_EQ(names.size(), 160u);
  EXPECT_EQ(recipes[0].name, "triangle");
  EXPECT_EQ(names.count("hexagon, rotate top -0.15"), 1u);
}



TEST(DistanceSamples, lie_where_the_rule_says)
{
  const auto       square = make_shape<2>({BaseShape::square, {}, ""}, 4);
  RandomNumbers    random(1);
  DistanceSampling sampling;
  sampling.n_points = 10000;
  const auto sample = sample_distances(square, "square", sampling, random);
  ASSERT_EQ(sample.values.size(), 10000u);
  const double half = std::sqrt(0.5) / 1.03;
  double       near = 0., far = 0.;
  for (unsigned int i = 0; i < 10000; ++i)
    {
      const Point<2> p(sample.positions[2 * i], sample.positions[2 * i + 1]);
      ASSERT_NEAR(sample.values[i], distance_to_box(p, {half, half}), 1e-14);
      if (i < 9000)
        (i % 2 == 0 ? near : far) += std::pow(sample.values[i], 2) / 4500.;
    }
  // but at corners, a distance is one of two deviates
  EXPECT_NEAR(near, 2.5e-4, 0.1 * 2.5e-4);
  EXPECT_NEAR(far, 2.5e-3, 0.1 * 2.5e-3);
}



TEST(Isosurface, of_a_disc_has_its_length_area_and_euler_number)
{
  const auto disc = isosurface<2>(
    in_batches<2>([](const Point<2> &p) { return p.norm() - 0.7; }), 1., 64);
  EXPECT_TRUE(disc.is_closed());
  EXPECT_EQ(disc.euler_number(), 1);
  // of the second order in the width 1/32 of a cell
  EXPECT_NEAR(disc.measure(), M_PI * 0.49, 1e-3);
  EXPECT_NEAR(disc.surface_measure(), 2. * M_PI * 0.7, 2e-3);
}



TEST(Isosurface, passes_through_nodes)
{
  // edges that lie on lines of the grid, corners in its nodes
  const auto box = isosurface<2>(in_batches<2>([](const Point<2> &p) {
                                   return distance_to_box(p, {0.5, 0.25});
                                 }),
                                 1.,
                                 16);
  EXPECT_TRUE(box.is_closed());
  EXPECT_EQ(box.euler_number(), 1);
  // the corners are cut across their cells
  EXPECT_NEAR(box.measure(), 0.5 - 4. * 0.5 / 64., 1e-14);
}



TEST(Isosurface, is_closed_where_opposite_corners_of_a_cell_are_inside)
{
  // two squares that overlap by a tenth of the cell in the middle
  const double h = 2. / 17., o = 0.05 * h;
  const auto   both = isosurface<2>(
    in_batches<2>([o](const Point<2> &p) {
      const double half = 0.35 + 0.5 * o, at = 0.35 - 0.5 * o;
      return std::min(
        distance_to_box(Point<2>(p[0] - at, p[1] - at), {half, half}),
        distance_to_box(Point<2>(p[0] + at, p[1] + at), {half, half}));
    }),
    1.,
    17);
  EXPECT_TRUE(both.is_closed());
  EXPECT_EQ(both.euler_number(), 1);
}



TEST(Isosurface, of_a_needle_turns_outwards)
{
  // A row of nodes lies in it, off its middle, so that it ends within a
  // hundredth of a cell from them, and its distance falls again further inside.
  const double thick = 0.002;
  const auto   needle =
    isosurface<2>(in_batches<2>([thick](const Point<2> &p) {
                    return distance_to_box(Point<2>(p[0], p[1] - 0.75 * thick),
                                           {0.53, thick});
                  }),
                  1.,
                  16);
  EXPECT_TRUE(needle.is_closed());
  EXPECT_EQ(needle.euler_number(), 1);
}



TEST(Isosurface, of_bodies_in_space_counts_their_holes)
{
  const auto ball = isosurface<3>(
    in_batches<3>([](const Point<3> &p) { return p.norm() - 0.61; }), 1., 24);
  EXPECT_TRUE(ball.is_closed());
  EXPECT_EQ(ball.euler_number(), 1);
  // chords as long as the diagonal of a cell cut off 3 h^2 / (8 r) at most
  const double r = 0.61, h = 1. / 12.;
  EXPECT_LT(ball.measure(), 4. / 3. * M_PI * r * r * r);
  EXPECT_GT(ball.measure(),
            4. * M_PI * r * r * (r / 3. - 3. * h * h / (8. * r)));
  const auto ring =
    isosurface<3>(in_batches<3>([](const Point<3> &p) {
                    return std::hypot(std::hypot(p[0], p[1]) - 0.6, p[2]) -
                           0.25;
                  }),
                  1.,
                  24);
  EXPECT_TRUE(ring.is_closed());
  EXPECT_EQ(ring.euler_number(), 0);
  EXPECT_NEAR(ring.measure(), 2. * M_PI * M_PI * 0.6 * 0.25 * 0.25, 0.03);
}



TEST(Isosurface, refuses_a_function_without_zero)
{
  EXPECT_EQ(message_of<InputError>([]() {
              isosurface<2>(in_batches<2>([](const Point<2> &) { return 1.; }),
                            1.,
                            4);
            }),
            "The function has no zero in the box.");
}



TEST(ChamferDistance, of_concentric_squares_is_known)
{
  // edges 2 and 2.2: from the inner one 0.1; from the outer one 0.1 along 2 of
  // 2.2, and at the corners up to 0.1 sqrt(2), the mean over t in [0, 1] of
  // 0.1 sqrt(1 + t^2) being 0.1 (sqrt(2) + asinh(1)) / 2
  const auto inner = polygon({{-1., -1.}, {1., -1.}, {1., 1.}, {-1., 1.}});
  const auto outer =
    polygon({{-1.1, -1.1}, {1.1, -1.1}, {1.1, 1.1}, {-1.1, 1.1}});
  const auto   distance = chamfer_distance(inner, outer, 20000);
  const double corner   = 0.1 * (std::sqrt(2.) + std::asinh(1.)) / 2.;
  EXPECT_NEAR(distance.mean,
              0.5 * (0.1 + (2. * 0.1 + 0.2 * corner) / 2.2),
              1e-4);
  EXPECT_NEAR(distance.largest, 0.1 * std::sqrt(2.), 1e-3);
  EXPECT_LT(chamfer_distance(inner, inner).mean, 1e-15);
}
