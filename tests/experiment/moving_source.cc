#include <asperity/experiment/moving_source.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace asperity;

namespace
{
  constexpr double     pi    = 3.14159265358979323846;
  const HeatProperties steel = {45., 7850., 500.};

  /** Velocity at which L = v l/(4 kappa). */
  double
  velocity_of(const double L, const double length)
  {
    return 4. * L * steel.diffusivity() / length;
  }
} // namespace

// The mean of Jaeger's integral over the band, by scipy's quadrature of
// exp(-u) K_0(|u|) at L = 0.1, 1 and 10.
TEST(MovingBand, agrees_with_quadrature)
{
  const double length = 1e-3;
  for (const auto &[L, mean] : {std::make_pair(0.1, 0.6477272528771751),
                                {1., 2.5128420558480298},
                                {10., 7.581413480285983}})
    {
      const double v = velocity_of(L, length);
      EXPECT_NEAR(moving_band(steel, length, v) /
                    (2. * steel.diffusivity() / (pi * steel.conductivity * v)),
                  mean,
                  1e-7 * mean);
    }
}

// C/k 4/3 sqrt(...): Loewen and Shaw (1954) have it as 0.752 (0.754 there).
TEST(MovingBand, tends_to_a_passing_band)
{
  const double length = 1e-3;
  for (const double L : {1e3, 1e5})
    {
      const double v = velocity_of(L, length);
      const double fast =
        4. / 3. *
        std::sqrt(length / (pi * steel.conductivity * steel.density *
                            steel.heat_capacity * v));
      EXPECT_NEAR(moving_band(steel, length, v), fast, 2. / L * fast);
    }
}

// A square of side 2 l: 0.473 q 2 l/k (Carslaw and Jaeger 1959); another
// rectangle by scipy's quadrature of 1/(2 pi k r).
TEST(RestingRectangle, agrees_with_known_numbers)
{
  EXPECT_NEAR(resting_rectangle(1., 1., 1.), 0.473 * 2., 1e-3);
  EXPECT_NEAR(resting_rectangle(1., 1., 0.5), 0.6502017827531587, 1e-9);
  // sides may be swapped, lengths and conductivity scale
  EXPECT_NEAR(resting_rectangle(2., 3., 1.5), 1.5 * 0.6502017827531587, 1e-9);
  EXPECT_NEAR(resting_rectangle(1., 0.5, 1.), 0.6502017827531587, 1e-9);
}

// 8/(3 pi) at rest (Carslaw and Jaeger 1959); fast, the mean of 4/3 sqrt(s/(pi
// k rho c v)) over the chords s of the circle, 0.6886/sqrt(Peclet).
TEST(MovingCircle, agrees_at_rest_and_fast)
{
  const double a = 1e-4, unit = a / steel.conductivity;
  EXPECT_NEAR(moving_circle(steel, a, 0.), 8. / (3. * pi) * unit, 1e-3 * unit);
  double             mean = 0.;
  const unsigned int n    = 20000;
  const double       v    = 2e6 * steel.diffusivity() / a;
  for (unsigned int i = 0; i < n; ++i)
    {
      const double y     = -1. + (2. * i + 1.) / n;
      const double chord = 2. * a * std::sqrt(1. - y * y);
      mean += 4. / 3. *
              std::sqrt(chord / (pi * steel.conductivity * steel.density *
                                 steel.heat_capacity * v)) *
              chord * (2. * a / n) / (pi * a * a);
    }
  EXPECT_NEAR(moving_circle(steel, a, v), mean, 1e-3 * mean);
}
