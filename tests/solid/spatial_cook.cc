#include <gtest/gtest.h>

#include "cook_membrane.h"

namespace
{
  using namespace loaded_solid;

  /**
   * The tapered panel of cook_membrane() as a block of 10 mm between the faces
   * `front` and `back`: x and z are the coordinates of the membrane, y goes
   * across it.
   */
  struct CookBlock
  {
    static constexpr double thickness = 10e-3;

    static Point<3>
    map(const Point<3> &xi)
    {
      return {48e-3 * xi[0],
              thickness * xi[1],
              44e-3 * xi[0] + (44e-3 - 28e-3 * xi[0]) * xi[2]};
    }

    /** The faces `front` and `back` keep their planes.
     *  @param n_across elements across */
    CookBlock(const unsigned int degree,
              const unsigned int n,
              const unsigned int n_across)
      : space(std::make_shared<SplineSpace<3>>(
          std::array<KnotVector, 3>{{KnotVector(degree, equal_spans(n)),
                                     KnotVector(degree, equal_spans(n_across)),
                                     KnotVector(degree, equal_spans(n))}}))
      , geometry(PatchGeometry<3>::from_map(*space, map))
      , solid(space, geometry, cook_material().make_law())
      , load(EdgeLoad<3>::dead_traction(
          *space,
          geometry,
          Edge::right,
          [](const Point<3> &, const Tensor<1, 3> &) {
            return Point<3>(0., 0., cook_traction);
          }))
      , u(3 * space->n_functions())
    {
      for (const unsigned int a : space->edge_functions(Edge::left))
        for (unsigned int i = 0; i < 3; ++i)
          constraints.add_line(displacement_dof<3>(a, i));
      for (const Edge face : {Edge::front, Edge::back})
        for (const unsigned int a : space->edge_functions(face))
          constraints.add_line(displacement_dof<3>(a, 1));
      constraints.close();
    }

    /** @return height that the upper edge on the right has risen by [m], at
     *  both of its ends */
    std::array<double, 2>
    rise(const unsigned int n_steps)
    {
      Equilibrium equilibrium(u.size(), {&solid, &load}, constraints);
      for (unsigned int step = 1; step <= n_steps; ++step)
        {
          load.set_factor(double(step) / n_steps);
          NewtonStatistics        statistics;
          const ConvergenceReport report =
            newton(equilibrium, u, newton_options(1e-3), statistics);
          EXPECT_TRUE(report.converged) << report.reason;
          solid.accept();
        }
      return {{height({1., 0., 1.}), height({1., 1., 1.})}};
    }

    double
    height(const Point<3> &parameter) const
    {
      const unsigned int  cell = space->find_cell(parameter);
      std::vector<double> N;
      space->evaluate(cell, parameter, N);
      double sum = 0.;
      for (unsigned int a = 0; a < N.size(); ++a)
        sum += N[a] * u(displacement_dof<3>(space->cell_functions(cell)[a], 2));
      return sum;
    }

    std::shared_ptr<SplineSpace<3>>   space;
    PatchGeometry<3>                  geometry;
    SolidAssembler<3>                 solid;
    EdgeLoad<3>                       load;
    dealii::AffineConstraints<double> constraints;
    Vector                            u;
  };
} // namespace



// The membrane's value is compared with published ones in plasticity.cc.
TEST(CookBlock, held_between_planes_is_the_membrane_in_plane_strain)
{
  const double membrane = cook_membrane(2, 4, 10);
  for (const unsigned int n_across : {1, 2})
    for (const double rise : CookBlock(2, 4, n_across).rise(10))
      EXPECT_NEAR(rise / membrane, 1., 1e-8);
}
