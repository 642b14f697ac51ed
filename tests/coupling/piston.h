#ifndef asperity_tests_coupling_piston_h
#define asperity_tests_coupling_piston_h

#include <asperity/coupling/partitioned_step.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

/**
 * A piston on a chamber, the smallest problem of fluid and solid: one
 * displacement d, one pressure p, both stepped by implicit Euler, so that both
 * sides have an impedance known in closed form.
 */
namespace piston
{
  using namespace asperity;
  using Vector = dealii::Vector<double>;

  constexpr double infinity = std::numeric_limits<double>::infinity();

  inline Vector
  scalar(const double value)
  {
    Vector v(1);
    v(0) = value;
    return v;
  }

  /** m d'' + k d + k3 d^3 = F + drive(t); d positive into the chamber. */
  class Piston : public SolidSide
  {
  public:
    double                        mass = 1., spring = 1., cubic = 0.;
    std::function<double(double)> drive = [](double) { return 0.; };

    /** d/dv of the force that the velocity at the end of the step takes. */
    double
    impedance(const double dt) const
    {
      return mass / dt + (spring + 3. * cubic * d * d) * dt;
    }

    void
    begin_step(const double new_dt) override
    {
      dt = new_dt;
      d  = old_d;
    }

    /** The balance increases with d (k3 >= 0), so Newton's method from any
     *  start converges. */
    ConvergenceReport
    solve(const Vector &force, Vector &displacement) override
    {
      ConvergenceReport report;
      const double      load       = force(0) + drive(time + dt);
      double            correction = infinity;
      for (; report.iterations < 100 && correction != 0.; ++report.iterations)
        {
          const double v = (d - old_d) / dt;
          const double residual =
            mass * (v - old_v) / dt + spring * d + cubic * d * d * d - load;
          correction = residual / (impedance(dt) / dt);
          if (std::abs(correction) <= 1e-15 * (std::abs(d) + std::abs(old_d)))
            correction = 0.;
          d -= correction;
        }
      report.converged = correction == 0.;
      displacement     = scalar(d);
      return report;
    }

    bool
    compliance(const Vector &force, Vector &displacement) override
    {
      displacement = scalar(force(0) * dt / impedance(dt));
      return true;
    }

    void
    accept() override
    {
      old_v = (d - old_d) / dt;
      old_d = d;
      time += dt;
    }

    double time = 0., dt = 1., d = 0., old_d = 0., old_v = 0.;
  };



  /**
   * A chamber behind a piston of area A: A v = leak p + V/K dp/dt, with the
   * force -A p on the piston. Without leak and with a rigid fluid it is sealed.
   */
  class Chamber : public FluidSide
  {
  public:
    double area       = 1.;
    double leak       = 0.; ///< g
    double elasticity = 0.; ///< V/K

    double
    impedance(const double dt) const
    {
      return area * area / (leak + elasticity / dt);
    }

    void
    begin_step(const double new_dt) override
    {
      dt = new_dt;
      inputs.clear();
      outputs.clear();
    }

    ConvergenceReport
    solve(const WallCondition &condition, WallResponse &response) override
    {
      const double v_wall = (condition.displacement(0) - old_d) / dt;
      const double F      = condition.force(0);
      const double Z_f    = impedance(dt);
      // F_fluid = F_rest - Z_f v = F + alpha (v - v_wall)
      double v = v_wall, F_fluid = 0.;
      if (is_sealed())
        {
          v       = 0.;
          F_fluid = F - condition.alpha * v_wall;
        }
      else
        {
          const double F_rest = -Z_f / area * elasticity / dt * old_p;
          if (std::isfinite(condition.alpha))
            v =
              (F_rest - F + condition.alpha * v_wall) / (condition.alpha + Z_f);
          F_fluid = F_rest - Z_f * v;
        }
      response.force         = scalar(F_fluid);
      response.velocity      = scalar(v);
      response.wall_velocity = scalar(v_wall);
      p                      = -F_fluid / area;
      d                      = condition.displacement(0);
      inputs.push_back(F);
      outputs.push_back(F_fluid);
      ConvergenceReport report;
      report.converged = true;
      return report;
    }

    void
    accept() override
    {
      old_p = p;
      old_d = d;
    }

    bool
    is_sealed() const override
    {
      return leak == 0. && elasticity == 0.;
    }

    double
    rate_coefficient() const override
    {
      return 1. / dt;
    }

    Vector
    lengths() const override
    {
      return scalar(1.);
    }

    std::vector<Vector>
    uniform_loads() const override
    {
      return {scalar(-1.)};
    }

    /** Of the iterations of the last step. */
    std::vector<double> inputs, outputs;

    double p = 0.;

  private:
    double dt = 1., old_p = 0., d = 0., old_d = 0.;
  };
} // namespace piston

#endif
