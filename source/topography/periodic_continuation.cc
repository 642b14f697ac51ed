#include <asperity/base/errors.h>
#include <asperity/topography/linear_solver.h>
#include <asperity/topography/periodic_continuation.h>

#include <algorithm>
#include <array>
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

    constexpr unsigned int max_degree = 5;

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

    /** The degree+1 uniform B-splines that live on a span, at t in [0, 1). */
    std::array<double, max_degree + 1>
    uniform_basis(const unsigned int degree, const double t)
    {
      std::array<double, max_degree + 1> basis = {{1.}};
      for (unsigned int p = 1; p <= degree; ++p)
        for (unsigned int k = p + 1; k-- > 0;)
          {
            // Spline k of degree p starts k spans before the end of its
            // support; both terms are the ramps of Cox and de Boor.
            const double left  = k > 0 ? (t + p - k) / p * basis[k - 1] : 0.;
            const double right = k < p ? (k + 1 - t) / p * basis[k] : 0.;
            basis[k]           = left + right;
          }
      return basis;
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

    /** A periodic spline: coefficients over uniform knots. */
    struct PeriodicSpline
    {
      unsigned int        degree = 3;
      std::vector<double> coefficients;

      /** Calls f(coefficient index, basis value) for position u in [0, 1). */
      template <typename Function>
      void
      visit(const double u, const Function &f) const
      {
        const unsigned int m     = coefficients.size();
        const auto         span  = std::min<unsigned int>(u * m, m - 1);
        const auto         basis = uniform_basis(degree, u * m - span);
        for (unsigned int k = 0; k <= degree; ++k)
          f((span + k) % m, basis[k]);
      }

      double
      operator()(const double u) const
      {
        double value = 0.;
        visit(u, [&](const unsigned int i, const double b) {
          value += b * coefficients[i];
        });
        return value;
      }
    };

    /** Lower band, and full last rows, where the spline wraps around. */
    SkylineMatrix
    cyclic_matrix(const unsigned int m, const unsigned int degree)
    {
      std::vector<unsigned int> first(m, 0);
      for (unsigned int i = degree; i + degree < m; ++i)
        first[i] = i - degree;
      return SkylineMatrix(first);
    }

    void
    fit(PeriodicSpline            &spline,
        const std::vector<double> &z,
        const double               blend)
    {
      const unsigned int  m      = spline.coefficients.size();
      const std::size_t   n      = z.size();
      SkylineMatrix       matrix = cyclic_matrix(m, spline.degree);
      std::vector<double> rhs(m, 0.);
      for (std::size_t i = 0; i < n; ++i)
        {
          const double weight = sample_weight(i, n, blend);
          const double u      = static_cast<double>(i) / n;
          spline.visit(u, [&](const unsigned int k, const double bk) {
            rhs[k] += weight * bk * z[i];
            spline.visit(u, [&](const unsigned int l, const double bl) {
              if (l <= k)
                matrix.add(k, l, weight * bk * bl);
            });
          });
        }
      for (unsigned int k = 0; k < m; ++k)
        {
          // Coefficient k+1 stands near this sample.
          const double centre =
            std::fmod(k + 1. + m - 0.5 * (spline.degree - 1.), m) / m;
          const auto sample =
            std::min<std::size_t>(std::lround(centre * n), n - 1);
          const double bending =
            (bending_on_data +
             bending_at_bridge * (1. - sample_weight(sample, n, blend))) *
            n / m;
          const unsigned int index[] = {k, (k + 1) % m, (k + 2) % m};
          const double       d[]     = {1., -2., 1.};
          for (unsigned int a = 0; a < 3; ++a)
            for (unsigned int b = 0; b < 3; ++b)
              if (index[b] <= index[a])
                matrix.add(index[a], index[b], bending * d[a] * d[b]);
        }
      spline.coefficients = matrix.factorize_and_solve(rhs);
    }

    Profile
    wrap(const Profile              &profile,
         const WrappedSplineOptions &options,
         ContinuationReport         &report)
    {
      const std::size_t n = profile.heights.size();
      PeriodicSpline    spline;
      spline.degree  = options.degree;
      report.n_knots = static_cast<unsigned int>(
        std::max(2. * options.degree + 1., n / options.samples_per_knot));
      if (report.n_knots > n)
        throw InputError(
          "A wrapped spline of degree " + std::to_string(options.degree) +
          " needs at least " + std::to_string(report.n_knots) +
          " samples, and the profile has " + std::to_string(n) + ".");
      spline.coefficients.resize(report.n_knots);
      fit(spline, profile.heights, options.blend_fraction);

      Profile     result = profile;
      std::size_t n_data = 0;
      result.periodic    = true;
      for (std::size_t i = 0; i < n; ++i)
        {
          result.heights[i] = spline(static_cast<double>(i) / n);
          if (sample_weight(i, n, options.blend_fraction) < 1.)
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
