#include <asperity/base/errors.h>
#include <asperity/isogeometric/spline_manifold.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Walls of meshes that are splines.

using namespace asperity;
using dealii::MappingQ;
using dealii::Point;
using dealii::Triangulation;
namespace GridGenerator = dealii::GridGenerator;

namespace
{
  /** A quarter of the circle of a radius, exactly. */
  SplineCurve
  quarter_circle(const double r)
  {
    return SplineCurve(KnotVector(2, {0., 1.}),
                       {Point<2>(r, 0.), Point<2>(r, r), Point<2>(0., r)},
                       {1., std::sqrt(0.5), 1.});
  }

  /** Two layers of n cells between two curves that run alike, on which walls 2
   *  and 3 are; refined. */
  void
  make_layer(Triangulation<2>  &mesh,
             const SplineCurve &lower,
             const SplineCurve &upper,
             const unsigned int n,
             const unsigned int n_refinements)
  {
    GridGenerator::subdivided_hyper_rectangle(
      mesh, {n, 2}, Point<2>(), Point<2>(1., 1.), true);
    dealii::GridTools::transform(
      [&](const Point<2> &s) {
        return Point<2>((1. - s[1]) * lower.value(s[0]) +
                        s[1] * upper.value(s[0]));
      },
      mesh);
    set_spline_wall(mesh, 2, lower);
    set_spline_wall(mesh, 3, upper);
    mesh.refine_global(n_refinements);
  }

  /** How far the mapped walls are off their curves, between the nodes. */
  double
  largest_distance(const Triangulation<2> &mesh,
                   const SplineCurve      &lower,
                   const SplineCurve      &upper,
                   const unsigned int      degree)
  {
    const ClosestPoint below(lower), above(upper);
    const MappingQ<2>  mapping(degree);
    double             largest = 0.;
    for (const auto &cell : mesh.active_cell_iterators())
      for (const unsigned int f : {2, 3})
        if (cell->at_boundary(f))
          for (const double t : {0.13, 0.3, 0.41, 0.64, 0.87})
            {
              const Point<2> X = mapping.transform_unit_to_real_cell(
                cell, Point<2>(t, f == 3 ? 1. : 0.));
              const ClosestPoint &curve =
                cell->face(f)->boundary_id() == 2 ? below : above;
              largest = std::max(largest, std::abs(curve.project(X).distance));
            }
    return largest;
  }
} // namespace

TEST(SplineManifold, new_nodes_of_walls_lie_on_NURBS_arcs)
{
  Triangulation<2> mesh;
  make_layer(mesh, quarter_circle(1.), quarter_circle(1.5), 3, 2);
  unsigned int n_nodes = 0;
  for (const unsigned int degree : {1, 2, 3, 4})
    {
      const dealii::FE_Q<2> nodes(degree);
      const MappingQ<2>     mapping(degree);
      for (const auto &cell : mesh.active_cell_iterators())
        for (const unsigned int f : {2, 3})
          if (cell->at_boundary(f))
            for (const Point<1> &t : nodes.get_unit_face_support_points(f))
              {
                const double   r = f == 2 ? 1. : 1.5;
                const Point<2> X = mapping.transform_unit_to_real_cell(
                  cell, Point<2>(t[0], f == 3 ? 1. : 0.));
                EXPECT_NEAR(X.norm(), r, 1e-12);
                ++n_nodes;
              }
    }
  EXPECT_EQ(n_nodes, 2 * 12 * (2 + 3 + 4 + 5));
}

// A mapping of degree p interpolates the walls: its error is of the order
// p + 1.
TEST(SplineManifold, mapped_walls_converge_by_their_degree)
{
  const SplineCurve lower(KnotVector(3, {0., 1.}),
                          {Point<2>(0., 0.),
                           Point<2>(0.3, 0.3),
                           Point<2>(0.7, -0.2),
                           Point<2>(1., 0.1)},
                          {1., 2., 0.7, 1.});
  const SplineCurve upper(KnotVector(3, {0., 1.}),
                          {Point<2>(0., 0.5),
                           Point<2>(0.3, 0.4),
                           Point<2>(0.7, 0.8),
                           Point<2>(1., 0.6)},
                          {1., 0.8, 1.5, 1.});
  for (const unsigned int degree : {2, 3})
    {
      std::vector<double> errors;
      for (const unsigned int n_refinements : {1, 2, 3})
        {
          Triangulation<2> mesh;
          make_layer(mesh, lower, upper, 6, n_refinements);
          errors.push_back(largest_distance(mesh, lower, upper, degree));
        }
      for (const unsigned int i : {0, 1})
        EXPECT_GT(std::log2(errors[i] / errors[i + 1]), degree + 1 - 0.3)
          << "degree " << degree;
    }
}

TEST(SplineManifold, vertices_off_the_curve_are_refused)
{
  Triangulation<2> mesh;
  GridGenerator::subdivided_hyper_rectangle(
    mesh, {2, 1}, Point<2>(), Point<2>(1., 1.), true);
  try
    {
      set_spline_wall(mesh, 2, quarter_circle(1.));
      FAIL() << "no exception";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what()).find("off the spline of its wall"),
                std::string::npos)
        << error.what();
    }
}
