#include <asperity/base/errors.h>

#include <gtest/gtest.h>

#include "law_tools.h"

using namespace asperity;
using namespace asperity::law_tools;

namespace
{
  constexpr double zero_celsius = 273.15;

  struct TableRow
  {
    double temperature; // [degC]
    double rate;        // [1/s]
    double stress[4];   // [MPa] at plastic strain 0.01, 0.1, 0.5, 1
    double heated[4];   // [degC]
  };

  // Adiabatic table, integrated by a fourth-order Runge-Kutta method in the
  // cube root of the plastic strain, independently of this program.
  const TableRow adiabatic[] = {{25,
                                 0.004,
                                 {476.079, 647.967, 837.389, 912.923},
                                 {26.114, 39.590, 117.898, 231.000}},
                                {25,
                                 1,
                                 {565.438, 769.185, 988.313, 1064.070},
                                 {26.323, 42.325, 135.039, 267.738}},
                                {25,
                                 1e3,
                                 {677.225, 920.617, 1173.836, 1243.034},
                                 {26.585, 45.744, 156.327, 312.706}},
                                {25,
                                 1e6,
                                 {789.004, 1071.790, 1355.534, 1410.555},
                                 {26.847, 49.160, 177.431, 356.533}},
                                {675,
                                 0.004,
                                 {318.371, 430.288, 538.147, 565.373},
                                 {675.745, 684.725, 735.843, 807.151}},
                                {675,
                                 1,
                                 {378.084, 510.100, 631.225, 652.077},
                                 {675.885, 686.540, 746.825, 829.782}},
                                {675,
                                 1e3,
                                 {452.766, 609.522, 744.231, 752.540},
                                 {676.060, 688.805, 760.371, 857.171}},
                                {675,
                                 1e6,
                                 {527.421, 708.470, 853.464, 844.449},
                                 {676.235, 691.066, 773.704, 883.554}}};

  /**
   * Total equivalent strain of an isochoric stretch at which the step
   * has the plastic increment asked for.
   */
  double
  strain_for_plastic_increment(const MaterialLaw   &law,
                               const MaterialState &old,
                               const double         increment,
                               const double         dt,
                               const double         guess)
  {
    const auto excess = [&](const double strain) {
      MaterialResponse r;
      law.evaluate(isochoric_stretch(strain), old, dt, false, r);
      return r.state.plastic_strain - old.plastic_strain - increment;
    };
    double lower = guess, upper = guess + increment + 0.01;
    for (int i = 0; i < 40; ++i)
      {
        const double middle                   = 0.5 * (lower + upper);
        (excess(middle) < 0. ? lower : upper) = middle;
      }
    return 0.5 * (lower + upper);
  }
} // namespace



TEST(JohnsonCook, isothermal_table_of_flow_stress)
{
  const JohnsonCook flow{JohnsonCookParameters()};
  const double      strain[] = {0., 0.01, 0.1, 0.5, 1.};
  const double      slow[]   = {287.872, 476.146, 649.524, 858.626, 982.561};
  const double      fast[]   = {477.135, 789.191, 1076.558, 1423.135, 1628.553};
  for (int i = 0; i < 5; ++i)
    {
      const double T = 25. + zero_celsius;
      EXPECT_NEAR(flow.evaluate(strain[i], 0.004, T).value / 1e6,
                  slow[i],
                  1e-3);
      EXPECT_NEAR(flow.evaluate(strain[i], 1e6, T).value / 1e6, fast[i], 1e-3);
      EXPECT_NEAR(flow.static_value(strain[i], T) / 1e6, slow[i], 1e-3);
    }
}



TEST(JohnsonCook, adiabatic_table_by_the_full_update_at_constant_plastic_rate)
{
  const auto   law        = MaterialParameters().make_law();
  const double reported[] = {0.01, 0.1, 0.5, 1.};
  for (const TableRow &row : adiabatic)
    {
      MaterialState state;
      state.temperature = row.temperature + zero_celsius;
      double    total   = 0.;
      int       column  = 0;
      const int n_steps = 4000;
      for (int step = 1; step <= n_steps; ++step)
        {
          const double increment = 1. / n_steps;
          total                  = strain_for_plastic_increment(
            *law, state, increment, increment / row.rate, total);
          MaterialResponse r;
          law->evaluate(
            isochoric_stretch(total), state, increment / row.rate, false, r);
          ASSERT_EQ(r.status, LawStatus::ok);
          ASSERT_TRUE(r.plastic);
          state = r.state;
          if (std::abs(state.plastic_strain - reported[column]) <
              0.5 * increment)
            {
              EXPECT_NEAR(r.mises / 1e6 / row.stress[column], 1., 1e-3)
                << row.temperature << " degC, " << row.rate << " 1/s, strain "
                << reported[column];
              EXPECT_NEAR((state.temperature - zero_celsius) /
                            row.heated[column],
                          1.,
                          1e-3);
              ++column;
            }
        }
      EXPECT_EQ(column, 4);
    }
}



TEST(JohnsonCook, factors_are_one_at_their_reference)
{
  const JohnsonCookParameters p;
  const JohnsonCook           flow(p);
  EXPECT_DOUBLE_EQ(flow.hardening(0.).value, p.A);
  EXPECT_DOUBLE_EQ(flow.hardening(1.).value, p.A + p.B);
  EXPECT_DOUBLE_EQ(flow.rate_factor(0.).value, 1.);
  EXPECT_DOUBLE_EQ(flow.rate_factor(p.reference_rate).value, 1.);
  EXPECT_DOUBLE_EQ(flow.rate_factor(p.reference_rate * std::exp(1.)).value,
                   1. + p.C);
  const Softening thermal = *flow.softening();
  EXPECT_DOUBLE_EQ(thermal.factor(p.transition_temperature).value, 1.);
  EXPECT_DOUBLE_EQ(thermal.factor(0.).value, 1.);
  EXPECT_DOUBLE_EQ(thermal.factor(p.melting_temperature).value,
                   Softening::floor);
  EXPECT_DOUBLE_EQ(thermal.factor(1e5).value, Softening::floor);
}



TEST(Softening, by_hand_and_back)
{
  const Softening thermal{2., 300., 1300.};
  // 1 - 0.5^2, slope -2 0.5/1000 K
  EXPECT_DOUBLE_EQ(thermal.factor(800.).value, 0.75);
  EXPECT_DOUBLE_EQ(thermal.factor(800.).slope, -1e-3);
  EXPECT_DOUBLE_EQ(thermal.temperature_at(0.75), 800.);
  const double end = thermal.temperature_at(Softening::floor);
  EXPECT_LT(thermal.factor(end - 1.).slope, 0.);
  EXPECT_EQ(thermal.factor(end + 1.).slope, 0.);
}



TEST(JohnsonCook, derivatives_agree_with_finite_differences)
{
  const JohnsonCook flow{JohnsonCookParameters()};
  for (const double strain : {1e-6, 0.01, 0.7})
    for (const double rate : {0.003, 1., 1e7})
      for (const double temperature : {280., 400., 1500., 1900.})
        {
          const FlowStressValue v = flow.evaluate(strain, rate, temperature);
          const auto            by_strain = [&](const double h) {
            return flow.evaluate(strain + h, rate, temperature).value;
          };
          const auto by_rate = [&](const double h) {
            return flow.evaluate(strain, rate + h, temperature).value;
          };
          const auto by_temperature = [&](const double h) {
            return flow.evaluate(strain, rate, temperature + h).value;
          };
          EXPECT_NEAR(derivative_at_zero(by_strain, 0.2 * strain),
                      v.d_strain,
                      1e-8 * v.d_strain);
          EXPECT_NEAR(derivative_at_zero(by_rate, 0.2 * rate),
                      v.d_rate,
                      1e-8 * v.value / rate);
          EXPECT_NEAR(derivative_at_zero(by_temperature, 5.),
                      v.d_temperature,
                      1e-8 * v.value / 100.);
        }
}



TEST(JohnsonCook, refuses_constants_without_physical_meaning)
{
  const auto refused = [](const std::function<void(MaterialParameters &)> &set,
                          const std::string &word) {
    MaterialParameters parameters;
    set(parameters);
    try
      {
        parameters.make_law();
      }
    catch (const InputError &error)
      {
        return std::string(error.what()).find(word) != std::string::npos;
      }
    return false;
  };
  using P = MaterialParameters;
  EXPECT_TRUE(
    refused([](P &p) { p.constants<JohnsonCookParameters>().A = -1.; },
            "constant A"));
  EXPECT_TRUE(refused([](P &p) { p.constants<JohnsonCookParameters>().n = 0.; },
                      "constant n"));
  EXPECT_TRUE(
    refused([](P &p) { p.constants<JohnsonCookParameters>().C = -0.1; },
            "constant C"));
  EXPECT_TRUE(refused(
    [](P &p) { p.constants<JohnsonCookParameters>().reference_rate = 0.; },
    "reference rate"));
  EXPECT_TRUE(refused(
    [](P &p) {
      p.constants<JohnsonCookParameters>().melting_temperature = 290.;
    },
    "melting temperature"));
  EXPECT_TRUE(refused([](P &p) { p.elasticity.density = -7800.; }, "density"));
  EXPECT_TRUE(
    refused([](P &p) { p.elasticity.poisson_ratio = 0.5; }, "Poisson"));
  EXPECT_TRUE(
    refused([](P &p) { p.elasticity.young_modulus = std::nan(""); }, "Young"));
  EXPECT_TRUE(
    refused([](P &p) { p.heating.heat_fraction = 1.1; }, "becomes heat"));
  EXPECT_TRUE(
    refused([](P &p) { p.heating.heat_capacity = 0.; }, "heat capacity"));
  EXPECT_TRUE(refused(
    [](P &p) {
      VoceParameters voce;
      voce.yield_stress = 0.;
      p.choose(voce);
    },
    "yield stress"));
}



// Lee (2025), section 2.1: 1133.92 MPa from a strain of 2 on.
TEST(JohnsonCook, hardening_ends_at_the_strain_limit)
{
  JohnsonCookParameters constants;
  constants.strain_limit = 2.;
  const JohnsonCook limited(constants), free((JohnsonCookParameters()));
  for (const double strain : {0., 1e-3, 0.5, 1.9, 2.})
    {
      EXPECT_EQ(limited.hardening(strain).value, free.hardening(strain).value);
      EXPECT_EQ(limited.hardening(strain).slope, free.hardening(strain).slope);
    }
  for (const double strain : {2.001, 3., 100.})
    {
      EXPECT_NEAR(limited.hardening(strain).value, 1133.92e6, 0.005e6);
      EXPECT_EQ(limited.hardening(strain).slope, 0.);
      EXPECT_GT(free.hardening(strain).value, 1133.93e6);
    }
  // k of the exported law is the same function
  MaterialParameters material;
  material.choose(constants);
  EXPECT_NEAR(material.make_law()->shear_limit(3., 0.004, 293.15),
              1133.92e6 / std::sqrt(3.),
              0.005e6);
}



TEST(JohnsonCook, tangents_on_both_sides_of_the_strain_limit)
{
  JohnsonCookParameters constants;
  constants.strain_limit = 2.;
  const auto         law = constants.make_law({}, {});
  const Tensor<2, 3> F   = plane(1.03, 0.04, -0.01, 0.98, 1.);
  for (const double strain : {0.5, 1.5, 1.99, 2., 3.})
    for (const double dt : {1e-7, 1.})
      {
        MaterialState old;
        old.plastic_strain         = strain;
        old.temperature            = 500.;
        const MaterialResponse now = evaluate(*law, F, old, dt);
        ASSERT_TRUE(now.plastic);
        EXPECT_LT(tangent_error(*law, F, old, dt), 1e-6) << strain;
        // the stress is the flow stress, across the limit as well
        const double flow =
          JohnsonCook(constants)
            .evaluate(now.state.plastic_strain,
                      (now.state.plastic_strain - strain) / dt,
                      now.state.temperature)
            .value;
        EXPECT_NEAR(now.mises, flow, 1e-8 * flow) << strain;
        EXPECT_EQ(now.state.plastic_strain > 2., strain >= 1.99) << strain;
      }
}
