#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/splines/grid_lines.h>
#include <asperity/topography/make_window.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

#include "report_words.h"

namespace asperity
{
  namespace
  {
    // Steps across the seam that are larger than others by this factor are no
    // longer what a periodic surface has.
    constexpr double usual_seam_step = 1.5;

    constexpr unsigned int fewest_samples = 10;

    /** Part of the window that may be filled without a word. */
    constexpr double filled_silently = 0.01;

    std::string
    size_of(const double x, const double y)
    {
      return micrometres(x) + " x " + micrometres(y);
    }

    unsigned int
    n_samples(const HeightMap &map, const unsigned int direction)
    {
      return direction == 0 ? map.nx : map.ny;
    }

    double
    spacing(const HeightMap &map, const unsigned int direction)
    {
      return direction == 0 ? map.dx : map.dy;
    }

    void
    set_size(HeightMap         &map,
             const unsigned int direction,
             const unsigned int n,
             const double       spacing)
    {
      (direction == 0 ? map.nx : map.ny) = n;
      (direction == 0 ? map.dx : map.dy) = spacing;
    }

    /** First sample and number of samples along a direction. */
    std::pair<unsigned int, unsigned int>
    find_range(const HeightMap    &map,
               const WindowChoice &choice,
               const unsigned int  d)
    {
      const double       h      = spacing(map, d);
      const unsigned int n_all  = n_samples(map, d);
      const double       extent = choice.extent[d];
      const char *const  name[] = {"x", "y"};
      if (!(extent > 0.) || !std::isfinite(extent))
        throw InputError("The extent of a window along " +
                         std::string(name[d]) + " is " + micrometres(extent) +
                         ", but a positive length is expected.");
      if (extent > n_all * h * (1. + 1e-9))
        throw InputError("A window of " +
                         size_of(choice.extent[0], choice.extent[1]) +
                         " does not fit into the map of " +
                         size_of(map.length_x(), map.length_y()) + " in " +
                         quoted_name(map.provenance.file) + ".");
      // As many samples as the extent holds; resampling makes up the rest.
      const auto n = static_cast<unsigned int>(extent / h * (1. + 1e-9));
      if (n < fewest_samples)
        throw InputError("The window's extent along " + std::string(name[d]) +
                         ", " + micrometres(extent) + ", holds " +
                         std::to_string(n) + " samples of " +
                         quoted_name(map.provenance.file) + ", but at least " +
                         std::to_string(fewest_samples) + " are expected.");
      if (!choice.origin)
        return {(n_all - n) / 2, n};
      const double first = std::round((*choice.origin)[d] / h);
      if (!(first >= 0. && first + n <= n_all))
        throw InputError("The window from " + micrometres((*choice.origin)[d]) +
                         " to " + micrometres((*choice.origin)[d] + extent) +
                         " along " + name[d] + " leaves the map of " +
                         size_of(map.length_x(), map.length_y()) + " in " +
                         quoted_name(map.provenance.file) + ".");
      return {static_cast<unsigned int>(first), n};
    }

    /** By straight lines along x; rows without a height by such along y. */
    std::size_t
    fill(HeightMap &map, const double largest_missing_fraction)
    {
      const double missing = map.missing_fraction();
      if (missing > largest_missing_fraction)
        throw InputError(
          percent(missing) + " of the window's points are missing in " +
          quoted_name(map.provenance.file) + ", more than the " +
          percent(largest_missing_fraction) +
          " that the entry 'Largest missing fraction' allows; set Crop = "
          "hole-free, or move the window.");
      const std::size_t n = map.heights.size() - map.n_valid();
      for (unsigned int d = 0; d < 2; ++d)
        map.heights = map_lines(d, map.nx, map.heights, [&](auto line) {
          const bool any = std::any_of(line.begin(), line.end(), [](double z) {
            return !std::isnan(z);
          });
          if (any)
            fill_gaps(line);
          return line;
        });
      return n;
    }

    /** To the spacing with which the samples meet the extent. The last one may
     *  lie up to one spacing beyond the last of the map, where it stays. */
    void
    meet_extent(HeightMap          &map,
                const WindowChoice &choice,
                TopographyReport   &report)
    {
      const double Sq      = areal_roughness(map).Sq;
      bool         changed = false;
      for (unsigned int d = 0; d < 2; ++d)
        {
          const unsigned int n = n_samples(map, d);
          const double       h = choice.extent[d] / n;
          if (std::abs(h / spacing(map, d) - 1.) < 1e-9)
            continue;
          map.heights =
            map_lines(d, map.nx, map.heights, [&](const auto &line) {
              Profile profile;
              profile.heights = line;
              profile.spacing = spacing(map, d);
              return resample(profile, h, n).heights;
            });
          set_size(map, d, n, h);
          changed = true;
        }
      if (changed)
        report.steps.push_back("Resampled to " + size_of(map.dx, map.dy) +
                               " by cubic splines, so that the window is " +
                               size_of(choice.extent[0], choice.extent[1]) +
                               ", Sq " + micrometres(Sq) + " -> " +
                               micrometres(areal_roughness(map).Sq) + ".");
    }

    /** What the heights of one line, extrapolated to the place of the first
     *  sample after the seam, and those extrapolated back from there, miss: the
     *  mean of both. */
    double
    jump(const std::vector<double> &z)
    {
      const std::size_t n = z.size();
      return (3. * z[n - 1] - z[n - 2] - 3. * z[0] + z[1]) / 2.;
    }

    std::vector<double>
    jumps(const HeightMap &map, const unsigned int direction)
    {
      return map_lines(direction, map.nx, map.heights, [](const auto &line) {
        return std::vector<double>{jump(line)};
      });
    }

    double
    root_mean_square(const std::vector<double> &values)
    {
      return std::sqrt(
        std::inner_product(values.begin(), values.end(), values.begin(), 0.) /
        values.size());
    }

    /** The tilt of the mean jumps, and the mean height. */
    void
    remove_tilt(HeightMap         &map,
                const Continuation continuation,
                WindowReport      &report)
    {
      for (unsigned int d = 0;
           d < 2 && continuation == Continuation::wrapped_spline;
           ++d)
        {
          const auto   all = jumps(map, d);
          const double mean =
            std::accumulate(all.begin(), all.end(), 0.) / all.size();
          report.removed_tilt[d] = mean / (n_samples(map, d) * spacing(map, d));
        }
      double mean = 0.;
      for (unsigned int j = 0; j < map.ny; ++j)
        for (unsigned int i = 0; i < map.nx; ++i)
          {
            map(i, j) -= report.removed_tilt[0] * i * map.dx +
                         report.removed_tilt[1] * j * map.dy;
            mean += map(i, j) / map.heights.size();
          }
      for (double &z : map.heights)
        z -= mean;
    }

    /** Whether steps across the seam are larger than those elsewhere. */
    bool
    has_seam(const HeightMap &map, const unsigned int direction)
    {
      const auto across =
        map_lines(direction, map.nx, map.heights, [](const auto &line) {
          return std::vector<double>{line.front() - line.back()};
        });
      const auto inside =
        map_lines(direction, map.nx, map.heights, [](const auto &line) {
          std::vector<double> steps;
          for (std::size_t i = 0; i + 1 < line.size(); ++i)
            steps.push_back(line[i + 1] - line[i]);
          return steps;
        });
      return root_mean_square(across) >
             usual_seam_step * root_mean_square(inside);
    }

    void
    describe_seams(const HeightMap &map, WindowReport &report)
    {
      for (unsigned int d = 0; d < 2; ++d)
        {
          const auto all     = jumps(map, d);
          report.rms_jump[d] = root_mean_square(all);
          for (const double jump : all)
            report.largest_jump[d] =
              std::max(report.largest_jump[d], std::abs(jump));
        }
      const ArealRoughness roughness = areal_roughness(map);
      report.Sq_before               = roughness.Sq;
      report.Sdq_before              = roughness.Sdq;
    }

    using WrappedFits = std::array<WrappedSpline, 2>;

    WrappedFits
    make_fits(const HeightMap            &map,
              const TopographyParameters &p,
              WindowReport               &report)
    {
      const auto fit_along = [&](const unsigned int d) {
        WrappedSplineOptions options = p.spline;
        report.bridged[d] = p.continuation == Continuation::wrapped_spline &&
                            options.blend_fraction > 0. && has_seam(map, d);
        if (!report.bridged[d])
          options.blend_fraction = 0.;
        return WrappedSpline(n_samples(map, d), options);
      };
      const WrappedFits fits = {{fit_along(0), fit_along(1)}};
      for (unsigned int d = 0; d < 2; ++d)
        report.n_knots[d] = fits[d].n_knots();
      return fits;
    }

    std::vector<double>
    fit(const HeightMap &map, const WrappedFits &fits)
    {
      const auto rows =
        map_lines(0, map.nx, map.heights, [&](const auto &line) {
          return fits[0].coefficients(line);
        });
      return map_lines(1, fits[0].n_knots(), rows, [&](const auto &line) {
        return fits[1].coefficients(line);
      });
    }

    /** What the fit changes at the samples of the window. */
    void
    compare(const HeightMap           &map,
            const WrappedFits         &fits,
            const std::vector<double> &coefficients,
            WindowReport              &report)
    {
      const auto rows =
        map_lines(0, fits[0].n_knots(), coefficients, [&](const auto &line) {
          return fits[0].values(line);
        });
      HeightMap after = map;
      after.heights   = map_lines(1, map.nx, rows, [&](const auto &line) {
        return fits[1].values(line);
      });

      std::size_t n = 0;
      for (unsigned int j = 0; j < map.ny; ++j)
        for (unsigned int i = 0; i < map.nx; ++i)
          if (!fits[0].is_blended(i) && !fits[1].is_blended(j))
            {
              const double change = std::abs(after(i, j) - map(i, j));
              report.fit_max      = std::max(report.fit_max, change);
              report.fit_rms += change * change;
              ++n;
            }
      report.fit_rms = std::sqrt(report.fit_rms / std::max<std::size_t>(n, 1));
      const ArealRoughness roughness = areal_roughness(after);
      report.Sq_after                = roughness.Sq;
      report.Sdq_after               = roughness.Sdq;
    }

    SplineSheet
    make_sheet(const WrappedFits          &fits,
               const std::vector<double>  &coefficients,
               const TopographyParameters &p,
               const WindowReport         &report)
    {
      const auto knots = [&](const unsigned int d) {
        return KnotVector::uniform_periodic(p.spline.degree,
                                            fits[d].n_knots(),
                                            0.,
                                            report.extent[d] * p.scale_x);
      };
      return SplineSheet({{knots(0), knots(1)}}, coefficients)
        .mapped(p.scale_z, 0.);
    }

    void
    describe(const TopographyParameters &p,
             const WindowReport         &w,
             TopographyReport           &report)
    {
      const auto bridge = [&](const unsigned int d) {
        return std::string(w.bridged[d] ? " (bridged)" : "");
      };
      const double Sq_change =
        w.Sq_before > 0. ? w.Sq_after / w.Sq_before - 1. : 0.;
      report.steps.push_back(
        "Window: columns " + std::to_string(w.window.column) + " .. " +
        std::to_string(w.window.column + w.window.nx - 1) + ", rows " +
        std::to_string(w.window.row) + " .. " +
        std::to_string(w.window.row + w.window.ny - 1) + ", " +
        size_of(w.extent[0], w.extent[1]) + "; missing samples: " +
        std::to_string(w.n_filled) + " filled by straight lines.");
      report.steps.push_back(
        "Periodic continuation in x and y: tilts removed " +
        percent(w.removed_tilt[0]) + " and " + percent(w.removed_tilt[1]) +
        "; jumps at the seam of x rms " + micrometres(w.rms_jump[0]) +
        ", largest " + micrometres(w.largest_jump[0]) + bridge(0) +
        ", of y rms " + micrometres(w.rms_jump[1]) + ", largest " +
        micrometres(w.largest_jump[1]) + bridge(1) + "; Sq " +
        micrometres(w.Sq_before) + " -> " + micrometres(w.Sq_after) + " (" +
        percent(Sq_change) + "), Sdq " + format_quantity(w.Sdq_before, "1", 4) +
        " -> " + format_quantity(w.Sdq_after, "1", 4) +
        ", change of a sample rms " + micrometres(w.fit_rms) + ", largest " +
        micrometres(w.fit_max) + ".");
      const double filled = double(w.n_filled) / w.window.nx / w.window.ny;
      if (filled > filled_silently)
        report.warnings.push_back(
          percent(filled) +
          " of the window's points are missing in the map and were filled by "
          "straight lines, which have no asperities: choose another window, or "
          "set Crop = hole-free.");
      if (std::abs(Sq_change) > 0.1)
        report.warnings.push_back(
          "The periodic continuation changes Sq by " + percent(Sq_change) +
          ": remove the form with a higher degree, or take a larger window.");
      if (p.scale_x != 1. || p.scale_z != 1.)
        report.steps.push_back(
          "Scaling: x and y by " + format_number(p.scale_x) + ", z by " +
          format_number(p.scale_z) + "; the periods are " +
          size_of(w.extent[0] * p.scale_x, w.extent[1] * p.scale_x) + ".");
    }
  } // namespace



  SplineSheet
  make_window(const TopographyParameters &parameters,
              const WindowChoice         &choice,
              TopographyReport           &report,
              WindowReport               &window_report)
  {
    if (parameters.continuation == Continuation::mirror)
      throw InputError(
        "A window cannot be continued by its mirror image, "
        "which has edges; set Periodic continuation = wrapped spline.");
    report.map                         = treat_map(parameters, report);
    window_report                      = {};
    window_report.extent               = choice.extent;
    Window &window                     = window_report.window;
    std::tie(window.column, window.nx) = find_range(report.map, choice, 0);
    std::tie(window.row, window.ny)    = find_range(report.map, choice, 1);
    HeightMap map                      = crop(report.map, window);
    window_report.n_filled = fill(map, parameters.largest_missing_fraction);
    meet_extent(map, choice, report);
    remove_tilt(map, parameters.continuation, window_report);
    describe_seams(map, window_report);
    const WrappedFits         fits = make_fits(map, parameters, window_report);
    const std::vector<double> coefficients = fit(map, fits);
    compare(map, fits, coefficients, window_report);
    describe(parameters, window_report, report);
    return make_sheet(fits, coefficients, parameters, window_report);
  }
} // namespace asperity
