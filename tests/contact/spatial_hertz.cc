#include <asperity/constitutive/hyperelasticity.h>

#include <gtest/gtest.h>

#include <cmath>

#include "ball.h"
#include "contact_examples.h"

namespace
{
  using namespace asperity;
  using dealii::Point;
  using dealii::Tensor;
  using Vector = dealii::Vector<double>;

  /** A quarter of an elastic block under a ball that presses on its corner,
   *  refined there. Lengths in units of the block's edge. */
  struct QuarterOfBlock
  {
    QuarterOfBlock(const double radius, const double contact_radius)
      : space(std::make_shared<SplineSpace<3>>(std::array<KnotVector, 3>{
          {KnotVector(2, example::equal_steps(0., 1., 5)),
           KnotVector(2, example::equal_steps(0., 1., 5)),
           KnotVector(2, example::equal_steps(-1., 0., 5))}}))
      , law(std::make_shared<NeoHooke>(elasticity()))
      , u(0)
    {
      for (unsigned int level = 1; level <= 4; ++level)
        {
          const double reach =
            std::max(1.3 * contact_radius, 0.8 * std::pow(0.5, level));
          space->refine_to_level(level,
                                 [&](const Point<3> &low,
                                     const Point<3> &high) {
                                   return std::hypot(low[0], low[1]) < reach &&
                                          high[2] > -0.6 * reach;
                                 });
        }
      ContactOptions options;
      options.penalty = 3e9;
      solid =
        std::make_unique<SolidAssembler<3>>(space, PatchGeometry<3>(), law);
      contact = std::make_unique<ContactAssembler<3>>(
        space,
        PatchGeometry<3>(),
        Edge::top,
        std::make_shared<example::Ball>(Point<3>(), radius),
        options);
      dealii::AffineConstraints<double>                constraints;
      const std::vector<std::pair<Edge, unsigned int>> held = {
        {Edge::left, 0}, {Edge::front, 1}, {Edge::bottom, 2}};
      for (const auto &[face, component] : held)
        for (const unsigned int a : space->edge_functions(face))
          constraints.add_line(displacement_dof<3>(a, component));
      constraints.close();
      u.reinit(3 * space->n_functions());
      equilibrium =
        std::make_unique<Equilibrium>(u.size(),
                                      std::vector<ForceTerm *>{solid.get(),
                                                               contact.get()},
                                      constraints,
                                      DirectSolverKind::cholmod);
    }

    static ElasticParameters
    elasticity()
    {
      ElasticParameters parameters;
      parameters.young_modulus = 1e6;
      parameters.poisson_ratio = 0.3;
      return parameters;
    }

    /** @return the force of the whole block */
    double
    press(const double depth)
    {
      Tensor<1, 3> offset;
      offset[2] = -depth;
      contact->set_obstacle_offset(offset);
      NewtonOptions options;
      options.tolerance          = 1e-4;
      options.maximum_iterations = 60;
      NewtonStatistics        statistics;
      const ConvergenceReport report =
        newton(*equilibrium, u, options, statistics);
      EXPECT_TRUE(report.converged) << report.reason;
      return -4. * contact->state().force[2];
    }

    std::shared_ptr<SplineSpace<3>>      space;
    std::shared_ptr<const MaterialLaw>   law;
    std::unique_ptr<SolidAssembler<3>>   solid;
    std::unique_ptr<ContactAssembler<3>> contact;
    std::unique_ptr<Equilibrium>         equilibrium;
    Vector                               u;
  };



  // H. Hertz: a^3 = 3 F R/(4 E*), p0 = 3 F/(2 pi a^2), and
  // p^2 = p0^2 (1 - r^2/a^2), of which a line through p^2 over r^2 tells p0 and
  // a; K. L. Johnson, Contact Mechanics (1985), section 4.2.
  TEST(SpatialHertz, ball_presses_on_a_block_as_on_a_half_space)
  {
    const double   radius = 2., a_wanted = 0.1;
    QuarterOfBlock block(radius, a_wanted);
    const double   E_star = 1e6 / (1. - 0.09);
    const double   force  = block.press(a_wanted * a_wanted / radius);
    const double   a      = std::cbrt(0.75 * force * radius / E_star);
    const double   p0     = 1.5 * force / (M_PI * a * a);
    double         n = 0., x = 0., y = 0., xx = 0., xy = 0.;
    const auto    &points = block.contact->positions();
    for (std::size_t q = 0; q < points.size(); ++q)
      {
        const double r = std::hypot(points[q][0], points[q][1]);
        if (r > 0.8 * a)
          continue;
        const double p = block.contact->pressure()[q],
                     w = block.contact->table().JxW[q];
        n += w;
        x += w * r * r;
        y += w * p * p;
        xx += w * r * r * r * r;
        xy += w * r * r * p * p;
      }
    const double slope = (n * xy - x * y) / (n * xx - x * x);
    const double level = (y - slope * x) / n;
    EXPECT_NEAR(std::sqrt(level), p0, 0.01 * p0);
    EXPECT_NEAR(std::sqrt(-level / slope), a, 0.01 * a);
    EXPECT_NEAR(a, a_wanted, 0.1 * a_wanted);
  }
} // namespace
