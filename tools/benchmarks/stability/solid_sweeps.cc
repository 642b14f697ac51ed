#include <asperity/constitutive/hyperelasticity.h>
#include <asperity/contact/contact_assembler.h>

#include <contact/contact_problem.h>
#include <solid/motion.h>

#include <algorithm>
#include <cmath>

#include "sweeps.h"

namespace
{
  using namespace stability;
  using namespace loaded_solid;

  /** C17: a thick elastic cylinder under pressure inside, nearly
   *  incompressible; the way of its inner face against Lame's formula. */
  Values
  thick_cylinder(const Cell &cell)
  {
    const double       nu = cell.number("poisson"), a = 1., b = 2., p = 1e-4;
    const unsigned int degree = cell.count("degree"), n = cell.count("cells");
    MaterialParameters material;
    material.elasticity.young_modulus = 1.;
    material.elasticity.poisson_ratio = nu;
    material.elasticity.validate();
    Body body(
      make_space(degree, equal_spans(n), equal_spans(2 * n)),
      [&](const Point<2> &xi) {
        const double R     = a + (b - a) * xi[0];
        const double angle = 0.5 * dealii::numbers::PI * xi[1];
        return Point<2>(R * std::cos(angle), R * std::sin(angle));
      },
      std::make_shared<NeoHooke>(material.elasticity));
    body.prescribe(Edge::bottom, 1);
    body.prescribe(Edge::top, 0);
    body.add_pressure(Edge::left, [p](const Point<2> &) { return p; });
    body.solve(1e-10);
    const double way   = body.displacement({0., 0.5}).norm();
    const double exact = (1. + nu) * p * a * a / (b * b - a * a) *
                         ((1. - 2. * nu) * a + b * b / a);
    return {{"displacement", std::abs(way / exact - 1.)}};
  }



  /** A bar of length 10 that flies upwards against a rigid wall: rho = 1,
   *  E = 900, nu = 0, so that waves travel at c = 30. */
  class FlyingBar
  {
  public:
    static constexpr double       length = 10., speed = 0.03, wave = 30.;
    static constexpr unsigned int cells = 20;

    FlyingBar(const double penalty_factor, const double rho)
      : body(
          make_space(2, equal_spans(1), equal_spans(cells)),
          [](const Point<2> &xi) {
            return Point<2>(xi[0], length * (xi[1] - 1.));
          },
          std::make_shared<NeoHooke>(elasticity()))
      , contact(body.space,
                body.geometry,
                Edge::top,
                std::make_shared<example::Ceiling>(0.),
                options(penalty_factor))
    {
      for (const Edge side : {Edge::left, Edge::right})
        for (const unsigned int f : body.space->edge_functions(side))
          constraints.add_line(2 * f);
      constraints.close();
      system =
        std::make_unique<Equilibrium>(body.u.size(),
                                      std::vector<ForceTerm *>{&body.solid,
                                                               &contact},
                                      constraints);
      mass = system->make_matrix();
      body.solid.assemble_mass(*mass);
      step = std::make_unique<SolidStep>(body.solid, *system, body.u, rho);
      SolidStep::State start = step->state();
      for (unsigned int i = 1; i < start.v.size(); i += 2)
        start.v(i) = speed;
      step->set_state(start);
    }

    /** @return the force on the wall at the end of the step [N/m] */
    double
    advance(const double dt)
    {
      step->begin(dt);
      Vector                  u = step->predict();
      const ConvergenceReport report =
        step->solve(u, newton_options(1e-9), statistics);
      if (!report.converged)
        throw Reported(report.reason);
      step->accept(u);
      return -contact.state().force[1];
    }

    const MotionEnergy &
    energy() const
    {
      return step->energy();
    }

    double
    kinetic_energy() const
    {
      const Vector v = step->state().v;
      Vector       momentum(v.size());
      mass->vmult(momentum, v);
      return 0.5 * (momentum * v);
    }

    double
    mean_velocity() const
    {
      const Vector v = step->state().v;
      Vector       momentum(v.size());
      mass->vmult(momentum, v);
      double sum = 0.;
      for (unsigned int i = 1; i < v.size(); i += 2)
        sum += momentum(i);
      return sum / length;
    }

  private:
    static ElasticParameters
    elasticity()
    {
      ElasticParameters bar;
      bar.density       = 1.;
      bar.young_modulus = wave * wave;
      bar.poisson_ratio = 0.;
      return bar;
    }

    static ContactOptions
    options(const double penalty_factor)
    {
      ContactOptions options;
      options.penalty = penalty_factor * wave * wave / (length / cells);
      return options;
    }

    Body                              body;
    ContactAssembler<2>               contact;
    dealii::AffineConstraints<double> constraints;
    std::unique_ptr<Equilibrium>      system;
    std::unique_ptr<Matrix>           mass;
    std::unique_ptr<SolidStep>        step;
    NewtonStatistics                  statistics;
  };



  /** C12: the bar leaves with the velocity with which it came, after 2 L/c
   *  under the pressure rho c v. */
  Answer
  bar_impact(const Cell &cell)
  {
    FlyingBar    bar(cell.number("penalty"), cell.number("rho"));
    const double contact_time = 2. * FlyingBar::length / FlyingBar::wave;
    // Courant number: part of an element that a wave travels in a step
    const double dt = cell.number("courant") * FlyingBar::length /
                      FlyingBar::cells / FlyingBar::wave;
    const double energy  = bar.kinetic_energy();
    double       impulse = 0., highest = 0., largest = 0.;
    for (double t = 0.; t < 1.5 * contact_time; t += dt)
      {
        const double force = bar.advance(dt);
        impulse += force * dt;
        largest = std::max(largest, force);
        highest = std::max(highest, bar.kinetic_energy());
      }
    const double pressure = FlyingBar::wave * FlyingBar::speed;
    return {{{"velocity",
              std::abs(bar.mean_velocity() / FlyingBar::speed + 1.)},
             {"energy", highest / energy - 1.},
             {"lost", bar.energy().lost_part(0.)},
             {"overshoot", largest / pressure - 1.},
             {"impulse", std::abs(impulse / (pressure * contact_time) - 1.)}},
            bar.energy().warning(0.)};
  }
} // namespace



namespace stability
{
  Sweeps
  solid_sweeps()
  {
    return {{"C12", bar_impact}, {"C17", thick_cylinder}};
  }
} // namespace stability
