#include <gtest/gtest.h>

#include <algorithm>

#include "column_examples.h"

namespace
{
  using namespace asperity;
  using namespace example;
  using dealii::Tensor;
} // namespace



TEST(ColumnWallVelocity, film_carried_by_the_chip_keeps_its_volume)
{
  // The chip presses into the tool and moves on by w; the film moves with it,
  // though the tool rests.
  const SplineCurve      tool = surface(tool_height);
  ColumnMesh             mesh(flat(0.), tool, layout_of(flat(0.)));
  dealii::Vector<double> w(mesh.dofs().n_dofs());
  for (const auto *nodes : {&mesh.chip_nodes(), &mesh.tool_nodes()})
    for (const auto &node : *nodes)
      {
        w(node.dof_x) = 3.;
        w(node.dof_y) = 2.;
      }
  ASSERT_TRUE(mesh.update(flat(0.), shift(0., -10. * um)).converged);
  ASSERT_NEAR(mesh.film().fraction, 1., 1e-12);
  for (const auto &v : mesh.tool_wall_velocity(shift(1., 0.), w))
    {
      EXPECT_NEAR(v[0], 1., 1e-12);
      EXPECT_NEAR(v[1], 2., 1e-12);
    }
}



// Nodes that slide along the tool have no velocity normal to it, but for the
// chords by which a quadratic edge knows its slope.
TEST(ColumnWallVelocity, off_the_film_the_fluid_goes_with_the_tool)
{
  const SplineCurve tool = surface(tool_height, 160, 4);
  const double      step = 1e-5 * um, dt = 1e-8, velocity = step / dt;
  double            coarse = 0.;
  for (const unsigned int n_columns : {80, 160, 320})
    {
      ColumnMesh mesh(flat(0.), tool, layout_of(flat(0.), n_columns));
      ASSERT_TRUE(mesh.update(flat(0.), shift(0., 1. * um)).converged);
      ASSERT_EQ(mesh.film().largest_lift, 0.);
      dealii::Vector<double> w = mesh.displacement();
      ASSERT_TRUE(mesh.update(flat(0.), shift(-step, 1. * um)).converged);
      w.sadd(-1. / dt, 1. / dt, mesh.displacement());
      double error = 0.;
      for (const auto &v : mesh.tool_wall_velocity(shift(-velocity), w))
        error = std::max(error, (v - shift(-velocity)).norm() / velocity);
      EXPECT_LT(error, 0.02);
      if (coarse > 0.)
        {
          EXPECT_NEAR(coarse / error, 4., 1.);
        }
      coarse = error;
    }
}



// Whether the lowest point of the tool just touches the film or just does not
// makes no difference to the velocity, whatever the mesh does.
TEST(ColumnWallVelocity, velocity_does_not_jump_at_the_edge_of_the_film)
{
  const double film = 0.005 * um, touch = film - 0.02 * um, step = 1e-6 * um;
  const SplineCurve      tool = surface(tool_height);
  ColumnMesh             mesh(flat(0.), tool, layout_of(flat(0.), 320, film));
  dealii::Vector<double> w(mesh.dofs().n_dofs());
  for (const auto &node : mesh.tool_nodes())
    {
      w(node.dof_x) = 3.;
      w(node.dof_y) = 2.;
    }
  std::vector<Tensor<1, 2>> last;
  unsigned int              n_lifted = 0;
  // The lowest node is at most some picometres above the lowest point.
  for (double y = touch; y > touch - 1e-3 * um; y -= step)
    {
      ASSERT_TRUE(mesh.update(flat(0.), shift(0., y)).converged);
      const auto v = mesh.tool_wall_velocity(shift(1., 0.), w);
      for (unsigned int i = 0; i < last.size(); ++i)
        EXPECT_LT((v[i] - last[i]).norm(), 1e-3);
      last = v;
      n_lifted += mesh.film().largest_lift > 0.;
    }
  EXPECT_GT(n_lifted, 0U);
  EXPECT_LT(n_lifted, 1000U);
}
