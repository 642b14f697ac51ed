#include <asperity/contact/penalty_warnings.h>

#include <gtest/gtest.h>

using namespace asperity;

TEST(PenaltyWarnings, of_a_penalty_that_makes_pressure_of_rounding)
{
  // 2^-52 of 1 m is 2.2e-16 m, and 2.2e-6 Pa at 1e10 Pa/m.
  EXPECT_EQ(rounding_warning(1e10, 1., 0.03, 1e-4), "");
  const std::string warning = rounding_warning(1e10, 1., 0.02, 1e-4);
  EXPECT_EQ(warning.find("With a penalty of 1e+10 Pa/m the rounding of "
                         "positions (2.2e-16 m) is a pressure of 2.2e-06 Pa"),
            0u)
    << warning;
  EXPECT_NE(warning.find("lower Contact/Penalty factor by 1.1 times"),
            std::string::npos)
    << warning;
}

TEST(PenaltyWarnings, of_a_penalty_that_gives_way_as_a_small_contact_does)
{
  EXPECT_EQ(soft_penalty_warning(8.), "");
  EXPECT_EQ(soft_penalty_warning(2.), "");
  // 1/(2 c n) with n = 4
  const std::string warning = soft_penalty_warning(1.);
  EXPECT_EQ(warning.find("With a penalty factor of 1 small contacts"), 0u)
    << warning;
  EXPECT_NE(warning.find("four elements the pressure is 12 % off"),
            std::string::npos)
    << warning;
}
