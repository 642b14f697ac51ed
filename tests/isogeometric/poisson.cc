#include <asperity/isogeometric/space_transfer.h>
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

#include "example_spaces.h"

using namespace asperity;
using dealii::Point;
using dealii::Tensor;

namespace
{
  // -div grad u = f with u = 0 on the flat bottom y = 0 and the exact normal
  // derivative elsewhere. u = sin(y) g(x); g is 2-periodic for the periodic
  // patch and otherwise a bump at x = 0.6, y = 1.
  struct Solution
  {
    bool periodic;

    double
    value(const Point<2> &x) const
    {
      return periodic ? std::sin(x[1]) * std::cos(M_PI * x[0]) :
                        x[1] * std::exp(-radius(x));
    }

    Tensor<1, 2>
    gradient(const Point<2> &x) const
    {
      Tensor<1, 2> g;
      if (periodic)
        {
          g[0] = -M_PI * std::sin(x[1]) * std::sin(M_PI * x[0]);
          g[1] = std::cos(x[1]) * std::cos(M_PI * x[0]);
        }
      else
        {
          const double e = std::exp(-radius(x));
          g[0]           = -2. * k * (x[0] - 0.6) * x[1] * e;
          g[1]           = e - 2. * k * (x[1] - 1.) * x[1] * e;
        }
      return g;
    }

    double
    source(const Point<2> &x) const
    {
      if (periodic)
        return (1. + M_PI * M_PI) * value(x);
      // Laplacian of y e: y (4 k r - 4 k) e + 2 de/dy.
      const double e = std::exp(-radius(x));
      return -(x[1] * (4. * k * radius(x) - 4. * k) * e -
               4. * k * (x[1] - 1.) * e);
    }

  private:
    static constexpr double k = 6.;

    static double
    radius(const Point<2> &x)
    {
      return k * ((x[0] - 0.6) * (x[0] - 0.6) + (x[1] - 1.) * (x[1] - 1.));
    }
  };

  struct Errors
  {
    double       L2 = 0., H1 = 0.;
    unsigned int n_functions = 0;
  };

  void
  assemble_cells(const BasisTable<2>          &cells,
                 const Solution               &exact,
                 dealii::SparseMatrix<double> &matrix,
                 dealii::Vector<double>       &load)
  {
    dealii::FullMatrix<double> cell_matrix;
    for (const auto &element : cells.elements)
      {
        const unsigned int n_a = element.functions.size();
        cell_matrix.reinit(n_a, n_a);
        for (unsigned int q = 0; q < cells.points_per_element; ++q)
          {
            const unsigned int point  = element.first_point + q;
            const double       source = exact.source(cells.position[point]);
            for (unsigned int a = 0; a < n_a; ++a)
              {
                load[element.functions[a]] +=
                  element.values[q * n_a + a] * source * cells.JxW[point];
                for (unsigned int b = 0; b < n_a; ++b)
                  cell_matrix(a, b) += element.gradients[q * n_a + a] *
                                       element.gradients[q * n_a + b] *
                                       cells.JxW[point];
              }
          }
        matrix.add(element.functions, cell_matrix);
      }
  }

  void
  add_normal_derivatives(const SplineSpace<2>   &space,
                         const PatchGeometry<2> &geometry,
                         const Solution         &exact,
                         dealii::Vector<double> &load)
  {
    std::vector<Edge> loaded{Edge::top};
    if (!space.is_periodic(0))
      loaded = {Edge::top, Edge::left, Edge::right};
    for (const Edge edge : loaded)
      {
        const auto table = tabulate_edge(
          space, geometry, edge, dealii::QGauss<1>(space.degree() + 2), true);
        for (const auto &element : table.elements)
          for (unsigned int q = 0; q < table.points_per_element; ++q)
            for (unsigned int a = 0; a < element.functions.size(); ++a)
              load[element.functions[a]] +=
                element.values[q * element.functions.size() + a] *
                (exact.gradient(table.position[element.first_point + q]) *
                 table.normal[element.first_point + q]) *
                table.JxW[element.first_point + q];
      }
  }

  Errors
  measure(const SplineSpace<2>         &space,
          const PatchGeometry<2>       &geometry,
          const Solution               &exact,
          const dealii::Vector<double> &u)
  {
    Errors     errors;
    const auto fine =
      tabulate_cells(space, geometry, dealii::QGauss<2>(space.degree() + 3));
    for (const auto &element : fine.elements)
      for (unsigned int q = 0; q < fine.points_per_element; ++q)
        {
          const unsigned int point    = element.first_point + q;
          const unsigned int n_a      = element.functions.size();
          double             value    = -exact.value(fine.position[point]);
          Tensor<1, 2>       gradient = -exact.gradient(fine.position[point]);
          for (unsigned int a = 0; a < n_a; ++a)
            {
              value += element.values[q * n_a + a] * u[element.functions[a]];
              gradient +=
                element.gradients[q * n_a + a] * u[element.functions[a]];
            }
          errors.L2 += value * value * fine.JxW[point];
          errors.H1 += gradient.norm_square() * fine.JxW[point];
        }
    errors.L2          = std::sqrt(errors.L2);
    errors.H1          = std::sqrt(errors.H1);
    errors.n_functions = space.n_functions();
    return errors;
  }

  Errors
  solve(const SplineSpace<2>   &space,
        const PatchGeometry<2> &geometry,
        const Solution         &exact)
  {
    const auto cells =
      tabulate_cells(space, geometry, dealii::QGauss<2>(space.degree() + 2));
    dealii::DynamicSparsityPattern pattern(space.n_functions());
    for (const auto &element : cells.elements)
      for (const unsigned int i : element.functions)
        for (const unsigned int j : element.functions)
          pattern.add(i, j);
    dealii::SparsityPattern sparsity;
    sparsity.copy_from(pattern);
    dealii::SparseMatrix<double> matrix(sparsity);
    dealii::Vector<double>       u(space.n_functions());
    assemble_cells(cells, exact, matrix, u);
    add_normal_derivatives(space, geometry, exact, u);
    for (const unsigned int fixed : space.edge_functions(Edge::bottom))
      {
        for (auto entry = matrix.begin(fixed); entry != matrix.end(fixed);
             ++entry)
          entry->value() = entry->column() == fixed ? 1. : 0.;
        u[fixed] = 0.;
      }
    dealii::SparseDirectUMFPACK solver;
    solver.initialize(matrix);
    solver.solve(u);
    return measure(space, geometry, exact, u);
  }

  /** A wavy patch over [0, 2] x [0, 1] with a flat bottom, and its geometry. */
  struct Patch
  {
    std::unique_ptr<SplineSpace<2>> space;
    PatchGeometry<2>                geometry;

    Patch(const unsigned int degree,
          const bool         periodic,
          const unsigned int multiplicity = 1)
    {
      space = std::make_unique<SplineSpace<2>>(
        KnotVector(
          degree, {0., 0.4, 0.8, 1.2, 1.6, 2.}, periodic, multiplicity),
        KnotVector(degree, {0., 0.5, 1.}, false, multiplicity));
      geometry = PatchGeometry<2>::from_map(*space, [](const Point<2> &x) {
        return Point<2>(x[0] + 0.1 * std::sin(3. * x[1]),
                        x[1] * (1. + 0.15 * std::sin(M_PI * x[0])));
      });
      for (const unsigned int a : space->edge_functions(Edge::bottom))
        geometry.offset[a][1] = 0.;
    }

    /** The shape stays that of the first mesh. */
    template <typename Wanted>
    void
    refine(const unsigned int level, const Wanted &wanted)
    {
      const auto before = space->hierarchy();
      space->refine_to_level(level, wanted);
      geometry = SpaceTransfer<2>(*before, *space->hierarchy()).apply(geometry);
    }
  };

  /** Degrees to be tested; see example::degrees(). */
  std::vector<unsigned int>
  orders()
  {
#ifdef DEBUG
    return {2};
#else
    return {1, 2, 3, 4};
#endif
  }

  bool
  everywhere(const Point<2> &, const Point<2> &)
  {
    return true;
  }

  /** The surroundings of the bump; across the period if periodic. */
  bool
  near_the_bump(const Point<2> &low, const Point<2> &high)
  {
    return low[0] < 1.05 && high[1] > 0.55;
  }

  void
  expect_order(const std::vector<Errors> &errors,
               const unsigned int         degree,
               const std::string         &name)
  {
    const Errors &coarse = errors[errors.size() - 2];
    const Errors &fine   = errors.back();
    const double  L2     = std::log2(coarse.L2 / fine.L2);
    const double  H1     = std::log2(coarse.H1 / fine.H1);
    std::cout << "  p = " << degree << ", " << name << ": L2 order " << L2
              << ", H1 order " << H1 << ", L2 error " << fine.L2 << '\n';
    EXPECT_GT(L2, degree + 0.85) << name;
    EXPECT_GT(H1, degree - 0.15) << name;
  }
} // namespace

TEST(Poisson, optimal_order_on_a_wavy_patch)
{
  for (const unsigned int p : orders())
    for (const bool periodic : {false, true})
      {
        Patch               patch(p, periodic);
        std::vector<Errors> errors;
        for (unsigned int level = 2; level <= 4; ++level)
          {
            patch.refine(level, everywhere);
            errors.push_back(
              solve(*patch.space, patch.geometry, Solution{periodic}));
          }
        expect_order(errors,
                     p,
                     periodic ? "periodic, uniform" : "open, uniform");
      }
}

TEST(Poisson, optimal_order_on_hierarchical_meshes)
{
  for (const unsigned int p : orders())
    for (const bool periodic : {false, true})
      {
        std::vector<Errors> errors;
        for (unsigned int level = 1; level <= 3; ++level)
          {
            Patch patch(p, periodic);
            patch.refine(level, everywhere);
            patch.refine(level + 1, near_the_bump);
            EXPECT_GT(patch.space->triangulation().n_levels(), level + 1);
            errors.push_back(
              solve(*patch.space, patch.geometry, Solution{periodic}));
          }
        expect_order(errors,
                     p,
                     periodic ? "periodic, hierarchical" :
                                "open, hierarchical");
      }
}

/** Functions of finite elements are splines whose knots are as many as their
 *  degree, on hanging nodes, too. */
TEST(Poisson, optimal_order_with_functions_that_have_kinks)
{
  for (const unsigned int p : {2u, 3u})
    for (const bool periodic : {false, true})
      {
        std::vector<Errors> errors;
        for (unsigned int level = 1; level <= 3; ++level)
          {
            Patch patch(p, periodic, p);
            patch.refine(level, everywhere);
            // p nodes of Q_p a cell and direction.
            const unsigned int n = 5u << level, m = 2u << level;
            EXPECT_EQ(patch.space->n_functions(),
                      (p * n + (periodic ? 0 : 1)) * (p * m + 1));
            patch.refine(level + 1, near_the_bump);
            errors.push_back(
              solve(*patch.space, patch.geometry, Solution{periodic}));
          }
        expect_order(errors, p, periodic ? "periodic, C0" : "open, C0");
      }
}

TEST(Poisson, refining_at_the_bump_halves_the_error_with_few_functions)
{
  for (const unsigned int p : orders())
    {
      if (p == 1)
        continue; // first order gains a factor of two at best
      Patch coarse(p, false), local(p, false), fine(p, false);
      for (Patch *patch : {&coarse, &local, &fine})
        patch->refine(3, everywhere);
      local.refine(4, near_the_bump);
      fine.refine(4, everywhere);
      const Solution exact{false};
      const auto     e0 = solve(*coarse.space, coarse.geometry, exact);
      const auto     e1 = solve(*local.space, local.geometry, exact);
      const auto     e2 = solve(*fine.space, fine.geometry, exact);
      EXPECT_LT(e1.n_functions, 0.75 * e2.n_functions);
      EXPECT_LT(e1.H1, 0.5 * e0.H1);
      // Nested spaces: the energy of the error falls from one to the next.
      EXPECT_LE(e2.H1, e1.H1 * (1. + 1e-6));
    }
}
