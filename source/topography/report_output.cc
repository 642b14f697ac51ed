#include <asperity/base/quantity.h>
#include <asperity/topography/report_output.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <ostream>

namespace asperity
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    void
    print_row(std::ostream      &out,
              const std::string &name,
              const std::string &value)
    {
      out << "  " << name
          << std::string(name.size() < 22 ? 22 - name.size() : 1, ' ') << value
          << '\n';
    }

    std::string
    length(const double value)
    {
      if (std::isnan(value))
        return "undefined";
      // Heights of nanometres are easier read as such.
      return format_quantity(value, std::abs(value) < 1e-7 ? "nm" : "um", 6);
    }

    std::string
    number(const double value)
    {
      if (std::isnan(value))
        return "undefined";
      char text[32];
      std::snprintf(text, sizeof(text), "%.6g", value);
      return text;
    }

    void
    print_sanity(const SanityReport &s, std::ostream &out)
    {
      out << "Surface\n";
      print_row(out, "file", s.file);
      print_row(out, "format", s.format);
      if (!s.description.empty())
        print_row(out, "description", s.description);
      print_row(out, "unit", s.unit_source);
      print_row(out,
                "points",
                std::to_string(s.nx) + " x " + std::to_string(s.ny));
      print_row(out, "spacing", length(s.dx) + " x " + length(s.dy));
      print_row(out, "size", length(s.length_x) + " x " + length(s.length_y));
      print_row(out, "heights", length(s.minimum) + " to " + length(s.maximum));
      print_row(out, "missing", number(100. * s.missing_fraction) + " %");
    }

    void
    print_areal(const ArealRoughness &a,
                const ArealTexture   &texture,
                std::ostream         &out)
    {
      out << "Areal roughness (ISO 25178-2)\n";
      print_row(out, "Sa", length(a.Sa));
      print_row(out, "Sq", length(a.Sq));
      print_row(out, "Sz", length(a.Sz));
      print_row(out, "Sp", length(a.Sp));
      print_row(out, "Sv", length(a.Sv));
      print_row(out, "Ssk", number(a.Ssk));
      print_row(out, "Sku", number(a.Sku));
      print_row(out, "Sdq", number(a.Sdq));
      print_row(out, "Sdr", number(100. * a.Sdr) + " %");
      print_row(out, "Sal", length(texture.Sal));
      print_row(out,
                "Str",
                std::isnan(texture.Str) ?
                  "at most " + number(texture.Str_bound) +
                    " (some decay to 0.2 takes more than half of the map)" :
                  number(texture.Str));
    }

    void
    print_profile_roughness(const std::string      &title,
                            const ProfileRoughness &r,
                            std::ostream           &out)
    {
      out << title << '\n';
      print_row(out, "Ra", length(r.Ra));
      print_row(out, "Rq", length(r.Rq));
      print_row(out, "Rz (five sections)", length(r.Rz));
      print_row(out, "Rt", length(r.Rt));
      print_row(out, "Rsk", number(r.Rsk));
      print_row(out, "Rku", number(r.Rku));
      print_row(out, "Rdq", number(r.Rdq));
    }

    Json
    json_of(const SanityReport &s)
    {
      return {{"file", s.file},
              {"format", s.format},
              {"description", s.description},
              {"unit_source", s.unit_source},
              {"points", {s.nx, s.ny}},
              {"spacing", {s.dx, s.dy}},
              {"size", {s.length_x, s.length_y}},
              {"minimum", s.minimum},
              {"maximum", s.maximum},
              {"missing_fraction", s.missing_fraction},
              {"warnings", s.warnings}};
    }

    Json
    json_of(const ArealRoughness &a, const ArealTexture &texture)
    {
      return {{"standard", "ISO 25178-2"},
              {"Sa", a.Sa},
              {"Sq", a.Sq},
              {"Sp", a.Sp},
              {"Sv", a.Sv},
              {"Sz", a.Sz},
              {"Ssk", a.Ssk},
              {"Sku", a.Sku},
              {"Sdq", a.Sdq},
              {"Sdr", a.Sdr},
              {"Sal", texture.Sal},
              {"Str", texture.Str},
              {"Str_bound", texture.Str_bound}};
    }

    Json
    json_of(const ProfileRoughness &r)
    {
      return {{"standard", "ISO 4287"},
              {"Ra", r.Ra},
              {"Rq", r.Rq},
              {"Rz", r.Rz},
              {"Rt", r.Rt},
              {"Rsk", r.Rsk},
              {"Rku", r.Rku},
              {"Rdq", r.Rdq}};
    }

    Json
    json_of(const ContinuationReport &c)
    {
      return {{"jump_before", c.jump_before},
              {"jump_after", c.jump_after},
              {"slope_jump_before", c.slope_jump_before},
              {"slope_jump_after", c.slope_jump_after},
              {"Rq_before", c.Rq_before},
              {"Rq_after", c.Rq_after},
              {"max_slope_before", c.max_slope_before},
              {"max_slope_after", c.max_slope_after},
              {"fit_rms", c.fit_rms},
              {"fit_max", c.fit_max},
              {"removed_trend", c.removed_trend},
              {"knots", c.n_knots}};
    }
  } // namespace

  void
  print_report(const TopographyReport &report, std::ostream &out)
  {
    print_sanity(report.sanity, out);
    out << "Steps\n";
    for (const auto &step : report.steps)
      out << "  " << step << '\n';
    if (report.map.ny > 1)
      print_areal(report.areal, report.texture, out);
    print_profile_roughness("Measured profile (ISO 4287)",
                            report.measured_roughness,
                            out);
    print_profile_roughness("Finished profile (ISO 4287; periodic, scaled)",
                            report.profile_roughness,
                            out);
    print_row(out, "period", length(report.profile.length()));
    const auto &c = report.continuation;
    print_row(out,
              "slope jump at seam",
              number(c.slope_jump_before) + " -> " +
                number(c.slope_jump_after));
    print_row(out,
              "largest slope",
              number(c.max_slope_before) + " -> " + number(c.max_slope_after) +
                " (before scaling)");
    if (!report.sanity.warnings.empty() || !report.warnings.empty())
      out << "Warnings\n";
    for (const auto *list : {&report.sanity.warnings, &report.warnings})
      for (const auto &warning : *list)
        out << "  " << warning << '\n';
  }

  std::string
  report_json(const TopographyReport &report)
  {
    Json json;
    json["surface"]                     = json_of(report.sanity);
    json["steps"]                       = report.steps;
    json["warnings"]                    = report.warnings;
    json["spikes"]                      = report.n_spikes;
    json["window"]                      = {{"column", report.window.column},
                                           {"row", report.window.row},
                                           {"points", {report.window.nx, report.window.ny}}};
    json["Sq_before_form"]              = report.Sq_before_form;
    json["areal"]                       = json_of(report.areal, report.texture);
    json["measured_profile"]            = json_of(report.measured_roughness);
    json["measured_profile"]["samples"] = report.measured.heights.size();
    json["measured_profile"]["spacing"] = report.measured.spacing;
    json["measured_profile"]["trimmed"] = report.n_trimmed;
    json["measured_profile"]["filled"]  = report.n_filled;
    json["continuation"]                = json_of(report.continuation);
    json["profile"]                     = json_of(report.profile_roughness);
    json["profile"]["samples"]          = report.profile.heights.size();
    json["profile"]["spacing"]          = report.profile.spacing;
    json["profile"]["period"]           = report.profile.length();
    json["profile"]["scale_x"]          = report.scale_x;
    json["profile"]["scale_z"]          = report.scale_z;
    // File names and comments may hold any bytes.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  }

  std::string
  profile_csv(const Profile &profile, const std::string &title)
  {
    std::string text = "# " + title + "\nx [m],z [m]\n";
    for (std::size_t i = 0; i < profile.heights.size(); ++i)
      {
        char line[64];
        std::snprintf(line,
                      sizeof(line),
                      "%.9e,%.9e\n",
                      i * profile.spacing,
                      profile.heights[i]);
        text += line;
      }
    return text;
  }
} // namespace asperity
