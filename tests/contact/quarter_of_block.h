#ifndef asperity_tests_contact_quarter_of_block_h
#define asperity_tests_contact_quarter_of_block_h

#include <asperity/constitutive/hyperelasticity.h>
#include <asperity/constitutive/material_parameters.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "ball.h"
#include "contact_examples.h"

namespace example
{
  using namespace asperity;

  /** A quarter of a block under a ball that presses on its corner,
   *  refined there. Lengths in units of the block's edge. */
  struct QuarterOfBlock
  {
    using Vector = dealii::Vector<double>;

    /** @param levels of refinement; each halves elements of a fifth */
    QuarterOfBlock(const double                              radius,
                   const double                              contact_radius,
                   const std::shared_ptr<const MaterialLaw> &law    = elastic(),
                   const unsigned int                        levels = 4)
      : space(std::make_shared<SplineSpace<3>>(std::array<KnotVector, 3>{
          {KnotVector(2, example::equal_steps(0., 1., 5)),
           KnotVector(2, example::equal_steps(0., 1., 5)),
           KnotVector(2, example::equal_steps(-1., 0., 5))}}))
      , law(law)
      , u(0)
    {
      for (unsigned int level = 1; level <= levels; ++level)
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
      solid->set_time_step(1.);
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
                                      LinearSolverKind::cholmod);
    }

    static std::shared_ptr<const MaterialLaw>
    elastic()
    {
      return std::make_shared<NeoHooke>(elasticity());
    }

    /** Von Mises's plasticity without hardening. */
    static std::shared_ptr<const MaterialLaw>
    plastic(const double yield_stress)
    {
      MaterialParameters material;
      material.elasticity = elasticity();
      material.choose(VoceParameters{yield_stress, yield_stress, 0., 0.});
      return material.make_law();
    }

    /** E/(1 - nu^2) */
    static double
    reduced_modulus()
    {
      const ElasticParameters e = elasticity();
      return e.young_modulus / (1. - e.poisson_ratio * e.poisson_ratio);
    }

    /** The state becomes that of the start of the next press(). */
    void
    accept()
    {
      solid->accept();
    }

    double
    largest_plastic_strain() const
    {
      double largest = 0.;
      for (const MaterialState &point : solid->history())
        largest = std::max(largest, point.plastic_strain);
      return largest;
    }

    /** Projected area of what touches, of the whole block. */
    double
    touching_area() const
    {
      double area = 0.;
      // The pressure of a mortar reaches beyond the last function that bears.
      for (unsigned int q = 0; q < contact->gaps().size(); ++q)
        if (contact->gaps()[q].gap < 0.)
          area += 4. * contact->table().JxW[q];
      return area;
    }

    /** @return the force of the whole block
     *  @throws std::runtime_error if no balance is found */
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
      if (!report.converged)
        throw std::runtime_error(report.reason);
      return -4. * contact->state().force[2];
    }

    std::shared_ptr<SplineSpace<3>>      space;
    std::shared_ptr<const MaterialLaw>   law;
    std::unique_ptr<SolidAssembler<3>>   solid;
    std::unique_ptr<ContactAssembler<3>> contact;
    std::unique_ptr<Equilibrium>         equilibrium;
    Vector                               u;
  };
} // namespace example

#endif
