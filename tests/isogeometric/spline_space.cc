#include <asperity/base/errors.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/spline_space.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "example_spaces.h"

using namespace asperity;
using dealii::Point;

TEST(SplineSpace, partition_of_unity)
{
  for (const auto &[name, space] : example::all())
    for (const auto &point : example::random_points(100))
      {
        std::vector<double>               values;
        std::vector<dealii::Tensor<1, 2>> gradients;
        space->evaluate(space->find_cell(point), point, values, &gradients);
        double               sum = 0.;
        dealii::Tensor<1, 2> gradient_sum;
        for (unsigned int a = 0; a < values.size(); ++a)
          {
            sum += values[a];
            gradient_sum += gradients[a];
          }
        EXPECT_NEAR(sum, 1., 1e-12) << name;
        EXPECT_NEAR(gradient_sum.norm(), 0., 1e-10) << name;
      }
}

TEST(SplineSpace, truncated_functions_are_not_negative)
{
  for (const auto &[name, space] : example::all())
    for (unsigned int cell = 0; cell < space->n_cells(); ++cell)
      {
        const auto &extraction = space->cell_extraction(cell);
        for (unsigned int a = 0; a < extraction.m(); ++a)
          for (unsigned int b = 0; b < extraction.n(); ++b)
            ASSERT_GE(extraction(a, b), 0.) << name;
      }
}

TEST(SplineSpace, functions_are_linearly_independent)
{
  for (const auto &[name, space] : example::all())
    {
      const auto gramian = L2Projection<2>::gramian(*space->hierarchy());
      dealii::LAPACKFullMatrix<double> scaled(gramian.m(), gramian.n());
      for (unsigned int i = 0; i < gramian.m(); ++i)
        for (unsigned int j = 0; j < gramian.n(); ++j)
          scaled(i, j) =
            gramian(i, j) / std::sqrt(gramian(i, i) * gramian(j, j));
      dealii::FullMatrix<double> vectors;
      dealii::Vector<double>     eigenvalues;
      scaled.compute_eigenvalues_symmetric(-1., 1e3, 0., eigenvalues, vectors);
      ASSERT_EQ(eigenvalues.size(), space->n_functions());
      EXPECT_GT(*std::min_element(eigenvalues.begin(), eigenvalues.end()), 1e-6)
        << name;
    }
}

TEST(SplineSpace, reproduces_polynomials_of_its_degree)
{
  for (const auto &[name, space] : example::all())
    {
      // With x periodic only constants in x are splines.
      const int  p_x = space->is_periodic(0) ? 0 : space->degree();
      const int  p_y = space->degree();
      const auto f   = [&](const Point<2> &x) {
        return std::vector<double>{std::pow(x[0] - 0.7, p_x) *
                                     std::pow(x[1] - 0.2, p_y),
                                   x[1]};
      };
      const auto coefficients = space->project(f, 2);
      for (const auto &point : example::random_points(50))
        for (unsigned int c = 0; c < 2; ++c)
          EXPECT_NEAR(example::value(*space, coefficients[c], point),
                      f(point)[c],
                      1e-11)
            << name;
    }
}

TEST(SplineSpace, dimension_of_the_tensor_product_space)
{
  for (unsigned int p = 1; p <= 4; ++p)
    {
      EXPECT_EQ(example::uniform(p, false)->n_functions(), (7 + p) * (5 + p));
      EXPECT_EQ(example::uniform(p, true)->n_functions(), 7 * (5 + p));
    }
}

TEST(SplineSpace, uniform_refinement_gives_the_splines_of_the_refined_knots)
{
  for (unsigned int p = 1; p <= 4; ++p)
    for (const bool periodic : {false, true})
      {
        auto space = example::uniform(p, periodic);
        space->refine_to_level(2, [](const Point<2> &, const Point<2> &) {
          return true;
        });
        const KnotVector x =
          KnotVector(p, example::breakpoints(7, 2.), periodic)
            .dyadic_refinement()
            .dyadic_refinement();
        const KnotVector y = KnotVector(p, example::breakpoints(5, 1.))
                               .dyadic_refinement()
                               .dyadic_refinement();
        ASSERT_EQ(space->n_functions(), x.n_basis() * y.n_basis());
        for (const auto &point : example::random_points(100))
          {
            const unsigned int                cell = space->find_cell(point);
            std::vector<double>               values;
            std::vector<dealii::Tensor<1, 2>> gradients;
            space->evaluate(cell, point, values, &gradients);
            const unsigned int i = x.find_span(point[0]);
            const unsigned int j = y.find_span(point[1]);
            const auto         X = x.evaluate(i, point[0], 1);
            const auto         Y = y.evaluate(j, point[1], 1);
            const auto         f = x.span_functions(i), g = y.span_functions(j);
            ASSERT_EQ(values.size(), (p + 1) * (p + 1));
            for (unsigned int a = 0; a < values.size(); ++a)
              {
                const unsigned int a_x = a % (p + 1), a_y = a / (p + 1);
                EXPECT_EQ(space->cell_functions(cell)[a],
                          g[a_y] * x.n_basis() + f[a_x]);
                EXPECT_NEAR(values[a], X[0][a_x] * Y[0][a_y], 1e-13);
                EXPECT_NEAR(gradients[a][0], X[1][a_x] * Y[0][a_y], 1e-10);
                EXPECT_NEAR(gradients[a][1], X[0][a_x] * Y[1][a_y], 1e-10);
              }
          }
      }
}

TEST(SplineSpace, functions_of_a_cell_stem_from_at_most_two_levels)
{
  for (const auto &[name, space] : example::all())
    {
      const auto   hierarchy = space->hierarchy();
      unsigned int largest   = 0;
      for (unsigned int cell = 0; cell < space->n_cells(); ++cell)
        {
          std::set<unsigned int> levels;
          for (const unsigned int f : space->cell_functions(cell))
            levels.insert(
              hierarchy->cell_index(hierarchy->function_home(f).first).level);
          EXPECT_LE(levels.size(), 2) << name;
          largest =
            std::max<unsigned int>(largest, space->cell_functions(cell).size());
        }
      const unsigned int p = space->degree();
      EXPECT_LE(largest, 2 * (p + 1) * (p + 1)) << name;
    }
}

TEST(SplineSpace, neighbour_levels_differ_by_one_across_the_period_too)
{
  for (const bool periodic : {false, true})
    {
      const auto space = example::graded(2, periodic);
      for (const auto &cell : space->triangulation().active_cell_iterators())
        {
          const unsigned int c   = cell->active_cell_index();
          const auto [low, high] = space->cell_box(c);
          if (!periodic || low[0] > 1e-12)
            continue;
          for (const double s : {0.1, 0.9})
            {
              const unsigned int left = space->find_cell(
                Point<2>(-1e-6, low[1] + s * (high[1] - low[1])));
              EXPECT_LE(std::abs(
                          int(space->hierarchy()->cell_index(left).level) -
                          cell->level()),
                        1);
            }
        }
      EXPECT_EQ(space->triangulation().n_levels(), 3);
    }
}

TEST(SplineSpace, numbering_and_boxes_are_those_of_the_triangulation)
{
  const auto space = example::graded(3, true);
  ASSERT_EQ(space->n_cells(), space->triangulation().n_active_cells());
  for (const auto &cell : space->triangulation().active_cell_iterators())
    {
      const unsigned int c   = cell->active_cell_index();
      const auto [low, high] = space->cell_box(c);
      EXPECT_NEAR((cell->vertex(0) - low).norm(), 0., 1e-14);
      EXPECT_NEAR((cell->vertex(3) - high).norm(), 0., 1e-14);
      EXPECT_EQ(space->find_cell(cell->center()), c);
      EXPECT_EQ(space->find_cell(cell->center() + Point<2>(2., 0.)), c);
      for (unsigned int f = 0; f < 4; ++f)
        if (cell->face(f)->at_boundary())
          {
            const auto cells =
              space->edge_cells(Edge(cell->face(f)->boundary_id()));
            EXPECT_EQ(cell->face(f)->boundary_id(), f);
            EXPECT_EQ(std::count(cells.begin(), cells.end(), c), 1);
          }
    }
}

TEST(SplineSpace, traces_vanish_outside_the_edge_functions)
{
  for (const auto &[name, space] : example::all())
    for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top})
      {
        std::set<unsigned int> seen;
        for (const auto &random : example::random_points(200))
          {
            Point<2> point = random;
            if (edge == Edge::left || edge == Edge::right)
              point[0] = edge == Edge::left ? 0. : 2.;
            else
              point[1] = edge == Edge::bottom ? 0. : 1.;
            const unsigned int  cell = space->find_cell(point);
            std::vector<double> values;
            space->evaluate(cell, point, values);
            for (unsigned int a = 0; a < values.size(); ++a)
              if (values[a] > 1e-13)
                seen.insert(space->cell_functions(cell)[a]);
          }
        const auto functions = space->edge_functions(edge);
        EXPECT_TRUE(std::is_sorted(functions.begin(), functions.end()));
        for (const unsigned int f : seen)
          EXPECT_TRUE(std::binary_search(functions.begin(), functions.end(), f))
            << name;
        if (name.find("uniform") != std::string::npos)
          {
            const bool vertical  = edge == Edge::left || edge == Edge::right;
            const unsigned int p = space->degree();
            if (!vertical)
              {
                EXPECT_EQ(functions.size(), space->is_periodic(0) ? 7 : 7 + p);
              }
            else if (!space->is_periodic(0))
              {
                EXPECT_EQ(functions.size(), 5 + p);
              }
          }
      }
}

TEST(SplineSpace, periodic_splines_are_continuous_across_the_period)
{
  // Derivatives up to p - 1 agree, by one-sided differences of the
  // polynomials on both sides.
  for (unsigned int p = 1; p <= 4; ++p)
    for (const bool refined : {false, true})
      {
        const auto space =
          refined ? example::graded(p, true) : example::uniform(p, true);
        const auto c = example::random_coefficients(space->n_functions());
        for (const double y : {0.05, 0.5, 0.97})
          {
            const auto side = [&](const double x, const double inside) {
              const unsigned int  cell = space->find_cell(Point<2>(inside, y));
              std::vector<double> N;
              space->evaluate(cell, Point<2>(x, y), N);
              double sum = 0.;
              for (unsigned int a = 0; a < N.size(); ++a)
                sum += N[a] * c[space->cell_functions(cell)[a]];
              return sum;
            };
            // Divided differences of order k on nodes straddling the period,
            // with the polynomial of either side.
            const double h = 0.02;
            for (unsigned int k = 0; k < p; ++k)
              {
                double left = 0., right = 0.;
                // Derivative k of a polynomial of degree p from p + 1 nodes:
                // solve by Newton's divided differences, then evaluate at 0.
                std::vector<double> nodes, l, r;
                for (unsigned int i = 0; i <= p; ++i)
                  {
                    nodes.push_back(h * (i - 0.5 * p));
                    l.push_back(side(nodes[i], 2. - 1e-9));
                    r.push_back(side(nodes[i], 1e-9));
                  }
                const unsigned int         n = p + 1;
                dealii::FullMatrix<double> vandermonde(n, n), inverse(n, n);
                for (unsigned int i = 0; i < n; ++i)
                  for (unsigned int j = 0; j < n; ++j)
                    vandermonde(i, j) = std::pow(nodes[i] / h, j);
                inverse.invert(vandermonde);
                for (unsigned int i = 0; i < n; ++i)
                  {
                    left += inverse(k, i) * l[i];
                    right += inverse(k, i) * r[i];
                  }
                EXPECT_NEAR(left, right, 1e-11) << p << " " << k;
              }
          }
      }
}

TEST(SplineSpace, refinement_and_coarsening_by_flags_return_the_space)
{
  for (unsigned int p = 1; p <= 4; ++p)
    {
      auto       space  = example::uniform(p, true);
      const auto before = space->hierarchy();
      space->refine_to_level(2, [](const Point<2> &low, const Point<2> &) {
        return low[0] < 0.1;
      });
      EXPECT_GT(space->n_functions(), before->n_functions());
      space->refine_like(*before);
      EXPECT_EQ(space->n_functions(), before->n_functions());
      EXPECT_EQ(space->n_cells(), before->n_cells());
    }
}

TEST(SplineSpace, refuses_two_degrees)
{
  EXPECT_THROW(SplineSpace<2>(KnotVector(2, example::breakpoints(4, 1.)),
                              KnotVector(3, example::breakpoints(4, 1.))),
               InputError);
}
