#include <asperity/isogeometric/spline_space.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/vector.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "example_spaces.h"

using namespace asperity;
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double lambda = 1.5, mu = 1.;

  /** Displacement coefficients [2 a + c] of plane linear elasticity with the
   *  coefficients of `prescribed` on the edges that bound the domain. */
  dealii::Vector<double>
  solve_elasticity(const SplineSpace<2>      &space,
                   const PatchGeometry<2>    &geometry,
                   const std::vector<double> &prescribed)
  {
    const unsigned int n = 2 * space.n_functions();
    const auto         table =
      tabulate_cells(space, geometry, dealii::QGauss<2>(space.degree() + 1));
    dealii::DynamicSparsityPattern pattern(n);
    for (const auto &element : table.elements)
      for (const unsigned int a : element.functions)
        for (const unsigned int b : element.functions)
          for (unsigned int c = 0; c < 4; ++c)
            pattern.add(2 * a + c / 2, 2 * b + c % 2);
    dealii::SparsityPattern sparsity;
    sparsity.copy_from(pattern);
    dealii::SparseMatrix<double> matrix(sparsity);
    for (const auto &element : table.elements)
      {
        const unsigned int         n_a = element.functions.size();
        dealii::FullMatrix<double> cell_matrix(2 * n_a, 2 * n_a);
        std::vector<unsigned int>  unknowns;
        for (const unsigned int a : element.functions)
          unknowns.insert(unknowns.end(), {2 * a, 2 * a + 1});
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          for (unsigned int a = 0; a < n_a; ++a)
            for (unsigned int b = 0; b < n_a; ++b)
              {
                const auto  &g_a = element.gradients[q * n_a + a];
                const auto  &g_b = element.gradients[q * n_a + b];
                const double JxW = table.JxW[element.first_point + q];
                for (unsigned int i = 0; i < 2; ++i)
                  for (unsigned int j = 0; j < 2; ++j)
                    cell_matrix(2 * a + i, 2 * b + j) +=
                      JxW * (lambda * g_a[i] * g_b[j] + mu * g_a[j] * g_b[i] +
                             (i == j ? mu * (g_a * g_b) : 0.));
              }
        matrix.add(unknowns, cell_matrix);
      }
    std::set<unsigned int> fixed;
    for (const Edge edge : {Edge::bottom, Edge::top, Edge::left, Edge::right})
      if (!space.is_periodic(0) || edge == Edge::bottom || edge == Edge::top)
        for (const unsigned int a : space.edge_functions(edge))
          fixed.insert({2 * a, 2 * a + 1});
    dealii::Vector<double> u(n);
    for (const unsigned int i : fixed)
      {
        for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
          entry->value() = entry->column() == i ? 1. : 0.;
        u[i] = prescribed[i];
      }
    dealii::SparseDirectUMFPACK solver;
    solver.initialize(matrix);
    solver.solve(u);
    return u;
  }
} // namespace

TEST(PatchTest, a_linear_displacement_is_exact_on_hierarchical_meshes)
{
  for (const auto &[name, space] : example::all())
    {
      // The geometry: a patch with curved cells everywhere.
      const auto c = example::random_coefficients(2 * space->n_functions());
      PatchGeometry<2> geometry;
      for (unsigned int a = 0; a < space->n_functions(); ++a)
        geometry.offset.push_back(
          Point<2>(0.005 * c[2 * a], 0.005 * c[2 * a + 1]));

      // u = A X; if x is periodic only the part of Y is.
      Tensor<2, 2> A;
      A[0][1] = 0.3;
      A[1][1] = -0.2;
      if (!space->is_periodic(0))
        {
          A[0][0] = 0.1;
          A[1][0] = 0.4;
        }
      const auto identity = space->project(
        [&](const Point<2> &x) {
          return std::vector<double>{space->is_periodic(0) ? 0. : x[0], x[1]};
        },
        2);
      std::vector<double> expected;
      for (unsigned int a = 0; a < space->n_functions(); ++a)
        {
          const Tensor<1, 2> X =
            Point<2>(identity[0][a], identity[1][a]) + geometry.offset[a];
          const Tensor<1, 2> u = A * X;
          expected.insert(expected.end(), {u[0], u[1]});
        }

      const auto u = solve_elasticity(*space, geometry, expected);
      for (unsigned int i = 0; i < u.size(); ++i)
        EXPECT_NEAR(u[i], expected[i], 1e-11) << name;
    }
}
