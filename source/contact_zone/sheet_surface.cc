#include <asperity/base/errors.h>
#include <asperity/contact_zone/sheet_surface.h>
#include <asperity/splines/spline_fit.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Length and width [m]. */
    using Periods = std::array<double, 2>;

    /** The heights of a periodic function of one variable, as coefficients. */
    std::vector<double>
    heights_of(const std::function<double(double)> &function,
               const double                         period,
               const unsigned int                   n_spans,
               const unsigned int                   degree)
    {
      const SplineCurve curve =
        interpolate_periodic_function(function, 0., period, n_spans, degree);
      std::vector<double> heights;
      for (const auto &point : curve.control_points())
        heights.push_back(point[1]);
      return heights;
    }

    KnotVector
    knots(const double period, const unsigned int n, const unsigned int degree)
    {
      std::vector<double> breakpoints(n + 1);
      for (unsigned int i = 0; i <= n; ++i)
        breakpoints[i] = period * i / n;
      return KnotVector(degree, breakpoints, true);
    }

    SheetSurface
    make_flat_sheet(const Periods &periods, const unsigned int degree)
    {
      SheetSurface       surface;
      const unsigned int n = 2 * degree + 2;
      surface.sheet        = SplineSheet({{knots(periods[0], n, degree),
                                           knots(periods[1], n, degree)}},
                                  std::vector<double>(n * n, 0.));
      surface.description  = "flat";
      return surface;
    }

    unsigned int
    highest(const std::vector<double> &numbers)
    {
      double result = 0.;
      for (const double j : numbers)
        result = std::max(result, std::abs(j));
      return static_cast<unsigned int>(result);
    }

    /** cos(a + b) = cos a cos b - sin a sin b: sums of products. */
    SheetSurface
    make_harmonic_sheet(const SurfaceParameters &p, const Periods &periods)
    {
      const unsigned int n_x = p.n_spans_of_harmonics(),
                         n_y = SurfaceParameters::spans_across *
                               std::max(1u, highest(p.across));
      const KnotVector x = knots(periods[0], n_x, p.degree),
                       y = knots(periods[1], n_y, p.degree);
      std::vector<double> heights(n_x * n_y, 0.);
      const auto          wave =
        [](const double number, const double phase, const double period) {
          return [=](const double at) {
            return std::cos(2. * M_PI * number * at / period + phase);
          };
        };
      for (std::size_t k = 0; k < p.wave_numbers.size(); ++k)
        {
          const double j = p.across.empty() ? 0. : p.across[k];
          for (const double turn : {0., 0.5 * M_PI})
            {
              // sin b = cos(b - pi/2); cos(a + pi/2) = -sin a
              const auto along  = heights_of(wave(p.wave_numbers[k],
                                                 p.phases[k] + turn,
                                                 periods[0]),
                                            periods[0],
                                            n_x,
                                            p.degree);
              const auto across = heights_of(wave(j, -turn, periods[1]),
                                             periods[1],
                                             n_y,
                                             p.degree);
              for (unsigned int b = 0; b < n_y; ++b)
                for (unsigned int a = 0; a < n_x; ++a)
                  heights[b * n_x + a] += p.topography.scale_z *
                                          p.amplitudes[k] * along[a] *
                                          across[b];
            }
        }
      SheetSurface surface;
      surface.sheet       = SplineSheet({{x, y}}, heights);
      surface.description = std::to_string(p.amplitudes.size()) + " harmonics";
      return surface;
    }

    /** A window of the map: as long as `Profile length` (before scaling) and as
     *  wide as `Geometry/Width` (after it), or as it is long.
     *  @param width of the patch, if it is given [m] */
    SheetSurface
    make_measured_sheet(const SurfaceParameters     &parameters,
                        const std::optional<double> &width)
    {
      const TopographyParameters &topography = parameters.topography;
      SheetSurface                surface;
      TopographyReport           &report = surface.topography.emplace();
      WindowChoice                choice;
      choice.extent[0] = topography.length;
      choice.extent[1] =
        width ? *width / topography.scale_x : topography.length;
      surface.sheet =
        make_window(topography, choice, report, surface.window.emplace());
      surface.description =
        "window of " + topography.file + ", " +
        std::to_string(surface.sheet.knot_vector(0).n_spans()) + " x " +
        std::to_string(surface.sheet.knot_vector(1).n_spans()) + " spans";
      return surface;
    }

    SheetSurface
    make_sheet(const SurfaceParameters &parameters, const Periods &periods)
    {
      return parameters.kind == SurfaceKind::harmonics ?
               make_harmonic_sheet(parameters, periods) :
               make_flat_sheet(periods, parameters.degree);
    }

    KnotVector
    moved_knots(const KnotVector &knots, const double distance)
    {
      std::vector<double> breakpoints = knots.breakpoints();
      for (double &t : breakpoints)
        t += distance;
      return KnotVector(knots.degree(), breakpoints, knots.is_periodic());
    }

    bool
    is_flat(const SheetSurface &surface)
    {
      const auto [low, high] =
        std::minmax_element(surface.sheet.coefficients().begin(),
                            surface.sheet.coefficients().end());
      return *low == *high;
    }
  } // namespace



  std::pair<SheetSurface, SheetSurface>
  make_sheets(const SceneParameters &p)
  {
    const Periods given = {
      {p.geometry.length, p.geometry.width.value_or(p.geometry.length)}};
    const SheetSurface tool    = p.tool.kind == SurfaceKind::measured ?
                                   make_measured_sheet(p.tool, p.geometry.width) :
                                   make_sheet(p.tool, given);
    const Periods      periods = {{tool.sheet.period(0), tool.sheet.period(1)}};
    return {tool, make_sheet(p.chip, periods)};
  }



  double
  SheetSurface::minimum() const
  {
    return sheet.minimum();
  }



  double
  SheetSurface::maximum() const
  {
    return sheet.maximum();
  }



  double
  SheetSurface::largest_slope() const
  {
    return sheet.largest_slope();
  }



  double
  SheetSurface::largest_slope(const unsigned int direction) const
  {
    return sheet.largest_slope(direction);
  }



  SheetSurface
  SheetSurface::mapped(const double factor, const double offset) const
  {
    SheetSurface surface = *this;
    surface.sheet        = sheet.mapped(factor, offset);
    return surface;
  }



  SheetSurface
  SheetSurface::moved(const double along_x, const double along_y) const
  {
    SheetSurface surface = *this;
    surface.sheet = SplineSheet({{moved_knots(sheet.knot_vector(0), along_x),
                                  moved_knots(sheet.knot_vector(1), along_y)}},
                                sheet.coefficients());
    return surface;
  }



  double
  smallest_gap(const SheetSurface &lower, const SheetSurface &upper)
  {
    if (is_flat(lower) || is_flat(upper))
      return upper.minimum() - lower.maximum();
    constexpr unsigned int n_a_span = 4;
    unsigned int           n[2];
    for (unsigned int d = 0; d < 2; ++d)
      n[d] = n_a_span * std::max(lower.sheet.knot_vector(d).n_spans(),
                                 upper.sheet.knot_vector(d).n_spans());
    double smallest = upper.maximum() - lower.minimum();
    for (unsigned int j = 0; j < n[1]; ++j)
      for (unsigned int i = 0; i < n[0]; ++i)
        {
          const dealii::Point<2> at(lower.sheet.period(0) * i / n[0],
                                    lower.sheet.period(1) * j / n[1]);
          smallest =
            std::min(smallest, upper.sheet.value(at) - lower.sheet.value(at));
        }
    return smallest;
  }
} // namespace asperity
