#include <asperity/base/errors.h>
#include <asperity/coupling/interface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace asperity;
using dealii::Point;
using dealii::Tensor;
using Vector = dealii::Vector<double>;

namespace
{
  /** A curved strip, refined locally, deformed at random; nodes at random
   *  places of three of its edges. */
  struct CurvedStrip
  {
    explicit CurvedStrip(const unsigned int degree, const bool periodic)
      : space(KnotVector(degree, {0., 0.7, 1.1, 2., 2.8, 3.5}, periodic),
              KnotVector(degree, {0., 0.4, 1.}))
    {
      space.refine_to_level(1, [](const Point<2> &low, const Point<2> &) {
        return low[0] < 1. && low[1] > 0.3;
      });
      geometry = PatchGeometry<2>::from_map(space, [&](const Point<2> &xi) {
        return Point<2>(xi[0] + (periodic ? 0. : 0.1 * xi[1] * xi[1]),
                        xi[1] + 0.2 * std::sin(2. * M_PI * xi[0] / 3.5));
      });
      std::uniform_real_distribution<double> uniform(0., 1.);
      for (unsigned int i = 0; i < 40; ++i)
        {
          places.push_back({Edge::top, 3.5 * uniform(random)});
          places.push_back({Edge::bottom, 3.5 * uniform(random)});
          if (!periodic)
            places.push_back({Edge::right, uniform(random)});
        }
      if (!periodic)
        places.push_back({Edge::right, 1.});
    }

    Vector
    random_vector(const unsigned int n)
    {
      std::uniform_real_distribution<double> uniform(-1., 1.);
      Vector                                 v(n);
      for (double &x : v)
        x = uniform(random);
      return v;
    }

    /** Positions of the control points, as coefficients of X + u. */
    Vector
    control_points(const Vector &u) const
    {
      const auto identity = space.project(
        [](const Point<2> &xi) {
          return std::vector<double>{xi[0], xi[1]};
        },
        2);
      Vector P = u;
      for (unsigned int a = 0; a < space.n_functions(); ++a)
        for (unsigned int c = 0; c < 2; ++c)
          P(2 * a + c) += identity[c][a] + geometry.offset[a][c];
      return P;
    }

    std::mt19937           random{3};
    SplineSpace<2>         space;
    PatchGeometry<2>       geometry;
    std::vector<EdgePoint> places;
  };

  Point<2>
  parameter_of(const EdgePoint &place)
  {
    switch (place.edge)
      {
        case Edge::top:
          return {place.parameter, 1.};
        case Edge::bottom:
          return {place.parameter, 0.};
        default:
          return {3.5, place.parameter};
      }
  }
} // namespace



TEST(Interface, nodes_move_with_the_spline_exactly)
{
  for (const bool periodic : {false, true})
    for (const unsigned int degree : {1u, 2u, 4u})
      {
        CurvedStrip        strip(degree, periodic);
        const Interface    interface(strip.space, strip.geometry, strip.places);
        const unsigned int n = strip.space.n_functions();
        const Vector       u = strip.random_vector(2 * n);
        // The displacement as the geometry of another patch.
        PatchGeometry<2> moved = strip.geometry;
        for (unsigned int a = 0; a < n; ++a)
          for (unsigned int c = 0; c < 2; ++c)
            moved.offset[a][c] += u(2 * a + c);
        const Vector d = interface.interpolate(u);
        for (unsigned int i = 0; i < strip.places.size(); ++i)
          {
            const Point<2> x =
              moved.position(strip.space, parameter_of(strip.places[i]));
            for (unsigned int c = 0; c < 2; ++c)
              EXPECT_NEAR(interface.reference_positions()[i][c] + d(2 * i + c),
                          x[c],
                          1e-12);
          }
      }
}



TEST(Interface, loads_conserve_force_moment_and_power)
{
  for (const bool periodic : {false, true})
    for (const unsigned int degree : {1u, 2u, 4u})
      {
        CurvedStrip        strip(degree, periodic);
        const Interface    interface(strip.space, strip.geometry, strip.places);
        const unsigned int n = strip.space.n_functions();
        const Vector       u = strip.random_vector(2 * n);
        const Vector       F = strip.random_vector(2 * strip.places.size());
        const Vector       d = interface.interpolate(u);
        const Vector       P = strip.control_points(u);
        Vector             f(2 * n);
        interface.add_loads(F, f);

        double sum[2] = {0., 0.}, moment = 0.;
        for (unsigned int a = 0; a < n; ++a)
          {
            sum[0] += f(2 * a);
            sum[1] += f(2 * a + 1);
            moment += P(2 * a) * f(2 * a + 1) - P(2 * a + 1) * f(2 * a);
          }
        for (unsigned int i = 0; i < strip.places.size(); ++i)
          {
            const auto  &X = interface.reference_positions()[i];
            const double x = X[0] + d(2 * i), y = X[1] + d(2 * i + 1);
            sum[0] -= F(2 * i);
            sum[1] -= F(2 * i + 1);
            moment -= x * F(2 * i + 1) - y * F(2 * i);
          }
        EXPECT_NEAR(sum[0], 0., 1e-12);
        EXPECT_NEAR(sum[1], 0., 1e-12);
        // The coefficients of x = xi jump at the seam of a period.
        if (!periodic)
          {
            EXPECT_NEAR(moment, 0., 1e-12);
          }
        EXPECT_NEAR(f * u, F * d, 1e-12 * F.l2_norm() * d.l2_norm());
      }
}



TEST(Interface, finds_nodes_on_their_edges)
{
  CurvedStrip     strip(3, false);
  const Interface interface(strip.space, strip.geometry, strip.places);
  const auto      found = find_on_edges(strip.space,
                                   strip.geometry,
                                   {Edge::bottom, Edge::right, Edge::top},
                                   interface.reference_positions(),
                                   1e-9);
  const Interface again(strip.space, strip.geometry, found);
  for (unsigned int i = 0; i < found.size(); ++i)
    EXPECT_LT(interface.reference_positions()[i].distance(
                again.reference_positions()[i]),
              1e-9);
  EXPECT_THROW(find_on_edges(strip.space,
                             strip.geometry,
                             {Edge::bottom},
                             {Point<2>(1., 0.5)},
                             0.1),
               InputError);
}



TEST(InterfaceLoad, is_minus_the_load_in_the_residual)
{
  CurvedStrip        strip(2, false);
  const Interface    interface(strip.space, strip.geometry, strip.places);
  InterfaceLoad      load(interface);
  const Vector       F = strip.random_vector(2 * strip.places.size());
  const unsigned int n = 2 * strip.space.n_functions();
  Vector             u(n), residual(n), loads(n);
  load.set_force(F);
  ASSERT_TRUE(load.add(u, residual, nullptr));
  interface.add_loads(F, loads);
  residual += loads;
  EXPECT_EQ(residual.l2_norm(), 0.);
}
