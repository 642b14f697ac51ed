#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace asperity
{
  namespace
  {
    /**
     * si = value * numerator / denominator + offset. Two exact factors instead
     * of one, so that "10 um" is the double next to 1e-5 and not its neighbour.
     */
    struct Unit
    {
      const char *name;
      Dimension   dimension;
      double      numerator;
      double      denominator;
      double      offset;

      double
      to_si(const double value) const
      {
        return value * numerator / denominator + offset;
      }

      double
      from_si(const double value) const
      {
        return (value - offset) * denominator / numerator;
      }
    };

    using D                 = Dimension;
    constexpr double pi     = 3.14159265358979323846;
    constexpr double zero_C = 273.15;

    /** The SI unit of each dimension first. */
    constexpr Unit units[] = {
      {"1", D::none, 1, 1, 0},
      {"%", D::none, 1, 100, 0},
      {"m", D::length, 1, 1, 0},
      {"cm", D::length, 1, 1e2, 0},
      {"mm", D::length, 1, 1e3, 0},
      {"um", D::length, 1, 1e6, 0},
      {"nm", D::length, 1, 1e9, 0},
      {"m2", D::area, 1, 1, 0},
      {"mm2", D::area, 1, 1e6, 0},
      {"um2", D::area, 1, 1e12, 0},
      {"s", D::time, 1, 1, 0},
      {"ms", D::time, 1, 1e3, 0},
      {"us", D::time, 1, 1e6, 0},
      {"ns", D::time, 1, 1e9, 0},
      {"min", D::time, 60, 1, 0},
      {"h", D::time, 3600, 1, 0},
      {"1/s", D::rate, 1, 1, 0},
      {"1/ms", D::rate, 1e3, 1, 0},
      {"1/us", D::rate, 1e6, 1, 0},
      {"1/min", D::rate, 1, 60, 0},
      {"Hz", D::rate, 1, 1, 0},
      {"m/s", D::velocity, 1, 1, 0},
      {"m/min", D::velocity, 1, 60, 0},
      {"km/h", D::velocity, 10, 36, 0},
      {"mm/s", D::velocity, 1, 1e3, 0},
      {"mm/min", D::velocity, 1, 6e4, 0},
      {"um/us", D::velocity, 1, 1, 0},
      {"m/s2", D::acceleration, 1, 1, 0},
      {"rad", D::angle, 1, 1, 0},
      {"deg", D::angle, pi, 180, 0},
      {"Pa", D::stress, 1, 1, 0},
      {"kPa", D::stress, 1e3, 1, 0},
      {"MPa", D::stress, 1e6, 1, 0},
      {"GPa", D::stress, 1e9, 1, 0},
      {"bar", D::stress, 1e5, 1, 0},
      {"N/m2", D::stress, 1, 1, 0},
      {"N/mm2", D::stress, 1e6, 1, 0},
      {"1/Pa", D::inverse_stress, 1, 1, 0},
      {"1/MPa", D::inverse_stress, 1, 1e6, 0},
      {"1/GPa", D::inverse_stress, 1, 1e9, 0},
      {"Pa/m", D::stress_per_length, 1, 1, 0},
      {"MPa/um", D::stress_per_length, 1e12, 1, 0},
      {"GPa/um", D::stress_per_length, 1e15, 1, 0},
      {"N/m3", D::stress_per_length, 1, 1, 0},
      {"N/mm3", D::stress_per_length, 1e9, 1, 0},
      {"Pa s/m", D::impedance, 1, 1, 0},
      {"MPa s/m", D::impedance, 1e6, 1, 0},
      {"N/m", D::line_load, 1, 1, 0},
      {"kN/m", D::line_load, 1e3, 1, 0},
      {"N/mm", D::line_load, 1e3, 1, 0},
      {"kg/m3", D::density, 1, 1, 0},
      {"g/cm3", D::density, 1e3, 1, 0},
      {"t/mm3", D::density, 1e12, 1, 0},
      {"Pa s", D::viscosity, 1, 1, 0},
      {"mPa s", D::viscosity, 1, 1e3, 0},
      {"cP", D::viscosity, 1, 1e3, 0},
      {"K", D::temperature, 1, 1, 0},
      {"degC", D::temperature, 1, 1, zero_C},
      {"degF", D::temperature, 5, 9, zero_C - 160. / 9.},
      {"1/K", D::expansion, 1, 1, 0},
      {"um/(m K)", D::expansion, 1, 1e6, 0},
      {"J/(kg K)", D::specific_heat, 1, 1, 0},
      {"kJ/(kg K)", D::specific_heat, 1e3, 1, 0},
      {"J/(g K)", D::specific_heat, 1e3, 1, 0},
      {"W/(m K)", D::thermal_conductivity, 1, 1, 0},
      {"W/(m2 K)", D::heat_transfer, 1, 1, 0},
    };

    void
    replace_all(std::string       &text,
                const std::string &old_part,
                const std::string &new_part)
    {
      for (auto at = text.find(old_part); at != std::string::npos;
           at      = text.find(old_part, at + new_part.size()))
        text.replace(at, old_part.size(), new_part);
    }

    /** One spelling for "°C", "µm", "m/s^2", "J/(kg*K)", "J/kg/K", "Pa*s". */
    std::string
    plain_spelling(std::string unit)
    {
      replace_all(unit, "\u00b5", "u"); // micro sign
      replace_all(unit, "\u03bc", "u"); // Greek mu
      replace_all(unit, "\u00b0", "deg");
      replace_all(unit, "\u00ba", "deg"); // ordinal, taken for the degree sign
      replace_all(unit, "\u2103", "degC");
      replace_all(unit, "\u2109", "degF");
      replace_all(unit, "\u00b2", "2");
      replace_all(unit, "\u00b3", "3");
      replace_all(unit, "^", "");
      replace_all(unit, "*", " ");
      replace_all(unit, "\u00b7", " "); // middle dot
      replace_all(unit, "\u22c5", " "); // dot operator
      // What is left of the upper half are the bytes of Latin-1.
      replace_all(unit, "\xb5", "u");
      replace_all(unit, "\xb0", "deg");
      replace_all(unit, "\xb2", "2");
      replace_all(unit, "\xb3", "3");
      for (const std::string quotient : {"J/kg/K", "W/m/K", "W/m2/K"})
        if (unit == quotient)
          unit =
            quotient.substr(0, quotient.size() - 2).replace(1, 1, "/(") + " K)";
      return unit;
    }

    const Unit *
    find_unit(const std::string &name)
    {
      const std::string plain = plain_spelling(name);
      for (const Unit &unit : units)
        if (plain == unit.name)
          return &unit;
      return nullptr;
    }

    const Unit &
    known_unit(const std::string &name)
    {
      if (const Unit *unit = find_unit(name))
        return *unit;
      throw InputError(quoted_name(name) + " is not a known unit");
    }

    std::string
    expectation(const Dimension dimension)
    {
      if (dimension == Dimension::none)
        return "a plain number is expected";
      return "a " + to_string(dimension) +
             " is expected, in one of the units " +
             join(accepted_units(dimension), ", ");
    }

    /** The blanks and the minus sign of typeset text in their plain form. */
    std::string
    plain_number(std::string text)
    {
      for (const char *const blank : {"\u00a0", "\u2007", "\u2009", "\u202f"})
        replace_all(text, blank, " ");
      replace_all(text, "\u2212", "-");
      return trim(text);
    }

    /** How many characters of the text are a number; 0 if it has none. Zero has
     *  no sign. */
    std::size_t
    read_number(const std::string &text, double &value)
    {
      // from_chars() does not depend on the locale, but knows no plus sign
      const std::size_t begin = (!text.empty() && text[0] == '+') ? 1 : 0;
      const auto        result =
        std::from_chars(text.data() + begin, text.data() + text.size(), value);
      if (result.ec == std::errc::result_out_of_range)
        throw InputError(quoted_text(text) +
                         " holds a number that the program cannot; one "
                         "between 2.3e-308 and 1.7e308 in size is expected");
      if (result.ec != std::errc() || !std::isfinite(value))
        return 0;
      if (value == 0.)
        value = 0.;
      return result.ptr - text.data();
    }

    /** What follows a number: the digits after a decimal comma? */
    bool
    begins_with_decimal_comma(const std::string &text)
    {
      return text.size() > 1 && text[0] == ',' && text[1] >= '0' &&
             text[1] <= '9';
    }
  } // namespace

  std::string
  to_string(const Dimension dimension)
  {
    switch (dimension)
      {
        case Dimension::none:
          return "number";
        case Dimension::length:
          return "length";
        case Dimension::area:
          return "surface area";
        case Dimension::time:
          return "time";
        case Dimension::rate:
          return "rate";
        case Dimension::velocity:
          return "velocity";
        case Dimension::acceleration:
          return "linear acceleration";
        case Dimension::angle:
          return "plane angle";
        case Dimension::stress:
          return "stress";
        case Dimension::inverse_stress:
          return "reciprocal stress";
        case Dimension::stress_per_length:
          return "stress per length";
        case Dimension::impedance:
          return "impedance";
        case Dimension::line_load:
          return "line load";
        case Dimension::density:
          return "density";
        case Dimension::viscosity:
          return "viscosity";
        case Dimension::temperature:
          return "temperature";
        case Dimension::expansion:
          return "thermal expansion coefficient";
        case Dimension::specific_heat:
          return "specific heat";
        case Dimension::thermal_conductivity:
          return "thermal conductivity";
        case Dimension::heat_transfer:
          return "heat transfer coefficient";
      }
    return "";
  }

  std::vector<std::string>
  accepted_units(const Dimension dimension)
  {
    std::vector<std::string> names;
    for (const Unit &unit : units)
      if (unit.dimension == dimension)
        names.push_back(unit.name);
    return names;
  }

  Dimension
  dimension_of(const std::string &unit)
  {
    return known_unit(unit).dimension;
  }

  double
  to_si(const double value, const std::string &unit)
  {
    return known_unit(unit).to_si(value);
  }

  double
  from_si(const double value, const std::string &unit)
  {
    return known_unit(unit).from_si(value);
  }

  double
  parse_quantity(const std::string &text, const Dimension dimension)
  {
    const std::string trimmed   = plain_number(text);
    double            value     = 0;
    const std::size_t n         = read_number(trimmed, value);
    const std::string unit_name = trim(trimmed.substr(n));
    if (n == 0)
      throw InputError(quoted_text(trimmed) +
                       " does not start with a number; " +
                       expectation(dimension));
    if (unit_name.empty())
      {
        if (dimension == Dimension::none)
          return value;
        throw InputError(quoted_text(trimmed) + " has no unit; " +
                         expectation(dimension));
      }
    const Unit *unit = find_unit(unit_name);
    if (begins_with_decimal_comma(unit_name))
      throw InputError(quoted_text(trimmed) +
                       " has a decimal comma; a decimal point is expected");
    if (unit == nullptr)
      throw InputError(quoted_text(trimmed) + " has the unknown unit " +
                       quoted_text(unit_name) + "; " + expectation(dimension));
    if (unit->dimension != dimension)
      throw InputError(quoted_text(trimmed) + " is a " +
                       to_string(unit->dimension) + "; " +
                       expectation(dimension));
    const double si = unit->to_si(value);
    if (!std::isfinite(si))
      throw InputError(quoted_text(trimmed) + " is too large");
    return si;
  }

  std::string
  format_quantity(const double value, const std::string &unit_name)
  {
    const Unit  &unit   = known_unit(unit_name);
    const double scaled = unit.from_si(value);
    // the offset of temperatures costs digits: look for the shortest text
    for (int digits = 6; digits <= 17; ++digits)
      {
        const std::string text = format_quantity(value, unit_name, digits);
        if (parse_quantity(text, unit.dimension) == value)
          return text;
      }
    const std::string text = format_number(scaled);
    return unit.name == std::string("1") ? text : text + " " + unit.name;
  }

  std::string
  format_quantity(const double       value,
                  const std::string &unit_name,
                  const unsigned int digits)
  {
    const Unit       &unit   = known_unit(unit_name);
    const double      scaled = unit.from_si(value);
    char              buffer[64];
    const auto        result = std::to_chars(buffer,
                                      buffer + sizeof(buffer),
                                      scaled == 0. ? 0. : scaled,
                                      std::chars_format::general,
                                      static_cast<int>(digits));
    const std::string number(buffer, result.ptr);
    return unit.name == std::string("1") ? number : number + " " + unit.name;
  }

  std::string
  per_cent(const double share)
  {
    return format_quantity(100. * share, "1", 2) + " %";
  }

  double
  parse_number(const std::string &text)
  {
    const std::string trimmed = plain_number(text);
    double            value   = 0;
    const std::size_t n       = read_number(trimmed, value);
    if (n != 0 && begins_with_decimal_comma(trimmed.substr(n)))
      throw InputError(quoted_text(trimmed) +
                       " has a decimal comma; a decimal point is expected");
    if (n == 0 || n != trimmed.size())
      throw InputError(quoted_text(trimmed) + " is not a plain number");
    return value;
  }

  std::string
  format_number(const double value)
  {
    char       buffer[64];
    const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
    return std::string(buffer, result.ptr);
  }
} // namespace asperity
