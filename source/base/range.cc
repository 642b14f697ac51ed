#include <asperity/base/parameters.h>

#include <cmath>

namespace asperity
{
  Range
  Range::any()
  {
    return {};
  }

  Range
  Range::positive()
  {
    return above(0.);
  }

  Range
  Range::non_negative()
  {
    return at_least(0.);
  }

  Range
  Range::at_least(const double minimum)
  {
    Range range;
    range.minimum = minimum;
    return range;
  }

  Range
  Range::above(const double minimum)
  {
    Range range           = at_least(minimum);
    range.minimum_allowed = false;
    return range;
  }

  Range
  Range::between(const double minimum, const double maximum)
  {
    Range range   = at_least(minimum);
    range.maximum = maximum;
    return range;
  }

  bool
  Range::contains(const double value) const
  {
    return (minimum_allowed ? value >= minimum : value > minimum) &&
           (maximum_allowed ? value <= maximum : value < maximum);
  }

  std::string
  Range::description(const std::string &unit) const
  {
    const auto print = [&unit](const double value) {
      return format_quantity(value, unit, 6);
    };
    const std::string from =
      (minimum_allowed ? "at least " : "more than ") + print(minimum);
    const std::string to =
      (maximum_allowed ? "at most " : "less than ") + print(maximum);
    if (std::isinf(minimum) && std::isinf(maximum))
      return "any";
    if (std::isinf(maximum))
      return from;
    if (std::isinf(minimum))
      return to;
    if (minimum_allowed && maximum_allowed)
      return print(minimum) + " to " + print(maximum);
    return from + " and " + to;
  }
} // namespace asperity
