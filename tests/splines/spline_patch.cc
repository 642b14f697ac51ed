#include <asperity/base/errors.h>
#include <asperity/splines/bezier_extraction.h>
#include <asperity/splines/patch_search.h>
#include <asperity/splines/spline_patch.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace asperity;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /** Quarter of an annulus, radii 1 and 3; xi along the arc. */
  SplinePatch
  quarter_annulus()
  {
    const double w = std::sqrt(0.5);
    return SplinePatch({{KnotVector(2, {0., 1.}), KnotVector(1, {0., 1.})}},
                       {{1, 0}, {1, 1}, {0, 1}, {3, 0}, {3, 3}, {0, 3}},
                       {1, w, 1, 1, w, 1});
  }



  /** A wavy strip, periodic in x (L = 8). */
  SplinePatch
  strip(const unsigned int p, const bool rational)
  {
    const KnotVector      xi(p, {0., 1., 1.5, 3., 4., 5., 6., 7.5, 8.}, true);
    const KnotVector      eta(p, {0., 0.3, 1., 2.});
    std::vector<Point<2>> points;
    std::vector<double>   weights;
    for (unsigned int j = 0; j < eta.n_basis(); ++j)
      for (unsigned int i = 0; i < xi.n_basis(); ++i)
        {
          points.emplace_back(xi.greville()[i] + 0.1 * std::sin(3. * i + j),
                              eta.greville()[j] + 0.1 * std::cos(2. * i - j));
          if (rational)
            weights.push_back(1. + 0.3 * std::sin(i + 2. * j));
        }
    Tensor<1, 2> period;
    period[0] = 8.;
    return SplinePatch({{xi, eta}}, points, weights, {{period, {}}});
  }



} // namespace



TEST(SplinePatch, nurbs_annulus_has_exact_radii)
{
  const SplinePatch patch = quarter_annulus();
  for (double xi = 0.; xi <= 1.; xi += 0.1)
    for (double eta = 0.; eta <= 1.; eta += 0.25)
      EXPECT_NEAR(patch.value(xi, eta).norm(), 1. + 2. * eta, 1e-14);
  EXPECT_NEAR(patch.edge(1, true).length(0., 1., 20), 1.5 * M_PI, 1e-12);
  EXPECT_NEAR(patch.edge(0, false).length(0., 1.), 2., 1e-14);
}



TEST(SplinePatch, derivatives_equal_finite_differences)
{
  const double h = 1e-5;
  for (const bool rational : {false, true})
    {
      const SplinePatch patch = strip(4, rational);
      for (const double xi : {0.4, 3.3, 7.8, 19.2})
        {
          const double eta  = 0.63;
          const auto   S    = patch.derivatives(xi, eta, 3);
          const auto   east = patch.derivatives(xi + h, eta, 2);
          const auto   west = patch.derivatives(xi - h, eta, 2);
          const auto   up   = patch.derivatives(xi, eta + h, 2);
          const auto   down = patch.derivatives(xi, eta - h, 2);
          for (unsigned int k = 0; k <= 2; ++k)
            for (unsigned int l = 0; k + l <= 2; ++l)
              {
                EXPECT_LT(
                  ((east[k][l] - west[k][l]) / (2. * h) - S[k + 1][l]).norm(),
                  1e-6);
                EXPECT_LT(
                  ((up[k][l] - down[k][l]) / (2. * h) - S[k][l + 1]).norm(),
                  1e-6);
              }
        }
    }
}



TEST(SplinePatch, its_edges_are_curves_on_it)
{
  for (const bool rational : {false, true})
    {
      const SplinePatch patch = strip(3, rational);
      for (double xi = -3.; xi < 12.; xi += 0.3)
        for (const bool back : {false, true})
          EXPECT_LT((patch.value(xi, back ? 2. : 0.) -
                     patch.edge(1, back).value(xi))
                      .norm(),
                    1e-14);
    }
}



TEST(SplinePatch, tensor_product_extraction_gives_the_patch)
{
  const unsigned int p     = 3;
  const SplinePatch  patch = strip(p, false);
  const auto         Cx    = bezier_extraction(patch.knot_vector(0));
  const auto         Cy    = bezier_extraction(patch.knot_vector(1));
  const auto B = KnotVector(p, {0., 1.}).evaluate(0, 0.3)[0]; // Bernstein
  const auto D = KnotVector(p, {0., 1.}).evaluate(0, 0.8)[0];
  for (unsigned int j = 0; j < Cy.size(); ++j)
    for (unsigned int i = 0; i < 5; ++i) // spans that do not wrap
      {
        const auto   C  = tensor_product(Cx[i], Cy[j]);
        const auto   fx = patch.knot_vector(0).span_functions(i);
        const auto   fy = patch.knot_vector(1).span_functions(j);
        Tensor<1, 2> sum;
        for (unsigned int a = 0; a < C.m(); ++a)
          for (unsigned int b = 0; b < C.n(); ++b)
            sum +=
              C(a, b) * B[b % (p + 1)] * D[b / (p + 1)] *
              patch.control_points()[fy[a / (p + 1)] * 8 + fx[a % (p + 1)]];
        const auto &x = patch.knot_vector(0).breakpoints();
        const auto &y = patch.knot_vector(1).breakpoints();
        EXPECT_LT((patch.value(0.7 * x[i] + 0.3 * x[i + 1],
                               0.2 * y[j] + 0.8 * y[j + 1]) -
                   sum)
                    .norm(),
                  1e-14);
      }
}



TEST(PatchSearch, inverts_the_map)
{
  for (const bool rational : {false, true})
    {
      const SplinePatch patch = strip(3, rational);
      const PatchSearch search(patch);
      for (double xi = -11.; xi < 27.; xi += 0.377)
        for (double eta = 0.; eta <= 2.; eta += 0.125)
          {
            const auto result = search.find(patch.value(xi, eta));
            EXPECT_TRUE(result.inside);
            EXPECT_NEAR(result.parameter[0], xi, 1e-9);
            EXPECT_NEAR(result.parameter[1], eta, 1e-9);
          }
      EXPECT_FALSE(search.find(Point<2>(3., 4.)).inside);
      EXPECT_FALSE(search.find(Point<2>(3., -1.)).inside);
    }
}



TEST(SplinePatch, contradicting_input_is_refused)
{
  const std::array<KnotVector, 2> knots = {
    {KnotVector(1, {0., 1.}), KnotVector(1, {0., 1.})}};
  const std::vector<Point<2>> points(4);
  EXPECT_THROW(SplinePatch(knots, std::vector<Point<2>>(3)), InputError);
  EXPECT_THROW(SplinePatch(knots, points, {1., 1.}), InputError);
  EXPECT_THROW(SplinePatch(knots, points, {1., 1., -1., 1.}), InputError);
  EXPECT_THROW(SplinePatch(knots, points, {}, {{Point<2>(1., 0.), {}}}),
               InputError);
  EXPECT_THROW(strip(2, false).edge(0, true), InputError);
}
