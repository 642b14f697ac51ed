#ifndef asperity_constitutive_return_map_h
#define asperity_constitutive_return_map_h

#include <asperity/base/lanes.h>
#include <asperity/constitutive/flow_stress.h>

#include <limits>

namespace asperity
{
  /** What the scalar return needs to know of the step, of one point or of a
   *  pack of points. */
  template <class Number = double>
  struct ReturnProblem
  {
    Number trial_stress;        ///< q_trial [Pa], above the static flow stress
    double three_mu;            ///< 3 mu [Pa]
    Number plastic_strain;      ///< at the start of the step
    Number temperature;         ///< at the start of the step [K]
    double inverse_dt;          ///< 1/dt [1/s], 0 for a static step
    double heating_coefficient; ///< chi/(rho c_p) [K/Pa]
    Number guess = Number(); ///< of the root; what is impossible counts as none
  };

  /** The root of the scalar return. */
  template <class Number = double>
  struct ReturnSolution
  {
    using Mask = decltype(Number() < Number());

    Number increment;   ///< dgamma
    Number stress;      ///< q = sigma at the end of the step [Pa]
    Number slope;       ///< dq/dq_trial
    Number temperature; ///< at the end of the step [K]
    Mask   found;       ///< of points that do not yield: false
    int    evaluations; ///< of the flow stress
  };

  /**
   * e^y for the root y of e^y - 1 + beta y = rho, beta > -1: the scalar return
   * with the flow stress linear in ln g, e^y being the ratio of the next g to
   * the last. Small roots come from the series (error y^4), others from
   * Newton's method, started where it converges monotonically since the left
   * side is convex.
   */
  template <class Number>
  Number
  logarithmic_step(const Number &beta, const Number &rho)
  {
    constexpr double series_below   = 0.1;
    constexpr double accuracy       = 1e-3; // its square is left
    constexpr int    max_iterations = 20;
    const Number     first          = rho / (1. + beta);
    const Number     a              = 0.5 / (1. + beta);
    const Number     small =
      first * (1. + first * (-a + first * (2. * a * a - a / 3.)));
    const Number series = 1. + small * (1. + small * (0.5 + small / 6.));
    const auto   large  = lanes::abs(first) >= series_below;
    if (!lanes::any(large))
      return series;

    const Number bound =
      lanes::log(lanes::select(rho > 0., 1. + rho, Number() + 1.));
    Number y = lanes::select((rho > 0.) & (bound < first), bound, first);
    Number exponential = lanes::exp(y);
    for (int i = 0; i < max_iterations; ++i)
      {
        const Number step =
          (rho + 1. - exponential - beta * y) / (exponential + beta);
        y += step;
        if (!lanes::any(large & (lanes::abs(step) > accuracy)))
          {
            exponential *= 1. + step;
            break;
          }
        exponential = lanes::exp(y);
      }
    return lanes::select(large, exponential, series);
  }



  /** R and its parts at one g; see solve_return(). */
  template <class Number>
  struct ReturnResidual
  {
    BasicFlowStressValue<Number> sigma;
    Number                       hardening; // d sigma/d g at fixed trial stress
    Number                       value;     // R
  };



  template <class FlowStress, class Number>
  ReturnResidual<Number>
  return_residual(const FlowStress            &flow_stress,
                  const ReturnProblem<Number> &p,
                  const Number                &g)
  {
    const double k         = p.heating_coefficient;
    const Number q         = p.trial_stress - p.three_mu * g;
    const auto   sigma     = flow_stress.evaluate(p.plastic_strain + g,
                                            g * p.inverse_dt,
                                            p.temperature + k * q * g);
    const Number hardening = sigma.d_strain + sigma.d_rate * p.inverse_dt +
                             sigma.d_temperature * k * (q - p.three_mu * g);
    return {sigma, hardening, q - sigma.value};
  }



  /** Writes the solution of the points `done`, whose g is the root up to a step
   *  of second order. */
  template <class Number>
  void
  finish_return(const ReturnProblem<Number>                 &p,
                const ReturnResidual<Number>                &R,
                const Number                                &g,
                const Number                                &step,
                const typename ReturnSolution<Number>::Mask &done,
                ReturnSolution<Number>                      &solution)
  {
    const double k         = p.heating_coefficient;
    const Number increment = g + step;
    const Number stress    = R.sigma.value + R.hardening * step;
    // by implicit differentiation of R(g, q_trial) = 0; the hardening at the
    // root is that of a flow stress linear in ln g
    const Number hardening     = R.hardening * (g / increment);
    const Number explicit_part = R.sigma.d_temperature * k * g;
    const Number slope =
      hardening * ((1. - explicit_part) / (p.three_mu + hardening)) +
      explicit_part;

    solution.increment   = lanes::select(done, increment, solution.increment);
    solution.stress      = lanes::select(done, stress, solution.stress);
    solution.slope       = lanes::select(done, slope, solution.slope);
    solution.temperature = lanes::select(done,
                                         p.temperature + k * stress * increment,
                                         solution.temperature);
    solution.found       = solution.found | (done & (slope - slope == 0.));
  }



  /**
   * Solve
   *   R(g) = q_trial - 3 mu g - sigma(eps_n + g, g/dt, T_n + k q(g) g) = 0,
   *   q(g) = q_trial - 3 mu g
   * for the points whose trial stress is above the static flow stress.
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
  template <class FlowStress, class Number>
  ReturnSolution<Number>
  solve_return(const FlowStress            &flow_stress,
               const ReturnProblem<Number> &p,
               const Number                &static_flow_stress)
  {
    constexpr double epsilon          = std::numeric_limits<double>::epsilon();
    constexpr int    max_evaluations  = 200;
    constexpr double smallest_g_ratio = 1e-3;
    constexpr double smallest_guess   = 1e-12; // less than round-off of eps_n
    // A step this short in ln g is taken to first order without another
    // evaluation: what it leaves in the stress is its square.
    constexpr double last_step = 1e-6;

    Number lower = Number();
    Number upper = p.trial_stress / p.three_mu;
    Number g =
      lanes::select((p.guess > smallest_guess * upper) & (p.guess < upper),
                    p.guess,
                    (p.trial_stress - static_flow_stress) / p.three_mu);
    auto                   open = p.trial_stress > static_flow_stress;
    ReturnSolution<Number> solution{};
    while (solution.evaluations < max_evaluations && lanes::any(open))
      {
        const ReturnResidual<Number> R = return_residual(flow_stress, p, g);
        ++solution.evaluations;
        const Number beta  = R.hardening / p.three_mu;
        const Number step  = R.value / (p.three_mu + R.hardening);
        const auto   below = R.value > 0.;
        const auto   mild  = beta > -1.;
        lower              = lanes::select(below, g, lower);
        upper              = lanes::select(below, upper, g);

        const auto last = mild & (lanes::abs(step) <= last_step * g);
        const auto done =
          open &
          (last | (lanes::abs(R.value) <= 4. * epsilon * p.trial_stress) |
           (upper - lower <= 4. * epsilon * upper));
        finish_return(
          p, R, g, lanes::select(last, step, Number()), done, solution);
        open = open & !done;

        const Number rho = R.value / (p.three_mu * g);
        const Number next =
          g * logarithmic_step(beta, lanes::select(open & mild, rho, Number()));
        const Number halved =
          lanes::select(lower > 0.,
                        lanes::sqrt(lower) * lanes::sqrt(upper),
                        smallest_g_ratio * upper);
        const auto inside = mild & (next > lower) & (next < upper);
        g = lanes::select(open, lanes::select(inside, next, halved), g);
      }
    return solution;
  }
} // namespace asperity

#endif
