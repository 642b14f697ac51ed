#include <asperity/isogeometric/space_transfer.h>

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
  bool
  around_a_point(const Point<2> &low, const Point<2> &high)
  {
    return low[0] < 0.7 && high[0] > 0.5 && high[1] > 0.6;
  }

  /** Integral over the parameters of a spline squared error. */
  double
  squared_distance(const SplineSpace<2>      &a,
                   const std::vector<double> &u,
                   const SplineSpace<2>      &b,
                   const std::vector<double> &v,
                   const SplineSpace<2>      &fine)
  {
    double     sum   = 0.;
    const auto table = tabulate_cells(fine, {}, QGauss<2>(5));
    for (unsigned int q = 0; q < table.JxW.size(); ++q)
      sum += table.JxW[q] * std::pow(example::value(a, u, table.parameter[q]) -
                                       example::value(b, v, table.parameter[q]),
                                     2);
    return sum;
  }
} // namespace

TEST(SpaceTransfer, refinement_leaves_the_spline_unchanged)
{
  for (auto &[name, space] : example::all())
    {
      const auto before = space->hierarchy();
      const auto c = example::random_coefficients(2 * space->n_functions());
      const auto points = example::random_points(100);
      std::vector<double> expected;
      std::vector<double> first(space->n_functions());
      for (unsigned int a = 0; a < first.size(); ++a)
        first[a] = c[2 * a + 1];
      for (const auto &point : points)
        expected.push_back(example::value(*space, first, point));

      space->refine_to_level(2, around_a_point);
      const SpaceTransfer<2> transfer(*before, *space->hierarchy());
      ASSERT_TRUE(transfer.is_exact());
      const auto d = transfer.apply(c, 2);
      first.resize(space->n_functions());
      for (unsigned int a = 0; a < first.size(); ++a)
        first[a] = d[2 * a + 1];
      for (unsigned int i = 0; i < points.size(); ++i)
        EXPECT_NEAR(example::value(*space, first, points[i]),
                    expected[i],
                    1e-12)
          << name;
    }
}

TEST(SpaceTransfer, an_unchanged_mesh_gives_the_same_coefficients)
{
  for (const auto &[name, space] : example::all())
    {
      const SpaceTransfer<2> transfer(*space->hierarchy(), *space->hierarchy());
      const auto c = example::random_coefficients(space->n_functions());
      const auto d = transfer.apply(c);
      for (unsigned int a = 0; a < c.size(); ++a)
        EXPECT_NEAR(d[a], c[a], 1e-12) << name;
    }
}

TEST(SpaceTransfer, coarsening_is_a_projection)
{
  for (auto &[name, space] : example::all())
    {
      // A spline of the coarse space survives refinement and coarsening.
      const auto coarse = space->hierarchy();
      const auto c      = example::random_coefficients(space->n_functions());
      space->refine_to_level(3, around_a_point);
      const auto fine = space->hierarchy();
      if (fine->n_cells() == coarse->n_cells())
        continue;
      const SpaceTransfer<2> up(*coarse, *fine);
      space->refine_like(*coarse);
      const SpaceTransfer<2> down(*fine, *coarse);
      EXPECT_FALSE(down.is_exact());
      const auto d = down.apply(up.apply(c));
      for (unsigned int a = 0; a < c.size(); ++a)
        EXPECT_NEAR(d[a], c[a], 1e-11) << name;
    }
}

TEST(SpaceTransfer, coarsening_gives_the_nearest_spline)
{
  for (const bool periodic : {false, true})
    {
      const auto coarse = example::uniform(2, periodic);
      const auto fine   = example::graded(2, periodic);
      const auto u      = example::random_coefficients(fine->n_functions());
      const SpaceTransfer<2> transfer(*fine->hierarchy(), *coarse->hierarchy());
      const auto             v = transfer.apply(u);
      const double best        = squared_distance(*fine, u, *coarse, v, *fine);
      for (unsigned int a = 0; a < v.size(); a += 5)
        for (const double change : {-1e-3, 1e-3})
          {
            auto w = v;
            w[a] += change;
            EXPECT_GT(squared_distance(*fine, u, *coarse, w, *fine), best);
          }
    }
}

TEST(SpaceTransfer, geometry_is_the_same_after_refinement)
{
  auto       space = example::uniform(3, true);
  const auto geometry =
    PatchGeometry<2>::from_map(*space, [](const Point<2> &x) {
      return Point<2>(x[0], x[1] * (1. + 0.1 * std::cos(M_PI * x[0])));
    });
  std::vector<Point<2>> expected;
  for (const auto &point : example::random_points(50))
    expected.push_back(geometry.position(*space, point));
  const auto before = space->hierarchy();
  space->refine_to_level(2, around_a_point);
  const auto refined =
    SpaceTransfer<2>(*before, *space->hierarchy()).apply(geometry);
  unsigned int i = 0;
  for (const auto &point : example::random_points(50))
    EXPECT_NEAR((refined.position(*space, point) - expected[i++]).norm(),
                0.,
                1e-13);
}

namespace
{
  /** Values of f at the quadrature points, two components f and -f. */
  template <typename Function>
  std::vector<double>
  history(const SplineSpace<2> &space,
          const QGauss<2>      &quadrature,
          const Function       &f)
  {
    std::vector<double> values;
    for (const auto &x : tabulate_cells(space, {}, quadrature).parameter)
      values.insert(values.end(), {f(x), -f(x)});
    return values;
  }

  double
  integral(const SplineSpace<2>      &space,
           const QGauss<2>           &quadrature,
           const std::vector<double> &values)
  {
    const auto table = tabulate_cells(space, {}, quadrature);
    double     sum   = 0.;
    for (unsigned int q = 0; q < table.JxW.size(); ++q)
      sum += table.JxW[q] * values[2 * q];
    return sum;
  }
} // namespace

TEST(HistoryTransfer, keeps_constants_integrals_and_bounds)
{
  for (unsigned int n = 1; n <= 4; ++n)
    for (const bool coarsen : {false, true})
      {
        const QGauss<2> quadrature(n);
        auto            space = example::graded(2, true);
        if (coarsen)
          space->refine_to_level(2, around_a_point);
        const auto front = [](const Point<2> &x) {
          return std::max(0., x[0] * x[0] + x[1] - 0.8);
        };
        const auto   old    = history(*space, quadrature, front);
        const double before = integral(*space, quadrature, old);
        const auto   constant =
          history(*space, quadrature, [](const Point<2> &) { return 0.7; });

        const auto from = space->hierarchy();
        if (coarsen)
          space->refine_like(*example::uniform(2, true)->hierarchy());
        else
          space->refine_to_level(3, around_a_point);
        const auto to = space->hierarchy();
        ASSERT_NE(from->n_cells(), to->n_cells());

        const auto values = transfer_history(*from, *to, quadrature, old, 2);
        ASSERT_EQ(values.size(), 2 * to->n_cells() * quadrature.size());
        EXPECT_NEAR(integral(*space, quadrature, values), before, 1e-13);
        const auto low  = *std::min_element(old.begin(), old.end());
        const auto high = *std::max_element(old.begin(), old.end());
        for (unsigned int i = 0; i < values.size(); i += 2)
          {
            EXPECT_GE(values[i], 0.);
            EXPECT_LE(values[i], high);
            EXPECT_GE(values[i + 1], low);
            // The transfer is odd: both signs are treated alike.
            EXPECT_NEAR(values[i + 1], -values[i], 1e-14);
          }
        const auto same = transfer_history(*from, *to, quadrature, constant, 2);
        for (unsigned int i = 0; i < same.size(); ++i)
          EXPECT_NEAR(same[i], i % 2 == 0 ? 0.7 : -0.7, 1e-14);
      }
}

TEST(HistoryTransfer, cells_of_both_meshes_keep_their_values)
{
  const QGauss<2> quadrature(3);
  auto            space = example::uniform(3, true);
  const auto      from  = space->hierarchy();
  const auto      old =
    example::random_coefficients(3 * from->n_cells() * quadrature.size());
  space->refine_to_level(2, around_a_point);
  const auto   to     = space->hierarchy();
  const auto   values = transfer_history(*from, *to, quadrature, old, 3);
  unsigned int n_kept = 0;
  for (unsigned int cell = 0; cell < to->n_cells(); ++cell)
    {
      const auto &node = from->nodes()[from->find_node(to->cell_index(cell))];
      if (!(node.index == to->cell_index(cell)))
        continue;
      ++n_kept;
      for (unsigned int i = 0; i < 27; ++i)
        EXPECT_EQ(values[cell * 27 + i], old[node.cell * 27 + i]);
    }
  EXPECT_GT(n_kept, 0);
}

TEST(HistoryTransfer, values_of_a_child_stay_in_the_range_of_its_parent)
{
  const QGauss<2> quadrature(4);
  auto            space = example::uniform(3, true);
  const auto      from  = space->hierarchy();
  const auto      old =
    example::random_coefficients(from->n_cells() * quadrature.size());
  space->refine_to_level(2, around_a_point);
  const auto to     = space->hierarchy();
  const auto values = transfer_history(*from, *to, quadrature, old, 1, 3);
  for (unsigned int cell = 0; cell < to->n_cells(); ++cell)
    {
      const auto parent =
        from->nodes()[from->find_node(to->cell_index(cell))].cell;
      const auto begin = old.begin() + 16 * parent;
      for (unsigned int q = 0; q < 16; ++q)
        {
          EXPECT_GE(values[16 * cell + q],
                    *std::min_element(begin, begin + 16));
          EXPECT_LE(values[16 * cell + q],
                    *std::max_element(begin, begin + 16));
        }
    }
}

TEST(HistoryTransfer, refined_values_converge_to_a_smooth_field)
{
  // Clamping to the range of the parent flattens the slope within a cell, so
  // the values are first-order accurate at a point, the means exact. Parabolas
  // that are left alone are third-order accurate.
  const QGauss<2>           quadrature(3);
  const auto                ranges = {HistoryRange::cell, HistoryRange::none};
  std::vector<double>       before(2, 0.);
  const std::vector<double> rates = {1.8, 6.};
  for (const unsigned int level : {1, 2, 3})
    {
      auto       space      = example::uniform(2, true);
      const auto everywhere = [](const Point<2> &, const Point<2> &) {
        return true;
      };
      space->refine_to_level(level, everywhere);
      const auto f = [](const Point<2> &x) {
        return std::sin(M_PI * x[0]) * std::exp(x[1]);
      };
      const auto old  = history(*space, quadrature, f);
      const auto from = space->hierarchy();
      space->refine_to_level(level + 1, everywhere);
      const auto   exact  = history(*space, quadrature, f);
      unsigned int number = 0;
      for (const HistoryRange range : ranges)
        {
          const auto values = transfer_history(
            *from, *space->hierarchy(), quadrature, old, 2, 2, range);
          double error = 0.;
          for (unsigned int i = 0; i < exact.size(); ++i)
            error = std::max(error, std::abs(values[i] - exact[i]));
          if (level > 1)
            EXPECT_GT(before[number] / error, rates[number]);
          before[number++] = error;
        }
    }
}

TEST(HistoryTransfer, values_keep_the_range_of_the_body_where_that_is_asked_for)
{
  const QGauss<2> quadrature(2);
  auto            space = example::uniform(2, true);
  const auto      front = [](const Point<2> &x) {
    return std::max(0., x[0] + x[1] - 0.8);
  };
  const auto from = space->hierarchy();
  const auto old  = history(*space, quadrature, front);
  space->refine_to_level(2, around_a_point);
  const auto values = transfer_history(
    *from, *space->hierarchy(), quadrature, old, 2, 2, HistoryRange::body);
  const auto high = *std::max_element(old.begin(), old.end());
  for (unsigned int i = 0; i < values.size(); i += 2)
    {
      EXPECT_GE(values[i], 0.);
      EXPECT_LE(values[i], high);
      EXPECT_NEAR(values[i + 1], -values[i], 1e-14);
    }
  EXPECT_NEAR(integral(*space, quadrature, values),
              integral(*example::uniform(2, true), quadrature, old),
              1e-13);
}

// Two Gauss points of each child lie at t = -+1/2 -+ 1/(2 sqrt(3)) of the
// parent's [-1, 1], where t^2 is 1/3 -+ 1/(2 sqrt(3)); its linear fit is 1/3.
TEST(HistoryTransfer, tells_what_a_coarsening_would_lose)
{
  const std::vector<double> knots = {0., .25, .5, .75, 1.};
  SplineSpace<2> space(KnotVector(2, knots, true), KnotVector(2, knots));
  space.refine_to_level(1, [](const Point<2> &lower, const Point<2> &) {
    return lower[0] < 0.5;
  });
  const QGauss<2>     quadrature(2);
  std::vector<double> linear, square;
  for (const auto &x : tabulate_cells(space, {}, quadrature).parameter)
    {
      linear.push_back(2. - x[0] + 3. * x[0] * x[1]);
      square.push_back(x[0] * x[0]);
    }
  const SplineHierarchy<2> &hierarchy = *space.hierarchy();
  const auto   none     = coarsening_loss(hierarchy, quadrature, linear);
  const auto   loss     = coarsening_loss(hierarchy, quadrature, square);
  const double expected = 0.125 * 0.125 / (2. * std::sqrt(3.));
  for (unsigned int cell = 0; cell < hierarchy.n_cells(); ++cell)
    {
      EXPECT_NEAR(none[cell], 0., 1e-13);
      EXPECT_NEAR(loss[cell],
                  hierarchy.cell_index(cell).level == 1 ? expected : 0.,
                  1e-13);
    }
}
