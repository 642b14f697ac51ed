#include <asperity/isogeometric/edge_trace.h>
#include <asperity/isogeometric/spline_manifold.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/fe/mapping_q_cache.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <cmath>

#include "example_spaces.h"

using namespace asperity;
using dealii::Point;
using dealii::Tensor;

namespace
{
  PatchGeometry<2>
  random_geometry(const SplineSpace<2> &space)
  {
    PatchGeometry<2> geometry;
    const auto       c = example::random_coefficients(2 * space.n_functions());
    for (unsigned int a = 0; a < space.n_functions(); ++a)
      geometry.offset.push_back(
        Point<2>(0.004 * c[2 * a], 0.004 * c[2 * a + 1]));
    return geometry;
  }

  /** The geometry as deal.II has it, which forms its own Jacobians: a spline is
   *  a polynomial on each cell. Not of degree 1: FEValues (deal.II 9.4) then
   *  takes the Jacobians of a cell for those of the next one whenever both have
   *  the same shape in the triangulation, whatever the cached points are. */
  void
  initialize(dealii::MappingQCache<2> &mapping,
             const SplineSpace<2>     &space,
             const PatchGeometry<2>   &geometry)
  {
    // deal.II's points of the parameter mesh are parameters. They lie on cell
    // faces, too, where the polynomials of this very cell are to be taken.
    mapping.initialize(
      dealii::MappingQ1<2>(),
      space.triangulation(),
      [&](const dealii::Triangulation<2>::cell_iterator &cell,
          const Point<2>                                &parameter) {
        Point<2> X = parameter;
        if (!cell->is_active())
          return X;
        const unsigned int  c = cell->active_cell_index();
        std::vector<double> values;
        space.evaluate(c, parameter, values);
        for (unsigned int a = 0; a < values.size(); ++a)
          X += values[a] * geometry.offset[space.cell_functions(c)[a]];
        return X;
      },
      /*function_describes_relative_displacement=*/false);
  }
} // namespace

TEST(EdgeTrace, the_curve_is_the_edge_of_the_patch)
{
  for (const auto &[name, space] : example::all())
    for (const Edge edge : {Edge::left, Edge::right, Edge::bottom, Edge::top})
      {
        const auto      geometry = random_geometry(*space);
        const EdgeTrace trace(*space->hierarchy(), edge);
        const auto      curve    = trace.curve(geometry.offset);
        const bool      vertical = edge == Edge::left || edge == Edge::right;
        for (const auto &random : example::random_points(40))
          {
            const double t = vertical ? random[1] : random[0];
            Point<2>     parameter(t, edge == Edge::top ? 1. : 0.);
            if (vertical)
              parameter = Point<2>(edge == Edge::right ? 2. : 0., t);
            EXPECT_NEAR(
              (curve.value(t) - geometry.position(*space, parameter)).norm(),
              0.,
              1e-13)
              << name;
          }
        // Continuity: one knot where cells meet.
        EXPECT_EQ(trace.knots().n_spans(), space->edge_cells(edge).size());
      }
}

TEST(EdgeTrace, a_periodic_edge_goes_on_beyond_the_period)
{
  const auto space    = example::graded(3, true);
  const auto geometry = random_geometry(*space);
  const auto curve =
    EdgeTrace(*space->hierarchy(), Edge::top).curve(geometry.offset);
  for (const double t : {-3.7, -0.01, 0.3, 2.01, 9.3})
    EXPECT_NEAR(
      (curve.value(t) - geometry.position(*space, Point<2>(t, 1.))).norm(),
      0.,
      1e-12);
}

TEST(EdgeTrace, multiple_knots_keep_their_kinks)
{
  // A double knot at 0.5 in a quadratic space: the edge may have a corner.
  SplineSpace<2> space(
    KnotVector::from_knots(2, {0., 0., 0., 0.5, 0.5, 1., 1., 1.}),
    KnotVector(2, {0., 0.5, 1.}));
  space.refine_to_level(1, [](const Point<2> &low, const Point<2> &) {
    return low[0] > 0.4;
  });
  const auto geometry = random_geometry(space);
  const auto curve =
    EdgeTrace(*space.hierarchy(), Edge::bottom).curve(geometry.offset);
  for (const double t : {0., 0.2, 0.5, 0.6, 0.77, 1.})
    EXPECT_NEAR(
      (curve.value(t) - geometry.position(space, Point<2>(t, 0.))).norm(),
      0.,
      1e-14);
}

TEST(SplineManifold, chart_and_curve_are_inverse)
{
  const auto           space    = example::graded(3, true);
  const auto           geometry = random_geometry(*space);
  const SplineManifold manifold(
    EdgeTrace(*space->hierarchy(), Edge::top).curve(geometry.offset));
  for (const auto &random : example::random_points(50))
    {
      const Point<1> t(random[0]);
      const Point<2> X = manifold.push_forward(t);
      EXPECT_NEAR(manifold.pull_back(X)[0], t[0], 1e-9);
      const double h        = 1e-6;
      const auto   gradient = manifold.push_forward_gradient(t);
      const auto   secant   = (manifold.push_forward(Point<1>(t[0] + h)) -
                           manifold.push_forward(Point<1>(t[0] - h))) /
                          (2. * h);
      for (unsigned int d = 0; d < 2; ++d)
        EXPECT_NEAR(gradient[d][0], secant[d], 1e-7);
    }
}

TEST(SplineManifold, refined_boundary_vertices_lie_on_the_curve)
{
  // A layer above a wavy curve y = 0.1 sin(pi x), as the fluid's mesh has it.
  const KnotVector    knots(3, example::breakpoints(9, 2.), true);
  const auto          greville = knots.greville();
  std::vector<double> heights;
  for (const double x : greville)
    heights.push_back(0.1 * std::sin(M_PI * x));
  const SplineManifold manifold(SplineCurve::graph(knots, heights));

  dealii::Triangulation<2> mesh;
  dealii::GridGenerator::subdivided_hyper_rectangle(
    mesh, {4, 1}, Point<2>(0., 0.), Point<2>(2., 0.5), true);
  for (const auto &cell : mesh.active_cell_iterators())
    for (const unsigned int v : {0, 1})
      cell->vertex(v) = manifold.push_forward(
        Point<1>(0.5 * std::round(2. * cell->vertex(v)[0])));
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == 2)
      face->set_manifold_id(7);
  mesh.set_manifold(7, manifold);
  mesh.refine_global(2);

  unsigned int n_vertices = 0;
  for (const auto &face : mesh.active_face_iterators())
    if (face->at_boundary() && face->boundary_id() == 2)
      for (const unsigned int v : {0, 1})
        {
          const Point<2> X = face->vertex(v);
          EXPECT_NEAR(X[1], manifold.curve().value(X[0])[1], 1e-13);
          ++n_vertices;
        }
  EXPECT_EQ(n_vertices, 32);
}

TEST(BasisTable, has_the_points_and_measures_of_a_mapping_of_deal_ii)
{
  for (const auto &[name, space] : example::all())
    {
      const auto               geometry = random_geometry(*space);
      dealii::MappingQCache<2> mapping(std::max(2u, space->degree()));
      initialize(mapping, *space, geometry);
      const dealii::QGauss<2> quadrature(3);
      const auto table = tabulate_cells(*space, geometry, quadrature);
      const dealii::FE_Q<2> element(1);
      dealii::FEValues<2>   values(mapping,
                                 element,
                                 quadrature,
                                 dealii::update_quadrature_points |
                                   dealii::update_JxW_values);
      for (const auto &cell : space->triangulation().active_cell_iterators())
        {
          values.reinit(cell);
          const unsigned int first =
            table.elements[cell->active_cell_index()].first_point;
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              EXPECT_NEAR(
                (values.quadrature_point(q) - table.position[first + q]).norm(),
                0.,
                1e-13)
                << name;
              EXPECT_NEAR(values.JxW(q) / table.JxW[first + q], 1., 1e-10)
                << name;
            }
        }
    }
}
