#include <asperity/base/errors.h>
#include <asperity/isogeometric/spline_space.h>
#include <asperity/postprocess/chip_output.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

#include "../files.h"
#include "vtu_reader.h"

using namespace asperity;

namespace
{
  KnotVector
  uniform(const unsigned int degree,
          const unsigned int n_spans,
          const double       length,
          const bool         periodic = false)
  {
    std::vector<double> breakpoints;
    for (unsigned int i = 0; i <= n_spans; ++i)
      breakpoints.push_back(length * i / n_spans);
    return KnotVector(degree, breakpoints, periodic);
  }

  /** Interleaved coefficients of a function that the space contains. */
  dealii::Vector<double>
  vector_field(
    const SplineSpace<2>                                               &space,
    const std::function<std::vector<double>(const dealii::Point<2> &)> &f)
  {
    const auto             coefficients = space.project(f, 2);
    dealii::Vector<double> result(2 * space.n_functions());
    for (unsigned int a = 0; a < space.n_functions(); ++a)
      for (unsigned int c = 0; c < 2; ++c)
        result[2 * a + c] = coefficients[c][a];
    return result;
  }

  std::vector<double>
  at_gauss_points(const SplineSpace<2>   &space,
                  const PatchGeometry<2> &geometry,
                  const unsigned int      n_gauss,
                  const std::function<double(const dealii::Point<2> &)> &f)
  {
    std::vector<double> values;
    for (const auto &point :
         tabulate_cells(space, geometry, dealii::QGauss<2>(n_gauss)).position)
      values.push_back(f(point));
    return values;
  }

  VtuReader
  written(const ChipOutput<2> &output,
          const ChipFields    &fields,
          const unsigned int   n_periods = 1)
  {
    std::ostringstream out;
    output.write(out, fields, 1e-7, 3, n_periods);
    return VtuReader(out.str());
  }
} // namespace



// Each of two ranks draws what the other one leaves out.
TEST(ChipOutput, draws_the_cells_of_a_rank_as_pieces_of_one_picture)
{
  const SplineSpace<2> space(uniform(2, 3, 3.), uniform(2, 2, 1.));
  ChipFields           fields;
  fields.displacement =
    vector_field(space, [](const dealii::Point<2> &p) -> std::vector<double> {
      return {0.1 * p[1], 0.2 * p[0]};
    });
  const VtuReader          whole = written({space, {}, 2, 3}, fields);
  std::vector<std::string> pieces;
  for (const unsigned int odd : {0, 1})
    {
      CellShare share;
      for (unsigned int cell = 0; cell < space.n_cells(); ++cell)
        share.owner.push_back((cell + odd) % 2);
      const auto own =
        ChipOutput<2>(space, {}, 2, 3, share).pieces(fields, 1e-7, 3);
      ASSERT_EQ(own.size(), 1u);
      pieces.push_back(own[0]);
    }
  std::ostringstream out;
  ChipOutput<2>::write(out, pieces);
  const VtuReader parts(out.str());
  EXPECT_EQ(parts.n_pieces, 2u);
  EXPECT_EQ(parts.n_cells, whole.n_cells);
  EXPECT_EQ(parts.time(), whole.time());
  std::vector<float> a = parts.points(), b = whole.points();
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  EXPECT_EQ(a, b);
  // Points of cells are those of their piece.
  const auto corners = parts.connectivity();
  EXPECT_EQ(*std::max_element(corners.begin(), corners.end()),
            static_cast<int>(parts.n_points) - 1);

  fields.displacement[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(ChipOutput<2>(space, {}, 2, 3).pieces(fields, 0., 0),
               SharedError);
}



// A bent strip, 1 <= y <= 2 and all x - y^2/4 in [0, 3]: quadratic, so a
// quadratic space holds the map exactly.
TEST(ChipOutput, corners_lie_on_the_deformed_curved_geometry)
{
  SplineSpace<2> space(uniform(2, 3, 3.), uniform(2, 2, 1.));
  space.refine_to_level(1,
                        [](const dealii::Point<2> &lower,
                           const dealii::Point<2> &) {
                          return lower[0] < 0.5;
                        });
  const auto map = [](const dealii::Point<2> &p) {
    const double y = 1. + p[1];
    return dealii::Point<2>(p[0] + y * y / 4., y);
  };
  const PatchGeometry<2> geometry = PatchGeometry<2>::from_map(space, map);
  // u(xi, eta) = (0.1 xi eta, 0.2 xi^2): quadratic in the parameters.
  ChipFields fields;
  fields.displacement  = vector_field(space, [](const dealii::Point<2> &p) {
    return std::vector<double>{0.1 * p[0] * p[1], 0.2 * p[0] * p[0]};
  });
  const unsigned int n = 3;
  const auto file      = written(ChipOutput<2>(space, geometry, n, 3), fields);

  ASSERT_EQ(file.n_points, space.n_cells() * (n + 1) * (n + 1));
  EXPECT_EQ(file.n_cells, space.n_cells() * n * n);
  EXPECT_NEAR(file.time(), 1e-7, 1e-13);
  const auto points = file.points();
  const auto u      = file.field("displacement [m]");
  double     left = 1e9, right = -1e9;
  for (unsigned int i = 0; i < file.n_points; ++i)
    {
      const double X = points[3 * i] - u[3 * i];
      const double Y = points[3 * i + 1] - u[3 * i + 1];
      // Back to the parameters through the inverse of the map.
      const double eta = Y - 1., xi = X - Y * Y / 4.;
      left  = std::min(left, xi);
      right = std::max(right, xi);
      EXPECT_NEAR(u[3 * i], 0.1 * xi * eta, 2e-6);
      EXPECT_NEAR(u[3 * i + 1], 0.2 * xi * xi, 4e-6);
      EXPECT_EQ(points[3 * i + 2], 0.f);
    }
  EXPECT_NEAR(left, 0., 1e-6);
  EXPECT_NEAR(right, 3., 2e-6);
}



TEST(ChipOutput, quadrilaterals_cover_the_deformed_area_without_overlap)
{
  const SplineSpace<2> space(uniform(2, 4, 2.), uniform(2, 3, 1.));
  ChipFields           fields;
  // A shear: area 2 stays, and straight lines stay straight.
  fields.displacement = vector_field(space, [](const dealii::Point<2> &p) {
    return std::vector<double>{0.5 * p[1], 0.};
  });
  const auto file     = written(ChipOutput<2>(space, {}, 2, 3), fields);
  const auto points   = file.points();
  const auto cells    = file.connectivity();
  ASSERT_EQ(cells.size(), 4u * file.n_cells);
  double area = 0.;
  for (unsigned int cell = 0; cell < file.n_cells; ++cell)
    {
      double cell_area = 0.;
      for (unsigned int i = 0; i < 4; ++i)
        {
          const int a = cells[4 * cell + i], b = cells[4 * cell + (i + 1) % 4];
          cell_area += 0.5 * (points[3 * a] * points[3 * b + 1] -
                              points[3 * b] * points[3 * a + 1]);
        }
      EXPECT_GT(cell_area, 0.);
      area += cell_area;
    }
  EXPECT_NEAR(area, 2., 1e-5);
}



TEST(ChipOutput, spline_fields_and_quadrature_polynomials_are_reproduced)
{
  const SplineSpace<2> space(uniform(2, 3, 3.), uniform(2, 2, 1.));
  ChipFields           fields;
  fields.displacement.reinit(2 * space.n_functions());
  fields.spline_vectors.emplace_back(
    "velocity [m/s]", vector_field(space, [](const dealii::Point<2> &p) {
      return std::vector<double>{p[0] * p[1], 7.};
    }));
  const auto scalar = space.project(
    [](const dealii::Point<2> &p) {
      return std::vector<double>{p[0] * p[0] - p[1]};
    },
    1);
  fields.spline_scalars.emplace_back("potential [V]",
                                     dealii::Vector<double>(scalar[0].begin(),
                                                            scalar[0].end()));
  // Constant along y: extrapolation beyond the outer Gauss points is clamped,
  // so only the middle third of a cell must be exact.
  fields.quadrature_scalars.emplace_back(
    "temperature [degC]",
    at_gauss_points(space, {}, 3, [](const dealii::Point<2> &p) {
      return 20. + 5. * p[0];
    }));

  const unsigned int n      = 4;
  const auto         file   = written(ChipOutput<2>(space, {}, n, 3), fields);
  const auto         points = file.points();
  const auto         v      = file.field("velocity [m/s]");
  const auto         phi    = file.field("potential [V]");
  const auto         T      = file.field("temperature [degC]");
  for (unsigned int i = 0; i < file.n_points; ++i)
    {
      const double x = points[3 * i], y = points[3 * i + 1];
      EXPECT_NEAR(v[3 * i], x * y, 1e-5);
      EXPECT_NEAR(v[3 * i + 1], 7., 1e-5);
      EXPECT_NEAR(phi[i], x * x - y, 1e-5);
      const unsigned int column = i % (n + 1);
      if (column > 0 && column < n)
        {
          EXPECT_NEAR(T[i], 20. + 5. * x, 1e-4);
        }
    }
}



TEST(ChipOutput, quadrature_fields_stay_in_the_range_of_their_cell)
{
  const SplineSpace<2> space(uniform(2, 3, 3.), uniform(2, 2, 1.));
  ChipFields           fields;
  fields.displacement.reinit(2 * space.n_functions());
  // A front inside the cells, which a polynomial would overshoot.
  fields.quadrature_scalars.emplace_back(
    "equivalent plastic strain [-]",
    at_gauss_points(space, {}, 3, [](const dealii::Point<2> &p) {
      return p[0] + p[1] > 1.5 ? 1. : 0.;
    }));
  const auto file = written(ChipOutput<2>(space, {}, 5, 3), fields);
  const auto ep   = file.field("equivalent plastic strain [-]");
  EXPECT_EQ(*std::min_element(ep.begin(), ep.end()), 0.f);
  EXPECT_EQ(*std::max_element(ep.begin(), ep.end()), 1.f);
}



TEST(ChipOutput, periods_are_drawn_side_by_side)
{
  const SplineSpace<2> space(uniform(2, 5, 10e-6, true), uniform(2, 2, 5e-6));
  ChipFields           fields;
  fields.displacement.reinit(2 * space.n_functions());
  const ChipOutput<2> output(space, {}, 2, 3);
  const auto one = written(output, fields), two = written(output, fields, 2);
  ASSERT_EQ(two.n_points, 2 * one.n_points);
  const auto points = two.points();
  double     left = 1., right = 0.;
  for (unsigned int i = 0; i < two.n_points; ++i)
    {
      left  = std::min<double>(left, points[3 * i]);
      right = std::max<double>(right, points[3 * i]);
    }
  EXPECT_NEAR(left, 0., 1e-11);
  EXPECT_NEAR(right, 20e-6, 1e-11);

  const SplineSpace<2> open(uniform(2, 5, 1.), uniform(2, 2, 1.));
  fields.displacement.reinit(2 * open.n_functions());
  EXPECT_THROW(written(ChipOutput<2>(open, {}, 2, 3), fields, 2),
               ComputationError);
}



TEST(ChipOutput, a_number_that_is_not_finite_is_refused_by_name)
{
  const double         nan = std::numeric_limits<double>::quiet_NaN();
  const SplineSpace<2> space(uniform(2, 3, 3.), uniform(2, 2, 1.));
  const ChipOutput<2>  output(space, {}, 2, 3);
  ChipFields           good;
  good.displacement.reinit(2 * space.n_functions());
  good.quadrature_scalars.emplace_back(
    "von Mises stress [Pa]",
    at_gauss_points(space, {}, 3, [](const dealii::Point<2> &) {
      return 1e9;
    }));
  written(output, good);

  // At each Gauss point of a cell.
  for (unsigned int q = 0; q < 9; ++q)
    {
      ChipFields fields                           = good;
      fields.quadrature_scalars[0].second[18 + q] = nan;
      EXPECT_NE(message_of<ComputationError>([&]() {
                  written(output, fields);
                }).find("von Mises stress [Pa]"),
                std::string::npos);
    }

  ChipFields fields      = good;
  fields.displacement[1] = nan;
  EXPECT_NE(message_of<ComputationError>([&]() {
              written(output, fields);
            }).find("displacement [m]"),
            std::string::npos);
}



TEST(ChipOutput, fields_of_another_length_are_refused_by_name)
{
  const SplineSpace<2> space(uniform(2, 3, 3.), uniform(2, 2, 1.));
  const ChipOutput<2>  output(space, {}, 2, 3);
  ChipFields           fields;
  fields.displacement.reinit(2 * space.n_functions() - 1);
  EXPECT_THROW(written(output, fields), ComputationError);
  fields.displacement.reinit(2 * space.n_functions());
  fields.quadrature_scalars.emplace_back("temperature [degC]",
                                         std::vector<double>(6 * 4));
  EXPECT_NE(message_of<ComputationError>([&]() {
              written(output, fields);
            }).find("temperature [degC]"),
            std::string::npos);
}
