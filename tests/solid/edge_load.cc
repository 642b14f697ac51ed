#include <gtest/gtest.h>

#include "loaded_solid.h"

namespace
{
  using namespace loaded_solid;

  std::shared_ptr<SplineSpace<2>>
  refined_space(const unsigned int degree)
  {
    auto space = make_space(degree, equal_spans(4), equal_spans(3));
    space->refine_to_level(1, [](const Point<2> &low, const Point<2> &) {
      return low[0] < 0.2;
    });
    return space;
  }

  const auto uneven = [](const Point<2> &X) { return 2. + X[0] * X[1]; };

  Tensor<1, 2>
  sum(const Vector &R)
  {
    Tensor<1, 2> total;
    for (unsigned int i = 0; i < R.size(); ++i)
      total[i % 2] += R(i);
    return total;
  }
} // namespace



TEST(EdgeLoad, follower_tangent_is_the_derivative_of_its_force)
{
  for (const auto kinematics :
       {Kinematics::plane_strain, Kinematics::axisymmetric})
    for (unsigned int degree = 1; degree <= 3; ++degree)
      for (const Edge edge : four_edges)
        {
          const auto space = refined_space(degree);
          const auto geometry =
            PatchGeometry<2>::from_map(*space, bent_rectangle);
          EdgeLoad<2> load = EdgeLoad<2>::follower_pressure(
            *space, geometry, edge, uneven, kinematics);
          load.set_factor(0.7);
          const unsigned int n         = 2 * space->n_functions();
          const Vector       u         = random_vector(n, 0.1);
          const Vector       direction = random_vector(n, 1.);
          // The force is a polynomial of degree 2 in u (3 in axisymmetry).
          EXPECT_LT(tangent_error(load, u, direction, 1e-3), 1e-6)
            << "degree " << degree << ", edge " << int(edge);
        }
}



TEST(EdgeLoad, uniform_pressure_all_around_has_no_resultant)
{
  const auto   space    = refined_space(3);
  const auto   geometry = PatchGeometry<2>::from_map(*space, bent_rectangle);
  const Vector u        = random_vector(2 * space->n_functions(), 0.05);
  Vector       R(u.size());
  for (const Edge edge : four_edges)
    EdgeLoad<2>::follower_pressure(*space,
                                   geometry,
                                   edge,
                                   [](const Point<2> &) { return 5.; })
      .add(u, R, nullptr);
  EXPECT_LT(sum(R).norm(), 1e-12);
}



TEST(EdgeLoad, pressure_force_is_that_of_the_chord_of_the_deformed_edge)
{
  // The resultant of a uniform pressure on any curve is that on its chord.
  const auto space    = refined_space(2);
  const auto geometry = PatchGeometry<2>::from_map(*space, bent_rectangle);
  Body       body(space, bent_rectangle, MaterialParameters().make_law());
  body.u = random_vector(2 * space->n_functions(), 0.1);
  Vector R(body.u.size());
  EdgeLoad<2>::follower_pressure(*space,
                                 geometry,
                                 Edge::top,
                                 [](const Point<2> &) { return 5.; })
    .add(body.u, R, nullptr);
  const auto end = [&](const double xi) {
    return geometry.position(*space, {xi, 1.}) + body.displacement({xi, 1.});
  };
  const Tensor<1, 2> chord = end(1.) - end(0.);
  // Outward is the turn to the left of the chord of the top edge; R is minus
  // the force, which points inwards.
  EXPECT_NEAR(sum(R)[0], -5. * chord[1], 1e-12);
  EXPECT_NEAR(sum(R)[1], 5. * chord[0], 1e-12);
}



TEST(EdgeLoad, axial_pressure_on_a_ring_acts_on_its_deformed_area)
{
  const auto space = refined_space(2);
  const auto geometry =
    PatchGeometry<2>::from_map(*space, [](const Point<2> &xi) {
      return Point<2>(1. + 2. * xi[0], xi[1]);
    });
  EdgeLoad<2> load = EdgeLoad<2>::follower_pressure(
    *space,
    geometry,
    Edge::top,
    [](const Point<2> &) { return 5.; },
    Kinematics::axisymmetric);
  Vector u(2 * space->n_functions()), R(2 * space->n_functions());
  for (unsigned int a = 0; a < space->n_functions(); ++a)
    u(2 * a) = 0.5; // radii 1.5 to 3.5
  load.add(u, R, nullptr);
  EXPECT_NEAR(sum(R)[1],
              5. * dealii::numbers::PI * (3.5 * 3.5 - 1.5 * 1.5),
              1e-11);
}



TEST(EdgeLoad, dead_traction_sums_to_its_integral_whatever_the_deformation)
{
  const auto space = refined_space(2);
  const auto geometry =
    PatchGeometry<2>::from_map(*space, [](const Point<2> &xi) {
      return Point<2>(1. + 2. * xi[0], xi[1]);
    });
  const auto linear = [](const Point<2> &X, const Tensor<1, 2> &N) {
    Tensor<1, 2> t;
    t[0] = X[0];
    t[1] = 3. * N[1];
    return t;
  };
  const Vector u = random_vector(2 * space->n_functions(), 0.2);
  for (const auto kinematics :
       {Kinematics::plane_strain, Kinematics::axisymmetric})
    {
      EdgeLoad<2> load = EdgeLoad<2>::dead_traction(
        *space, geometry, Edge::top, linear, kinematics);
      load.set_factor(2.);
      Vector R(u.size());
      load.add(u, R, nullptr);
      const bool axisymmetric = (kinematics == Kinematics::axisymmetric);
      // integral of X, or of 2 pi X^2, from 1 to 3
      const double x = axisymmetric ? 2. * dealii::numbers::PI * 26. / 3. : 4.;
      const double y = axisymmetric ? 3. * dealii::numbers::PI * 8. : 6.;
      EXPECT_NEAR(sum(R)[0], -2. * x, 1e-12 * x);
      EXPECT_NEAR(sum(R)[1], -2. * y, 1e-12 * y);
    }
}
