#include <asperity/base/errors.h>
#include <asperity/contact_zone/surface.h>
#include <asperity/splines/spline_fit.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace asperity
{
  namespace
  {
    /** Smallest value of a smooth periodic function: the best of a fine grid,
     *  then golden-section search between its neighbours. */
    double
    periodic_minimum(const std::function<double(double)> &f,
                     const double                         period,
                     const unsigned int                   n)
    {
      unsigned int best = 0;
      for (unsigned int i = 1; i < n; ++i)
        if (f(period * i / n) < f(period * best / n))
          best = i;
      const double ratio = 0.5 * (std::sqrt(5.) - 1.);
      double       a = period * (best - 1.) / n, b = period * (best + 1.) / n;
      for (unsigned int i = 0; i < 60; ++i)
        {
          const double c = b - ratio * (b - a), d = a + ratio * (b - a);
          (f(c) < f(d) ? b : a) = (f(c) < f(d) ? d : c);
        }
      return f(0.5 * (a + b));
    }

    unsigned int
    search_points(const Surface &surface)
    {
      return 8 * surface.curve.knot_vector().n_spans();
    }

    Surface
    make_flat(const double length, const unsigned int degree)
    {
      Surface surface;
      surface.period = length;
      surface.curve  = interpolate_periodic_function(
        [](const double) { return 0.; }, 0., length, 2 * degree + 2, degree);
      surface.description = "flat";
      return surface;
    }

    Surface
    make_harmonics(const SurfaceParameters &parameters, const double length)
    {
      Surface surface;
      surface.period = length;
      surface.curve  = interpolate_periodic_function(
        [&](const double x) {
          double y = 0.;
          for (std::size_t k = 0; k < parameters.amplitudes.size(); ++k)
            y += parameters.amplitudes[k] *
                 std::cos(2. * M_PI * parameters.wave_numbers[k] * x / length +
                          parameters.phases[k]);
          return parameters.topography.scale_z * y;
        },
        0.,
        length,
        parameters.n_spans_of_harmonics(),
        parameters.degree);
      surface.description =
        std::to_string(parameters.amplitudes.size()) + " harmonics";
      return surface;
    }

    Surface
    make_measured(const SurfaceParameters &parameters)
    {
      Surface       surface;
      const Profile profile =
        make_profile(parameters.topography, surface.topography.emplace());
      if (!profile.periodic)
        throw InputError(parameters.topography.file +
                         ": the profile is not periodic; choose a periodic "
                         "continuation.");
      const std::size_t   n = profile.heights.size();
      std::vector<double> x(n);
      for (std::size_t i = 0; i < n; ++i)
        x[i] = i * profile.spacing;
      surface.period = profile.length();
      const SplineFit fit =
        parameters.fit == SurfaceFit::interpolation ?
          interpolate_periodic_graph(profile.heights,
                                     surface.period,
                                     parameters.degree) :
          fit_periodic_graph(x,
                             profile.heights,
                             surface.period,
                             parameters.spans.value_or(
                               std::max<std::size_t>(8, n / 2)),
                             parameters.degree);
      surface.curve       = fit.curve;
      surface.fit_rms     = fit.report.rms_error;
      surface.description = "profile of " + parameters.topography.file + ", " +
                            std::to_string(n) + " points";
      return surface;
    }
  } // namespace



  Surface
  make_surface(const SurfaceParameters &parameters, const double length)
  {
    switch (parameters.kind)
      {
        case SurfaceKind::harmonics:
          return make_harmonics(parameters, length);
        case SurfaceKind::measured:
          return make_measured(parameters);
        default:
          return make_flat(length, parameters.degree);
      }
  }



  namespace
  {
    /** A measured surface again, with a profile that is cut to a period. */
    Surface
    cut_to_period(const Surface     &longer,
                  SurfaceParameters  parameters,
                  const double       period,
                  const std::string &of_whom)
    {
      TopographyParameters &topography = parameters.topography;
      const bool mirrored = topography.continuation == Continuation::mirror;
      topography.length   = period / topography.scale_x / (mirrored ? 2. : 1.);
      Surface           surface = make_measured(parameters);
      TopographyReport &report  = *surface.topography;
      const double      before  = longer.topography->profile_roughness.Rq,
                   after        = report.profile_roughness.Rq;
      report.steps.push_back(
        "Common period: " + format_quantity(period, "um", 5) + " of the " +
        of_whom + " instead of " + format_quantity(longer.period, "um", 5) +
        ", " + format_quantity(100. * period / longer.period, "1", 3) +
        " % of the length; Rq " + format_quantity(before, "um", 4) + " -> " +
        format_quantity(after, "um", 4) + ".");
      if (std::abs(after - before) > 0.1 * before)
        report.warnings.push_back(
          "The common period changes Rq from " +
          format_quantity(before, "um", 4) + " to " +
          format_quantity(after, "um", 4) +
          ": the profile is not the same everywhere; choose a typical piece by "
          "Profile start.");
      return surface;
    }

    bool
    same(const double one, const double other)
    {
      return std::abs(one - other) <= 1e-9 * std::max(one, other);
    }
  } // namespace



  std::pair<Surface, Surface>
  make_surfaces(const SceneParameters &parameters)
  {
    Surface tool = make_surface(parameters.tool, parameters.geometry.length),
            chip = make_surface(parameters.chip, tool.period);
    if (same(chip.period, tool.period))
      return {tool, chip};
    if (chip.period > tool.period)
      chip = cut_to_period(chip, parameters.chip, tool.period, "tool");
    else if (parameters.tool.kind == SurfaceKind::measured)
      tool = cut_to_period(tool, parameters.tool, chip.period, "chip");
    if (!same(chip.period, tool.period))
      throw InputError(
        "Chip surface: its period is " + format_quantity(chip.period, "um") +
        "; expected that of the tool, " + format_quantity(tool.period, "um") +
        "; crop or scale one of them.");
    return {tool, chip};
  }



  double
  Surface::height(const double x) const
  {
    return curve.value(x)[1];
  }



  double
  Surface::minimum() const
  {
    return periodic_minimum([this](const double x) { return height(x); },
                            period,
                            search_points(*this));
  }



  double
  Surface::maximum() const
  {
    return -periodic_minimum([this](const double x) { return -height(x); },
                             period,
                             search_points(*this));
  }



  double
  Surface::mean() const
  {
    const dealii::QGauss<1> gauss(curve.degree() / 2 + 1);
    double                  sum = 0.;
    for (const BezierPiece &piece : curve.bezier_pieces())
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          const double width = piece.end - piece.begin;
          sum += gauss.weight(q) * width *
                 height(piece.begin + width * gauss.point(q)[0]);
        }
    return sum / period;
  }



  double
  Surface::largest_slope() const
  {
    return -periodic_minimum(
      [this](const double x) {
        return -std::abs(curve.derivatives(x, 1)[1][1]);
      },
      period,
      search_points(*this));
  }



  Surface
  Surface::mapped(const double factor, const double offset) const
  {
    Surface surface = *this;
    auto    points  = curve.control_points();
    for (auto &point : points)
      point[1] = factor * point[1] + offset;
    surface.curve.set_control_points(points);
    return surface;
  }



  Surface
  Surface::moved(const double distance) const
  {
    std::vector<double> breakpoints = curve.knot_vector().breakpoints();
    for (double &x : breakpoints)
      x += distance;
    auto points = curve.control_points();
    for (auto &point : points)
      point[0] += distance;
    Surface surface = *this;
    surface.curve =
      SplineCurve(KnotVector(curve.degree(), breakpoints, curve.is_periodic()),
                  points,
                  curve.weights(),
                  curve.period());
    return surface;
  }



  double
  smallest_gap(const Surface &lower, const Surface &upper)
  {
    return periodic_minimum(
      [&](const double x) { return upper.height(x) - lower.height(x); },
      lower.period,
      std::max(search_points(lower), search_points(upper)));
  }
} // namespace asperity
