#include <asperity/solvers/newton.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity
{
  namespace
  {
    using Vector = dealii::Vector<double>;

    /** Residual norm over tolerance from which one more iteration mostly
     *  converges. */
    constexpr double near_end = 200.;

    /** A step with an old tangent is tried if, contracting as the last one has,
     *  it would end at this many tolerances. It mostly contracts less: with 3
     *  there are series of such steps, which cost more than a new tangent (a
     *  dry run has 3 % more iterations, one with a shear factor of 1 28 %). */
    constexpr double last_step = 0.4;

    /** The search along one direction: u + a d. */
    class LineSearch
    {
    public:
      LineSearch(NonlinearSystem     &system,
                 const NewtonOptions &options,
                 NewtonStatistics    &statistics)
        : system(system)
        , options(options)
        , statistics(statistics)
      {}

      /**
       * On entry R = R(u); on success u and R are those of the accepted point.
       * @param linearized whether the tangent is the one there
       */
      bool
      advance(Vector &u, Vector &R, const Vector &d, bool &linearized)
      {
        const double s0   = energy_slope(R, d);
        const double norm = system.norm(R);
        const Vector u0   = u;
        double       a = 1., low = 0., high = 1., s_low = s0, s_high = 0.;
        bool         bracketed = false;
        for (unsigned int trial = 0; trial < options.line_search_trials;
             ++trial)
          {
            u = u0;
            u.add(a, d);
            // The full step is mostly accepted and needs a tangent next, unless
            // the iteration is about to end.
            linearized = trial == 0 && !is_about_to_end(norm);
            is_first   = false;
            const bool exists =
              linearized ? system.linearize(u, R) : system.residual(u, R);
            ++(linearized ? statistics.linearizations : statistics.residuals);
            if (!exists)
              {
                high      = a;
                bracketed = false;
                a         = 0.5 * (low + a);
                continue;
              }
            const double s = energy_slope(R, d);
            if (acceptable(s, s0, system.norm(R), norm))
              return true;
            if (options.merit == NewtonMerit::residual_norm)
              a *= 0.5;
            else
              a = next(a, s, s0, low, high, s_low, s_high, bracketed);
          }
        return false;
      }

    private:
      /** Whether a step from where the norm is this one may well converge. */
      bool
      is_about_to_end(const double norm) const
      {
        if (is_first && options.first_step_ends)
          return *options.first_step_ends;
        return norm <= near_end * options.tolerance;
      }

      /** R.d, see NewtonOptions::n_energy_components. */
      double
      energy_slope(const Vector &R, const Vector &d) const
      {
        if (options.n_energy_components == 0)
          return R * d;
        return std::inner_product(R.begin(),
                                  R.begin() + options.n_energy_components,
                                  d.begin(),
                                  0.);
      }

      bool
      acceptable(const double s,
                 const double s0,
                 const double norm,
                 const double norm0) const
      {
        if (norm <= options.tolerance)
          return true;
        // An indefinite tangent can give a direction that climbs in energy;
        // then only the residual can judge.
        if (s0 >= 0. || options.merit == NewtonMerit::residual_norm)
          return norm < norm0;
        return std::abs(s) <= options.line_search_tolerance * std::abs(s0);
      }

      /** Regula falsi between the signs of s, halving where there is none. */
      static double
      next(const double a,
           const double s,
           const double s0,
           double      &low,
           double      &high,
           double      &s_low,
           double      &s_high,
           bool        &bracketed)
      {
        if (s0 < 0. && s < 0. && (bracketed || a < 1.))
          {
            low   = a;
            s_low = s;
          }
        else
          {
            high      = a;
            s_high    = s;
            bracketed = s0 < 0. && s > 0.;
          }
        if (!bracketed)
          return 0.5 * (low + high);
        const double root   = low - s_low * (high - low) / (s_high - s_low);
        const double margin = 0.1 * (high - low);
        return std::min(std::max(root, low + margin), high - margin);
      }

      NonlinearSystem     &system;
      const NewtonOptions &options;
      NewtonStatistics    &statistics;
      bool                 is_first = true; ///< step of the iteration
    };

    /**
     * A full step with the tangent of an earlier iterate, whose factor is at
     * hand: it converges as fast as the steps before have, which is fast enough
     * for the last correction.
     * @param u, R on success those of the new point, else as they were
     * @return whether the norm has fallen
     */
    bool
    correct(NonlinearSystem  &system,
            Vector           &u,
            Vector           &R,
            Vector           &d,
            NewtonStatistics &statistics)
    {
      ++statistics.iterations;
      if (!system.direction(R, d))
        return false;
      const Vector old_u = u, old_R = R;
      u += d;
      ++statistics.residuals;
      if (system.residual(u, R) && system.norm(R) < system.norm(old_R))
        return true;
      u = old_u;
      R = old_R;
      return false;
    }

    /**
     * Full steps with a tangent that is kept while it is good enough. Ends at
     * convergence, at a step that fails with a new tangent, or at the iteration
     * limit; u is the best iterate, report.iterations the steps up to it.
     */
    ConvergenceReport
    iterate_with_kept_tangent(NonlinearSystem     &system,
                              Vector              &u,
                              const NewtonOptions &options,
                              NewtonStatistics    &statistics)
    {
      ConvergenceReport report;
      Vector            R(u.size()), R_new(u.size()), d(u.size());
      ++statistics.residuals;
      if (!system.residual(u, R))
        return report;
      report.residual = system.norm(R);
      bool is_slow    = !system.has_tangent();
      while (std::isfinite(report.residual) &&
             report.iterations < options.maximum_iterations)
        {
          report.converged = report.residual <= options.tolerance;
          if (report.converged)
            return report;
          const bool is_new = is_slow;
          if (is_new)
            {
              ++statistics.linearizations;
              if (!system.linearize(u, R))
                return report;
            }
          ++statistics.iterations;
          if (!system.direction(R, d))
            return report;
          u += d;
          ++statistics.residuals;
          const bool   exists = system.residual(u, R_new);
          const double norm   = system.norm(R_new);
          if (!exists || !(norm < report.residual))
            {
              u -= d;
              if (is_new)
                return report;
              is_slow = true;
              continue;
            }
          is_slow = norm > options.kept_tangent_contraction * report.residual;
          report.residual = norm;
          R.swap(R_new);
          ++report.iterations;
        }
      return report;
    }



    /** Whether the residual in the report ends the iteration, and how. */
    bool
    has_ended(ConvergenceReport &report, const NewtonOptions &options)
    {
      if (!std::isfinite(report.residual))
        report.reason = "the residual is not finite";
      else if (report.residual <= options.tolerance)
        report.converged = true;
      else if (report.iterations == options.maximum_iterations)
        report.reason = "the iteration limit was reached";
      return report.converged || !report.reason.empty();
    }
  } // namespace



  ConvergenceReport
  newton(NonlinearSystem     &system,
         Vector              &u,
         const NewtonOptions &options,
         NewtonStatistics    &statistics)
  {
    ConvergenceReport report;
    if (options.kept_tangent_contraction > 0.)
      {
        report = iterate_with_kept_tangent(system, u, options, statistics);
        if (report.converged)
          return report;
      }
    Vector R(u.size()), d(u.size());
    ++statistics.linearizations;
    if (!system.linearize(u, R))
      {
        report.reason = "an element is inverted at the start of the iteration";
        return report;
      }
    LineSearch line_search(system, options, statistics);
    bool       linearized = true;
    double     previous   = 0.; // norm
    for (;; ++report.iterations)
      {
        previous        = report.residual;
        report.residual = system.norm(R);
        if (has_ended(report, options))
          return report;
        if (!linearized && options.merit == NewtonMerit::energy &&
            system.has_tangent() &&
            report.residual * report.residual <=
              last_step * options.tolerance * previous &&
            correct(system, u, R, d, statistics))
          continue;
        if (!linearized)
          {
            ++statistics.linearizations;
            if (!system.linearize(u, R))
              {
                report.reason = "no tangent exists where a residual does";
                return report;
              }
          }
        ++statistics.iterations;
        if (!system.direction(R, d))
          {
            report.reason = system.direction_failure();
            return report;
          }
        if (!line_search.advance(u, R, d, linearized))
          {
            report.reason = "the line search found no better point";
            return report;
          }
      }
  }
} // namespace asperity
