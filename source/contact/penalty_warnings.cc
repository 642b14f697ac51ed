#include <asperity/base/quantity.h>
#include <asperity/contact/penalty_warnings.h>

#include <limits>

namespace asperity
{
  namespace
  {
    /** Of a contact of n elements on its half-width a penalty c E/h gives way
     *  by 1/(2 c n) of what the elastic body does, p h/(c E) against 2 p a/E.
     *  Measured by tools/stability, C8: with n = 4 the pressure of Hertz is 11
     *  to 14 % off at c = 1, as 1/8 says. */
    constexpr double smallest_factor = 2.;
  } // namespace



  std::string
  rounding_warning(const double penalty,
                   const double position,
                   const double pressure,
                   const double tolerance)
  {
    const double rounding = std::numeric_limits<double>::epsilon() * position;
    if (penalty * rounding <= tolerance * pressure)
      return "";
    return "With a penalty of " + format_quantity(penalty, "Pa/m", 3) +
           " the rounding of positions (" + format_quantity(rounding, "m", 2) +
           ") is a pressure of " +
           format_quantity(penalty * rounding, "Pa", 2) +
           ", where the tolerance of Newton's method tells " +
           format_quantity(tolerance * pressure, "Pa", 2) +
           " from none: contacts come and go by chance; lower Contact/Penalty "
           "factor by " +
           format_quantity(penalty * rounding / (tolerance * pressure),
                           "1",
                           2) +
           " times, and take augmentations instead.";
  }



  std::string
  soft_penalty_warning(const double factor)
  {
    if (factor >= smallest_factor)
      return "";
    return "With a penalty factor of " + format_quantity(factor, "1", 2) +
           " small contacts are too soft: of one whose half-width is four "
           "elements the pressure is " +
           format_quantity(100. / (8. * factor), "1", 2) +
           " % off; expected is a Contact/Penalty factor of 8, or "
           "Contact/Augmentations.";
  }
} // namespace asperity
