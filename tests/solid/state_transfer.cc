#include <asperity/isogeometric/spline_space.h>
#include <asperity/solid/state_transfer.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

  double
  integral_of_strain(const SplineSpace<2>             &space,
                     const std::vector<MaterialState> &states)
  {
    const auto table = tabulate_cells(space, {}, quadrature);
    double     sum   = 0.;
    for (std::size_t q = 0; q < states.size(); ++q)
      sum += table.JxW[q] * states[q].plastic_strain;
    return sum;
  }
} // namespace

TEST(StateTransfer, keeps_bounds_integrals_and_a_determinant_of_one)
{
  SplineSpace<2> space = unit_square();
  for (const bool coarsen : {false, true})
    {
      const auto from   = space.hierarchy();
      const auto before = states_of(space);
      const auto work   = integral_of_strain(space, before);
      space.adapt([&](const Point<2> &lower, const Point<2> &upper) {
        return !coarsen && in_the_corner(lower, upper) ? 2u : 0u;
      });
      const auto to = space.hierarchy();
      ASSERT_NE(from->n_cells(), to->n_cells());
      const auto after = transfer_states(*from, *to, quadrature, before);
      ASSERT_EQ(after.size(), to->n_cells() * quadrature.size());
      double highest = 0.;
      for (const MaterialState &state : before)
        highest = std::max(highest, state.plastic_strain);
      for (const MaterialState &state : after)
        {
          EXPECT_GE(state.plastic_strain, 0.);
          EXPECT_LE(state.plastic_strain, highest);
          EXPECT_NEAR(determinant(state.Cp_inverse), 1., 1e-12);
          for (const double value : eigenvalues(state.Cp_inverse))
            EXPECT_GT(value, 0.);
        }
      EXPECT_NEAR(integral_of_strain(space, after), work, 1e-12 * work);
    }
}

TEST(StateTransfer, cells_of_both_meshes_keep_their_states_bit_by_bit)
{
  SplineSpace<2> space  = unit_square();
  const auto     from   = space.hierarchy();
  const auto     before = states_of(space);
  space.refine_to_level(1, in_the_corner);
  const auto   to     = space.hierarchy();
  const auto   after  = transfer_states(*from, *to, quadrature, before);
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
