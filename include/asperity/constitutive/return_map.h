#ifndef asperity_constitutive_return_map_h
#define asperity_constitutive_return_map_h

#include <asperity/constitutive/flow_stress.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity
{
  /** What the scalar return needs to know of the step. */
  struct ReturnProblem
  {
    double trial_stress;        ///< q_trial [Pa], above the static flow stress
    double three_mu;            ///< 3 mu [Pa]
    double plastic_strain;      ///< at the start of the step
    double temperature;         ///< at the start of the step [K]
    double inverse_dt;          ///< 1/dt [1/s], 0 for a static step
    double heating_coefficient; ///< chi/(rho c_p) [K/Pa]
    double guess = 0.; ///< of the root; what is impossible counts as none
  };

  /** The root of the scalar return. */
  struct ReturnSolution
  {
    double increment;   ///< dgamma
    double stress;      ///< q = sigma at the end of the step [Pa]
    double slope;       ///< dq/dq_trial
    double temperature; ///< at the end of the step [K]
    int    evaluations; ///< of the flow stress
    bool   found;
  };

  /**
   * e^y for the root y of e^y - 1 + beta y = rho, beta > -1: the scalar return
   * with the flow stress linear in ln g, e^y being the ratio of the next g to
   * the last. Small roots come from the series (error y^4), others from
   * Newton's method, started where it converges monotonically since the left
   * side is convex.
   */
  inline double
  logarithmic_step(const double beta, const double rho)
  {
    constexpr double series_below   = 0.1;
    constexpr double accuracy       = 1e-3; // its square is left
    constexpr int    max_iterations = 20;
    double           y              = rho / (1. + beta);
    if (std::abs(y) < series_below)
      {
        const double a = 0.5 / (1. + beta);
        y *= 1. + y * (-a + y * (2. * a * a - a / 3.));
        return 1. + y * (1. + y * (0.5 + y / 6.));
      }
    if (rho > 0.)
      y = std::fmin(y, std::log1p(rho));
    double exponential = std::exp(y);
    for (int i = 0; i < max_iterations; ++i)
      {
        const double step =
          (rho + 1. - exponential - beta * y) / (exponential + beta);
        y += step;
        if (!(std::abs(step) > accuracy))
          return exponential * (1. + step);
        exponential = std::exp(y);
      }
    return exponential;
  }



  /** R and its parts at one g; see solve_return(). */
  struct ReturnResidual
  {
    FlowStressValue sigma;
    double          hardening; // d sigma/d g at fixed trial stress
    double          value;     // R
  };



  template <class FlowStress>
  ReturnResidual
  return_residual(const FlowStress    &flow_stress,
                  const ReturnProblem &p,
                  const double         g)
  {
    const double          k = p.heating_coefficient;
    const double          q = p.trial_stress - p.three_mu * g;
    const FlowStressValue sigma =
      flow_stress.evaluate(p.plastic_strain + g,
                           g * p.inverse_dt,
                           p.temperature + k * q * g);
    const double hardening = sigma.d_strain + sigma.d_rate * p.inverse_dt +
                             sigma.d_temperature * k * (q - p.three_mu * g);
    return {sigma, hardening, q - sigma.value};
  }



  /** The solution once g is the root up to a step of second order. */
  inline ReturnSolution
  finish_return(const ReturnProblem  &p,
                const ReturnResidual &R,
                const double          g,
                const double          step,
                const int             evaluations)
  {
    const double k = p.heating_coefficient;

    ReturnSolution solution;
    solution.increment = g + step;
    solution.stress    = R.sigma.value + R.hardening * step;
    solution.temperature =
      p.temperature + k * solution.stress * solution.increment;
    // by implicit differentiation of R(g, q_trial) = 0; the hardening at the
    // root is that of a flow stress linear in ln g
    const double hardening     = R.hardening * (g / solution.increment);
    const double explicit_part = R.sigma.d_temperature * k * g;
    solution.slope =
      hardening * ((1. - explicit_part) / (p.three_mu + hardening)) +
      explicit_part;
    solution.evaluations = evaluations;
    solution.found       = std::isfinite(solution.slope);
    return solution;
  }



  /**
   * Solve
   *   R(g) = q_trial - 3 mu g - sigma(eps_n + g, g/dt, T_n + k q(g) g) = 0,
   *   q(g) = q_trial - 3 mu g.
   *
   * R(0) > 0 since the trial stress is above the static flow stress, and
   * R(q_trial/(3 mu)) = -sigma < 0, so a root exists; a bracket around it is
   * kept at all times. Each step makes the flow stress linear in ln g and
   * keeps the elastic part as it is: the slopes of eps^n and ln(rate) in g are
   * infinite at 0, but in ln g they are mild. Where the step leaves the
   * bracket, the bracket is halved in ln g.
   *
   * @param static_flow_stress sigma(eps_n, 0, T_n) [Pa]
   */
  template <class FlowStress>
  ReturnSolution
  solve_return(const FlowStress    &flow_stress,
               const ReturnProblem &p,
               const double         static_flow_stress)
  {
    constexpr double epsilon          = std::numeric_limits<double>::epsilon();
    constexpr int    max_evaluations  = 200;
    constexpr double smallest_g_ratio = 1e-3;
    constexpr double smallest_guess   = 1e-12; // less than round-off of eps_n
    // A step this short in ln g is taken to first order without another
    // evaluation: what it leaves in the stress is its square.
    constexpr double last_step = 1e-6;

    double lower = 0.;
    double upper = p.trial_stress / p.three_mu;
    double g     = p.guess;
    if (!(g > smallest_guess * upper && g < upper))
      g = (p.trial_stress - static_flow_stress) / p.three_mu;
    for (int evaluation = 1; evaluation <= max_evaluations; ++evaluation)
      {
        const ReturnResidual R         = return_residual(flow_stress, p, g);
        const double         beta      = R.hardening / p.three_mu;
        const double         step      = R.value / (p.three_mu + R.hardening);
        (R.value > 0. ? lower : upper) = g;

        if (beta > -1. && std::abs(step) <= last_step * g)
          return finish_return(p, R, g, step, evaluation);
        if (std::abs(R.value) <= 4. * epsilon * p.trial_stress ||
            upper - lower <= 4. * epsilon * upper)
          return finish_return(p, R, g, 0., evaluation);

        double next = 0.;
        if (beta > -1.)
          next = g * logarithmic_step(beta, R.value / (p.three_mu * g));
        if (!(next > lower && next < upper))
          next = (lower > 0.) ? std::sqrt(lower) * std::sqrt(upper) :
                                smallest_g_ratio * upper;
        g = next;
      }
    return {g, 0., 0., p.temperature, max_evaluations, false};
  }
} // namespace asperity

#endif
