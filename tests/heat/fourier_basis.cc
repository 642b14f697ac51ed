#include <asperity/heat/fourier_basis.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace asperity;
} // namespace



TEST(FourierBasis, has_the_waves_of_the_period)
{
  const FourierBasis basis(3., 40);
  ASSERT_EQ(basis.size(), 81u);
  const std::vector<double> x      = {0., 0.2, 2.9, -7.3};
  const auto                values = basis.values(x);
  for (unsigned int q = 0; q < x.size(); ++q)
    {
      EXPECT_EQ(values(q, 0), 1.);
      for (unsigned int k = 1; k <= 40; ++k)
        {
          const double phase = 2. * M_PI * k * x[q] / 3.;
          EXPECT_NEAR(values(q, 2 * k - 1), std::cos(phase), 1e-12);
          EXPECT_NEAR(values(q, 2 * k), std::sin(phase), 1e-12);
          EXPECT_NEAR(basis.wave_number(2 * k), 2. * M_PI * k / 3., 1e-12);
          EXPECT_EQ(basis.wave_number(2 * k - 1), basis.wave_number(2 * k));
        }
    }
}



TEST(FourierBasis, projects_its_own_functions_to_themselves)
{
  const FourierBasis  basis(2., 3);
  const unsigned int  n = 16; // the rectangle rule is exact below n/2 waves
  std::vector<double> x;
  for (unsigned int i = 0; i < n; ++i)
    x.push_back(2. * i / n);
  const auto f = basis.values(x);
  for (unsigned int a = 0; a < basis.size(); ++a)
    for (unsigned int b = 0; b < basis.size(); ++b)
      {
        double sum = 0.;
        for (unsigned int i = 0; i < n; ++i)
          sum += basis.norm(a) * f(i, a) * f(i, b) * 2. / n;
        EXPECT_NEAR(sum, a == b ? 1. : 0., 1e-14) << a << " " << b;
      }
}
