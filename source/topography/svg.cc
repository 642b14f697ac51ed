#include <asperity/topography/png_image.h>
#include <asperity/topography/svg.h>

#include <cmath>
#include <cstdio>

namespace asperity
{
  namespace svg
  {
    namespace
    {
      /** Round step that divides the range into about @p n parts. */
      double
      tick_step(const double range, const unsigned int n)
      {
        const double rough = range / n;
        const double power = std::pow(10., std::floor(std::log10(rough)));
        for (const double factor : {1., 2., 5.})
          if (factor * power >= rough)
            return factor * power;
        return 10. * power;
      }

    } // namespace

    std::string
    format(const char *pattern, const double a, const double b)
    {
      char text[64];
      std::snprintf(text, sizeof(text), pattern, a, b);
      return text;
    }

    std::string
    escape(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        if (c == '&')
          result += "&amp;";
        else if (c == '<')
          result += "&lt;";
        else if (c == '>')
          result += "&gt;";
        else if (static_cast<unsigned char>(c) < 32 ||
                 static_cast<unsigned char>(c) > 126)
          result += '?';
        else
          result += c;
      return result;
    }

    std::string
    label(const double       x,
          const double       y,
          const std::string &text,
          const std::string &attributes)
    {
      return format("<text x=\"%.1f\" y=\"%.1f\" ", x, y) + attributes + ">" +
             escape(text) + "</text>\n";
    }

    std::string
    segment(const double       x0,
            const double       y0,
            const double       x1,
            const double       y1,
            const std::string &attributes)
    {
      return format("<line x1=\"%.2f\" y1=\"%.2f\" ", x0, y0) +
             format("x2=\"%.2f\" y2=\"%.2f\" ", x1, y1) + attributes + "/>\n";
    }

    std::string
    border(const Frame &f)
    {
      return format("<rect x=\"%.1f\" y=\"%.1f\" ", f.x, f.y) +
             format("width=\"%.1f\" height=\"%.1f\" ", f.width, f.height) +
             "fill=\"none\" stroke=\"#444\"/>\n";
    }

    std::string
    axis(const Frame       &f,
         const bool         vertical,
         const double       unit,
         const std::string &name)
    {
      const double low  = (vertical ? f.y_min : f.x_min) / unit;
      const double high = (vertical ? f.y_max : f.x_max) / unit;
      const double step = tick_step(high - low, vertical ? 5 : 8);
      std::string  svg;
      for (double t = std::ceil(low / step - 1e-9) * step;
           t <= high + 1e-9 * step;
           t += step)
        {
          const auto text = format("%.6g", std::abs(t) < 1e-9 * step ? 0. : t);
          if (vertical)
            {
              const double y = f.py(t * unit);
              svg += segment(f.x - 4, y, f.x, y, "stroke=\"#444\"");
              svg += label(f.x - 7, y + 4, text, "text-anchor=\"end\"");
            }
          else
            {
              const double x = f.px(t * unit);
              const double y = f.y + f.height;
              svg += segment(x, y, x, y + 4, "stroke=\"#444\"");
              svg += label(x, y + 17, text, "text-anchor=\"middle\"");
            }
        }
      if (vertical)
        {
          const double x = f.x - 52, y = f.y + 0.5 * f.height;
          svg += label(x,
                       y,
                       name,
                       "text-anchor=\"middle\" transform=\"rotate(-90 " +
                         format("%.1f %.1f", x, y) + ")\"");
        }
      else
        svg += label(f.x + 0.5 * f.width,
                     f.y + f.height + 34,
                     name,
                     "text-anchor=\"middle\"");
      return svg;
    }

    std::string
    image(const Frame &f, const std::string &png)
    {
      return format("<image x=\"%.1f\" y=\"%.1f\" ", f.x, f.y) +
             format("width=\"%.1f\" height=\"%.1f\" ", f.width, f.height) +
             "preserveAspectRatio=\"none\" image-rendering=\"pixelated\" "
             "xlink:href=\"data:image/png;base64," +
             base64(png) + "\"/>\n";
    }
  } // namespace svg
} // namespace asperity
