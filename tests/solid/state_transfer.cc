#include <asperity/isogeometric/spline_space.h>
#include <asperity/solid/state_transfer.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "state_transfer_examples.h"

using namespace asperity;
using dealii::Point;

namespace
{
  const dealii::QGauss<2> quadrature(2);

  SplineSpace<2>
  unit_square()
  {
    const std::vector<double> knots = {
      0., .125, .25, .375, .5, .625, .75, .875, 1.};
    return SplineSpace<2>(KnotVector(2, knots, true), KnotVector(2, knots));
  }

  bool
  in_the_corner(const Point<2> &lower, const Point<2> &)
  {
    return lower[0] < 0.5 && lower[1] >= 0.5;
  }

  /** States with a front of plastic strain, isochoric in the plane and across
   *  it: exp of a trace-free tensor. */
  std::vector<MaterialState>
  states_of(const SplineSpace<2> &space)
  {
    std::vector<MaterialState> states;
    for (const auto &x : tabulate_cells(space, {}, quadrature).parameter)
      {
        MaterialState state;
        const double  e      = std::max(0., 3. * (x[0] + x[1] - 0.8));
        state.plastic_strain = e;
        state.temperature    = 300. + 50. * e;
        // A shear of the plane, C_p = F^T F of F = I + e (e_x e_y).
        state.Cp_inverse[0][0] = 1. + e * e;
        state.Cp_inverse[0][1] = -e;
        states.push_back(state);
      }
    return states;
  }

  using Symmetric = dealii::SymmetricTensor<2, 3>;
  using Gradient  = dealii::Tensor<2, 3>;

  const Symmetric one = dealii::unit_symmetric_tensor<3>();

  /** A stretch and a shear that change from point to point. */
  std::vector<Gradient>
  gradients_of(const SplineSpace<2> &space, const double size)
  {
    std::vector<Gradient> F;
    for (const auto &x : tabulate_cells(space, {}, quadrature).parameter)
      {
        F.emplace_back(one);
        F.back()[0][0] += 0.2 * size * std::cos(9. * x[1]);
        F.back()[0][1] += size * std::sin(7. * x[0] + x[1]);
      }
    return F;
  }

  /** Logarithmic elastic strain, linear in the parameters. */
  Symmetric
  elastic_strain(const Point<2> &x)
  {
    Symmetric strain;
    strain[0][0] = 0.01 * x[0];
    strain[1][1] = 0.02 - 0.03 * x[1];
    strain[0][1] = 0.005 * (x[0] - x[1]);
    strain[2][2] = -0.004 * x[1];
    return strain;
  }
} // namespace

TEST(StateTransfer, keeps_bounds_and_integrals)
{
  SplineSpace<2> space = unit_square();
  for (const bool coarsen : {false, true})
    {
      const auto from   = space.hierarchy();
      const auto before = states_of(space);
      const auto work   = integral_of_strain(space, quadrature, before);
      space.adapt([&](const Point<2> &lower, const Point<2> &upper) {
        return !coarsen && in_the_corner(lower, upper) ? 2u : 0u;
      });
      const auto to = space.hierarchy();
      ASSERT_NE(from->n_cells(), to->n_cells());
      const std::vector<Gradient> F(before.size(), Gradient(one));
      const std::vector<Gradient> F_after(to->n_cells() * quadrature.size(),
                                          Gradient(one));
      const auto                  after =
        transfer_states(*from, *to, quadrature, before, F, F_after);
      ASSERT_EQ(after.size(), to->n_cells() * quadrature.size());
      double highest = 0.;
      for (const MaterialState &state : before)
        highest = std::max(highest, state.plastic_strain);
      for (const MaterialState &state : after)
        {
          EXPECT_GE(state.plastic_strain, 0.);
          EXPECT_LE(state.plastic_strain, highest);
          for (const double value : eigenvalues(state.Cp_inverse))
            EXPECT_GT(value, 0.);
        }
      EXPECT_NEAR(integral_of_strain(space, quadrature, after),
                  work,
                  1e-12 * work);
    }
}

TEST(StateTransfer, cells_of_both_meshes_keep_their_states_bit_by_bit)
{
  SplineSpace<2> from_space = unit_square(), space = unit_square();
  const auto     from   = space.hierarchy();
  const auto     before = states_of(space);
  space.refine_to_level(1, in_the_corner);
  const auto   to     = space.hierarchy();
  const auto   after  = transfer_states(*from,
                                     *to,
                                     quadrature,
                                     before,
                                     gradients_of(from_space, 0.4),
                                     gradients_of(space, 0.4));
  unsigned int n_kept = 0;
  for (unsigned int cell = 0; cell < to->n_cells(); ++cell)
    if (to->cell_index(cell).level == 0)
      {
        ++n_kept;
        const int old =
          from->nodes()[from->find_node(to->cell_index(cell))].cell;
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          EXPECT_EQ(after[cell * quadrature.size() + q].Cp_inverse,
                    before[old * quadrature.size() + q].Cp_inverse);
      }
  EXPECT_GT(n_kept, 0u);
}

// What a spline loses of its gradient when its cells are coarsened must not
// become stress: that would be Young's modulus times it.
TEST(StateTransfer, keeps_elastic_strains_under_another_deformation)
{
  SplineSpace<2> space = unit_square();
  for (const bool coarsen : {false, true})
    {
      const auto                 from = space.hierarchy();
      const auto                 F    = gradients_of(space, 0.8);
      std::vector<MaterialState> before(F.size());
      const auto parameters = tabulate_cells(space, {}, quadrature).parameter;
      for (std::size_t q = 0; q < F.size(); ++q)
        before[q].Cp_inverse =
          symmetrize(invert(F[q]) *
                     Gradient(exponential(2. * elastic_strain(parameters[q]))) *
                     transpose(invert(F[q])));
      space.adapt([&](const Point<2> &lower, const Point<2> &upper) {
        return !coarsen && in_the_corner(lower, upper) ? 2u : 0u;
      });
      const auto F_after = gradients_of(space, 0.7);
      const auto after   = transfer_states(
        *from, *space.hierarchy(), quadrature, before, F, F_after);
      const auto points = tabulate_cells(space, {}, quadrature).parameter;
      ASSERT_EQ(after.size(), points.size());
      for (std::size_t q = 0; q < points.size(); ++q)
        {
          const Symmetric b = symmetrize(
            F_after[q] * Gradient(after[q].Cp_inverse) * transpose(F_after[q]));
          EXPECT_LT((b - exponential(2. * elastic_strain(points[q]))).norm(),
                    1e-12);
        }
    }
}

TEST(StateTransfer, leaves_what_has_not_yielded_elastic)
{
  SplineSpace<2> space = unit_square();
  const auto     from  = space.hierarchy();
  const auto     F     = gradients_of(space, 0.1);
  space.refine_to_level(1, in_the_corner);
  for (const MaterialState &state :
       transfer_states(*from,
                       *space.hierarchy(),
                       quadrature,
                       std::vector<MaterialState>(F.size()),
                       F,
                       gradients_of(space, 0.2)))
    EXPECT_EQ(state.Cp_inverse, one);
}
