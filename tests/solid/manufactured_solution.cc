#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include "loaded_solid.h"

namespace
{
  using namespace loaded_solid;

  /** A displacement of finite strain that vanishes at X = 0, with its first
   *  and second derivatives. It stretches the body everywhere: under dead
   *  tractions that press, the equilibrium would be unstable. */
  struct Solution
  {
    static constexpr double a = 0.3, b = 0.2;

    static Tensor<1, 2>
    value(const Point<2> &X)
    {
      Tensor<1, 2> u;
      u[0] = a * std::sin(X[0]) * std::cos(0.5 * X[1]);
      u[1] = b * X[0] * std::sin(X[1]);
      return u;
    }

    static Tensor<2, 2>
    gradient(const Point<2> &X)
    {
      Tensor<2, 2> G;
      G[0][0] = a * std::cos(X[0]) * std::cos(0.5 * X[1]);
      G[0][1] = -0.5 * a * std::sin(X[0]) * std::sin(0.5 * X[1]);
      G[1][0] = b * std::sin(X[1]);
      G[1][1] = b * X[0] * std::cos(X[1]);
      return G;
    }

    static Tensor<3, 2>
    hessian(const Point<2> &X)
    {
      Tensor<3, 2> H;
      H[0][0][0] = -a * std::sin(X[0]) * std::cos(0.5 * X[1]);
      H[0][0][1] = -0.5 * a * std::cos(X[0]) * std::sin(0.5 * X[1]);
      H[0][1][0] = H[0][0][1];
      H[0][1][1] = -0.25 * a * std::sin(X[0]) * std::cos(0.5 * X[1]);
      H[1][0][1] = b * std::cos(X[1]);
      H[1][1][0] = H[1][0][1];
      H[1][1][1] = -b * X[0] * std::sin(X[1]);
      return H;
    }
  };



  MaterialResponse
  exact_response(const MaterialLaw &law, const Point<2> &X)
  {
    const auto       G = Solution::gradient(X);
    MaterialResponse response;
    Tensor<2, 3>     F = dealii::unit_symmetric_tensor<3>();
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int J = 0; J < 2; ++J)
        F[i][J] += G[i][J];
    law.evaluate(F, MaterialState(), 1., true, response);
    return response;
  }

  /** -Div P of the solution: -dP_iJ/dF_kL u_k,LJ. */
  Tensor<1, 2>
  body_force(const MaterialLaw &law, const Point<2> &X)
  {
    const auto   response = exact_response(law, X);
    const auto   H        = Solution::hessian(X);
    Tensor<1, 2> f;
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int J = 0; J < 2; ++J)
        for (unsigned int k = 0; k < 2; ++k)
          for (unsigned int L = 0; L < 2; ++L)
            f[i] -= response.tangent[i][J][k][L] * H[k][L][J];
    return f;
  }

  Point<2>
  curved(const Point<2> &xi)
  {
    return {xi[0] * (1. + 0.2 * std::sin(2. * xi[1])),
            xi[1] + 0.15 * std::sin(3. * xi[0]) * (1. + xi[1])};
  }

  struct Errors
  {
    double L2 = 0., H1 = 0.;
  };

  Errors
  errors(const Body &body)
  {
    const BasisTable<2> table =
      tabulate_cells(*body.space,
                     body.geometry,
                     dealii::QGauss<2>(body.space->degree() + 3));
    Errors e;
    for (const auto &entry : table.elements)
      {
        const ElementView<2> element(table, entry);
        for (unsigned int q = 0; q < table.points_per_element; ++q)
          {
            const Point<2> X = table.position[element.point(q)];
            Tensor<1, 2>   u = -Solution::value(X);
            Tensor<2, 2>   G = -Solution::gradient(X);
            element.add_displacement(q, body.u, u);
            add_gradient(element, q, body.u, G);
            e.L2 += u.norm_square() * element.JxW(q);
            e.H1 += G.norm_square() * element.JxW(q);
          }
      }
    return {std::sqrt(e.L2), std::sqrt(e.H1)};
  }

  /** Support on the left, the solution's own tractions elsewhere. */
  Errors
  solve(const unsigned int degree, const unsigned int n, const bool refined)
  {
    MaterialParameters material;
    material.choose(NeoHookeParameters());
    material.elasticity.young_modulus            = 1.;
    material.elasticity.poisson_ratio            = 0.3;
    const std::shared_ptr<const MaterialLaw> law = material.make_law();

    auto space = make_space(degree, equal_spans(n), equal_spans(n));
    if (refined)
      space->refine_to_level(1, [](const Point<2> &low, const Point<2> &high) {
        return low[0] < 0.5 - 1e-9 && high[1] > 0.5 + 1e-9;
      });
    Body body(space, curved, law);
    body.clamp(Edge::left);
    for (const Edge edge : {Edge::right, Edge::bottom, Edge::top})
      body.add_traction(edge, [&law](const Point<2> &X, const Tensor<1, 2> &N) {
        const auto   P = exact_response(*law, X).P;
        Tensor<1, 2> t;
        t[0] = P[0][0] * N[0] + P[0][1] * N[1];
        t[1] = P[1][0] * N[0] + P[1][1] * N[1];
        return t;
      });
    add_body_force(
      body.solid,
      [&law](const Point<2> &X) { return body_force(*law, X); },
      body.load);
    body.solve(1e-13);
    return errors(body);
  }

  void
  expect_optimal_order(const bool refined)
  {
    for (unsigned int degree = 1; degree <= 4; ++degree)
      {
        const unsigned int n      = degree == 1 ? 16 : 8;
        const Errors       coarse = solve(degree, n, refined);
        const Errors       fine   = solve(degree, 2 * n, refined);
        const double       L2     = std::log2(coarse.L2 / fine.L2);
        const double       H1     = std::log2(coarse.H1 / fine.H1);
        // Orders beyond the optimal ones are no fault on coarse meshes.
        EXPECT_GT(L2, degree + 1. - 0.15) << "degree " << degree;
        EXPECT_LT(L2, degree + 1. + 0.5);
        EXPECT_GT(H1, degree - 0.15) << "degree " << degree;
        EXPECT_LT(H1, degree + 0.5);
      }
  }
} // namespace



TEST(ManufacturedSolution, neo_hooke_converges_optimally_on_a_curved_body)
{
  expect_optimal_order(false);
}



TEST(ManufacturedSolution, neo_hooke_converges_optimally_on_hierarchical_meshes)
{
  expect_optimal_order(true);
}
