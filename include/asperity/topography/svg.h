#ifndef asperity_topography_svg_h
#define asperity_topography_svg_h

#include <string>

namespace asperity
{
  /** The few elements of SVG that pictures of surfaces need. */
  namespace svg
  {
    /** A frame on the page [px] and the values that its edges stand for. */
    struct Frame
    {
      double x, y, width, height;
      double x_min, x_max, y_min, y_max; // y_min is the lower edge

      double
      px(const double value) const
      {
        return x + width * (value - x_min) / (x_max - x_min);
      }

      double
      py(const double value) const
      {
        return y + height * (y_max - value) / (y_max - y_min);
      }
    };

    /** printf with two numbers. */
    std::string
    format(const char *pattern, const double a, const double b = 0.);

    /** Text with XML's special characters replaced, others than ASCII by ?. */
    std::string
    escape(const std::string &text);

    std::string
    label(const double       x,
          const double       y,
          const std::string &text,
          const std::string &attributes = "");

    std::string
    segment(const double       x0,
            const double       y0,
            const double       x1,
            const double       y1,
            const std::string &attributes);

    std::string
    border(const Frame &frame);

    /** Ticks, their values over @p unit, and a name, below or left of it. */
    std::string
    axis(const Frame       &frame,
         const bool         vertical,
         const double       unit,
         const std::string &name);

    /** The bytes of a PNG file, stretched over the frame. */
    std::string
    image(const Frame &frame, const std::string &png);
  } // namespace svg
} // namespace asperity

#endif
