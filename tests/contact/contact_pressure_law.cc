#include <asperity/contact/contact_pressure_law.h>

#include <gtest/gtest.h>

using namespace asperity;

TEST(ContactPressureLaw,
     slope_is_the_derivative_of_the_pressure_on_both_branches)
{
  const ContactPressureLaw law{3e15};
  const double             step = 1e-12;
  for (const double multiplier : {0., 2e8})
    for (const double gap : {-1e-7, -2e-8, 5e-8, 1e-7, 4e-7})
      {
        const double difference = (law.evaluate(gap + step, multiplier).value -
                                   law.evaluate(gap - step, multiplier).value) /
                                  (2. * step);
        EXPECT_NEAR(law.evaluate(gap, multiplier).slope,
                    difference,
                    1e-8 * law.penalty);
      }
}



TEST(ContactPressureLaw,
     presses_where_the_multiplier_exceeds_the_penalty_of_the_gap)
{
  const ContactPressureLaw law{1e15};
  EXPECT_DOUBLE_EQ(law.evaluate(-1e-7, 0.).value, 1e8);
  EXPECT_DOUBLE_EQ(law.evaluate(-1e-7, 5e7).value, 1.5e8);
  EXPECT_DOUBLE_EQ(law.evaluate(1e-7, 3e8).value, 2e8);
  for (const ContactPressure open :
       {law.evaluate(1e-7, 0.), law.evaluate(4e-7, 3e8), law.evaluate(0., 0.)})
    {
      EXPECT_EQ(open.value, 0.);
      EXPECT_EQ(open.slope, 0.);
    }
}
