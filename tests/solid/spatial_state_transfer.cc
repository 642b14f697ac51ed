#include <asperity/isogeometric/spline_space.h>
#include <asperity/solid/state_transfer.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "state_transfer_examples.h"

using namespace asperity;
using dealii::Point;

// States of a block whose principal directions lie in no plane.

namespace
{
  using Symmetric = dealii::SymmetricTensor<2, 3>;
  using Gradient  = dealii::Tensor<2, 3>;

  const dealii::QGauss<3> quadrature(2);
  const Symmetric         one = dealii::unit_symmetric_tensor<3>();

  SplineSpace<3>
  unit_cube()
  {
    const std::vector<double> knots = {0., .25, .5, .75, 1.};
    return SplineSpace<3>(KnotVector(1, knots, true),
                          KnotVector(1, knots, true),
                          KnotVector(1, knots));
  }

  bool
  in_a_corner(const Point<3> &lower, const Point<3> &)
  {
    return lower[0] < 0.5 && lower[1] >= 0.5 && lower[2] >= 0.5;
  }

  /** A stretch and shears that change from point to point. */
  Gradient
  deformation(const Point<3> &x, const double size)
  {
    Gradient F(one);
    F[0][0] += 0.2 * size * std::cos(9. * x[1]);
    F[0][2] += size * std::sin(7. * x[0] + x[1]);
    F[2][1] += 0.5 * size * std::sin(5. * x[2]);
    return F;
  }

  /** Logarithmic, linear in the parameters, with all components. */
  Symmetric
  elastic_strain(const Point<3> &x)
  {
    Symmetric strain;
    strain[0][0] = 0.01 * x[0];
    strain[1][1] = 0.02 - 0.03 * x[2];
    strain[2][2] = -0.004 * x[1];
    strain[0][1] = 0.005 * (x[0] - x[1]);
    strain[0][2] = 0.003 - 0.01 * x[1];
    strain[1][2] = 0.008 * x[2];
    return strain;
  }
} // namespace



TEST(SpatialStateTransfer, keeps_elastic_strains_bounds_and_integrals)
{
  SplineSpace<3> space = unit_cube();
  for (const bool coarsen : {false, true})
    {
      const auto                 from   = space.hierarchy();
      const auto                 points = tabulate_cells(space, {}, quadrature);
      std::vector<MaterialState> before;
      std::vector<Gradient>      F, F_after;
      for (const Point<3> &x : points.parameter)
        {
          F.push_back(deformation(x, 0.8));
          before.emplace_back();
          before.back().plastic_strain =
            std::max(0., 3. * (x[0] + x[1] + x[2] - 1.2));
          before.back().Cp_inverse = symmetrize(
            invert(F.back()) * Gradient(exponential(2. * elastic_strain(x))) *
            transpose(invert(F.back())));
        }
      const double mean = integral_of_strain(space, quadrature, before);
      space.adapt([&](const Point<3> &lower, const Point<3> &upper) {
        return !coarsen && in_a_corner(lower, upper) ? 1u : 0u;
      });
      ASSERT_NE(space.n_cells(), from->n_cells());
      const auto new_points = tabulate_cells(space, {}, quadrature);
      for (const Point<3> &x : new_points.parameter)
        F_after.push_back(deformation(x, 0.7));
      const auto after = transfer_states(
        *from, *space.hierarchy(), quadrature, before, F, F_after);
      ASSERT_EQ(after.size(), F_after.size());
      for (std::size_t q = 0; q < after.size(); ++q)
        {
          const Symmetric b = symmetrize(
            F_after[q] * Gradient(after[q].Cp_inverse) * transpose(F_after[q]));
          EXPECT_LT((b -
                     exponential(2. * elastic_strain(new_points.parameter[q])))
                      .norm(),
                    1e-12);
          EXPECT_GE(after[q].plastic_strain, 0.);
          EXPECT_LE(after[q].plastic_strain, 5.4);
        }
      EXPECT_NEAR(integral_of_strain(space, quadrature, after),
                  mean,
                  1e-12 * mean);
    }
}
