#include <asperity/flow/shape_table.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <gtest/gtest.h>

#include <cmath>

#include "flow_examples.h"

using namespace flow_examples;

// Fields, gradients and areas in curved cells are those of FEValues.
TEST(ShapeTable, says_what_deal_ii_says)
{
  const auto       mesh = rectangle(3, 2);
  const FluidSpace space(*mesh, FluidElement::taylor_hood, 2, 2, {});
  MovingMesh       motion(space);
  Vector           d(space.geometry_dofs().n_dofs()), u(space.dofs().n_dofs());
  for (unsigned int i = 0; i < d.size(); ++i)
    d(i) = 0.02 * std::sin(12.9898 * i);
  for (unsigned int i = 0; i < u.size(); ++i)
    u(i) = std::cos(7.23 * i);
  ASSERT_TRUE(motion.set_displacement(d));

  const auto             &fe      = space.dofs().get_fe();
  const auto             &mesh_fe = space.geometry_dofs().get_fe();
  const dealii::QGauss<2> quadrature(3);
  const ShapeTable        velocity(fe.base_element(0), quadrature.get_points()),
    pressure(fe.base_element(1), quadrature.get_points()),
    geometry(mesh_fe.base_element(0), quadrature.get_points());
  CellUnknowns        unknowns(fe), mesh_unknowns(mesh_fe);
  NodalVectors        x, v;
  std::vector<double> p;

  const dealii::FEValuesExtractors::Vector velocity_field(0);
  const dealii::FEValuesExtractors::Scalar pressure_field(2);
  dealii::FEValues<2>                      values(motion.mapping(),
                             fe,
                             quadrature,
                             dealii::update_values | dealii::update_gradients |
                               dealii::update_JxW_values |
                               dealii::update_quadrature_points);
  std::vector<dealii::Tensor<1, 2>>        v_expected(quadrature.size());
  std::vector<dealii::Tensor<2, 2>>        grad_expected(quadrature.size());
  std::vector<double>                      p_expected(quadrature.size());
  const std::vector<double>                areas = motion.cell_areas();
  for (const auto &cell : space.cells())
    {
      values.reinit(cell);
      values[velocity_field].get_function_values(u, v_expected);
      values[velocity_field].get_function_gradients(u, grad_expected);
      values[pressure_field].get_function_values(u, p_expected);
      unknowns.reinit(cell);
      mesh_unknowns.reinit(space.geometry_cell(cell));
      unknowns.extract(u, v);
      unknowns.extract(u, 2, p);
      mesh_unknowns.extract(motion.positions(), x);
      double area = 0.;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const dealii::Tensor<2, 2> J = geometry.gradient(q, x);
          area += values.JxW(q);
          EXPECT_NEAR(determinant(J) * quadrature.weight(q),
                      values.JxW(q),
                      1e-14);
          EXPECT_LT((geometry.value(q, x) - values.quadrature_point(q)).norm(),
                    1e-13);
          EXPECT_LT((velocity.value(q, v) - v_expected[q]).norm(), 1e-13);
          EXPECT_LT(
            (velocity.gradient(q, v) * invert(J) - grad_expected[q]).norm(),
            1e-11);
          EXPECT_NEAR(pressure.value(q, p), p_expected[q], 1e-13);
        }
      EXPECT_NEAR(areas[cell->active_cell_index()], area, 1e-14);
    }
}
