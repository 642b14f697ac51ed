#include <asperity/constitutive/material_parameters.h>
#include <asperity/coupling/spline_solid.h>

#include <deal.II/base/quadrature_lib.h>

#include <gtest/gtest.h>

using namespace asperity;
using dealii::Point;
using Vector = dealii::Vector<double>;

namespace
{
  /** A square block on a clamped bottom, loaded at points of its top. */
  struct Block
  {
    Block()
      : space(std::make_shared<SplineSpace<2>>(KnotVector(2, {0., 0.5, 1.}),
                                               KnotVector(2, {0., 0.5, 1.})))
      , geometry(
          PatchGeometry<2>::from_map(*space,
                                     [](const Point<2> &xi) { return xi; }))
      , interface(*space,
                  geometry,
                  {{Edge::top, 0.2}, {Edge::top, 0.5}, {Edge::top, 0.9}})
      , assembler(space, geometry, MaterialParameters().make_law())
    {
      for (const unsigned int a : space->edge_functions(Edge::bottom))
        for (unsigned int c = 0; c < 2; ++c)
          constraints.add_line(displacement_dof<2>(a, c));
      constraints.close();
    }

    std::shared_ptr<SplineSpace<2>>   space;
    PatchGeometry<2>                  geometry;
    Interface                         interface;
    SolidAssembler<2>                 assembler;
    dealii::AffineConstraints<double> constraints;
  };

  Vector
  force(const double size)
  {
    Vector f(6);
    f    = size;
    f(3) = -2. * size;
    return f;
  }
} // namespace

TEST(SplineSolid, forgets_the_forces_of_an_iteration_that_has_diverged)
{
  Block       block;
  SplineSolid solid(block.assembler, block.constraints, block.interface);
  Vector      expected, found;
  solid.begin_step(1e-3);
  ASSERT_TRUE(solid.solve(force(1e7), expected).converged);
  ASSERT_GT(expected.l2_norm(), 0.);

  solid.begin_step(1e-3);
  solid.solve(force(1e20), found); // whatever becomes of it
  solid.begin_step(1e-3);
  ASSERT_TRUE(solid.solve(force(1e7), found).converged);
  found -= expected;
  EXPECT_LT(found.l2_norm(), 1e-6 * expected.l2_norm());
}
