#include <asperity/constitutive/lubricant_parameters.h>

#include <gtest/gtest.h>

#include <cmath>

#include "law_tools.h"

using namespace asperity;
using law_tools::derivative_at_zero;

namespace
{
  LubricantParameters
  oil_with(const TemperatureLaw law)
  {
    LubricantParameters oil;
    oil.temperature.law = law;
    return oil;
  }
} // namespace



TEST(LubricantTemperature, none_leaves_every_constant)
{
  const LubricantParameters oil = oil_with(TemperatureLaw::none).at(900., 300.);
  EXPECT_EQ(oil.viscosity.viscosity, 0.032);
  EXPECT_EQ(oil.density, 800.);
  EXPECT_EQ(oil.compressibility.bulk_modulus, 1.6e9);
  EXPECT_EQ(oil.compressibility.ambient_ratio, 1.);
}



TEST(LubricantTemperature, Vogel_is_the_fit_of_Seireg_and_Dandage_for_SAE_30)
{
  // mu = 0.0141e-6 reyn exp(1360/(F + 95)), F in degrees Fahrenheit
  const auto reyn = [](const double kelvin) {
    const double F = (kelvin - 273.15) * 1.8 + 32.;
    return 0.0141e-6 * std::exp(1360. / (F + 95.));
  };
  const LubricantTemperature law = oil_with(TemperatureLaw::vogel).temperature;
  for (const double T : {300., 350., 420.})
    EXPECT_NEAR(law.viscosity(0.032, T) / 0.032,
                reyn(T) / reyn(298.15),
                2e-3 * reyn(T) / reyn(298.15));
}



// Mineral oils of table 2.3 of G. W. Stachowiak and A. W. Batchelor,
// Engineering Tribology (2005), chapter 2: viscosities at 30, 60 and 100 degC
// [mPa s]. With the slope that the first and the last of them have, Roelands'
// law gives the one between.
TEST(LubricantTemperature, Roelands_interpolates_measured_viscosities)
{
  const double oils[][3] = {{38., 12.1, 5.3},
                            {153., 34., 9.1},
                            {250., 50.5, 12.6},
                            {810., 135., 26.8},
                            {18.6, 6.3, 2.4},
                            {45., 12., 3.9},
                            {107., 23.3, 6.4},
                            {122., 26.3, 7.3},
                            {171., 31., 7.5},
                            {30.7, 8.6, 3.1},
                            {165., 30., 6.8},
                            {310., 44.2, 9.4},
                            {2000., 180., 24.}};
  const double eta_R     = LubricantViscosity::roelands_viscosity;
  for (const auto &oil : oils)
    {
      LubricantTemperature law = oil_with(TemperatureLaw::roelands).temperature;
      law.reference            = 303.15;
      law.roelands_slope       = std::log(std::log(1e-3 * oil[0] / eta_R) /
                                    std::log(1e-3 * oil[2] / eta_R)) /
                           std::log((373.15 - 138.) / (303.15 - 138.));
      EXPECT_GT(law.roelands_slope, 1.);
      EXPECT_LT(law.roelands_slope, 1.6);
      EXPECT_NEAR(law.viscosity(1e-3 * oil[0], 373.15), 1e-3 * oil[2], 1e-12);
      EXPECT_NEAR(law.viscosity(1e-3 * oil[0], 333.15) / (1e-3 * oil[1]),
                  1.,
                  0.14);
    }
}



// At 850 kg/m3 and 100 degC the class 30 of SAE J300 has 9.3 to 12.5 mm2/s.
TEST(LubricantTemperature, Vogel_is_an_oil_SAE_30)
{
  LubricantTemperature law = oil_with(TemperatureLaw::vogel).temperature;
  law.reference            = 313.15;
  // With 9.72e-5 Pa s, which is 0.0141e-6 reyn, before the exponential
  const double nu =
    law.viscosity(9.72e-5 * std::exp(755.6 / (313.15 - 202.6)), 373.15) / 850.;
  EXPECT_GT(nu, 9.3e-6);
  EXPECT_LT(nu, 12.5e-6);
}



TEST(LubricantTemperature, Roelands_is_his_law_of_pressure_and_temperature)
{
  // eta_0 exp((ln eta_0 + 9.67)
  //           ((1 + 5.1e-9 p)^Z ((T - 138)/(T_0 - 138))^(-S_0) - 1))
  LubricantParameters oil    = oil_with(TemperatureLaw::roelands);
  oil.viscosity.pressure_law = PressureLaw::roelands;
  const double log_eta       = std::log(0.032);
  const double S_0 = 1.1, Z = 0.6, T_0 = 298.15;
  for (const double T : {280., 298.15, 373.15, 600.})
    for (const double p : {0., 3e8, 1e9})
      {
        const double expected =
          log_eta +
          (log_eta + 9.67) * (std::pow(1. + 5.1e-9 * p, Z) *
                                std::pow((T - 138.) / (T_0 - 138.), -S_0) -
                              1.);
        const LubricantViscosity hot(oil.at(T, T).viscosity);
        EXPECT_NEAR(std::log(hot.evaluate(0., p).value), expected, 0.02);
      }
}



TEST(LubricantTemperature, a_liquid_is_a_glass_where_its_law_says_so)
{
  for (const TemperatureLaw law :
       {TemperatureLaw::vogel, TemperatureLaw::roelands})
    {
      const LubricantTemperature temperature = oil_with(law).temperature;
      const double               T = temperature.glass_temperature(0.032);
      EXPECT_GT(T, temperature.lowest());
      EXPECT_NEAR(temperature.viscosity(0.032, T), 1e12, 1e3);
      EXPECT_TRUE(
        std::isinf(temperature.viscosity(0.032, temperature.lowest())));
    }
}



TEST(LubricantTemperature, density_and_modulus_fall_exponentially)
{
  const LubricantParameters hot =
    oil_with(TemperatureLaw::vogel).at(398.15, 348.15);
  EXPECT_NEAR(hot.density, 800. * std::exp(-0.065), 1e-10);
  EXPECT_NEAR(hot.compressibility.bulk_modulus, 1.6e9 * std::exp(-0.65), 1.);
  // counted from the temperature at which the volume is given
  EXPECT_NEAR(hot.compressibility.ambient_ratio, std::exp(-0.0325), 1e-14);
  EXPECT_NEAR(hot.compressibility.ratio(0.), std::exp(-0.0325), 1e-14);
}



TEST(LubricantTemperature, slopes_of_a_hot_oil_are_those_of_differences)
{
  for (const TemperatureLaw law :
       {TemperatureLaw::vogel, TemperatureLaw::roelands})
    {
      LubricantParameters oil       = oil_with(law);
      oil.viscosity.shear_law       = ShearLaw::carreau;
      oil.viscosity.pressure_law    = PressureLaw::barus;
      const LubricantParameters hot = oil.at(380., 320.);
      const LubricantViscosity  viscosity(hot.viscosity);
      const double              rate = 2e7, p = 2e8;
      const ViscosityValue      eta = viscosity.evaluate(rate, p);
      EXPECT_NEAR(derivative_at_zero(
                    [&](const double h) {
                      return viscosity.evaluate(rate * (1. + h), p).value;
                    },
                    0.1) /
                    rate,
                  eta.d_rate,
                  1e-6 * std::abs(eta.d_rate));
      EXPECT_NEAR(derivative_at_zero(
                    [&](const double h) {
                      return viscosity.evaluate(rate, p * (1. + h)).value;
                    },
                    0.1) /
                    p,
                  eta.d_pressure,
                  1e-6 * eta.d_pressure);
      for (const DensityLaw density_law : {DensityLaw::murnaghan,
                                           DensityLaw::dowson_higginson,
                                           DensityLaw::constant_modulus})
        {
          LubricantDensity density = hot.compressibility;
          density.law              = density_law;
          EXPECT_NEAR(derivative_at_zero(
                        [&](const double h) {
                          return density.ratio(p * (1. + h));
                        },
                        0.1) /
                        p,
                      density.derivative(p),
                      1e-6 * density.derivative(p));
          EXPECT_NEAR(density.pressure(density.ratio(p)), p, 1e-6 * p);
        }
    }
}



TEST(LubricantTemperature, Carreau_shifts_with_the_viscosity_at_rest)
{
  // eta(rate, T) = a eta(a rate, T_0), a = eta_0(T)/eta_0(T_0)
  LubricantParameters oil    = oil_with(TemperatureLaw::vogel);
  oil.viscosity.shear_law    = ShearLaw::carreau;
  const double             a = oil.temperature.viscosity(0.032, 373.15) / 0.032;
  const LubricantViscosity cold(oil.viscosity),
    hot(oil.at(373.15, 373.15).viscosity);
  for (const double rate : {0., 1e6, 1e8})
    EXPECT_NEAR(hot.evaluate(rate, 0.).value,
                a * cold.evaluate(a * rate, 0.).value,
                1e-14);
}
