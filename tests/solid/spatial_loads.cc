#include <asperity/constitutive/hyperelasticity.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include "loaded_solid.h"

// Loads on faces in three dimensions, and the sphere that needs them.

namespace
{
  using namespace loaded_solid;

  /** @param refined with elements half as long in a quarter of the box */
  std::shared_ptr<SplineSpace<3>>
  make_box(const unsigned int degree, const unsigned int n, const bool refined)
  {
    const KnotVector knots(degree, equal_spans(n));
    auto             space = std::make_shared<SplineSpace<3>>(
      std::array<KnotVector, 3>{{knots, knots, knots}});
    if (refined)
      space->refine_to_level(1, [](const Point<3> &low, const Point<3> &) {
        return low[0] < 0.5 - 1e-9 && low[2] < 0.5 - 1e-9;
      });
    return space;
  }

  /**
   * A part of a thick elastic sphere under a small pressure p inside, between
   * the planes x = 0, y = 0, x = z and y = z, on which the solution of Lame is
   * prescribed: u_r = A r + B/r^2,
   *   A = p a^3/(b^3 - a^3) (1 - 2 nu)/E,
   *   B = p a^3 b^3/(b^3 - a^3) (1 + nu)/(2 E);
   * S. P. Timoshenko, J. N. Goodier, Theory of Elasticity (1970), section 136.
   */
  struct ThickSphere
  {
    static constexpr double inner = 1., outer = 2.; ///< a, b [m]
    static constexpr double E = 1e6, nu = 0.3, p = 1.;
    static constexpr double a3 = inner * inner * inner,
                            b3 = outer * outer * outer;
    static constexpr double A  = p * a3 / (b3 - a3) * (1. - 2. * nu) / E,
                            B  = p * a3 * b3 / (b3 - a3) * (1. + nu) / (2. * E);

    static Point<3>
    map(const Point<3> &xi)
    {
      Tensor<1, 3> direction = Point<3>(xi[0], xi[1], 1.);
      direction /= direction.norm();
      return Point<3>((inner + (outer - inner) * xi[2]) * direction);
    }

    static Tensor<1, 3>
    displacement(const Point<3> &X)
    {
      const double r = X.norm();
      return (A + B / (r * r * r)) * X;
    }

    static Tensor<2, 3>
    gradient(const Point<3> &X)
    {
      const double r      = X.norm();
      Tensor<2, 3> result = -3. * B / std::pow(r, 5) * outer_product(X, X);
      for (unsigned int i = 0; i < 3; ++i)
        result[i][i] += A + B / (r * r * r);
      return result;
    }

    ThickSphere(const unsigned int degree,
                const unsigned int n,
                const bool         refined)
      : space(make_box(degree, n, refined))
      , geometry(PatchGeometry<3>::from_map(*space, map))
      , solid(space, geometry, law())
      , load(EdgeLoad<3>::follower_pressure(*space,
                                            geometry,
                                            Edge::bottom,
                                            [](const Point<3> &) { return p; }))
      , u(3 * space->n_functions())
    {
      const auto c = space->project(
        [](const Point<3> &xi) {
          const Tensor<1, 3> exact = displacement(map(xi));
          return std::vector<double>{exact[0], exact[1], exact[2]};
        },
        3);
      Vector target(u.size());
      for (unsigned int i = 0; i < u.size(); ++i)
        target(i) = c[i % 3][i / 3];
      dealii::AffineConstraints<double> constraints;
      for (const Edge face : {Edge::left, Edge::right, Edge::front, Edge::back})
        for (const unsigned int a : space->edge_functions(face))
          for (unsigned int i = 0; i < 3; ++i)
            constraints.add_line(displacement_dof<3>(a, i));
      constraints.close();
      Equilibrium equilibrium(u.size(),
                              std::vector<ForceTerm *>{&solid, &load},
                              constraints,
                              LinearSolverKind::cholmod);
      EXPECT_TRUE(equilibrium.prescribe(u, target));
      NewtonStatistics        statistics;
      const ConvergenceReport report =
        newton(equilibrium, u, newton_options(1e-9), statistics);
      EXPECT_TRUE(report.converged) << report.reason;
    }

    static std::shared_ptr<const MaterialLaw>
    law()
    {
      ElasticParameters elasticity;
      elasticity.young_modulus = E;
      elasticity.poisson_ratio = nu;
      return std::make_shared<NeoHooke>(elasticity);
    }

    /** L2 norms of the errors of u and of its gradient, over those of u. */
    std::array<double, 2>
    errors() const
    {
      const auto table = tabulate_cells(*space,
                                        geometry,
                                        dealii::QGauss<3>(space->degree() + 2));
      double     error = 0., slope = 0., all = 0., slopes = 0.;
      for (const auto &entry : table.elements)
        {
          const ElementView<3> element(table, entry);
          for (unsigned int q = 0; q < table.points_per_element; ++q)
            {
              const Point<3> &X = table.position[element.point(q)];
              Tensor<1, 3>    v;
              Tensor<2, 3>    H;
              element.add_displacement(q, u, v);
              for (unsigned int a = 0; a < element.n_functions(); ++a)
                for (unsigned int i = 0; i < 3; ++i)
                  H[i] += u(element.dof(a, i)) * element.gradient(q, a);
              error += element.JxW(q) * (v - displacement(X)).norm_square();
              slope += element.JxW(q) * (H - gradient(X)).norm_square();
              all += element.JxW(q) * displacement(X).norm_square();
              slopes += element.JxW(q) * gradient(X).norm_square();
            }
        }
      return {{std::sqrt(error / all), std::sqrt(slope / slopes)}};
    }

    std::shared_ptr<SplineSpace<3>> space;
    PatchGeometry<3>                geometry;
    SolidAssembler<3>               solid;
    EdgeLoad<3>                     load;
    Vector                          u;
  };
} // namespace



// Orders p + 1 and p, on locally refined meshes, too; the pressure is so small
// that the strains are.
TEST(ThickSphere, converges_to_the_solution_of_lame_with_the_optimal_orders)
{
  for (const bool refined : {false, true})
    for (const unsigned int degree : {1, 2, 3})
      {
        const auto coarse = ThickSphere(degree, 2, refined).errors(),
                   fine   = ThickSphere(degree, 4, refined).errors();
        EXPECT_GT(std::log2(coarse[0] / fine[0]), degree + 1. - 0.3)
          << "degree " << degree << ": " << coarse[0] << ", " << fine[0];
        EXPECT_GT(std::log2(coarse[1] / fine[1]), degree - 0.3)
          << "degree " << degree << ": " << coarse[1] << ", " << fine[1];
      }
}



TEST(SpatialLoad, follower_tangent_is_the_derivative_of_its_force)
{
  const auto space    = make_box(2, 2, false);
  const auto geometry = bent(*space);
  const auto n        = 3 * space->n_functions();
  for (const Edge face : all_edges<3>())
    {
      auto load = EdgeLoad<3>::follower_pressure(
        *space, geometry, face, [](const Point<3> &X) {
          return 2. + X[0] - X[1] * X[2];
        });
      dealii::DynamicSparsityPattern couplings(n);
      load.add_couplings(couplings);
      dealii::SparsityPattern pattern;
      pattern.copy_from(couplings);
      Matrix       tangent(pattern);
      const Vector u = random_vector(n, 0.05), d = random_vector(n, 1.);
      const double h = 1e-6;
      Vector       R(n), product(n), plus(u), minus(u), high(n), low(n);
      load.add(u, R, &tangent);
      tangent.vmult(product, d);
      plus.add(h, d);
      minus.add(-h, d);
      load.add(plus, high, nullptr);
      load.add(minus, low, nullptr);
      high -= low;
      high /= 2. * h;
      high -= product;
      EXPECT_LT(high.linfty_norm(), 1e-8 * product.linfty_norm());
    }
}



// Pressure pushes inwards on every face, and dead traction sums up to its
// integral.
TEST(SpatialLoad, uniform_pressure_all_around_has_no_resultant)
{
  const auto space    = make_box(2, 2, false);
  const auto geometry = bent(*space);
  Vector     R(3 * space->n_functions()), top(R);
  const auto u = random_vector(R.size(), 0.05);
  for (const Edge face : all_edges<3>())
    EdgeLoad<3>::follower_pressure(*space,
                                   geometry,
                                   face,
                                   [](const Point<3> &) { return 5.; })
      .add(u, R, nullptr);
  const PatchGeometry<3> unit_box;
  EdgeLoad<3>::dead_traction(*space,
                             unit_box,
                             Edge::top,
                             [](const Point<3> &X, const Tensor<1, 3> &N) {
                               return X[0] * N;
                             })
    .add(u, top, nullptr);
  Tensor<1, 3> sum, dead;
  for (unsigned int i = 0; i < R.size(); ++i)
    {
      sum[i % 3] += R(i);
      dead[i % 3] -= top(i);
    }
  EXPECT_LT(sum.norm(), 1e-12 * R.l1_norm());
  EXPECT_NEAR(dead[2], 0.5, 1e-12);
  EXPECT_NEAR(std::abs(dead[0]) + std::abs(dead[1]), 0., 1e-12);
}
