#include <asperity/base/errors.h>
#include <asperity/isogeometric/spline_space.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "example_spaces.h"

using namespace asperity;
using dealii::Point;
using dealii::QGauss;
using dealii::Tensor;

namespace
{
  const auto edges = {Edge::left, Edge::right, Edge::bottom, Edge::top};

  /** A curved map that the space contains, and one with random periodic
   *  offsets small enough not to fold. */
  PatchGeometry<2>
  curved(const SplineSpace<2> &space)
  {
    if (space.is_periodic(0))
      {
        PatchGeometry<2> geometry;
        const auto c = example::random_coefficients(2 * space.n_functions());
        for (unsigned int a = 0; a < space.n_functions(); ++a)
          {
            Tensor<1, 2> D;
            D[0] = 0.004 * c[2 * a];
            D[1] = 0.004 * c[2 * a + 1];
            geometry.offset.push_back(D);
          }
        return geometry;
      }
    return PatchGeometry<2>::from_map(space, [&](const Point<2> &x) {
      if (space.degree() == 1)
        return Point<2>(x[0] + 0.2 * x[0] * x[1], x[1]);
      return Point<2>(x[0] + 0.2 * x[1] * x[1], x[1] + 0.1 * x[0] * x[0]);
    });
  }

  /** Integral of the determinant of the maps of curved() over [0,2] x [0,1]. */
  double
  area_of_curved(const SplineSpace<2> &space)
  {
    return space.degree() == 1 ? 2.2 : 2. - 0.4 * 0.2 * 2. * 0.5;
  }



  /** dX/dxi from the offsets and the parametric gradients. */
  Tensor<2, 2>
  jacobian(const PatchGeometry<2>          &geometry,
           const std::vector<unsigned int> &functions,
           const std::vector<Tensor<1, 2>> &gradients)
  {
    Tensor<2, 2> J;
    J[0][0] = J[1][1] = 1.;
    for (unsigned int a = 0; a < functions.size(); ++a)
      J += outer_product(geometry.offset[functions[a]], gradients[a]);
    return J;
  }
} // namespace

TEST(BasisTable, measures_of_a_curved_patch)
{
  for (const auto &[name, space] : example::all())
    if (!space->is_periodic(0))
      {
        const auto   geometry = curved(*space);
        const auto   table    = tabulate_cells(*space, geometry, QGauss<2>(3));
        const double area =
          std::accumulate(table.JxW.begin(), table.JxW.end(), 0.);
        EXPECT_NEAR(area, area_of_curved(*space), 1e-12) << name;
        if (space->degree() > 1)
          {
            // Top edge y = 1 + 0.1 x^2, x = xi + 0.2: the length of a parabola.
            const auto top =
              tabulate_edge(*space, geometry, Edge::top, QGauss<1>(8));
            const double length =
              std::accumulate(top.JxW.begin(), top.JxW.end(), 0.);
            const double k = 0.2, t = 2.;
            EXPECT_NEAR(length,
                        0.5 * t * std::sqrt(1. + k * k * t * t) +
                          std::asinh(k * t) / (2. * k),
                        1e-11)
              << name;
          }
      }
}

TEST(BasisTable, divergence_theorem_for_every_function)
{
  for (const auto &[name, space] : example::all())
    {
      const auto                geometry = curved(*space);
      std::vector<Tensor<1, 2>> defect(space->n_functions());
      const auto                cells =
        tabulate_cells(*space, geometry, QGauss<2>(2 * space->degree()));
      for (const auto &element : cells.elements)
        for (unsigned int q = 0; q < cells.points_per_element; ++q)
          for (unsigned int a = 0; a < element.functions.size(); ++a)
            defect[element.functions[a]] +=
              element.gradients[q * element.functions.size() + a] *
              cells.JxW[element.first_point + q];
      for (const Edge edge : edges)
        {
          const auto table = tabulate_edge(
            *space, geometry, edge, QGauss<1>(2 * space->degree()), true);
          for (const auto &element : table.elements)
            for (unsigned int q = 0; q < table.points_per_element; ++q)
              for (unsigned int a = 0; a < element.functions.size(); ++a)
                defect[element.functions[a]] -=
                  element.values[q * element.functions.size() + a] *
                  table.JxW[element.first_point + q] *
                  table.normal[element.first_point + q];
        }
      for (const auto &d : defect)
        EXPECT_NEAR(d.norm(), 0., 1e-13) << name;
    }
}

TEST(BasisTable, values_and_gradients_are_those_of_evaluation)
{
  for (const auto &[name, space] : example::all())
    {
      const auto geometry = curved(*space);
      const auto table    = tabulate_cells(*space, geometry, QGauss<2>(2));
      std::vector<double>       N;
      std::vector<Tensor<1, 2>> dN;
      for (const auto &element : table.elements)
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          {
            const unsigned int point = element.first_point + q;
            space->evaluate(element.cell, table.parameter[point], N, &dN);
            EXPECT_EQ(element.functions, space->cell_functions(element.cell));
            EXPECT_NEAR((geometry.position(*space, table.parameter[point]) -
                         table.position[point])
                          .norm(),
                        0.,
                        1e-14);
            const Tensor<2, 2> J = jacobian(geometry, element.functions, dN);
            for (unsigned int a = 0; a < N.size(); ++a)
              {
                EXPECT_NEAR(element.values[q * N.size() + a], N[a], 1e-14);
                // Chain rule, written without an inverse.
                EXPECT_NEAR(
                  (transpose(J) * element.gradients[q * N.size() + a] - dN[a])
                    .norm(),
                  0.,
                  1e-11)
                  << name;
              }
          }
    }
}

namespace
{
  /** Point q of an edge's element against the values of the cell there; returns
   *  the parameter along the edge. */
  double
  check_edge_point(const SplineSpace<2>         &space,
                   const PatchGeometry<2>       &geometry,
                   const BasisTable<2>          &table,
                   const BasisTable<2>::Element &element,
                   const unsigned int            q,
                   const unsigned int            along)
  {
    const unsigned int        point = element.first_point + q;
    const unsigned int        n     = element.functions.size();
    std::vector<double>       N;
    std::vector<Tensor<1, 2>> dN;
    space.evaluate(element.cell, table.parameter[point], N, &dN);
    const Tensor<2, 2> J = jacobian(geometry, element.functions, dN);
    Tensor<1, 2>       tangent;
    for (unsigned int d = 0; d < 2; ++d)
      tangent[d] = J[d][along];
    const Tensor<1, 2> normal = table.normal[point];
    EXPECT_NEAR(normal.norm(), 1., 1e-14);
    EXPECT_NEAR(normal * tangent, 0., 1e-13);
    EXPECT_NEAR((table.tangent[point] - tangent / tangent.norm()).norm(),
                0.,
                1e-14);
    for (unsigned int a = 0; a < n; ++a)
      {
        // The gradients are (derivative along the edge, along the normal).
        const Tensor<1, 2> derivative = element.gradients[q * n + a];
        EXPECT_NEAR(element.values[q * n + a], N[a], 1e-14);
        EXPECT_NEAR(derivative[0] * tangent.norm(), dN[a][along], 1e-10);
        const Tensor<1, 2> gradient =
          derivative[0] * tangent / tangent.norm() + derivative[1] * normal;
        EXPECT_NEAR((transpose(J) * gradient - dN[a]).norm(), 0., 1e-10);
      }
    return table.parameter[point][along];
  }



  /** The trace holds the functions that do not vanish on the edge, in the
   *  order of the whole element. */
  void
  check_trace(const BasisTable<2>::Element &whole,
              const BasisTable<2>::Element &trace,
              const unsigned int            q)
  {
    unsigned int matched = 0;
    for (unsigned int a = 0; a < whole.functions.size(); ++a)
      {
        const double value = whole.values[q * whole.functions.size() + a];
        if (matched < trace.functions.size() &&
            trace.functions[matched] == whole.functions[a])
          {
            EXPECT_EQ(trace.values[q * trace.functions.size() + matched],
                      value);
            ++matched;
          }
        else
          EXPECT_NEAR(value, 0., 1e-14);
      }
    EXPECT_EQ(matched, trace.functions.size());
  }
} // namespace

TEST(BasisTable, edge_values_are_the_traces_of_the_cell)
{
  for (const auto &[name, space] : example::all())
    for (const Edge edge : edges)
      {
        SCOPED_TRACE(name);
        const auto geometry = curved(*space);
        const auto full = tabulate_edge(*space, geometry, edge, QGauss<1>(3));
        const auto traces =
          tabulate_edge(*space, geometry, edge, QGauss<1>(3), true);
        const unsigned int along =
          (edge == Edge::left || edge == Edge::right) ? 1 : 0;
        double previous = -1.;
        for (unsigned int e = 0; e < full.elements.size(); ++e)
          for (unsigned int q = 0; q < full.points_per_element; ++q)
            {
              const double parameter = check_edge_point(
                *space, geometry, full, full.elements[e], q, along);
              EXPECT_GT(parameter, previous);
              previous = parameter;
              check_trace(full.elements[e], traces.elements[e], q);
            }
      }
}

TEST(BasisTable, outward_normals_of_the_rectangle)
{
  const auto space  = example::graded(2, true);
  const auto normal = [&](const Edge edge) {
    return tabulate_edge(*space, {}, edge, QGauss<1>(1)).normal[0];
  };
  EXPECT_NEAR(normal(Edge::left)[0], -1., 1e-15);
  EXPECT_NEAR(normal(Edge::right)[0], 1., 1e-15);
  EXPECT_NEAR(normal(Edge::bottom)[1], -1., 1e-15);
  EXPECT_NEAR(normal(Edge::top)[1], 1., 1e-15);
}

TEST(BasisTable, a_folded_geometry_is_refused)
{
  const auto space  = example::uniform(2, false);
  const auto folded = PatchGeometry<2>::from_map(*space, [](const Point<2> &x) {
    return Point<2>(-x[0], x[1]);
  });
  EXPECT_THROW(tabulate_cells(*space, folded, QGauss<2>(2)), ComputationError);
}
