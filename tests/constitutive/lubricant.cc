#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/constitutive/lubricant_parameters.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include "law_tools.h"

using namespace asperity;
using law_tools::derivative_at_zero;

namespace
{
  constexpr double eta_0 = 0.032, eta_inf = 0.003, lambda = 1e-7, n = 0.6;
  constexpr double alpha = 19e-9, Z = 0.6, tau_0 = 5e6, zeta = 0.05;

  LubricantViscosity
  viscosity(const ShearLaw    shear,
            const PressureLaw pressure,
            const StressLimit limit)
  {
    ViscosityParameters p;
    p.shear_law    = shear;
    p.pressure_law = pressure;
    p.stress_limit = limit;
    return LubricantViscosity(p);
  }
} // namespace



TEST(LubricantDensity, laws_have_the_values_of_their_formulas)
{
  LubricantDensity density;
  // (1 + 10 * 1e9 / 1.6e9)^(1/10) = 7.25^0.1
  EXPECT_NEAR(density.ratio(1e9), std::exp(0.1 * std::log(7.25)), 1e-14);
  density.law = DensityLaw::dowson_higginson;
  EXPECT_NEAR(density.ratio(1e9), 1. + 0.6 / 2.7, 1e-14);
  density.law = DensityLaw::constant_modulus;
  EXPECT_NEAR(density.ratio(0.8e9), std::sqrt(std::exp(1.)), 1e-14);
  density.law = DensityLaw::incompressible;
  EXPECT_EQ(density.ratio(1e9), 1.);
  EXPECT_EQ(density.derivative(1e9), 0.);
}



TEST(LubricantDensity, slope_inverse_and_bulk_modulus_agree)
{
  for (const DensityLaw law : {DensityLaw::murnaghan,
                               DensityLaw::dowson_higginson,
                               DensityLaw::constant_modulus})
    {
      LubricantDensity density;
      density.law = law;
      EXPECT_EQ(density.ratio(0.), 1.);
      for (const double p : {-1e7, 0., 1e6, 3e8, 2e9})
        {
          EXPECT_NEAR(density.pressure(density.ratio(p)),
                      p,
                      1e-11 * (std::abs(p) + density.bulk_modulus));
          const auto ratio = [&](const double h) {
            return density.ratio(p + 1e7 * h);
          };
          EXPECT_NEAR(derivative_at_zero(ratio, 1.) / 1e7,
                      density.derivative(p),
                      1e-7 * density.derivative(p));
        }
    }
  // K = rho dp/drho grows by K' in Murnaghan's law.
  const LubricantDensity murnaghan;
  EXPECT_NEAR(murnaghan.ratio(1e9) / murnaghan.derivative(1e9), 11.6e9, 1.);
}



TEST(LubricantDensity, dowson_higginson_ends)
{
  LubricantDensity density;
  density.law = DensityLaw::dowson_higginson;
  EXPECT_TRUE(std::isinf(density.pressure(1. + 0.6 / 1.7 + 1e-9)));
  EXPECT_LT(density.ratio(1e15), 1. + 0.6 / 1.7);
}



TEST(LubricantViscosity, laws_have_the_values_of_their_formulas)
{
  using S           = ShearLaw;
  using P           = PressureLaw;
  using L           = StressLimit;
  const double rate = 3e7, p = 0.2e9;
  EXPECT_EQ(viscosity(S::newtonian, P::none, L::none).evaluate(rate, p).value,
            eta_0);
  const double carreau =
    eta_inf + (eta_0 - eta_inf) *
                std::pow(1. + lambda * lambda * rate * rate, 0.5 * (n - 1.));
  EXPECT_NEAR(viscosity(S::carreau, P::none, L::none).evaluate(rate, p).value,
              carreau,
              1e-14);
  EXPECT_NEAR(
    viscosity(S::newtonian, P::barus, L::none).evaluate(rate, p).value,
    eta_0 * std::exp(3.8),
    1e-13);
  // Roelands as it is mostly printed, with ln eta_0 + 9.67.
  const double roelands = eta_0 * std::exp((std::log(eta_0) + 9.67) *
                                           (std::pow(1. + 5.1e-9 * p, Z) - 1.));
  EXPECT_NEAR(
    viscosity(S::newtonian, P::roelands, L::none).evaluate(rate, p).value,
    roelands,
    2e-3 * roelands);
  // All together.
  const double eta_N = carreau * std::exp(alpha * p);
  const double tau_L = tau_0 + zeta * p;
  EXPECT_NEAR(
    viscosity(S::carreau, P::barus, L::circular).evaluate(rate, p).value,
    eta_N / std::sqrt(1. + std::pow(eta_N * rate / tau_L, 2)),
    1e-14);
}



TEST(LubricantViscosity, derivatives_agree_with_finite_differences)
{
  for (const ShearLaw shear : {ShearLaw::newtonian, ShearLaw::carreau})
    for (const PressureLaw law :
         {PressureLaw::none, PressureLaw::barus, PressureLaw::roelands})
      for (const StressLimit limit : {StressLimit::none, StressLimit::circular})
        for (const double rate : {0., 1e3, 1e6, 3e8})
          for (const double p : {-1e7, 1e6, 1e8, 6e8})
            {
              const LubricantViscosity eta = viscosity(shear, law, limit);
              const ViscosityValue     v   = eta.evaluate(rate, p);
              const double             rate_scale = rate + 1e3;
              // Even in the rate, so differences at zero are right, too.
              const auto by_rate = [&](const double h) {
                return eta.evaluate(std::abs(rate + rate_scale * h), p).value;
              };
              const auto by_pressure = [&](const double h) {
                return eta.evaluate(rate, p + std::abs(p) * h).value;
              };
              EXPECT_NEAR(derivative_at_zero(by_rate, 0.1),
                          v.d_rate * rate_scale,
                          1e-7 * v.value);
              EXPECT_NEAR(derivative_at_zero(by_pressure, 0.1),
                          v.d_pressure * std::abs(p),
                          1e-6 * v.value);
            }
}



TEST(LubricantViscosity, stress_stays_below_the_limit_whatever_the_pressure)
{
  for (const PressureLaw law : {PressureLaw::barus, PressureLaw::roelands})
    {
      const LubricantViscosity eta =
        viscosity(ShearLaw::newtonian, law, StressLimit::circular);
      for (const double p : {2e9, 5e9, 1e11, 1e13})
        for (const double rate : {1e2, 1e9})
          {
            const ViscosityValue v     = eta.evaluate(rate, p);
            const double         tau_L = eta.limiting_stress(p);
            EXPECT_EQ(tau_L, tau_0 + zeta * p);
            EXPECT_LE(v.value * rate, tau_L * (1. + 1e-12));
            EXPECT_GT(v.value * rate, 0.99 * tau_L);
            EXPECT_TRUE(std::isfinite(v.d_rate) && std::isfinite(v.d_pressure));
            EXPECT_FALSE(v.solid);
          }
    }
}



TEST(LubricantViscosity, says_where_the_lubricant_is_solid)
{
  const LubricantViscosity eta =
    viscosity(ShearLaw::carreau, PressureLaw::barus, StressLimit::none);
  EXPECT_FALSE(eta.evaluate(0., 1.6e9).solid);
  for (const double p : {1.7e9, 5e9, 1e12})
    {
      const ViscosityValue v = eta.evaluate(0., p);
      EXPECT_TRUE(v.solid);
      EXPECT_EQ(v.value, LubricantViscosity::glass_viscosity);
      EXPECT_EQ(v.d_pressure, 0.);
      EXPECT_EQ(v.d_rate, 0.);
    }
}



TEST(LubricantParameters, are_read_with_units)
{
  LubricantParameters      oil;
  dealii::ParameterHandler handler;
  ParameterDeclarator      parameters(handler);
  oil.declare(parameters);
  EXPECT_EQ(oil.viscosity.viscosity, eta_0);
  EXPECT_EQ(oil.density, 800.);
  EXPECT_EQ(oil.compressibility.law, DensityLaw::murnaghan);
  parameters.read_text("subsection Lubricant\n"
                       "  set Density = 0.87 g/cm^3\n"
                       "  set Density law = Dowson-Higginson\n"
                       "  set Viscosity = 40 mPa s\n"
                       "  set Shear law = Carreau\n"
                       "  set Pressure law = Roelands\n"
                       "  set Pressure coefficient = 22 1/GPa\n"
                       "  set Stress limit = circular\n"
                       "  set Limiting stress = 2 MPa\n"
                       "  subsection Carreau\n"
                       "    set Time constant = 2 us\n"
                       "  end\n"
                       "end\n",
                       "oil.prm");
  oil.check();
  EXPECT_NEAR(oil.density, 870., 1e-9);
  EXPECT_EQ(oil.compressibility.law, DensityLaw::dowson_higginson);
  EXPECT_NEAR(oil.viscosity.viscosity, 0.04, 1e-15);
  EXPECT_EQ(oil.viscosity.shear_law, ShearLaw::carreau);
  EXPECT_EQ(oil.viscosity.pressure_law, PressureLaw::roelands);
  EXPECT_EQ(oil.viscosity.stress_limit, StressLimit::circular);
  EXPECT_NEAR(oil.viscosity.pressure_coefficient, 22e-9, 1e-20);
  EXPECT_NEAR(oil.viscosity.time_constant, 2e-6, 1e-18);
  EXPECT_NEAR(oil.viscosity.limiting_stress, 2e6, 1e-6);
}



TEST(LubricantParameters, refuse_constants_without_physical_meaning)
{
  const auto message =
    [](const std::function<void(LubricantParameters &)> &set) {
      LubricantParameters oil;
      oil.viscosity.shear_law    = ShearLaw::carreau;
      oil.viscosity.pressure_law = PressureLaw::barus;
      oil.viscosity.stress_limit = StressLimit::circular;
      set(oil);
      try
        {
          oil.check();
        }
      catch (const InputError &error)
        {
          return std::string(error.what());
        }
      return std::string();
    };
  using P = LubricantParameters;
  EXPECT_EQ(message([](P &) {}), "");
  EXPECT_EQ(message([](P &p) { p.density = -1.; }),
            "The lubricant's density must be positive, but it is -1 kg/m3.");
  const auto says = [&](const std::function<void(P &)> &set,
                        const std::string              &word) {
    return message(set).find(word) != std::string::npos;
  };
  EXPECT_TRUE(
    says([](P &p) { p.compressibility.bulk_modulus = 0.; }, "bulk modulus"));
  EXPECT_TRUE(says([](P &p) { p.compressibility.modulus_derivative = -1.; },
                   "bulk modulus slope"));
  EXPECT_TRUE(says([](P &p) { p.viscosity.viscosity = 0.; }, "viscosity"));
  EXPECT_TRUE(says([](P &p) { p.viscosity.viscosity = std::nan(""); }, "visc"));
  EXPECT_TRUE(says([](P &p) { p.viscosity.infinite_shear_viscosity = 1.; },
                   "infinite shear rate"));
  EXPECT_TRUE(says([](P &p) { p.viscosity.power_index = 0.; }, "power index"));
  EXPECT_TRUE(says([](P &p) { p.viscosity.time_constant = -1.; }, "time"));
  EXPECT_TRUE(says([](P &p) { p.viscosity.pressure_coefficient = -1.; },
                   "pressure-viscosity"));
  EXPECT_TRUE(says([](P &p) { p.viscosity.limiting_stress = 0.; }, "limiting"));
  EXPECT_TRUE(says([](P &p) { p.viscosity.limiting_stress_slope = -1.; },
                   "fall with pressure"));
  EXPECT_TRUE(says(
    [](P &p) {
      p.viscosity.pressure_law             = PressureLaw::roelands;
      p.viscosity.viscosity                = 5e-5;
      p.viscosity.infinite_shear_viscosity = 0.;
    },
    "Roelands"));
}
