#include <asperity/base/lanes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace asperity;
using lanes::Pack;

namespace
{
  /** Difference in units of the last place of the right value. */
  double
  ulps(const double value, const long double right)
  {
    const double rounded = std::fabs(static_cast<double>(right));
    const double ulp =
      std::nextafter(rounded, std::numeric_limits<double>::infinity()) -
      rounded;
    return static_cast<double>(std::fabs(value - right) / ulp);
  }
} // namespace



TEST(Lanes, logarithm_and_exponential_are_off_by_less_than_two_ulp)
{
  double worst_log = 0., worst_exp = 0.;
  for (int i = -70000; i <= 70000; ++i)
    {
      const double x = 0.01 * i + 1e-3;
      const double y = 1. + 1e-6 * i;
      const Pack   e = lanes::exp(Pack{x, x / 700., x, x / 7e5});
      worst_exp = std::fmax(worst_exp, ulps(e[0], std::exp((long double)x)));
      worst_exp =
        std::fmax(worst_exp, ulps(e[1], std::exp((long double)(x / 700.))));
      worst_exp =
        std::fmax(worst_exp, ulps(e[3], std::exp((long double)(x / 7e5))));
      const double large = std::exp(x);
      const Pack   l     = lanes::log(Pack{large, y, large, y * 1.4});
      worst_log =
        std::fmax(worst_log, ulps(l[0], std::log((long double)large)));
      worst_log = std::fmax(worst_log, ulps(l[1], std::log((long double)y)));
      worst_log =
        std::fmax(worst_log, ulps(l[3], std::log((long double)(y * 1.4))));
    }
  EXPECT_LT(worst_log, 2.);
  EXPECT_LT(worst_exp, 2.);
}



TEST(Lanes, functions_of_a_pack_are_those_of_each_number)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan      = std::numeric_limits<double>::quiet_NaN();
  const Pack   x{0.25, 2., 9., 1e6};
  for (unsigned int i = 0; i < lanes::width; ++i)
    {
      EXPECT_EQ(lanes::sqrt(x)[i], std::sqrt(x[i]));
      EXPECT_EQ(lanes::abs(-x)[i], x[i]);
      EXPECT_NEAR(lanes::pow(x, 0.3)[i] / std::pow(x[i], 0.3), 1., 1e-14);
      EXPECT_EQ(lanes::select(x < 5., x, 2. * x)[i],
                x[i] < 5. ? x[i] : 2. * x[i]);
    }
  EXPECT_TRUE(lanes::any(x > 10.));
  EXPECT_FALSE(lanes::any(x > 1e7));
  EXPECT_EQ(lanes::log(Pack{infinity, 1., 1., 1.})[0], infinity);
  EXPECT_TRUE(std::isnan(lanes::log(Pack{nan, 1., 1., 1.})[0]));
  EXPECT_TRUE(std::isnan(lanes::exp(Pack{nan, 1., 1., 1.})[0]));
  EXPECT_EQ(lanes::exp(Pack{0., 1e9, -1e9, 0.})[0], 1.);
}
