#include <asperity/flow/shape_table.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <gtest/gtest.h>

#include <cmath>

#include "flow_examples.h"

using namespace flow_examples;

namespace
{
  /** A flow on cells whose nodes are all displaced. */
  struct CurvedCells
  {
    CurvedCells()
      : mesh(rectangle(3, 2))
      , space(*mesh, FluidElement::taylor_hood, 2, 2, {})
      , motion(space)
      , u(space.dofs().n_dofs())
    {
      Vector d(space.geometry_dofs().n_dofs());
      for (unsigned int i = 0; i < d.size(); ++i)
        d(i) = 0.02 * std::sin(12.9898 * i);
      for (unsigned int i = 0; i < u.size(); ++i)
        u(i) = std::cos(7.23 * i);
      valid = motion.set_displacement(d);
    }

    decltype(rectangle(3, 2)) mesh;
    const FluidSpace          space;
    MovingMesh                motion;
    Vector                    u;
    bool                      valid;
  };

  const dealii::QGauss<2> quadrature(3);
} // namespace

TEST(ShapeTable, has_the_fields_of_deal_ii_and_their_gradients)
{
  CurvedCells cells;
  ASSERT_TRUE(cells.valid);
  const auto      &fe = cells.space.dofs().get_fe();
  const ShapeTable velocity(fe.base_element(0), quadrature.get_points()),
    pressure(fe.base_element(1), quadrature.get_points());
  CellUnknowns        unknowns(fe);
  NodalVectors        v;
  std::vector<double> p;

  const dealii::FEValuesExtractors::Vector velocity_field(0);
  const dealii::FEValuesExtractors::Scalar pressure_field(2);
  dealii::FEValues<2>                      values(cells.motion.mapping(),
                             fe,
                             quadrature,
                             dealii::update_values | dealii::update_gradients |
                               dealii::update_jacobians);
  std::vector<dealii::Tensor<1, 2>>        v_expected(quadrature.size());
  std::vector<dealii::Tensor<2, 2>>        grad_expected(quadrature.size());
  std::vector<double>                      p_expected(quadrature.size());
  for (const auto &cell : cells.space.cells())
    {
      values.reinit(cell);
      values[velocity_field].get_function_values(cells.u, v_expected);
      values[velocity_field].get_function_gradients(cells.u, grad_expected);
      values[pressure_field].get_function_values(cells.u, p_expected);
      unknowns.reinit(cell);
      unknowns.extract(cells.u, v);
      unknowns.extract(cells.u, 2, p);
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const dealii::Tensor<2, 2> J(values.jacobian(q));
          EXPECT_LT((velocity.value(q, v) - v_expected[q]).norm(), 1e-13);
          EXPECT_LT(
            (velocity.gradient(q, v) * invert(J) - grad_expected[q]).norm(),
            1e-11);
          EXPECT_NEAR(pressure.value(q, p), p_expected[q], 1e-13);
        }
    }
}

TEST(ShapeTable, has_the_cells_of_deal_ii)
{
  CurvedCells cells;
  ASSERT_TRUE(cells.valid);
  const auto         &fe = cells.space.geometry_dofs().get_fe();
  const ShapeTable    geometry(fe.base_element(0), quadrature.get_points());
  CellUnknowns        unknowns(fe);
  NodalVectors        x;
  dealii::FEValues<2> values(cells.motion.mapping(),
                             cells.space.dofs().get_fe(),
                             quadrature,
                             dealii::update_JxW_values |
                               dealii::update_quadrature_points);
  const std::vector<double> areas = cells.motion.cell_areas();
  for (const auto &cell : cells.space.cells())
    {
      values.reinit(cell);
      unknowns.reinit(cells.space.geometry_cell(cell));
      unknowns.extract(cells.motion.positions(), x);
      double area = 0.;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          area += values.JxW(q);
          EXPECT_NEAR(determinant(geometry.gradient(q, x)) *
                        quadrature.weight(q),
                      values.JxW(q),
                      1e-14);
          EXPECT_LT((geometry.value(q, x) - values.quadrature_point(q)).norm(),
                    1e-13);
        }
      EXPECT_NEAR(areas[cell->active_cell_index()], area, 1e-14);
    }
}
