#include <asperity/topography/length_unit.h>
#include <asperity/topography/text_header.h>

#include <algorithm>
#include <map>

namespace asperity
{
  namespace
  {
    /** "x-length = 1.6 um" as "x-length" and "1.6 um". */
    std::pair<std::string, std::string>
    split_entry(const std::string &line)
    {
      const auto sign = line.find_first_of("=:");
      if (sign == std::string::npos)
        return {};
      std::string key = strip(line.substr(0, sign));
      std::transform(key.begin(), key.end(), key.begin(), [](const char c) {
        return c >= 'A' && c <= 'Z' ? char(c + 'a' - 'A') : c;
      });
      return {key, strip(line.substr(sign + 1))};
    }

    /** A number and what follows it; empty if there is none. */
    std::optional<std::pair<double, std::string>>
    split_number(const std::string &text)
    {
      const auto  end    = text.find_first_not_of("+-0123456789.,eE");
      std::string number = text.substr(0, end);
      std::replace(number.begin(), number.end(), ',', '.');
      double value = 0.;
      if (!parse_decimal(number, value) || !(value > 0.))
        return {};
      return {{value, end == std::string::npos ? "" : strip(text.substr(end))}};
    }

    class HeaderReader
    {
    public:
      explicit HeaderReader(const std::vector<std::string> &lines)
        : lines(lines)
      {
        for (const std::string &line : lines)
          {
            const auto [key, value] = split_entry(line);
            if (key == "file format" && value == "ASCII")
              is_spip = true;
            else if (key == "x-unit" || key == "y-unit")
              lateral_unit[key[0]] = value;
          }
      }

      TextHeader
      run()
      {
        for (const std::string &line : lines)
          {
            const auto [key, value] = split_entry(line);
            if (key == "width" || key == "breite" || key == "x-length")
              read_length(line, value, 'x', header.length_x);
            else if (key == "height" || key == "h\xc3\xb6he" ||
                     key == "y-length")
              read_length(line, value, 'y', header.length_y);
            else if (key == "value units" || key == "einheiten" ||
                     key == "z-unit")
              read_height_unit(line, value);
            else if (key == "x-pixels")
              read_count(line, value, header.nx);
            else if (key == "y-pixels")
              read_count(line, value, header.ny);
          }
        return header;
      }

    private:
      void
      read_length(const std::string     &line,
                  const std::string     &text,
                  const char             axis,
                  std::optional<double> &length)
      {
        const auto parts = split_number(text);
        if (!parts)
          return;
        std::string unit = parts->second;
        if (unit.empty() && lateral_unit.count(axis) != 0)
          unit = lateral_unit[axis];
        if (unit.empty() && is_spip)
          unit = "nm";
        if (metres_per(unit) == 0.)
          header.not_understood.push_back(line);
        else
          {
            length = parts->first * metres_per(unit);
            header.lines.push_back(line);
          }
      }

      void
      read_height_unit(const std::string &line, const std::string &unit)
      {
        if (metres_per(unit) == 0.)
          header.not_understood.push_back(line);
        else
          {
            header.height_unit = metres_per(unit);
            header.lines.push_back(line);
          }
      }

      void
      read_count(const std::string           &line,
                 const std::string           &text,
                 std::optional<std::int64_t> &count)
      {
        double value = 0.;
        if (!parse_decimal(text, value) || !(value >= 1. && value < 1e9))
          return;
        count = static_cast<std::int64_t>(value);
        header.lines.push_back(line);
      }

      const std::vector<std::string> &lines;
      TextHeader                      header;

      /** Of SPIP, which leaves out the nanometres. */
      bool                        is_spip = false;
      std::map<char, std::string> lateral_unit;
    };
  } // namespace

  TextHeader
  read_text_header(const std::vector<std::string> &lines)
  {
    return HeaderReader(lines).run();
  }
} // namespace asperity
