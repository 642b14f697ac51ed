#ifndef asperity_base_quantity_h
#define asperity_base_quantity_h

#include <string>
#include <vector>

namespace asperity
{
  /** What a number measures. Everything is stored in SI units. */
  enum class Dimension
  {
    none,                 // 1, %
    length,               // m
    area,                 // m2
    time,                 // s
    rate,                 // 1/s
    velocity,             // m/s
    acceleration,         // m/s2
    angle,                // rad
    stress,               // Pa, also pressures and moduli
    inverse_stress,       // 1/Pa
    stress_per_length,    // Pa/m, contact penalties
    impedance,            // Pa s/m, stress over velocity
    line_load,            // N/m, a force per thickness of a plane model
    density,              // kg/m3
    viscosity,            // Pa s
    temperature,          // K, absolute
    expansion,            // 1/K
    specific_heat,        // J/(kg K)
    thermal_conductivity, // W/(m K)
    heat_transfer         // W/(m2 K)
  };

  /** "stress", "specific heat", ..., as error messages call it. */
  std::string
  to_string(const Dimension dimension);

  /** The units accepted for a dimension, the SI unit first. */
  std::vector<std::string>
  accepted_units(const Dimension dimension);

  /**
   * The dimension of a unit ("MPa" -> stress, "1" -> none). Each unit belongs
   * to one dimension.
   *
   * @throws InputError with a half sentence if the unit is unknown
   */
  Dimension
  dimension_of(const std::string &unit);

  /** Converts a value in the given unit to SI (675 degC -> 948.15 K).
   *  @throws InputError as dimension_of() */
  double
  to_si(const double value, const std::string &unit);

  /** Converts an SI value to the given unit.
   *  @throws InputError as dimension_of() */
  double
  from_si(const double value, const std::string &unit);

  /**
   * Reads a number with a unit ("1.3 GPa", "22.5 m/min", "0.25us") and returns
   * its SI value. Only a quantity of dimension `none` may stand without a unit.
   * Decimals follow a point, and zero has no sign.
   *
   * @throws InputError with a half sentence (no file, no entry: the caller
   * knows them) that says what was found and lists the units accepted
   */
  double
  parse_quantity(const std::string &text, const Dimension dimension);

  /**
   * Writes an SI value in a unit with the fewest digits that parse_quantity()
   * reads back as the same double (up to 17): 3e8, "MPa" -> "300 MPa".
   *
   * @throws InputError as dimension_of()
   */
  std::string
  format_quantity(const double value, const std::string &unit);

  /** The same with a fixed number of significant digits, for people to read.
   *  @throws InputError as dimension_of() */
  std::string
  format_quantity(const double       value,
                  const std::string &unit,
                  const unsigned int digits);

  /** 0.0123 as "1.2 %". */
  std::string
  per_cent(const double share);

  /**
   * Reads a plain number; independent of the locale.
   *
   * @throws InputError with a half sentence if the text is anything else or not
   *   finite
   */
  double
  parse_number(const std::string &text);

  /** The fewest digits that parse_number() reads back as the same double. */
  std::string
  format_number(const double value);
} // namespace asperity

#endif
