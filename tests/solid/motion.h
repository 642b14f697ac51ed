#ifndef asperity_tests_solid_motion_h
#define asperity_tests_solid_motion_h

#include <asperity/time_integration/generalized_alpha.h>

#include "loaded_solid.h"

namespace loaded_solid
{
  /** A body in time, by generalized-alpha, under its load from t = 0 on. */
  class Motion
  {
  public:
    Motion(Body &body, const double rho)
      : method(rho)
      , body(body)
      , mass(body.equilibrium().make_matrix())
      , old_forces(body.u.size())
    {
      method.u.reinit(body.u.size());
      method.v.reinit(body.u.size());
      method.a.reinit(body.u.size());
      body.solid.assemble_mass(*mass);
    }

    /** The acceleration of the load at rest, M a = load - f(0). */
    void
    start_with_load(const double tolerance)
    {
      // By Newton's method, so that supports count; scaled, since the internal
      // force is evaluated (with weight 0) at what is an acceleration here.
      const double scale = 1e-9;
      old_forces         = body.load;
      old_forces *= -1.;
      Vector constant = old_forces;
      constant *= scale;
      body.equilibrium().set_inertia(mass.get(), 1., constant, 0.);
      Vector a(body.u.size());
      check(body.newton_from(a, scale * tolerance));
      method.a = a;
      method.a /= scale;
    }

    void
    step(const double dt, const double tolerance)
    {
      Vector constant(body.u.size());
      mass->vmult(constant, method.constant(dt));
      constant.add(method.alpha_f(), old_forces);
      body.solid.set_time_step(dt);
      body.equilibrium().set_load(body.load);
      body.equilibrium().set_inertia(mass.get(),
                                     method.mass_factor(dt),
                                     constant,
                                     1. - method.alpha_f());
      Vector u = method.predict(dt);
      for (const auto &line : body.constraints.get_lines())
        u(line.index) = body.u(line.index);
      ConvergenceReport report = body.newton_from(u, tolerance);
      if (!report.converged)
        {
          u      = body.u;
          report = body.newton_from(u, tolerance);
        }
      check(report);
      body.equilibrium().forces(u, old_forces);
      old_forces -= body.load;
      method.advance(u, dt);
      body.solid.accept();
      body.u = u;
    }

    double
    kinetic_energy() const
    {
      Vector momentum(body.u.size());
      mass->vmult(momentum, method.v);
      return 0.5 * (momentum * method.v);
    }

    GeneralizedAlpha method;

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
    Vector                  old_forces;
  };
} // namespace loaded_solid

#endif
