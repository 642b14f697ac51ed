#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace asperity;

namespace
{
  std::string
  message_of(const std::string &text, const Dimension dimension)
  {
    try
      {
        parse_quantity(text, dimension);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "no error";
  }
} // namespace

TEST(Quantity, units_of_the_field_become_si)
{
  EXPECT_DOUBLE_EQ(parse_quantity("1.3 GPa", Dimension::stress), 1.3e9);
  EXPECT_DOUBLE_EQ(parse_quantity("210000 N/mm2", Dimension::stress), 2.1e11);
  EXPECT_DOUBLE_EQ(parse_quantity("22.5 m/min", Dimension::velocity), 0.375);
  EXPECT_DOUBLE_EQ(parse_quantity("0.25us", Dimension::time), 2.5e-7);
  EXPECT_DOUBLE_EQ(parse_quantity("675 degC", Dimension::temperature), 948.15);
  EXPECT_DOUBLE_EQ(parse_quantity("32 degF", Dimension::temperature), 273.15);
  EXPECT_DOUBLE_EQ(parse_quantity("7.85 g/cm3", Dimension::density), 7850.);
  EXPECT_DOUBLE_EQ(parse_quantity("180 deg", Dimension::angle), std::acos(-1.));
  EXPECT_DOUBLE_EQ(parse_quantity("475 J/(kg K)", Dimension::specific_heat),
                   475.);
  EXPECT_DOUBLE_EQ(parse_quantity("2e18 N/m3", Dimension::stress_per_length),
                   2e18);
  EXPECT_DOUBLE_EQ(parse_quantity("5 %", Dimension::none), 0.05);
  EXPECT_DOUBLE_EQ(parse_quantity("+0.3", Dimension::none), 0.3);
}

TEST(Quantity, small_units_round_correctly)
{
  // a factor 1e-6 would be off by one unit in the last place
  EXPECT_EQ(parse_quantity("10 um", Dimension::length), 1e-5);
  EXPECT_EQ(parse_quantity("3 nm", Dimension::length), 3e-9);
  EXPECT_EQ(parse_quantity("250 ns", Dimension::time), 2.5e-7);
}

TEST(Quantity, other_spellings_of_a_unit_are_understood)
{
  EXPECT_EQ(parse_quantity("10 \u00b5m", Dimension::length), 1e-5);
  EXPECT_EQ(parse_quantity("10 \u03bcm", Dimension::length), 1e-5);
  EXPECT_EQ(parse_quantity("25 \u00b0C", Dimension::temperature), 298.15);
  EXPECT_EQ(parse_quantity("1 kg/m^3", Dimension::density), 1.);
  EXPECT_EQ(parse_quantity("1 J/kg/K", Dimension::specific_heat), 1.);
  EXPECT_EQ(parse_quantity("1 J/(kg*K)", Dimension::specific_heat), 1.);
  EXPECT_EQ(parse_quantity("1 Pa*s", Dimension::viscosity), 1.);
  // the degree sign of its own, Latin-1, and blanks and signs of typeset text
  EXPECT_EQ(parse_quantity("25 \u2103", Dimension::temperature), 298.15);
  EXPECT_EQ(parse_quantity("25 \xb0"
                           "C",
                           Dimension::temperature),
            298.15);
  EXPECT_EQ(parse_quantity("10 \xb5m", Dimension::length), 1e-5);
  EXPECT_EQ(parse_quantity("300\u00a0MPa", Dimension::stress), 3e8);
  EXPECT_EQ(parse_quantity("\u22123\u202fMPa", Dimension::stress), -3e6);
}

TEST(Quantity, every_unit_converts_there_and_back)
{
  for (int d = 0; d <= static_cast<int>(Dimension::heat_transfer); ++d)
    {
      const auto dimension = static_cast<Dimension>(d);
      ASSERT_FALSE(accepted_units(dimension).empty()) << to_string(dimension);
      EXPECT_EQ(to_si(1., accepted_units(dimension).front()), 1.)
        << "the first unit is the SI unit: " << to_string(dimension);
      for (const std::string &unit : accepted_units(dimension))
        {
          EXPECT_EQ(dimension_of(unit), dimension) << unit;
          EXPECT_NEAR(from_si(to_si(12.5, unit), unit), 12.5, 1e-12) << unit;
        }
    }
}

TEST(Quantity, printed_quantities_read_back_as_the_same_number)
{
  EXPECT_EQ(format_quantity(3e8, "MPa"), "300 MPa");
  EXPECT_EQ(format_quantity(948.15, "degC"), "675 degC");
  EXPECT_EQ(format_quantity(0.375, "m/min"), "22.5 m/min");
  EXPECT_EQ(format_quantity(1e-5, "um"), "10 um");
  EXPECT_EQ(format_quantity(0.25, "1"), "0.25");
  EXPECT_EQ(format_quantity(-0., "um"), "0 um");
  for (const double value : {1. / 3., 123456.789, 1.23456789012345e-7, 5e300})
    EXPECT_EQ(parse_quantity(format_quantity(value, "um"), Dimension::length),
              value);
  EXPECT_EQ(format_quantity(1. / 3., "m", 3), "0.333 m");
}

TEST(Quantity, wrong_dimension_lists_the_units_accepted)
{
  EXPECT_EQ(message_of("300 mm", Dimension::stress),
            "'300 mm' is a length; a stress is expected, in one of the units "
            "Pa, kPa, MPa, GPa, bar, N/m2, N/mm2");
}

TEST(Quantity, missing_unit_is_refused_even_for_zero)
{
  EXPECT_EQ(message_of("0", Dimension::time),
            "'0' has no unit; a time is expected, in one of the units s, ms, "
            "us, ns, min, h");
}

TEST(Quantity, unknown_unit_is_named)
{
  EXPECT_EQ(message_of("3 furlong", Dimension::angle),
            "'3 furlong' has the unknown unit 'furlong'; a plane angle is "
            "expected, in one of the units rad, deg");
}

TEST(Quantity, what_is_not_a_finite_number_is_refused)
{
  for (const std::string text : {"",
                                 "MPa",
                                 "nan MPa",
                                 "inf MPa",
                                 "1e999 MPa",
                                 "- 3 MPa",
                                 "0x10 MPa",
                                 "1,5 MPa",
                                 "1e308 GPa",
                                 "3 4 MPa"})
    EXPECT_THROW(parse_quantity(text, Dimension::stress), InputError) << text;
  EXPECT_THROW(parse_number("12a"), InputError);
  EXPECT_THROW(parse_number(""), InputError);
}

TEST(Quantity, numbers_beyond_those_of_the_program_are_named_as_such)
{
  for (const std::string text : {"1e400 MPa", "-1e400 MPa", "1e-400 MPa"})
    EXPECT_EQ(message_of(text, Dimension::stress),
              "'" + text +
                "' holds a number that the program cannot; one between "
                "2.3e-308 and 1.7e308 in size is expected");
}

TEST(Quantity, zero_has_no_sign)
{
  EXPECT_FALSE(std::signbit(parse_quantity("-0 um", Dimension::length)));
  EXPECT_FALSE(std::signbit(parse_number("-0.0")));
}
