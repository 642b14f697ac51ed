#include <asperity/constitutive/interface_law.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace asperity;

namespace
{
  constexpr double k = 500e6;

  InterfaceLaw
  law(const InterfaceShear         kind,
      const double                 m        = 0.5,
      const std::optional<double> &m_wet    = {},
      const double                 friction = 0.3)
  {
    InterfaceParameters parameters;
    parameters.law                  = kind;
    parameters.shear_factor         = m;
    parameters.wet_shear_factor     = m_wet;
    parameters.friction_coefficient = friction;
    return InterfaceLaw(parameters);
  }

  double
  shear(const InterfaceLaw &law, const InterfaceState &state)
  {
    return law.strength(state).value;
  }
} // namespace

TEST(InterfaceLaw, limits_are_those_of_the_formulas)
{
  const double p = 1e9;
  EXPECT_EQ(shear(law(InterfaceShear::none), {p, k}), 0.);
  EXPECT_DOUBLE_EQ(shear(law(InterfaceShear::coulomb), {p, k}), 0.3 * p);
  EXPECT_DOUBLE_EQ(shear(law(InterfaceShear::shear_factor), {p, k}), 0.5 * k);
  // 0.3 GPa against 0.25 GPa, and against 0.25 GPa of 30 MPa.
  const InterfaceLaw limited = law(InterfaceShear::limited_coulomb);
  EXPECT_DOUBLE_EQ(shear(limited, {p, k}), 0.5 * k);
  EXPECT_DOUBLE_EQ(shear(limited, {0.1 * p, k}), 0.03 * p);
}

TEST(InterfaceLaw, a_spot_that_touches_in_part_bears_that_part_of_m_k)
{
  for (const auto kind :
       {InterfaceShear::shear_factor, InterfaceShear::limited_coulomb})
    EXPECT_DOUBLE_EQ(shear(law(kind, 0.5, {}, 5.), {1e9, k, 0.25}), 0.125 * k);
  // What presses under Coulomb's law is the whole.
  EXPECT_DOUBLE_EQ(shear(law(InterfaceShear::coulomb), {1e9, k, 0.25}), 0.3e9);
}

TEST(InterfaceLaw, shear_factors_of_dry_and_wet_spots_are_blended)
{
  const InterfaceLaw both = law(InterfaceShear::shear_factor, 0.8, 0.2);
  EXPECT_DOUBLE_EQ(shear(both, {1e9, k, 1., 0.}), 0.8 * k);
  EXPECT_DOUBLE_EQ(shear(both, {1e9, k, 1., 1.}), 0.2 * k);
  EXPECT_DOUBLE_EQ(shear(both, {1e9, k, 1., 0.5}), 0.5 * k);
  EXPECT_DOUBLE_EQ(shear(law(InterfaceShear::shear_factor, 0.8),
                         {1e9, k, 1., 1.}),
                   0.8 * k);
}

// For f = 1/2: (f alpha)' = 1 - sqrt(1/2), p'/k = (1 + pi/2 + pi/3 +
// sqrt(3)/2)/(1 + sqrt(1/2)) = 2.626678.
TEST(InterfaceLaw, wanheim_and_bay_lead_from_amontons_to_a_shear_factor)
{
  const InterfaceLaw wanheim_bay = law(InterfaceShear::wanheim_bay);
  const double       at_limit = 1. - std::sqrt(0.5), limit = 2.626678 * k;
  EXPECT_NEAR(shear(wanheim_bay, {0.1 * limit, k}),
              0.1 * at_limit * k,
              1e-6 * k);
  EXPECT_NEAR(shear(wanheim_bay, {limit, k}), at_limit * k, 1e-6 * k);
  EXPECT_NEAR(
    shear(wanheim_bay, {2. * limit, k}),
    (0.5 - (0.5 - at_limit) * std::exp(-at_limit / (0.5 - at_limit))) * k,
    1e-6 * k);
  EXPECT_NEAR(shear(wanheim_bay, {50. * limit, k}), 0.5 * k, 1e-9 * k);
  // Asperities without friction, and welded ones: p' = (1 + pi/2) k.
  EXPECT_EQ(shear(law(InterfaceShear::wanheim_bay, 0.), {limit, k}), 0.);
  const InterfaceLaw welded = law(InterfaceShear::wanheim_bay, 1.);
  EXPECT_NEAR(shear(welded, {0.5 * (1. + M_PI_2) * k, k}), 0.5 * k, 1e-9 * k);
  EXPECT_NEAR(shear(welded, {3. * k, k}), k, 1e-9 * k);
}

TEST(InterfaceLaw, slopes_are_derivatives_on_each_branch)
{
  for (const auto kind : {InterfaceShear::coulomb,
                          InterfaceShear::shear_factor,
                          InterfaceShear::limited_coulomb,
                          InterfaceShear::wanheim_bay})
    for (const double pressure : {1e8, 1e9, 2e9})
      {
        const InterfaceLaw   interface = law(kind, 0.5, 0.1);
        const InterfaceState at{pressure, k, 0.7, 0.3};
        const ShearStrength  strength = interface.strength(at);
        const auto           slope = [&](double InterfaceState::*const member,
                               const double                  step) {
          InterfaceState plus = at, minus = at;
          plus.*member += step;
          minus.*member -= step;
          return (shear(interface, plus) - shear(interface, minus)) /
                 (2. * step);
        };
        EXPECT_NEAR(strength.by_pressure,
                    slope(&InterfaceState::pressure, 1e3),
                    1e-7);
        EXPECT_NEAR(strength.by_touching,
                    slope(&InterfaceState::touching, 1e-4),
                    1e-7 * k);
      }
}
