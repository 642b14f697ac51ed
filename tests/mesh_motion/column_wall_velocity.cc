#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q_eulerian.h>

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



// Else a gap between sealed places would lose or gain oil by the sliding alone.
TEST(ColumnWallVelocity, no_fluid_passes_through_the_curved_edges_of_the_tool)
{
  const SplineCurve tool = surface(tool_height, 160, 4);
  ColumnMesh        mesh(flat(0.), tool, layout_of(flat(0.), 40));
  ASSERT_TRUE(mesh.update(flat(0.), shift(0., 1. * um)).converged);
  const auto &fe = mesh.dofs().get_fe();
  const dealii::MappingQEulerian<2, dealii::Vector<double>> mapping(
    2, mesh.dofs(), mesh.displacement());
  dealii::FEFaceValues<2> face(mapping,
                               fe,
                               dealii::QGauss<1>(4),
                               dealii::update_values |
                                 dealii::update_normal_vectors |
                                 dealii::update_JxW_values);
  // However the nodes of the mesh slide.
  dealii::Vector<double> w(mesh.dofs().n_dofs()), relative(w);
  for (unsigned int i = 0; i < mesh.tool_nodes().size(); ++i)
    w(mesh.tool_nodes()[i].dof_x) = 3. + std::sin(0.3 * i);
  w(mesh.tool_nodes().back().dof_x) = w(mesh.tool_nodes().front().dof_x);
  const auto v                      = mesh.tool_wall_velocity({}, w);
  for (unsigned int i = 0; i < v.size(); ++i)
    {
      relative(mesh.tool_nodes()[i].dof_x) =
        v[i][0] - w(mesh.tool_nodes()[i].dof_x);
      relative(mesh.tool_nodes()[i].dof_y) =
        v[i][1] - w(mesh.tool_nodes()[i].dof_y);
    }
  double net = 0., gross = 0.;
  for (const auto &cell : mesh.dofs().active_cell_iterators())
    for (const unsigned int f : cell->face_indices())
      if (cell->at_boundary(f) &&
          cell->face(f)->boundary_id() == ColumnMesh::tool_wall)
        {
          face.reinit(cell, f);
          std::vector<Tensor<1, 2>> u(face.n_quadrature_points);
          face[dealii::FEValuesExtractors::Vector(0)].get_function_values(
            relative, u);
          for (const unsigned int q : face.quadrature_point_indices())
            {
              net += u[q] * face.normal_vector(q) * face.JxW(q);
              gross += u[q].norm() * face.JxW(q);
            }
        }
  EXPECT_GT(gross, 0.);
  EXPECT_LT(std::abs(net), 1e-13 * gross);
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
        EXPECT_LT((v[i] - last[i]).norm(), 0.01); // a switch: 2
      last = v;
      n_lifted += mesh.film().largest_lift > 0.;
    }
  EXPECT_GT(n_lifted, 0U);
  EXPECT_LT(n_lifted, 1000U);
}
