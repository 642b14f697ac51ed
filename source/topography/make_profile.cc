#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/topography/form_removal.h>
#include <asperity/topography/gaussian_filter.h>
#include <asperity/topography/length_unit.h>
#include <asperity/topography/make_profile.h>
#include <asperity/topography/read_height_map.h>

#include <algorithm>
#include <tuple>

#include "report_words.h"
#include "treatment_warnings.h"

namespace asperity
{
  namespace
  {
    /** Calls parse() and completes its half sentence with the entry's name. */
    template <typename Parse>
    double
    parse_entry(const std::string &entry,
                const std::string &text,
                const Parse       &parse)
    {
      try
        {
          return parse();
        }
      catch (const InputError &error)
        {
          throw InputError("The entry " + quoted_name(entry) + " = " +
                           quoted_text(text) + ": " + error.what());
        }
    }

    double
    unit_of_entry(const std::string &entry, const std::string &text)
    {
      if (text.empty())
        return 0.;
      const double metre = metres_per(text);
      if (metre == 0.)
        throw InputError("The entry " + quoted_name(entry) + " = " +
                         quoted_text(text) +
                         " is no unit of length; m, mm, um, nm or pm is "
                         "expected.");
      return metre;
    }

    HeightMap
    read_surface(const TopographyParameters &p)
    {
      if (p.file.empty())
        throw InputError("The entry 'File' of the topography is empty; the "
                         "file of a measured surface is expected.");
      ReadOptions options;
      options.lateral_unit = unit_of_entry("Lateral unit", p.lateral_unit);
      options.height_unit  = unit_of_entry("Height unit", p.height_unit);
      options.spacing_x    = p.spacing_x.value_or(0.);
      options.spacing_y    = p.spacing_y.value_or(options.spacing_x);
      HeightMap map        = read_height_map(p.file, options);
      if (!map.provenance.has_unit)
        {
          std::string what = map.provenance.warnings.back();
          what.pop_back(); // its full stop
          throw InputError("The surface file " + quoted_name(p.file) + ": " +
                           what + "; set both Lateral unit and Height unit.");
        }
      return map;
    }

    /** First index and number of samples that an entry asks for. */
    std::pair<unsigned int, unsigned int>
    parse_range(const std::string &entry,
                const std::string &text,
                const double       spacing,
                const unsigned int n)
    {
      if (trim(text) == "all")
        return {0, n};
      const auto dots = text.find("..");
      if (dots == std::string::npos)
        throw InputError("The entry " + quoted_name(entry) + " = " +
                         quoted_text(text) +
                         " is no range; all, 60 .. 195 or 380 um .. 1250 um "
                         "is expected.");
      bool       is_length = false;
      const auto index     = [&](const std::string &part) {
        is_length = part.find_first_not_of("0123456789") != std::string::npos;
        return parse_entry(entry, text, [&]() {
          return is_length ?
                       std::round(parse_quantity(part, Dimension::length) /
                              spacing) :
                       parse_quantity(part, Dimension::none);
        });
      };
      const double first = index(trim(text.substr(0, dots)));
      double       last  = index(trim(text.substr(dots + 2)));
      // A length may name the outer edge of the map, one beyond the last.
      if (is_length && last == n)
        last = n - 1.;
      if (!(first >= 0. && last > first && last < n))
        throw InputError(
          "The entry " + quoted_name(entry) + " = " + quoted_text(text) +
          " is empty or leaves the map, which has the samples "
          "0 .. " +
          std::to_string(n - 1) + " over " + micrometres(n * spacing) + ".");
      const auto begin = static_cast<unsigned int>(first);
      return {begin, static_cast<unsigned int>(last) - begin + 1};
    }

    Window
    choose_window(const TopographyParameters &p, const HeightMap &map)
    {
      if (p.crop == CropChoice::hole_free)
        return largest_window_without_holes(map);
      Window window = {0, 0, map.nx, map.ny};
      if (p.crop == CropChoice::window)
        {
          std::tie(window.column, window.nx) =
            parse_range("Crop columns", p.crop_columns, map.dx, map.nx);
          std::tie(window.row, window.ny) =
            parse_range("Crop rows", p.crop_rows, map.dy, map.ny);
        }
      return window;
    }

    void
    remove_spikes_and_crop(const TopographyParameters &p,
                           HeightMap                  &map,
                           TopographyReport           &report)
    {
      if (p.spike_threshold > 0.)
        {
          report.n_spikes = remove_spikes(map, p.spike_threshold);
          report.steps.push_back(
            "Spikes: " + std::to_string(report.n_spikes) + " points beyond " +
            format_number(p.spike_threshold) +
            " robust standard deviations were declared missing.");
        }
      else
        report.spikes = mark_spikes(map);
      report.window  = choose_window(p, map);
      const Window w = report.window;
      if (p.crop != CropChoice::none)
        {
          map = crop(map, w);
          report.steps.push_back("Crop: columns " + std::to_string(w.column) +
                                 " .. " + std::to_string(w.column + w.nx - 1) +
                                 ", rows " + std::to_string(w.row) + " .. " +
                                 std::to_string(w.row + w.ny - 1) + ", " +
                                 micrometres(map.length_x()) + " x " +
                                 micrometres(map.length_y()) + ", " +
                                 percent(map.missing_fraction()) + " missing.");
        }
      // Holes outside the crop are of no consequence.
      if (map.missing_fraction() > 0.2)
        report.warnings.push_back(
          percent(map.missing_fraction()) +
          " of the points used are missing: crop the map to where it is "
          "measured, or set Crop = hole-free.");
    }

    void
    remove_form_and_filter(const TopographyParameters &p,
                           HeightMap                  &map,
                           TopographyReport           &report)
    {
      const auto Sq         = [&map]() { return areal_roughness(map).Sq; };
      report.Sq_before_form = Sq();
      if (p.form != FormChoice::none)
        {
          const bool plane = p.form == FormChoice::plane;
          remove_form(map, plane ? 1 : p.polynomial_degree);
          report.steps.push_back(
            std::string("F-operator: ") +
            (plane ?
               "plane" :
               "polynomial of degree " + std::to_string(p.polynomial_degree)) +
            " removed, Sq " + micrometres(report.Sq_before_form) + " -> " +
            micrometres(Sq()) + ".");
        }
      const auto filter = [&](const std::string &name,
                              const double       index,
                              void (*apply)(HeightMap &, double)) {
        if (index == 0.)
          return;
        const double before = Sq();
        apply(map, index);
        report.steps.push_back(
          name + "-filter: Gaussian, nesting index " + micrometres(index) +
          ", Sq " + micrometres(before) + " -> " + micrometres(Sq()) + ".");
        if (index > 0.5 * std::max(map.length_x(), map.length_y()))
          report.warnings.push_back(
            "The nesting index of the " + name +
            "-filter is more than half of the map: its result is mostly an "
            "effect of the ends.");
      };
      filter("S", p.s_filter, [](HeightMap &m, double i) {
        apply_s_filter(m, i);
      });
      filter("L", p.l_filter, [](HeightMap &m, double i) {
        apply_l_filter(m, i);
      });
      if (p.l_filter == 0.)
        report.steps.push_back(
          "L-filter: none; the values R* are those of the primary profile, which "
          "ISO 4287 calls Pa, Pq, Pt and so on.");
    }

    /** The point in the map that the entry `Profile position` asks for. */
    ProfileLine
    find_line(const TopographyParameters &p, const HeightMap &map)
    {
      ProfileLine line;
      line.angle        = p.direction;
      line.x            = 0.5 * (map.nx - 1) * map.dx;
      line.y            = 0.5 * (map.ny - 1) * map.dy;
      line.from         = p.start;
      line.to           = p.length > 0. ? p.start + p.length : 0.;
      const bool steep  = std::abs(std::sin(p.direction)) > std::sqrt(0.5);
      double    &across = steep ? line.x : line.y;
      const auto text   = trim(p.position);
      const auto word   = steep ? std::string("column") : std::string("row");
      if (text == "middle" || map.ny == 1)
        return line;
      across = parse_entry("Profile position", text, [&]() {
        if (text.compare(0, word.size(), word) == 0)
          return parse_quantity(trim(text.substr(word.size())),
                                Dimension::none) *
                 (steep ? map.dx : map.dy);
        return parse_quantity(text, Dimension::length);
      });
      return line;
    }

    /** Cut off what is missing at the ends; returns how many samples. */
    std::size_t
    trim_ends(std::vector<double> &heights)
    {
      const auto valid = [](const double z) { return !std::isnan(z); };
      const auto first = std::find_if(heights.begin(), heights.end(), valid);
      const auto last  = std::find_if(heights.rbegin(), heights.rend(), valid);
      if (first == heights.end())
        return 0;
      const std::vector<double> measured(first, last.base());
      const std::size_t         n_cut = heights.size() - measured.size();
      heights                         = measured;
      return n_cut;
    }

    /** Leaves as many samples of the profile as fit into the length that is
     *  asked for, and sets their distance so that it is met. A mirrored profile
     *  keeps both ends, and turns round there. */
    void
    meet_length(const TopographyParameters &p, TopographyReport &report)
    {
      if (p.length == 0.)
        return;
      Profile          &profile  = report.measured;
      const bool        mirrored = p.continuation == Continuation::mirror;
      const std::size_t n        = profile.heights.size() - (mirrored ? 1 : 0);
      // Trimmed profiles are shorter.
      const double length = std::min(p.length, n * profile.spacing);
      if (length < p.length - profile.spacing)
        report.warnings.push_back("Ends of the profile are missing: it is " +
                                  micrometres(length) + " long instead of " +
                                  micrometres(p.length) + ".");
      const auto m = static_cast<std::size_t>(
        std::floor(length / profile.spacing * (1. + 1e-9)));
      const double h = length / m;
      if (std::abs(h / profile.spacing - 1.) < 1e-9)
        {
          profile.heights.resize(m + (mirrored ? 1 : 0));
          return;
        }
      const auto Rq = [&profile]() {
        return micrometres(
          profile_roughness(profile.heights, profile.spacing).Rq);
      };
      const std::string before =
        "Resampled from " + micrometres(profile.spacing) + " to " +
        micrometres(h) + " by a cubic spline, so that the length is " +
        micrometres(length) + ", Rq " + Rq();
      profile = resample(profile, h, m + (mirrored ? 1 : 0));
      report.steps.push_back(before + " -> " + Rq() + ".");
    }

    void
    take_profile(const TopographyParameters &p,
                 const HeightMap            &map,
                 TopographyReport           &report)
    {
      report.line      = find_line(p, map);
      report.measured  = extract_profile(map, report.line);
      auto &heights    = report.measured.heights;
      report.n_trimmed = trim_ends(heights);
      double missing   = 0.;
      for (const double z : heights)
        missing += std::isnan(z) / static_cast<double>(heights.size());
      if (missing > p.largest_missing_fraction)
        throw InputError(
          percent(missing) + " of the profile's points are missing in " +
          quoted_name(p.file) + ", more than the " +
          percent(p.largest_missing_fraction) +
          " that the entry 'Largest missing fraction' allows; set Crop = "
          "hole-free, or move the profile.");
      report.n_filled = fill_gaps(heights);
      meet_length(p, report);
      report.measured_roughness =
        profile_roughness(heights, report.measured.spacing);
      report.steps.push_back(
        "Profile: " + std::to_string(heights.size()) + " samples over " +
        micrometres(report.measured.length()) + " at " +
        format_quantity(p.direction, "deg", 4) + " to x, position " +
        p.position + "; missing samples: " + std::to_string(report.n_trimmed) +
        " at the ends cut off, " + std::to_string(report.n_filled) +
        " inside filled by straight lines.");
    }

    void
    finish_profile(const TopographyParameters &p, TopographyReport &report)
    {
      report.profile = make_periodic(report.measured,
                                     p.continuation,
                                     p.spline,
                                     report.continuation);
      const auto  &c = report.continuation;
      const double Rq_change =
        c.Rq_before > 0. ? c.Rq_after / c.Rq_before - 1. : 0.;
      const char *names[] = {"wrapped spline", "mirror", "none"};
      report.steps.push_back(
        std::string("Periodic continuation: ") +
        names[static_cast<int>(p.continuation)] + "; trend removed " +
        percent(c.removed_trend) + ", jump at the seam " +
        micrometres(c.jump_before) + " -> " + micrometres(c.jump_after) +
        ", Rq " + micrometres(c.Rq_before) + " -> " + micrometres(c.Rq_after) +
        " (" + percent(Rq_change) + "), change of a sample rms " +
        micrometres(c.fit_rms) + ", largest " + micrometres(c.fit_max) + ".");
      if (std::abs(Rq_change) > 0.1)
        report.warnings.push_back(
          "The periodic continuation changes Rq by " + percent(Rq_change) +
          ": remove the form with a higher degree, or take a longer profile.");

      report.scale_x = p.scale_x;
      report.scale_z = p.scale_z;
      report.profile.spacing *= p.scale_x;
      for (double &z : report.profile.heights)
        z *= p.scale_z;
      if (p.scale_x != 1. || p.scale_z != 1.)
        report.steps.push_back("Scaling: x by " + format_number(p.scale_x) +
                               ", z by " + format_number(p.scale_z) +
                               "; the period is " +
                               micrometres(report.profile.length()) + ".");
      report.profile_roughness =
        profile_roughness(report.profile.heights, report.profile.spacing);
    }
  } // namespace

  HeightMap
  treat_map(const TopographyParameters &parameters, TopographyReport &report)
  {
    report        = {};
    HeightMap map = read_surface(parameters);
    report.sanity = check_sanity(map);
    report.steps  = map.provenance.notes;
    remove_spikes_and_crop(parameters, map, report);
    remove_form_and_filter(parameters, map, report);
    report.areal   = areal_roughness(map);
    report.texture = areal_texture(map);
    return map;
  }

  Profile
  make_profile(const TopographyParameters &parameters, TopographyReport &report)
  {
    report.map = treat_map(parameters, report);
    take_profile(parameters, report.map, report);
    finish_profile(parameters, report);
    warn_of_treatment(report);
    return report.profile;
  }
} // namespace asperity
