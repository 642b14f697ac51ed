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
   * Solve
   *   R(g) = q_trial - 3 mu g - sigma(eps_n + g, g/dt, T_n + k q(g) g) = 0,
   *   q(g) = q_trial - 3 mu g.
   *
   * R(0) > 0 since the trial stress is above the static flow stress, and
   * R(q_trial/(3 mu)) = -sigma < 0, so a root exists; a bracket around it is
   * kept at all times. Where a step is long compared with g, Newton's method
   * works in ln g: there eps^n and ln(rate) are mild while their slopes in g
   * are infinite at 0, and R is concave, so that iterates from the right do
   * not overshoot. Short steps are taken in g, where R is nearly linear.
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
    constexpr double longest_g_step   = 0.3;
    constexpr double smallest_g_ratio = 1e-3;
    // A step this short in ln g is taken to first order without another
    // evaluation: what it leaves is its square.
    constexpr double last_step = 1e-9;

    const double k     = p.heating_coefficient;
    double       lower = 0.;
    double       upper = p.trial_stress / p.three_mu;
    double       g     = (p.trial_stress - static_flow_stress) / p.three_mu;

    for (int evaluation = 1; evaluation <= max_evaluations; ++evaluation)
      {
        const double          q = p.trial_stress - p.three_mu * g;
        const FlowStressValue sigma =
          flow_stress.evaluate(p.plastic_strain + g,
                               g * p.inverse_dt,
                               p.temperature + k * q * g);
        // d sigma/d g at fixed trial stress
        const double hardening = sigma.d_strain + sigma.d_rate * p.inverse_dt +
                                 sigma.d_temperature * k * (q - p.three_mu * g);
        const double residual = q - sigma.value;
        const double slope    = -p.three_mu - hardening;
        const double step     = -residual / slope;

        if (residual > 0.)
          lower = g;
        else
          upper = g;

        const bool last = (slope < 0. && std::abs(step) <= last_step * g);
        if (last || std::abs(residual) <= 4. * epsilon * p.trial_stress ||
            upper - lower <= 4. * epsilon * upper)
          {
            ReturnSolution solution;
            solution.increment = last ? g + step : g;
            solution.stress    = sigma.value + (last ? hardening * step : 0.);
            solution.temperature =
              p.temperature + k * solution.stress * solution.increment;
            // by implicit differentiation of R(g, q_trial) = 0
            const double explicit_part = sigma.d_temperature * k * g;
            solution.slope =
              hardening * ((1. - explicit_part) / (p.three_mu + hardening)) +
              explicit_part;
            solution.evaluations = evaluation;
            solution.found       = std::isfinite(solution.slope);
            return solution;
          }

        double next = g + step;
        if (std::abs(step) > longest_g_step * g)
          next = g * std::exp(step / g);
        if (!(slope < 0. && next > lower && next < upper))
          next = (lower > 0.) ? std::sqrt(lower) * std::sqrt(upper) :
                                smallest_g_ratio * upper;
        g = next;
      }
    return {g, 0., 0., p.temperature, max_evaluations, false};
  }
} // namespace asperity

#endif
