#include <asperity/constitutive/hyperelasticity.h>
#include <asperity/contact/penalty_warnings.h>

#include <contact/contact_examples.h>
#include <solid/loaded_solid.h>

#include <algorithm>
#include <cmath>

#include "sweeps.h"

namespace
{
  using namespace stability;
  using namespace asperity;
  using dealii::Point;

  ContactFormulation
  formulation(const Cell &cell)
  {
    return cell.text("formulation") == "mortar" ?
             ContactFormulation::mortar :
             ContactFormulation::gauss_point;
  }



  example::Discretization
  discretization(const Cell &cell)
  {
    example::Discretization result;
    result.formulation    = formulation(cell);
    result.degree         = cell.count("degree");
    result.penalty_factor = cell.number("penalty");
    result.resolution     = cell.number("elements");
    return result;
  }



  std::shared_ptr<const MaterialLaw>
  neo_hooke(const double young_modulus)
  {
    ElasticParameters elasticity;
    elasticity.young_modulus = young_modulus;
    elasticity.poisson_ratio = 0.3;
    return std::make_shared<NeoHooke>(elasticity);
  }



  /** C7 and C8: line contact of Hertz, elements on the half-width. */
  Values
  hertz(const Cell &cell)
  {
    example::HalfPlane body = example::hertz(discretization(cell));
    if (!std::isfinite(body.problem->press(body.force, body.depth)))
      throw Reported(body.problem->last.reason);
    return {{"pressure",
             example::pressure_error(*body.problem,
                                     2.,
                                     [&](const double x) {
                                       return example::hertz_pressure(body, x);
                                     })},
            {"force", std::abs(body.problem->force() / body.force - 1.)},
            {"iterations", double(body.problem->statistics.iterations)}};
  }



  /** C9: a wave pressed until all of it touches; its smooth pressure is exact,
   *  a checkerboard is not. */
  Values
  full_contact(const Cell &cell)
  {
    example::Westergaard wave(discretization(cell));
    if (!wave.press(0.5))
      throw Reported(wave.problem->last.reason);
    return {{"pressure",
             example::pressure_error(*wave.problem,
                                     0.5,
                                     [&](const double x) {
                                       return wave.exact_pressure(0.5, x);
                                     })},
            {"iterations", double(wave.problem->statistics.iterations)}};
  }



  /** C10: a wavy tool on a wavy body; the forces at the clamped bottom against
   *  those of the contact, their moments, and the tangent against differences.
   */
  Values
  curved_balance(const Cell &cell)
  {
    const double   amplitude = cell.number("amplitude");
    const unsigned degree    = cell.count("degree");
    const auto     space     = std::make_shared<SplineSpace<2>>(
      KnotVector(degree, example::equal_steps(0., 1., 20), true),
      KnotVector(degree, example::equal_steps(-0.5, 0., 6)));
    ContactOptions options;
    options.formulation = formulation(cell);
    options.penalty     = 20. * cell.number("penalty");
    const auto skew     = [amplitude](const double x) {
      return amplitude * (1.4 - std::cos(2. * M_PI * x) -
                          0.4 * std::sin(4. * M_PI * x + 0.3));
    };
    example::ContactProblem problem(space,
                                    neo_hooke(1.),
                                    example::periodic_tool(skew, 1., 48),
                                    options);
    problem.options.tolerance = 1e-12;
    const double depth        = 0.5 * amplitude + 0.01;
    if (!problem.move(0., depth))
      throw Reported(problem.last.reason);
    dealii::Vector<double> R(problem.u.size());
    problem.equilibrium->forces(problem.u, R);
    dealii::Tensor<1, 2> bottom;
    for (const unsigned int a : space->edge_functions(Edge::bottom))
      for (unsigned int c = 0; c < 2; ++c)
        bottom[c] += R(2 * a + c);
    const auto             force = problem.contact->state().force;
    dealii::Vector<double> nodal(problem.u.size());
    problem.contact->add(problem.u, nodal, nullptr);
    dealii::Tensor<1, 2> sum;
    for (unsigned int i = 0; i < nodal.size(); ++i)
      sum[i % 2] -= nodal(i);
    return {{"balance", (bottom + force).norm() / force.norm()},
            {"sum", (sum - force).norm() / force.norm()},
            {"tangent",
             loaded_solid::tangent_error(
               *problem.contact,
               problem.u,
               loaded_solid::random_vector(problem.u.size(), 1e-3),
               1e-6)}};
  }



  /** C13: a block under a ceiling that has come down by a shift, from zero over
   *  round-off to a percent; -P22 = epsilon (shift - compression). */
  Answer
  flat_on_flat(const Cell &cell)
  {
    const double   shift = cell.number("shift"), E = 1e6;
    ContactOptions options;
    options.formulation = formulation(cell);
    options.penalty     = E * cell.number("penalty");
    const auto space    = std::make_shared<SplineSpace<2>>(
      KnotVector(2, {0., 0.3, 0.5, 0.9, 1.3, 1.5, 2.}),
      KnotVector(2, {0., 0.3, 0.6, 0.8, 1.}));
    example::ContactProblem problem(space,
                                    neo_hooke(E),
                                    std::make_shared<example::Ceiling>(1.),
                                    options,
                                    example::Support::rollers);
    // Rounding a position costs penalty times 1e-16 times the length.
    problem.options.tolerance = std::max(1e-9, 1e-15 * options.penalty);
    unsigned int iterations   = 0;
    for (const double s : {0., shift, -shift, shift})
      {
        if (!problem.solve(0., -s).converged)
          throw Reported(problem.last.reason);
        iterations = std::max(iterations, problem.last.iterations);
      }
    // Small strain, plane: E' = E/(1 - nu^2) where the sides are free.
    const double stiffness = E / (1. - 0.09);
    const double pressure =
      shift > 0. ? shift / (1. / options.penalty + 1. / stiffness) : 0.;
    // Below a strain of 1e-9, or a gap of a thousand roundings, all is
    // round-off.
    const double found = 0.5 * problem.force();
    // The tolerance of a run.
    return {
      {{"pressure",
        std::abs(found - pressure) /
          std::max({pressure, 1e-9 * stiffness, 1e-13 * options.penalty})},
       {"iterations", double(iterations)}},
      shift > 0. ? rounding_warning(options.penalty, 1., pressure, 1e-4) : ""};
  }
} // namespace



namespace stability
{
  Sweeps
  contact_sweeps()
  {
    return {{"C8", hertz},
            {"C9", full_contact},
            {"C10", curved_balance},
            {"C13", flat_on_flat}};
  }
} // namespace stability
