#include <asperity/base/errors.h>
#include <asperity/mesh_motion/column_mesh.h>
#include <asperity/mesh_motion/mesh_quality.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/fe/mapping_q_eulerian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "column_examples.h"

namespace
{
  using namespace asperity;
  using namespace example;
  using dealii::Point;
  using dealii::Tensor;

  /** Area of the cells [m^2]. */
  double
  area(const ColumnMesh &mesh)
  {
    const dealii::MappingQEulerian<2, dealii::Vector<double>> mapping(
      2, mesh.dofs(), mesh.displacement());
    dealii::FEValues<2> values(mapping,
                               mesh.dofs().get_fe(),
                               dealii::QGauss<2>(4),
                               dealii::update_JxW_values);
    double              sum = 0.;
    for (const auto &cell : mesh.dofs().active_cell_iterators())
      {
        values.reinit(cell);
        for (const unsigned int q : values.quadrature_point_indices())
          sum += values.JxW(q);
      }
    return sum;
  }



  /** Present places of wall nodes [m]. */
  std::vector<Point<2>>
  places(const ColumnMesh &mesh, const std::vector<ColumnMesh::WallNode> &nodes)
  {
    std::vector<Point<2>> points(mesh.dofs().n_dofs());
    dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<2>(),
                                                 mesh.dofs(),
                                                 points);
    const auto           &d = mesh.displacement();
    std::vector<Point<2>> result;
    for (const auto &node : nodes)
      result.push_back(points[node.dof_x] +
                       Point<2>(d(node.dof_x), d(node.dof_y)));
    return result;
  }



  /** A wavy edge that is stretched and squeezed along x, and has moved. */
  SplineCurve
  deformed_chip(const double distance)
  {
    const SplineCurve     start  = flat(0.);
    std::vector<Point<2>> points = start.control_points();
    for (Point<2> &p : points)
      {
        const double phase = 2. * M_PI * p[0] / period;
        p += shift(distance + 0.3 * um * std::sin(phase),
                   0.1 * um * std::cos(2. * phase));
      }
    SplineCurve chip = start;
    chip.set_control_points(points);
    return chip;
  }
} // namespace



TEST(ColumnMesh, walls_lie_on_the_curves_at_the_nodes)
{
  const SplineCurve tool = surface(tool_height);
  ColumnMesh        mesh(flat(0.), tool, layout_of(flat(0.)));
  const SplineCurve chip = deformed_chip(3.3 * um);
  ASSERT_TRUE(mesh.update(chip, shift(1.7 * um, 0.5 * um)).converged);
  EXPECT_EQ(mesh.film().fraction, 0.);
  ASSERT_EQ(mesh.chip_nodes().size(), 161u);
  const auto chip_places = places(mesh, mesh.chip_nodes());
  const auto tool_places = places(mesh, mesh.tool_nodes());
  for (unsigned int i = 0; i < 161; ++i)
    {
      const auto    &node  = mesh.chip_nodes()[i];
      const Point<2> below = chip_places[i], above = tool_places[i];
      EXPECT_LT(below.distance(chip.value(node.parameter)), 1e-14 * period);
      EXPECT_NEAR(above[0], below[0], 1e-15 * period);
      EXPECT_NEAR(above[1],
                  tool.value(above[0] - 1.7 * um)[1] + 0.5 * um,
                  1e-14 * period);
    }
}



TEST(ColumnMesh, area_is_exact_where_the_walls_are_quadratic_in_each_column)
{
  // Columns on the knots of both; the integral of a spline over a period is
  // that of its control values.
  const SplineCurve chip = surface(
    [](const double x) { return 0.1 * um * std::sin(4. * M_PI * x / period); },
    80);
  const SplineCurve tool = surface(tool_height, 80);
  double            gap  = 0.;
  for (unsigned int i = 0; i < 80; ++i)
    gap += (tool.control_points()[i][1] - chip.control_points()[i][1]) / 80.;
  ColumnMesh mesh(chip, tool, layout_of(chip));
  ASSERT_TRUE(mesh.update(chip, shift(0., 0.2 * um)).converged);
  EXPECT_NEAR(area(mesh) / (period * (gap + 0.2 * um)), 1., 1e-12);
}



TEST(ColumnMesh, area_converges_to_that_between_the_curves)
{
  // The chip's area beneath is that of its piecewise quadratic edge, exactly;
  // the tool's, at an offset that is no multiple of a span, by fine quadrature.
  const SplineCurve tool  = surface(tool_height, 640, 3);
  const SplineCurve chip  = deformed_chip(0.);
  double            exact = 0.;
  for (unsigned int i = 0; i < 80000; ++i)
    {
      const double s = (i + 0.5) * period / 80000.;
      const auto   C = chip.derivatives(s, 1);
      exact += (tool.value(C[0][0] - 0.777 * um)[1] + 0.3 * um - C[0][1]) *
               C[1][0] * period / 80000.;
    }
  std::vector<double> errors;
  for (const unsigned int n : {80, 160, 320})
    {
      ColumnMesh mesh(chip, tool, layout_of(chip, n));
      ASSERT_TRUE(mesh.update(chip, shift(0.777 * um, 0.3 * um)).converged);
      errors.push_back(std::abs(area(mesh) / exact - 1.));
    }
  // Simpson's rule: fourth order
  EXPECT_LT(errors[0], 1e-5);
  EXPECT_LT(errors[1], errors[0] / 12.);
  EXPECT_LT(errors[2], 1e-7);
}



TEST(ColumnMesh, tool_wraps_around_and_cycles_return)
{
  const SplineCurve tool = surface(tool_height);
  const SplineCurve chip = deformed_chip(0.);
  ColumnMesh        mesh(chip, tool, layout_of(chip));
  ASSERT_TRUE(mesh.update(chip, shift(0.)).converged);
  const dealii::Vector<double> start = mesh.displacement();
  for (const double turns : {0.3, 1., 7.6, -3., 1000.})
    {
      ASSERT_TRUE(mesh.update(chip, shift(turns * period)).converged);
      dealii::Vector<double> difference = mesh.displacement();
      difference -= start;
      const bool whole = turns == std::floor(turns);
      EXPECT_EQ(difference.linfty_norm() < 1e-12 * period, whole) << turns;
    }
  // and the same when the chip moves instead of the tool
  ASSERT_TRUE(mesh.update(deformed_chip(3. * period), shift(0.)).converged);
  for (const auto &node : mesh.tool_nodes())
    EXPECT_NEAR(mesh.displacement()(node.dof_y),
                start(node.dof_y),
                1e-12 * period);
}



TEST(ColumnMesh, no_cell_is_inverted_over_long_distances)
{
  const SplineCurve tool = surface(tool_height);
  ColumnMesh        mesh(flat(0.), tool, layout_of(flat(0.)));
  const MeshWatch   watch(mesh.dofs(), dealii::MappingQ1<2>());
  // The steepest line is that of the tool, of slope 0.75.
  const double least = 1. / std::hypot(1., 0.76);
  for (unsigned int k = 0; k < 60; ++k)
    {
      const SplineCurve chip = flat(0.);
      ASSERT_TRUE(mesh.update(chip, shift(-0.37 * um * k)).converged);
      EXPECT_GT(watch.quality(mesh.displacement()).smallest_scaled_jacobian,
                least);
    }
}



TEST(ColumnMesh, residual_film_keeps_one_mesh_where_surfaces_overlap)
{
  const double      film = 0.005 * um;
  const SplineCurve tool = surface(tool_height);
  ColumnMesh        mesh(flat(0.), tool, layout_of(flat(0.), 80, film));
  const MeshWatch   watch(mesh.dofs(), dealii::MappingQ1<2>());
  for (unsigned int k = 0; k < 20; ++k)
    {
      // overlapping by up to 0.3 um
      const Tensor<1, 2> offset = shift(0.41 * um * k, -0.016 * um * k);
      ASSERT_TRUE(mesh.update(flat(0.), offset).converged);
      EXPECT_GT(watch.quality(mesh.displacement()).smallest_scaled_jacobian,
                0.5);
      double     true_smallest = 1., largest_lift = 0.;
      const auto tool_places = places(mesh, mesh.tool_nodes());
      for (unsigned int i = 0; i < tool_places.size(); ++i)
        {
          const Point<2> above = tool_places[i];
          const double   gap = tool.value(above[0] - offset[0])[1] + offset[1];
          EXPECT_GE(above[1], film * (1. - 1e-9));
          EXPECT_NEAR(mesh.lift()[i], above[1] - gap, 1e-14 * period);
          if (i % 2 == 0)
            {
              EXPECT_NEAR(above[1], std::max(gap, film), 1e-14 * period);
            }
          true_smallest = std::min(true_smallest, gap);
          largest_lift  = std::max(largest_lift, above[1] - gap);
        }
      // between the nodes, too
      for (unsigned int i = 0; i + 2 < tool_places.size(); i += 2)
        for (double t = 0.; t <= 1.; t += 0.05)
          EXPECT_GE(tool_places[i][1] * (1. - t) * (1. - 2. * t) +
                      tool_places[i + 1][1] * 4. * t * (1. - t) +
                      tool_places[i + 2][1] * t * (2. * t - 1.),
                    film * (1. - 1e-9));
      EXPECT_NEAR(mesh.film().smallest_gap, true_smallest, 1e-14 * period);
      EXPECT_NEAR(mesh.film().largest_lift, largest_lift, 1e-14 * period);
      EXPECT_EQ(mesh.film().fraction > 0., largest_lift > 1e-6 * um);
    }
}



TEST(ColumnMesh, an_edge_that_folds_over_is_refused)
{
  const SplineCurve chip = flat(0.);
  ColumnMesh        mesh(chip, surface(tool_height), layout_of(chip));
  ASSERT_TRUE(mesh.update(chip, shift(0.)).converged);
  const dealii::Vector<double> before = mesh.displacement();
  std::vector<Point<2>>        points = chip.control_points();
  for (Point<2> &p : points)
    p[0] += 2. * um * std::sin(2. * M_PI * p[0] / period);
  SplineCurve folded = chip;
  folded.set_control_points(points);
  const ConvergenceReport report = mesh.update(folded, shift(0.));
  EXPECT_FALSE(report.converged);
  EXPECT_NE(report.reason.find("no graph"), std::string::npos);
  EXPECT_EQ(mesh.displacement(), before);
}



TEST(ColumnMesh, layouts_and_curves_that_do_not_fit_are_refused)
{
  const SplineCurve  chip = flat(0.), tool = surface(tool_height);
  const ColumnLayout good = layout_of(chip);
  ColumnLayout       bad  = good;
  bad.residual_film       = 0.;
  EXPECT_THROW(ColumnMesh(chip, tool, bad), InputError);
  bad         = good;
  bad.rows[1] = 0.;
  EXPECT_THROW(ColumnMesh(chip, tool, bad), InputError);
  bad = good;
  bad.columns.pop_back();
  EXPECT_THROW(ColumnMesh(chip, tool, bad), InputError);
  // the parameter of this tool is not x
  EXPECT_THROW(ColumnMesh(chip, deformed_chip(0.), good), InputError);
  const SplineCurve shorter = interpolate_periodic_function(
    [](const double) { return 0.; }, 0., 0.5 * period, 20, 2);
  EXPECT_THROW(ColumnMesh(chip, shorter, good), InputError);
}



TEST(ColumnLayout, columns_are_dense_where_the_gap_is_narrow)
{
  const SplineCurve chip = flat(0., 20), tool = surface(tool_height);
  const auto        columns = columns_on_spans(chip.knot_vector(),
                                        120,
                                        film_density(chip, tool, shift(0.)));
  EXPECT_NEAR(columns.size(), 121., 10.);
  EXPECT_TRUE(std::is_sorted(columns.begin(), columns.end()));
  for (const double knot : chip.knot_vector().breakpoints())
    EXPECT_TRUE(std::binary_search(columns.begin(), columns.end(), knot));
  double narrowest = 0., widest = 0.;
  for (double x = 0.; x < period; x += 1e-3 * period)
    {
      if (tool_height(x) < tool_height(narrowest))
        narrowest = x;
      if (tool_height(x) > tool_height(widest))
        widest = x;
    }
  const auto width_at = [&columns](const double x) {
    const auto right = std::upper_bound(columns.begin(), columns.end(), x);
    return *right - *(right - 1);
  };
  EXPECT_LT(width_at(narrowest), 0.5 * width_at(widest));
}



TEST(ColumnLayout, rows_are_graded_symmetrically)
{
  const std::vector<double> equal = graded_rows(4);
  for (unsigned int j = 0; j <= 4; ++j)
    EXPECT_DOUBLE_EQ(equal[j], 0.25 * j);
  // heights 1, 2, 3, 2, 1
  const std::vector<double> graded     = graded_rows(5, 3.);
  const double              expected[] = {0., 1., 3., 6., 8., 9.};
  for (unsigned int j = 0; j <= 5; ++j)
    EXPECT_DOUBLE_EQ(graded[j], expected[j] / 9.);
}
