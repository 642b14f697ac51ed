#include <asperity/base/errors.h>
#include <asperity/flow/channel_meshes.h>
#include <asperity/flow/flow_transfer.h>

#include <deal.II/numerics/vector_tools.h>

#include <gtest/gtest.h>

#include "flow_examples.h"

using namespace flow_examples;

namespace
{
  /** Polynomials of position in the coarse cells, hence in both spaces. */
  class Polynomials : public dealii::Function<2>
  {
  public:
    Polynomials()
      : Function(3)
    {}

    double
    value(const Point<2> &x, const unsigned int component) const override
    {
      return component == 0 ? x[0] * x[0] - x[1] :
             component == 1 ? 1. + x[0] * x[1] :
                              2. * x[0] - 3. * x[1];
    }
  };

  Vector
  interpolant(const FluidSpace &space)
  {
    Vector u(space.dofs().n_dofs());
    dealii::VectorTools::interpolate(space.reference_mapping(),
                                     space.dofs(),
                                     Polynomials(),
                                     u);
    return u;
  }
} // namespace



TEST(FlowTransfer, keeps_what_both_spaces_hold)
{
  // Each mesh is finer than the other somewhere.
  const auto left = rectangle(2, 2), right = rectangle(2, 2);
  left->begin_active()->set_refine_flag();
  left->execute_coarsening_and_refinement();
  right->last_active()->set_refine_flag();
  right->execute_coarsening_and_refinement();
  const FluidSpace from(*left, FluidElement::taylor_hood, 2, 2, {});
  const FluidSpace to(*right, FluidElement::taylor_hood, 3, 3, {});
  Vector u = interpolate_to_mesh(from.dofs(), interpolant(from), to.dofs());
  u -= interpolant(to);
  EXPECT_LT(u.linfty_norm(), 1e-13);
}



TEST(FlowTransfer, refuses_another_coarse_mesh)
{
  const auto       a = rectangle(2, 2), b = rectangle(3, 2);
  const FluidSpace from(*a, FluidElement::taylor_hood, 2, 2, {});
  const FluidSpace to(*b, FluidElement::taylor_hood, 2, 2, {});
  try
    {
      interpolate_to_mesh(from.dofs(), interpolant(from), to.dofs());
      FAIL();
    }
  catch (const InputError &error)
    {
      EXPECT_STREQ(error.what(),
                   "A flow can be interpolated between refinements of one "
                   "coarse mesh only; found coarse meshes of 4 and 6 cells.");
    }
}



TEST(ChannelMeshes, corner_layers_refine_the_flags_corners)
{
  Mesh plain, refined;
  make_channel_with_flag(plain, 0, 0);
  make_channel_with_flag(refined, 0, 0, 1);
  // Five cells have a corner of the tip, the middle one both; two one of the
  // root.
  EXPECT_EQ(refined.n_active_cells(), plain.n_active_cells() + 3 * 7);
}
