#include <asperity/base/errors.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/space_transfer.h>
#include <asperity/isogeometric/spline_space.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "example_spaces.h"

using namespace asperity;
using dealii::Point;
using dealii::QGauss;
using dealii::Tensor;
using example::value;

namespace
{
  /** The unit box, periodic in all directions but the last or open, refined
   *  twice around the corner of least parameters and the top. */
  template <int dim>
  std::array<KnotVector, dim>
  knots(const unsigned int degree, const bool periodic)
  {
    std::array<KnotVector, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = KnotVector(degree,
                             example::breakpoints(degree + 2 + d, 1.),
                             periodic && d + 1 < dim);
    return result;
  }

  template <int dim>
  bool
  everywhere(const Point<dim> &, const Point<dim> &)
  {
    return true;
  }

  /** Near the corner of least parameters at the top. */
  template <int dim>
  bool
  near_a_corner(const Point<dim> &low, const Point<dim> &high)
  {
    for (unsigned int d = 0; d + 1 < dim; ++d)
      if (low[d] > 0.05)
        return false;
    return high[dim - 1] > 0.95;
  }

  /** The unit box, open or periodic in all directions but the last, refined
   *  everywhere and `more` times around a corner. */
  template <int dim>
  std::unique_ptr<SplineSpace<dim>>
  graded(const unsigned int degree,
         const bool         periodic,
         const unsigned int uniform = 0,
         const unsigned int more    = 2)
  {
    auto space =
      std::make_unique<SplineSpace<dim>>(knots<dim>(degree, periodic));
    space->refine_to_level(uniform, everywhere<dim>);
    space->refine_to_level(uniform + more, near_a_corner<dim>);
    return space;
  }

  template <int dim>
  std::vector<Point<dim>>
  random_points(const unsigned int n)
  {
    const auto              numbers = example::random_coefficients(dim * n);
    std::vector<Point<dim>> points(n);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        points[i][d] = 0.5 + 0.5 * numbers[dim * i + d];
    return points;
  }

  template <typename Dimension>
  class Dimensions : public testing::Test
  {};
  using BothDimensions = testing::Types<std::integral_constant<int, 2>,
                                        std::integral_constant<int, 3>>;
} // namespace

TYPED_TEST_SUITE(Dimensions, BothDimensions);

TYPED_TEST(Dimensions, functions_sum_to_one_and_are_not_negative)
{
  constexpr int dim = TypeParam::value;
  for (const unsigned int p : {1, 2, 3})
    for (const bool periodic : {false, true})
      {
        const auto space = graded<dim>(p, periodic);
        for (const auto &point : random_points<dim>(50))
          {
            std::vector<double>         N;
            std::vector<Tensor<1, dim>> dN;
            space->evaluate(space->find_cell(point), point, N, &dN);
            EXPECT_NEAR(std::accumulate(N.begin(), N.end(), 0.), 1., 1e-12);
            EXPECT_GE(*std::min_element(N.begin(), N.end()), -1e-14);
            EXPECT_NEAR(
              std::accumulate(dN.begin(), dN.end(), Tensor<1, dim>()).norm(),
              0.,
              1e-10);
          }
      }
}

TYPED_TEST(Dimensions, functions_are_linearly_independent)
{
  constexpr int      dim     = TypeParam::value;
  const auto         space   = graded<dim>(2, true);
  const auto         gramian = L2Projection<dim>::gramian(*space->hierarchy());
  const unsigned int n       = gramian.m();
  dealii::LAPACKFullMatrix<double> scaled(n, n);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      scaled(i, j) = gramian(i, j) / std::sqrt(gramian(i, i) * gramian(j, j));
  dealii::FullMatrix<double> vectors;
  dealii::Vector<double>     eigenvalues;
  scaled.compute_eigenvalues_symmetric(-1., 1e3, 0., eigenvalues, vectors);
  ASSERT_EQ(eigenvalues.size(), n);
  EXPECT_GT(*std::min_element(eigenvalues.begin(), eigenvalues.end()), 1e-6);
}

TYPED_TEST(Dimensions, polynomials_of_the_degree_are_splines)
{
  constexpr int dim = TypeParam::value;
  for (const unsigned int p : {1, 2, 3})
    {
      const auto space = graded<dim>(p, false);
      const auto f     = [p](const Point<dim> &x) {
        double product = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          product *= std::pow(x[d] - 0.3 - 0.1 * d, p);
        return std::vector<double>{product};
      };
      const auto c = space->project(f, 1)[0];
      for (const auto &point : random_points<dim>(30))
        EXPECT_NEAR(value(*space, c, point), f(point)[0], 1e-11);
    }
}

TYPED_TEST(Dimensions, refinement_keeps_splines_and_coarsening_returns_them)
{
  constexpr int dim = TypeParam::value;
  for (const unsigned int p : {1, 2, 3})
    {
      auto       space  = graded<dim>(p, true);
      const auto before = space->hierarchy();
      const auto c      = example::random_coefficients(before->n_functions());
      std::vector<double> expected;
      for (const auto &point : random_points<dim>(30))
        expected.push_back(value(*space, c, point));
      space->refine_to_level(1, [](const Point<dim> &low, const Point<dim> &) {
        return low[dim - 1] < 0.5;
      });
      const auto               fine = space->hierarchy();
      const SpaceTransfer<dim> up(*before, *fine);
      ASSERT_GT(fine->n_functions(), before->n_functions());
      ASSERT_TRUE(up.is_exact());
      const auto   refined = up.apply(c);
      unsigned int i       = 0;
      for (const auto &point : random_points<dim>(30))
        EXPECT_NEAR(value(*space, refined, point), expected[i++], 1e-12);
      space->refine_like(*before);
      const auto back =
        SpaceTransfer<dim>(*fine, *space->hierarchy()).apply(refined);
      ASSERT_EQ(back.size(), c.size());
      for (unsigned int a = 0; a < c.size(); ++a)
        EXPECT_NEAR(back[a], c[a], 1e-10);
    }
}

// The identity plus a shear: each face is a parallelogram of known area and
// normal. X = (x + 0.5 z, y, z) with z the last parameter.
TYPED_TEST(Dimensions, measures_and_normals_of_a_sheared_box)
{
  constexpr int dim   = TypeParam::value;
  const auto    space = graded<dim>(2, false);
  const auto    shear = [](Point<dim> x) {
    x[0] += 0.5 * x[dim - 1];
    return x;
  };
  const auto geometry = PatchGeometry<dim>::from_map(*space, shear);
  const auto cells    = tabulate_cells(*space, geometry, QGauss<dim>(3));
  EXPECT_NEAR(std::accumulate(cells.JxW.begin(), cells.JxW.end(), 0.),
              1.,
              1e-12);
  for (const Edge edge : all_edges<dim>())
    {
      const auto table =
        tabulate_edge(*space, geometry, edge, QGauss<dim - 1>(3));
      Tensor<1, dim>     normal;
      const unsigned int d = normal_direction<dim>(edge);
      normal[d]            = is_at_end(edge) ? 1. : -1.;
      double area          = 1.;
      if (d == 0)
        {
          normal[dim - 1] = -0.5 * normal[0];
          area            = normal.norm();
          normal /= area;
        }
      EXPECT_NEAR(std::accumulate(table.JxW.begin(), table.JxW.end(), 0.),
                  area,
                  1e-12);
      for (unsigned int q = 0; q < table.JxW.size(); ++q)
        {
          EXPECT_NEAR((table.normal[q] - normal).norm(), 0., 1e-10);
          for (unsigned int k = 0; k < dim - 1; ++k)
            EXPECT_NEAR(table.tangent[(dim - 1) * q + k] * normal, 0., 1e-10);
        }
    }
}

TYPED_TEST(Dimensions, refined_everywhere_it_has_the_b_splines_of_finer_knots)
{
  constexpr int dim = TypeParam::value;
  for (const unsigned int p : {1, 2, 3})
    for (const bool periodic : {false, true})
      {
        const auto space = graded<dim>(p, periodic, 1, 0);
        auto       fine  = knots<dim>(p, periodic);
        for (KnotVector &direction : fine)
          direction = direction.dyadic_refinement();
        for (const auto &point : random_points<dim>(30))
          {
            const unsigned int          cell = space->find_cell(point);
            std::vector<double>         N;
            std::vector<Tensor<1, dim>> dN;
            space->evaluate(cell, point, N, &dN);
            ASSERT_EQ(N.size(), std::pow(p + 1, dim));
            for (unsigned int a = 0; a < N.size(); ++a)
              {
                double         product = 1.;
                Tensor<1, dim> gradient;
                for (unsigned int d = 0; d < dim; ++d)
                  gradient[d] = 1.;
                unsigned int number = 0, stride = 1, rest = a;
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    const unsigned int span = fine[d].find_span(point[d]);
                    const auto         B = fine[d].evaluate(span, point[d], 1);
                    const unsigned int k = rest % (p + 1);
                    rest /= p + 1;
                    product *= B[0][k];
                    for (unsigned int e = 0; e < dim; ++e)
                      gradient[e] *= B[d == e ? 1 : 0][k];
                    number += stride * fine[d].span_functions(span)[k];
                    stride *= fine[d].n_basis();
                  }
                EXPECT_EQ(space->cell_functions(cell)[a], number);
                EXPECT_NEAR(N[a], product, 1e-13);
                EXPECT_NEAR((dN[a] - gradient).norm(), 0., 1e-10);
              }
          }
      }
}

// Preservation of coefficients (H. Speleers, C. Manni, Numer. Math. 132 (2016)
// 155-184): a spline of level 0 has the coefficients of level 0 that it has
// without refinement, truncated or not.
TYPED_TEST(Dimensions, truncated_functions_keep_their_coefficients)
{
  constexpr int dim      = TypeParam::value;
  const auto    coarse   = graded<dim>(2, true, 0, 0)->hierarchy();
  const auto    fine     = graded<dim>(2, true)->hierarchy();
  const auto    c        = example::random_coefficients(coarse->n_functions());
  const auto    refined  = SpaceTransfer<dim>(*coarse, *fine).apply(c);
  unsigned int  compared = 0;
  for (unsigned int a = 0; a < fine->n_functions(); ++a)
    {
      const auto [cell, place] = fine->function_home(a);
      if (fine->cell_index(cell).level > 0)
        continue;
      const auto         box  = fine->cell_box(cell);
      const unsigned int same = coarse->find_cell(
        Point<dim>(box.first + 0.5 * (box.second - box.first)));
      EXPECT_NEAR(refined[a], c[coarse->cell_functions(same)[place]], 1e-12);
      ++compared;
    }
  EXPECT_GT(compared, 0u);
  EXPECT_LT(compared, coarse->n_functions());
}

TYPED_TEST(Dimensions, splines_repeat_after_the_period_in_each_direction)
{
  constexpr int dim   = TypeParam::value;
  const auto    space = graded<dim>(3, true);
  const auto    c     = example::random_coefficients(space->n_functions());
  for (const auto &point : random_points<dim>(30))
    for (unsigned int d = 0; d + 1 < dim; ++d)
      {
        Point<dim> shifted = point, before = point, after = point;
        shifted[d] += 1.;
        before[d] = -1e-9;
        after[d]  = 1e-9;
        EXPECT_NEAR(value(*space, c, shifted), value(*space, c, point), 1e-11);
        EXPECT_NEAR(value(*space, c, before), value(*space, c, after), 1e-6);
        EXPECT_LE(
          std::abs(
            int(
              space->hierarchy()->cell_index(space->find_cell(before)).level) -
            int(space->hierarchy()->cell_index(space->find_cell(after)).level)),
          1);
      }
}

TYPED_TEST(Dimensions, projection_converges_with_order_p_plus_one)
{
  constexpr int dim = TypeParam::value;
  for (const unsigned int p : {1, 2, 3})
    {
      std::vector<double> errors;
      for (const unsigned int level : {3 - dim, 4 - dim})
        {
          const auto space = graded<dim>(p, true, level, 1);
          const auto f     = [](const Point<dim> &x) {
            double product = std::exp(x[dim - 1]);
            for (unsigned int d = 0; d + 1 < dim; ++d)
              product *= std::cos(2. * M_PI * x[d]);
            return std::vector<double>{product};
          };
          const auto c     = space->project(f, 1, 0.)[0];
          const auto table = tabulate_cells(*space, {}, QGauss<dim>(p + 2));
          double     error = 0.;
          for (const auto &element : table.elements)
            for (unsigned int q = 0; q < table.points_per_element; ++q)
              {
                const unsigned int point      = element.first_point + q;
                double             difference = -f(table.parameter[point])[0];
                for (unsigned int a = 0; a < element.functions.size(); ++a)
                  difference +=
                    element.values[q * element.functions.size() + a] *
                    c[element.functions[a]];
                error += difference * difference * table.JxW[point];
              }
          errors.push_back(std::sqrt(error));
        }
      EXPECT_GT(std::log2(errors[0] / errors[1]), p + 0.8) << p;
    }
}

TYPED_TEST(Dimensions, transferred_histories_keep_integral_and_bounds)
{
  constexpr int     dim = TypeParam::value;
  const QGauss<dim> quadrature(3);
  auto              space = graded<dim>(2, true);
  const auto        from  = space->hierarchy();
  const auto        old =
    example::random_coefficients(from->n_cells() * quadrature.size());
  const auto integral = [&](const std::vector<double> &values) {
    const auto table = tabulate_cells(*space, {}, quadrature);
    return std::inner_product(values.begin(),
                              values.end(),
                              table.JxW.begin(),
                              0.);
  };
  const double before = integral(old);
  const auto   bounds = std::minmax_element(old.begin(), old.end());
  for (const bool coarsen : {false, true})
    {
      if (coarsen)
        space->refine_like(*graded<dim>(2, true, 0, 0)->hierarchy());
      else
        space->refine_to_level(2,
                               [](const Point<dim> &low, const Point<dim> &) {
                                 return low[dim - 1] < 0.1;
                               });
      const auto values =
        transfer_history(*from, *space->hierarchy(), quadrature, old, 1);
      EXPECT_NEAR(integral(values), before, 1e-12);
      for (const double v : values)
        {
          EXPECT_GE(v, *bounds.first);
          EXPECT_LE(v, *bounds.second);
        }
    }
}
