#ifndef asperity_tests_solid_motion_h
#define asperity_tests_solid_motion_h

#include <asperity/solid/solid_step.h>

#include "loaded_solid.h"

namespace loaded_solid
{
  /** A body in time, by generalized-alpha, under its load from t = 0 on. */
  class Motion
  {
  public:
    Motion(Body &body, const double rho)
      : body(body)
      , mass(body.equilibrium().make_matrix())
      , solid_step(body.solid, body.equilibrium(), body.u, rho)
    {
      body.solid.assemble_mass(*mass);
    }

    /** The acceleration of the load at rest, M a = load - f(0). */
    void
    start_with_load(const double tolerance)
    {
      // By Newton's method, so that supports count; scaled, since the internal
      // force is evaluated (with weight 0) at what is an acceleration here.
      const double     scale = 1e-9;
      SolidStep::State start = solid_step.state();
      start.forces -= body.load;
      Vector constant = start.forces;
      constant *= scale;
      body.equilibrium().set_inertia(mass.get(), 1., constant, 0.);
      check(body.newton_from(start.a, scale * tolerance));
      start.a /= scale;
      solid_step.set_state(start);
    }

    /** @param velocity coefficients at the start [m/s] */
    void
    start_with_velocity(const Vector &velocity)
    {
      SolidStep::State start = solid_step.state();
      start.v                = velocity;
      solid_step.set_state(start);
    }

    void
    step(const double dt, const double tolerance)
    {
      solid_step.begin(dt, body.load);
      Vector u = solid_step.predict();
      for (const auto &line : body.constraints.get_lines())
        u(line.index) = body.u(line.index);
      const NewtonOptions options = newton_options(tolerance);
      ConvergenceReport report = solid_step.solve(u, options, body.statistics);
      if (!report.converged)
        {
          u      = body.u;
          report = solid_step.solve(u, options, body.statistics);
        }
      check(report);
      solid_step.accept(u);
      body.u = u;
    }

    double
    kinetic_energy() const
    {
      const Vector velocity = solid_step.state().v;
      Vector       momentum(velocity.size());
      mass->vmult(momentum, velocity);
      return 0.5 * (momentum * velocity);
    }

  private:
    static void
    check(const ConvergenceReport &report)
    {
      if (!report.converged)
        throw std::runtime_error("a time step failed: " + report.reason +
                                 ", residual " +
                                 std::to_string(report.residual));
    }

    Body                   &body;
    std::unique_ptr<Matrix> mass;
    SolidStep               solid_step;
  };
} // namespace loaded_solid

#endif
