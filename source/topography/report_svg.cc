#include <asperity/base/quantity.h>
#include <asperity/topography/png_image.h>
#include <asperity/topography/report_output.h>
#include <asperity/topography/svg.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    using namespace svg;

    /** Heights from which @p tail of all points are lower, or higher. */
    std::pair<double, double>
    colour_limits(const HeightMap &map, const double tail)
    {
      std::vector<double> valid;
      for (const double z : map.heights)
        if (!std::isnan(z))
          valid.push_back(z);
      std::sort(valid.begin(), valid.end());
      const auto   cut = static_cast<std::size_t>(tail * valid.size());
      const double low = valid[cut], high = valid[valid.size() - 1 - cut];
      return {low, high > low ? high : low + 1e-12};
    }

    /** Every pixel shows one sample; huge maps are thinned out. */
    std::string
    map_png(const HeightMap &map, const double low, const double high)
    {
      const unsigned int  width   = std::min(map.nx, 1200u);
      const unsigned int  height  = std::min(map.ny, 1200u);
      const Colour        missing = {{200, 200, 200}};
      std::vector<Colour> pixels;
      pixels.reserve(std::size_t(width) * height);
      // Row 0 of the map is the lower edge, so that y points up.
      for (unsigned int row = height; row-- > 0;)
        for (unsigned int column = 0; column < width; ++column)
          {
            const double z = map(std::uint64_t(column) * map.nx / width,
                                 std::uint64_t(row) * map.ny / height);
            pixels.push_back(std::isnan(z) ? missing :
                                             viridis((z - low) / (high - low)));
          }
      return encode_png(width, height, pixels);
    }

    std::string
    colour_bar(const Frame &f)
    {
      std::vector<Colour> pixels;
      for (unsigned int i = 256; i-- > 0;)
        pixels.push_back(viridis(i / 255.));
      return image(f, encode_png(1, 256, pixels)) + border(f);
    }

    /** Line of the profile in the map, clipped by the frame. */
    std::string
    profile_line(const Frame &f, const TopographyReport &report)
    {
      const ProfileLine &line  = report.line;
      const double       reach = report.map.length_x() + report.map.length_y();
      const double       tx = std::cos(line.angle), ty = std::sin(line.angle);
      const std::string  clip =
        "<clipPath id=\"map\">" +
        format("<rect x=\"%.1f\" y=\"%.1f\" ", f.x, f.y) +
        format("width=\"%.1f\" height=\"%.1f\"/>", f.width, f.height) +
        "</clipPath>\n";
      return clip + segment(f.px(line.x - reach * tx),
                            f.py(line.y - reach * ty),
                            f.px(line.x + reach * tx),
                            f.py(line.y + reach * ty),
                            "stroke=\"#d62728\" stroke-width=\"1.5\" "
                            "clip-path=\"url(#map)\"");
    }

    std::string
    curve(const Frame &f, const Profile &profile, const std::string &attributes)
    {
      std::string points;
      for (std::size_t i = 0; i < profile.heights.size(); ++i)
        points += format("%.2f,%.2f ",
                         f.px(i * profile.spacing),
                         f.py(profile.heights[i]));
      return "<polyline fill=\"none\" " + attributes + " points=\"" + points +
             "\"/>\n";
    }

    std::string
    map_panel(const TopographyReport &report)
    {
      const HeightMap &map   = report.map;
      const auto [low, high] = colour_limits(map, 0.001);
      const double ratio     = map.length_y() / map.length_x();
      const double max_width = 440., max_height = 300.;
      const double width = std::min(max_width, max_height / ratio);
      Frame        f     = {80,
                            60,
                            width,
                            std::max(8., width * ratio),
                            0.,
                            map.length_x(),
                            0.,
                            map.length_y()};
      const bool   nano  = high - low < 1e-7;
      const Frame  bar   = {f.x + f.width + 70,
                            f.y,
                            14,
                            std::max(60., f.height),
                            0.,
                            1.,
                            low,
                            high};
      std::string  page  = image(f, map_png(map, low, high)) + border(f);
      page += axis(f, false, 1e-6, "x [um]");
      if (map.ny > 1)
        page += axis(f, true, 1e-6, "y [um]");
      page += profile_line(f, report);
      page += colour_bar(bar);
      page += axis(bar, true, nano ? 1e-9 : 1e-6, nano ? "z [nm]" : "z [um]");
      return page;
    }

    std::string
    number_panel(const TopographyReport &report)
    {
      const auto  &a     = report.areal;
      const auto  &r     = report.measured_roughness;
      const auto  &p     = report.profile_roughness;
      const double x     = 690.;
      double       y     = 72.;
      std::string  page  = "<g font-family=\"monospace\">\n";
      const auto   print = [&](const std::string &text) {
        page += label(x, y, text, "xml:space=\"preserve\"");
        y += 17.;
      };
      const auto row = [&](const std::string &name,
                           const double       first,
                           const double       second,
                           const bool         is_length) {
        const auto text = [&](const double value) {
          return std::isnan(value) ?
                   std::string("-") :
                   format("%.4g", is_length ? value * 1e6 : value);
        };
        std::string line = name + std::string(12 - name.size(), ' ');
        line += text(first);
        if (!std::isnan(second))
          line +=
            std::string(std::max<int>(1, 24 - line.size()), ' ') + text(second);
        print(line);
      };
      const double none = missing_height;
      if (report.map.ny > 1)
        {
          print("ISO 25178-2");
          row("Sa [um]", a.Sa, none, true);
          row("Sq [um]", a.Sq, none, true);
          row("Sz [um]", a.Sz, none, true);
          row("Ssk", a.Ssk, none, false);
          row("Sku", a.Sku, none, false);
          row("Sdq", a.Sdq, none, false);
          row("Sdr", a.Sdr, none, false);
          row("Sal [um]", report.texture.Sal, none, true);
          row("Str", report.texture.Str, none, false);
          y += 10.;
        }
      print("ISO 4287    measured    finished");
      row("Ra [um]", r.Ra, p.Ra, true);
      row("Rq [um]", r.Rq, p.Rq, true);
      row("Rz [um]", r.Rz, p.Rz, true);
      row("Rt [um]", r.Rt, p.Rt, true);
      row("Rsk", r.Rsk, p.Rsk, false);
      row("Rku", r.Rku, p.Rku, false);
      row("Rdq", r.Rdq, p.Rdq, false);
      return page + "</g>\n";
    }

    /** Heights about their mean. */
    Profile
    centred(Profile profile)
    {
      double mean = 0.;
      for (const double z : profile.heights)
        mean += z / profile.heights.size();
      for (double &z : profile.heights)
        z -= mean;
      return profile;
    }

    /** The finished profile without its scaling, repeated up to @p length. */
    Profile
    unscaled(const TopographyReport &report, const double length)
    {
      Profile profile = report.profile;
      profile.spacing /= report.scale_x;
      for (double &z : profile.heights)
        z /= report.scale_z;
      const std::size_t n = profile.heights.size();
      for (std::size_t i = n; i * profile.spacing <= length; ++i)
        profile.heights.push_back(profile.heights[i - n]);
      return profile;
    }

    /** Both profiles, and a quarter of the next period, to show the seam. */
    std::string
    profile_panel(const TopographyReport &report)
    {
      const double  period = report.profile.length() / report.scale_x;
      const double  length = std::max(report.measured.length(), 1.25 * period);
      const Profile measured = centred(report.measured);
      const Profile finished = centred(unscaled(report, length));
      double        low = 0., high = 0.;
      for (const auto *profile : {&measured, &finished})
        for (const double z : profile->heights)
          {
            low  = std::min(low, z);
            high = std::max(high, z);
          }
      const double margin = 0.05 * std::max(high - low, 1e-12);
      const bool   nano   = high - low < 1e-7;
      const Frame  f      = {
              80, 440, 860, 190, 0., length, low - margin, high + margin};

      std::string page = border(f);
      page += segment(f.px(period),
                      f.y,
                      f.px(period),
                      f.y + f.height,
                      "stroke=\"#888\" stroke-dasharray=\"4 3\"");
      page += curve(f, measured, "stroke=\"#999\" stroke-width=\"2.5\"");
      page += curve(f, finished, "stroke=\"#1f77b4\" stroke-width=\"1.2\"");
      page += axis(f, false, 1e-6, "along the profile [um]");
      page += axis(f, true, nano ? 1e-9 : 1e-6, nano ? "z [nm]" : "z [um]");
      page += label(f.x,
                    f.y - 8,
                    "grey: measured; blue: periodic, before scaling (each "
                    "about its mean); dashed: end of the period, " +
                      format_quantity(period, "um", 5));
      return page;
    }
  } // namespace

  std::string
  report_svg(const TopographyReport &report)
  {
    std::string page =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"980\" "
      "height=\"690\" viewBox=\"0 0 980 690\" font-family=\"sans-serif\" "
      "font-size=\"12\">\n<rect width=\"980\" height=\"690\" "
      "fill=\"white\"/>\n";
    const auto slash = report.sanity.file.find_last_of('/');
    page += label(80,
                  34,
                  report.sanity.file.substr(
                    slash == std::string::npos ? 0 : slash + 1) +
                    " (" + report.sanity.format + ")",
                  "font-size=\"16\"");
    page += map_panel(report);
    page += number_panel(report);
    page += profile_panel(report);
    return page + "</svg>\n";
  }
} // namespace asperity
