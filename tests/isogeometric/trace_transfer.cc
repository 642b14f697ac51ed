#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/trace_transfer.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "example_spaces.h"

using namespace asperity;
using dealii::Point;
using dealii::QGauss;

namespace
{
  /** On level 0 and, in part, two levels finer. */
  template <int dim>
  std::unique_ptr<SplineSpace<dim>>
  periodic_space(const unsigned int degree, const bool is_fine)
  {
    std::array<KnotVector, dim> knots;
    for (unsigned int d = 0; d < dim; ++d)
      {
        std::vector<double> breakpoints;
        for (unsigned int i = 0; i <= 6; ++i)
          breakpoints.push_back(i / 6.);
        knots[d] = KnotVector(degree, breakpoints, d + 1 < dim);
      }
    auto space = std::make_unique<SplineSpace<dim>>(knots);
    if (is_fine)
      space->refine_to_level(2,
                             [](const Point<dim> &low, const Point<dim> &high) {
                               return low[0] < 0.7 && high[0] > 0.5 &&
                                      high[dim - 1] > 0.9 && low[dim - 2] < 0.7;
                             });
    return space;
  }

  /** Of the top edge, at the points of its cells. */
  template <int dim>
  std::vector<double>
  values(const SplineSpace<dim> &space, const std::vector<double> &coefficients)
  {
    const auto functions = space.edge_functions(Edge::top);
    const auto table = tabulate_edge(space, {}, Edge::top, QGauss<dim - 1>(3));
    std::vector<double> at_points;
    for (const auto &element : table.elements)
      for (unsigned int q = 0; q < table.points_per_element; ++q)
        {
          double sum = 0.;
          for (unsigned int a = 0; a < element.functions.size(); ++a)
            {
              const auto found = std::lower_bound(functions.begin(),
                                                  functions.end(),
                                                  element.functions[a]);
              if (found != functions.end() && *found == element.functions[a])
                sum += element.values[q * element.functions.size() + a] *
                       coefficients[found - functions.begin()];
            }
          at_points.push_back(sum);
        }
    return at_points;
  }

  template <int dim>
  double
  integral(const SplineSpace<dim>    &space,
           const std::vector<double> &coefficients)
  {
    const auto table = tabulate_edge(space, {}, Edge::top, QGauss<dim - 1>(3));
    const auto at    = values(space, coefficients);
    double     sum   = 0.;
    for (unsigned int q = 0; q < at.size(); ++q)
      sum += table.JxW[q] * at[q];
    return sum;
  }

  /** A spline goes to a finer mesh and back, and a fine one to the coarse. */
  template <int dim>
  void
  expect_exact_and_conservative(const unsigned int degree)
  {
    const auto coarse = periodic_space<dim>(degree, false),
               fine   = periodic_space<dim>(degree, true);
    const TraceTransfer<dim> up(*coarse->hierarchy(),
                                *fine->hierarchy(),
                                Edge::top),
      down(*fine->hierarchy(), *coarse->hierarchy(), Edge::top);
    const auto c =
      example::random_coefficients(coarse->edge_functions(Edge::top).size());
    const auto refined = up.apply(c), back = down.apply(refined);
    EXPECT_GT(refined.size(), c.size());
    for (unsigned int a = 0; a < c.size(); ++a)
      EXPECT_NEAR(back[a], c[a], 1e-12);
    EXPECT_NEAR(integral(*fine, refined), integral(*coarse, c), 1e-13);
    const auto f =
      example::random_coefficients(fine->edge_functions(Edge::top).size());
    EXPECT_NEAR(integral(*coarse, down.apply(f)), integral(*fine, f), 1e-13);
    const TraceTransfer<dim> same(*fine->hierarchy(),
                                  *fine->hierarchy(),
                                  Edge::top);
    const auto               again = same.apply(f);
    for (unsigned int a = 0; a < f.size(); ++a)
      EXPECT_NEAR(again[a], f[a], 1e-12);
    const auto zero = down.apply(std::vector<double>(f.size(), 0.));
    EXPECT_EQ(zero, std::vector<double>(c.size(), 0.));
  }
} // namespace

TEST(TraceTransfer, is_exact_where_it_can_be_and_keeps_integrals)
{
  for (const unsigned int degree : {1, 2, 3})
    {
      expect_exact_and_conservative<2>(degree);
      expect_exact_and_conservative<3>(degree);
    }
}

// The values of a refined spline at the points of the fine mesh are those of
// the coarse one: sums over its functions at the same parameters.
TEST(TraceTransfer, gives_the_values_of_the_old_spline)
{
  const auto coarse = periodic_space<3>(2, false),
             fine   = periodic_space<3>(2, true);
  const TraceTransfer<3> up(*coarse->hierarchy(),
                            *fine->hierarchy(),
                            Edge::top);
  const auto             functions = coarse->edge_functions(Edge::top);
  const auto             c  = example::random_coefficients(functions.size());
  const auto             at = values(*fine, up.apply(c));
  const auto          table = tabulate_edge(*fine, {}, Edge::top, QGauss<2>(3));
  std::vector<double> N;
  for (unsigned int q = 0; q < at.size(); ++q)
    {
      const unsigned int cell = coarse->find_cell(table.parameter[q]);
      coarse->evaluate(cell, table.parameter[q], N);
      double sum = 0.;
      for (unsigned int a = 0; a < N.size(); ++a)
        {
          const unsigned int f = coarse->cell_functions(cell)[a];
          const auto         found =
            std::lower_bound(functions.begin(), functions.end(), f);
          if (found != functions.end() && *found == f)
            sum += N[a] * c[found - functions.begin()];
        }
      EXPECT_NEAR(at[q], sum, 1e-12);
    }
}

TEST(TraceTransfer, takes_linear_values_at_points_exactly_and_leaves_no_range)
{
  const auto coarse = periodic_space<3>(2, false),
             fine   = periodic_space<3>(2, true);
  const QGauss<2> rule(3);
  const auto      tables = {tabulate_edge(*coarse, {}, Edge::top, rule),
                            tabulate_edge(*fine, {}, Edge::top, rule)};
  const auto      linear = [](const BasisTable<3> &table) {
    std::vector<double> values;
    for (const auto &x : table.parameter)
      values.insert(values.end(),
                    {1. + 2. * x[0] - 3. * x[1], x[0] > 0.5 ? 1. : 0.});
    return values;
  };
  const auto on_coarse = linear(*tables.begin()),
             on_fine   = linear(*(tables.begin() + 1));
  const auto up        = transfer_edge_history(
    *coarse->hierarchy(), *fine->hierarchy(), Edge::top, rule, on_coarse, 2);
  const auto down = transfer_edge_history(
    *fine->hierarchy(), *coarse->hierarchy(), Edge::top, rule, on_fine, 2);
  ASSERT_EQ(up.size(), on_fine.size());
  ASSERT_EQ(down.size(), on_coarse.size());
  for (unsigned int q = 0; q < up.size() / 2; ++q)
    {
      EXPECT_TRUE(up[2 * q + 1] >= 0. && up[2 * q + 1] <= 1.);
      // Old cells at the ends are drawn into the range of the old points.
      const auto &x = (tables.begin() + 1)->parameter[q];
      const bool  is_inside =
        std::max(std::abs(x[0] - 0.5), std::abs(x[1] - 0.5)) < 1. / 3.;
      if (is_inside)
        {
          EXPECT_NEAR(up[2 * q], on_fine[2 * q], 1e-12);
        }
    }
  for (unsigned int i = 0; i < down.size(); i += 2)
    EXPECT_NEAR(down[i], on_coarse[i], 1e-12);
}
