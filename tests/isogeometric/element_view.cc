#include <asperity/isogeometric/element_view.h>
#include <asperity/isogeometric/spline_space.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <cmath>

#include "example_spaces.h"

using namespace asperity;
using dealii::Point;
using dealii::Tensor;
using Vector = dealii::Vector<double>;

namespace
{
  /** Coefficients of a displacement, numbered by displacement_dof(). */
  Vector
  interleaved(const std::vector<std::vector<double>> &components)
  {
    Vector u(2 * components[0].size());
    for (unsigned int a = 0; a < components[0].size(); ++a)
      for (unsigned int c = 0; c < 2; ++c)
        u(displacement_dof<2>(a, c)) = components[c][a];
    return u;
  }

  /** Polynomials of the space: u = (x^p y + y^p, 2 x - 3 y + 1); on a periodic
   *  space without their terms in x. */
  struct Polynomial
  {
    unsigned int p;
    double       along;

    Tensor<1, 2>
    value(const Point<2> &X) const
    {
      return Point<2>(along * std::pow(X[0], p) * X[1] + std::pow(X[1], p),
                      2. * along * X[0] - 3. * X[1] + 1.);
    }

    Tensor<2, 2>
    gradient(const Point<2> &X) const
    {
      Tensor<2, 2> G;
      G[0][0] = along * p * std::pow(X[0], p - 1.) * X[1];
      G[0][1] = along * std::pow(X[0], p) + p * std::pow(X[1], p - 1.);
      G[1][0] = 2. * along;
      G[1][1] = -3.;
      return G;
    }

    Vector
    coefficients(const SplineSpace<2> &space) const
    {
      return interleaved(space.project(
        [this](const Point<2> &X) {
          const Tensor<1, 2> u = value(X);
          return std::vector<double>{u[0], u[1]};
        },
        2));
    }
  };

  Polynomial
  polynomial_of(const example::Case &example)
  {
    const bool is_open = example.name.find("open") != std::string::npos;
    return {example.space->degree(), is_open ? 1. : 0.};
  }

  Tensor<2, 2>
  gradient_of(const ElementView<2> &element,
              const unsigned int    q,
              const Vector         &u)
  {
    Tensor<2, 2> G;
    for (unsigned int a = 0; a < element.n_functions(); ++a)
      for (unsigned int c = 0; c < 2; ++c)
        G[c] += u(element.dof(a, c)) * element.gradient(q, a);
    return G;
  }
} // namespace

TEST(ElementView, interpolates_polynomials_and_their_gradients)
{
  for (const example::Case &example : example::all())
    {
      const Polynomial    polynomial = polynomial_of(example);
      const Vector        u          = polynomial.coefficients(*example.space);
      const BasisTable<2> table      = tabulate_cells(*example.space,
                                                 PatchGeometry<2>(),
                                                 dealii::QGauss<2>(2));
      double              area       = 0.;
      for (const auto &entry : table.elements)
        {
          const ElementView<2> element(table, entry);
          for (unsigned int q = 0; q < table.points_per_element; ++q)
            {
              const Point<2> X = table.position[element.point(q)];
              Tensor<1, 2>   x = X;
              element.add_displacement(q, u, x);
              EXPECT_LT((x - X - polynomial.value(X)).norm(), 1e-11)
                << example.name;
              EXPECT_LT(
                (gradient_of(element, q, u) - polynomial.gradient(X)).norm(),
                1e-9)
                << example.name;
              area += element.JxW(q);
            }
        }
      EXPECT_NEAR(area, 2., 1e-12) << example.name;
    }
}

namespace
{
  /** Expects t + A t of the tangents t of all edges where u = A X. */
  void
  expect_stretched_tangents(const SplineSpace<2>   &space,
                            const PatchGeometry<2> &geometry,
                            const Vector           &u,
                            const Tensor<2, 2>     &A)
  {
    for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top})
      {
        const BasisTable<2> table =
          tabulate_edge(space, geometry, edge, dealii::QGauss<1>(3), true);
        for (const auto &entry : table.elements)
          {
            const ElementView<2> element(table, entry);
            for (unsigned int q = 0; q < table.points_per_element; ++q)
              {
                const Tensor<1, 2> tangent = table.tangent[element.point(q)];
                Tensor<1, 2>       current = tangent;
                element.add_stretch(q, u, current);
                EXPECT_LT((current - tangent - A * tangent).norm(), 1e-9);
              }
          }
      }
  }
} // namespace

// u = A X on a curved patch: the gradient is A, and a tangent t of an edge
// becomes t + A t.
TEST(ElementView, has_a_linear_map_of_a_curved_patch)
{
  Tensor<2, 2> A;
  A[0][0] = 0.3;
  A[0][1] = -1.2;
  A[1][0] = 0.7;
  A[1][1] = -0.4;
  for (const unsigned int degree : example::degrees())
    {
      const auto space = example::graded(degree, false);
      auto       X     = space->project(
        [](const Point<2> &xi) {
          return std::vector<double>{xi[0], xi[1]};
        },
        2);
      const auto       random = example::random_coefficients(2 * X[0].size());
      PatchGeometry<2> geometry;
      std::vector<std::vector<double>> coefficients = X;
      for (unsigned int a = 0; a < X[0].size(); ++a)
        {
          const Tensor<1, 2> offset =
            Point<2>(0.004 * random[2 * a], 0.004 * random[2 * a + 1]);
          geometry.offset.push_back(offset);
          const Tensor<1, 2> AX = A * (Point<2>(X[0][a], X[1][a]) + offset);
          for (unsigned int c = 0; c < 2; ++c)
            coefficients[c][a] = AX[c];
        }
      const Vector u = interleaved(coefficients);

      const BasisTable<2> cells =
        tabulate_cells(*space, geometry, dealii::QGauss<2>(2));
      for (const auto &entry : cells.elements)
        {
          const ElementView<2> element(cells, entry);
          for (unsigned int q = 0; q < cells.points_per_element; ++q)
            {
              Tensor<1, 2> displacement;
              element.add_displacement(q, u, displacement);
              const Tensor<1, 2> expected =
                A * cells.position[element.point(q)];
              EXPECT_LT((displacement - expected).norm(), 1e-11);
              EXPECT_LT((gradient_of(element, q, u) - A).norm(), 1e-9);
            }
        }

      expect_stretched_tangents(*space, geometry, u, A);
    }
}

// The nodal loads of f = (y, 2) on [0, 2] x [0, 1] add up to its integral, and
// their work on u is the integral of f . u, both by hand.
TEST(ElementView, nodal_loads_do_the_work_of_the_force)
{
  for (const example::Case &example : example::all())
    {
      const Polynomial    polynomial = polynomial_of(example);
      const unsigned int  p          = polynomial.p;
      const Vector        u          = polynomial.coefficients(*example.space);
      const BasisTable<2> table      = tabulate_cells(*example.space,
                                                 PatchGeometry<2>(),
                                                 dealii::QGauss<2>(p + 1));
      Vector              r(u.size());
      for (const auto &entry : table.elements)
        {
          const ElementView<2> element(table, entry);
          for (unsigned int q = 0; q < table.points_per_element; ++q)
            {
              const Point<2> f(table.position[element.point(q)][1], 2.);
              element.add_force(q, element.JxW(q) * f, r);
            }
        }
      double sum[2] = {0., 0.};
      for (unsigned int i = 0; i < r.size(); ++i)
        sum[i % 2] += r(i);
      EXPECT_NEAR(sum[0], 1., 1e-12) << example.name;
      EXPECT_NEAR(sum[1], 4., 1e-12) << example.name;
      const double work =
        polynomial.along * (std::pow(2., p + 1.) / (p + 1.) / 3. + 8.) +
        2. / (p + 2.) - 2.;
      EXPECT_NEAR(r * u, work, 1e-10) << example.name;
    }
}
