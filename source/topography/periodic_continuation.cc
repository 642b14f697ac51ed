#include <asperity/base/errors.h>
#include <asperity/topography/periodic_continuation.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace asperity
{
  namespace
  {
    /** Weight of the second differences against that of one sample: small
     * where there are data, strong enough to bridge where there are none. */
    constexpr double bending_on_data   = 1e-7;
    constexpr double bending_at_bridge = 1e-2;

    double
    mean(const std::vector<double> &values)
    {
      return std::accumulate(values.begin(), values.end(), 0.) / values.size();
    }

    double
    rms_about_mean(const std::vector<double> &values)
    {
      const double m   = mean(values);
      double       sum = 0.;
      for (const double value : values)
        sum += (value - m) * (value - m);
      return std::sqrt(sum / values.size());
    }

    double
    max_slope(const Profile &profile)
    {
      const auto       &z       = profile.heights;
      double            maximum = 0.;
      const std::size_t n       = z.size();
      for (std::size_t i = 0; i + 1 < n + profile.periodic; ++i)
        maximum = std::max(maximum, std::abs(z[(i + 1) % n] - z[i]));
      return maximum / profile.spacing;
    }

    /** See ContinuationReport. */
    std::pair<double, double>
    seam_jumps(const Profile &profile)
    {
      const auto       &z    = profile.heights;
      const std::size_t n    = z.size();
      const double      last = z[n - 1] - z[n - 2];
      return {z[n - 1] + last - z[0], (last - (z[1] - z[0])) / profile.spacing};
    }

    /** Subtract the least-squares line; returns its slope. */
    double
    remove_trend(Profile &profile)
    {
      auto        &z      = profile.heights;
      const double n      = z.size();
      const double middle = 0.5 * (n - 1.);
      const double z_mean = mean(z);
      double       sum = 0., norm = 0.;
      for (std::size_t i = 0; i < z.size(); ++i)
        {
          sum += (i - middle) * (z[i] - z_mean);
          norm += (i - middle) * (i - middle);
        }
      for (std::size_t i = 0; i < z.size(); ++i)
        z[i] -= z_mean + sum / norm * (i - middle);
      return sum / norm / profile.spacing;
    }

    /** Weight of sample i of n: 0 near the ends, 1 inside, smooth between. */
    double
    sample_weight(const std::size_t i, const std::size_t n, const double blend)
    {
      const double width    = blend * n;
      const double distance = 0.5 + std::min(i, n - 1 - i);
      if (distance >= width)
        return 1.;
      const double t = 2. * distance / width - 1.;
      return t <= 0. ? 0. : t * t * (3. - 2. * t);
    }

    /** One knot a unit of length, so that the spline repeats after @p m. */
    KnotVector
    uniform_knots(const unsigned int degree, const unsigned int m)
    {
      std::vector<double> breakpoints(m + 1);
      std::iota(breakpoints.begin(), breakpoints.end(), 0.);
      return KnotVector(degree, breakpoints, true);
    }

    KnotVector
    wrapped_knots(const std::size_t n, const WrappedSplineOptions &options)
    {
      const auto m = static_cast<unsigned int>(
        std::max(2. * options.degree + 1., n / options.samples_per_knot));
      if (m > n)
        throw InputError("A wrapped spline of degree " +
                         std::to_string(options.degree) + " needs at least " +
                         std::to_string(m) + " samples, and the profile has " +
                         std::to_string(n) + ".");
      return uniform_knots(options.degree, m);
    }

    /** Second differences of neighbouring coefficients, squared. */
    void
    add_bending(const KnotVector &knots,
                const std::size_t n_samples,
                const double      blend,
                BandedSolver     &matrix)
    {
      const unsigned int        m       = knots.n_basis();
      const std::vector<double> centres = knots.greville();
      for (unsigned int k = 0; k < m; ++k)
        {
          // Coefficient k+1 stands near this sample.
          const double centre = knots.wrap(centres[(k + 1) % m]) / m;
          const auto   sample =
            std::min<std::size_t>(std::lround(centre * n_samples),
                                  n_samples - 1);
          const double bending =
            (bending_on_data +
             bending_at_bridge *
               (1. - sample_weight(sample, n_samples, blend))) *
            n_samples / m;
          const double d[] = {1., -2., 1.};
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 3; ++b)
              matrix.add((k + a) % m, (k + b) % m, bending * d[a] * d[b]);
        }
    }

    Profile
    wrap(const Profile              &profile,
         const WrappedSplineOptions &options,
         ContinuationReport         &report)
    {
      const std::size_t   n = profile.heights.size();
      const WrappedSpline spline(n, options);
      report.n_knots = spline.n_knots();

      Profile     result = profile;
      std::size_t n_data = 0;
      result.periodic    = true;
      result.heights     = spline.values(spline.coefficients(profile.heights));
      for (std::size_t i = 0; i < n; ++i)
        {
          if (spline.is_blended(i))
            continue;
          const double change =
            std::abs(result.heights[i] - profile.heights[i]);
          report.fit_max = std::max(report.fit_max, change);
          report.fit_rms += change * change;
          ++n_data;
        }
      report.fit_rms =
        std::sqrt(report.fit_rms / std::max<std::size_t>(n_data, 1));
      return result;
    }
  } // namespace

  WrappedSpline::WrappedSpline(const std::size_t           n_samples,
                               const WrappedSplineOptions &options)
    : knots(wrapped_knots(n_samples, options))
    , matrix(knots.n_basis(), std::max(2u, knots.degree()), true)
  {
    const unsigned int m = knots.n_basis();
    for (std::size_t i = 0; i < n_samples; ++i)
      {
        weights.push_back(sample_weight(i, n_samples, options.blend_fraction));
        const double       t    = static_cast<double>(i) * m / n_samples;
        const unsigned int span = knots.find_span(t);
        bases.push_back(
          {knots.span_functions(span), knots.evaluate(span, t)[0]});
        const LocalBasis &basis = bases.back();
        for (unsigned int a = 0; a <= knots.degree(); ++a)
          for (unsigned int b = 0; b <= knots.degree(); ++b)
            matrix.add(basis.functions[a],
                       basis.functions[b],
                       weights[i] * basis.values[a] * basis.values[b]);
      }
    add_bending(knots, n_samples, options.blend_fraction, matrix);
    if (!matrix.factorize())
      throw ComputationError("The wrapped spline of the profile is not "
                             "determined by its " +
                             std::to_string(n_samples) + " samples.");
  }

  unsigned int
  WrappedSpline::n_knots() const
  {
    return knots.n_basis();
  }

  std::vector<double>
  WrappedSpline::coefficients(const std::vector<double> &heights) const
  {
    std::vector<double> rhs(knots.n_basis(), 0.);
    for (std::size_t i = 0; i < bases.size(); ++i)
      for (unsigned int a = 0; a <= knots.degree(); ++a)
        rhs[bases[i].functions[a]] +=
          weights[i] * bases[i].values[a] * heights[i];
    matrix.solve(rhs);
    return rhs;
  }

  std::vector<double>
  WrappedSpline::values(const std::vector<double> &coefficients) const
  {
    std::vector<double> result(bases.size());
    for (std::size_t i = 0; i < bases.size(); ++i)
      for (unsigned int a = 0; a <= knots.degree(); ++a)
        result[i] += bases[i].values[a] * coefficients[bases[i].functions[a]];
    return result;
  }

  bool
  WrappedSpline::is_blended(const std::size_t sample) const
  {
    return weights[sample] < 1.;
  }

  Profile
  make_periodic(const Profile              &profile,
                const Continuation          continuation,
                const WrappedSplineOptions &options,
                ContinuationReport         &report)
  {
    if (profile.heights.size() < 10)
      throw InputError("A profile of " +
                       std::to_string(profile.heights.size()) +
                       " samples is too short for a periodic continuation.");
    report           = {};
    Profile straight = profile;
    if (continuation == Continuation::wrapped_spline)
      report.removed_trend = remove_trend(straight);
    std::tie(report.jump_before, report.slope_jump_before) =
      seam_jumps(profile);
    report.Rq_before        = rms_about_mean(profile.heights);
    report.max_slope_before = max_slope(profile);

    Profile result  = straight;
    result.periodic = true;
    if (continuation == Continuation::wrapped_spline)
      result = wrap(straight, options, report);
    else if (continuation == Continuation::mirror)
      for (std::size_t i = profile.heights.size() - 1; --i > 0;)
        result.heights.push_back(profile.heights[i]);

    std::tie(report.jump_after, report.slope_jump_after) = seam_jumps(result);
    report.Rq_after        = rms_about_mean(result.heights);
    report.max_slope_after = max_slope(result);
    return result;
  }
} // namespace asperity
