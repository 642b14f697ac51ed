#include <gtest/gtest.h>

#include "law_tools.h"

using namespace asperity;
using namespace asperity::law_tools;

namespace
{
  /** A point, with the branch of the law it must lie on. */
  struct Branch
  {
    std::string   name;
    PlaneTensor   F;
    MaterialState old;
    double        dt;
    bool          plastic;
    double        lowest_rate, highest_rate; // of plastic strain [1/s]
    double        lowest_temperature;        // after the step [K]
    double        highest_temperature;
  };



  /** On the yield surface after 3 % of stretch, at 300 K. */
  MaterialState
  deformed_state(const MaterialLaw &law)
  {
    MaterialState state;
    state.temperature = 300.;
    return evaluate(law, isochoric_stretch(0.03), state, 1e3).state;
  }



  std::vector<Branch>
  branches(const MaterialLaw &law)
  {
    constexpr double    huge         = 1e300;
    const MaterialState deformed     = deformed_state(law);
    const PlaneTensor   sheared      = {{1.03, 0.04, -0.01, 0.98, 1.}};
    const PlaneTensor   axisymmetric = {{1.02, 0.03, -0.02, 0.97, 1.04}};
    MaterialState       hot          = deformed;
    hot.temperature                  = 950.;
    MaterialState nearly_molten      = deformed;
    nearly_molten.temperature        = 1740.;
    MaterialState molten             = deformed;
    molten.temperature               = 1800.;
    const PlaneTensor unloaded       = isochoric_stretch(0.0285);
    return {
      {"elastic",
       {{1.0005, 2e-4, 1e-4, 1.0002, 1.}},
       {},
       1.,
       false,
       0.,
       0.,
       0,
       huge},
      {"elastic coincident",
       {{1.002, 0., 0., 1.002, 1.002}},
       {},
       1.,
       false,
       0.,
       0.,
       0,
       huge},
      {"elastic identity", identity, {}, 1., false, 0., 0., 0, huge},
      {"unloading", unloaded, deformed, 1., false, 0., 0., 0, huge},
      {"slow", sheared, deformed, 1e3, true, 0., 0.004, 0., huge},
      {"static", sheared, deformed, 0., true, 0., 0.004, 0., huge},
      {"fast", sheared, deformed, 1e-8, true, 1e5, huge, 0., huge},
      {"hot", sheared, hot, 1e-7, true, 1e5, huge, 900., 1500.},
      {"near melting",
       sheared,
       nearly_molten,
       1e-7,
       true,
       1e5,
       huge,
       1700.,
       1772.},
      {"molten", sheared, molten, 1e-7, true, 1e5, huge, 1773.15, huge},
      {"coincident in plane",
       {{1.02, 0., 0., 1.02, 0.96}},
       {},
       1e-6,
       true,
       1e3,
       huge,
       0.,
       huge},
      {"all coincident but rotated",
       {{0.6, -0.8, 0.8, 0.6, 0.97}},
       {},
       1e-6,
       true,
       1e3,
       huge,
       0.,
       huge},
      {"axisymmetric", axisymmetric, deformed, 1e-7, true, 1e5, huge, 0., huge},
      {"large strain",
       {{1.8, 0.9, -0.2, 0.7, 0.9}},
       deformed,
       1e-6,
       true,
       1e5,
       huge,
       0.,
       huge}};
  }
} // namespace



TEST(Tangent, EveryBranchOfJohnsonCookAgreesWithFiniteDifferences)
{
  const auto law = make_material_law(MaterialParameters());
  for (const Branch &b : branches(*law))
    {
      SCOPED_TRACE(b.name);
      const MaterialResponse r = evaluate(*law, b.F, b.old, b.dt);
      ASSERT_EQ(r.status, LawStatus::ok);
      ASSERT_EQ(r.plastic, b.plastic);
      if (b.plastic && b.dt > 0.)
        {
          const double rate =
            (r.state.plastic_strain - b.old.plastic_strain) / b.dt;
          ASSERT_GT(rate, b.lowest_rate);
          ASSERT_LT(rate, b.highest_rate);
        }
      ASSERT_GE(r.state.temperature, b.lowest_temperature);
      ASSERT_LE(r.state.temperature, b.highest_temperature);
      EXPECT_LT(tangent_error(*law, b.F, b.old, b.dt), 1e-6);
    }
}



TEST(Tangent, EveryLawAgreesWithFiniteDifferences)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      RandomDeformation random(1);
      for (int i = 0; i < 30; ++i)
        {
          const PlaneTensor   F1  = random.near(identity, 0.05);
          const MaterialState old = evaluate(*law, F1, {}, 1e-7).state;
          const PlaneTensor   F2  = random.near(F1, 0.05);
          EXPECT_LT(tangent_error(*law, F2, old, 1e-7), 1e-6);
          EXPECT_LT(tangent_error(*law, identity, {}, 1e-7), 1e-6);
        }
    }
}



TEST(Tangent, IsMajorSymmetric)
{
  for (const auto &law : all_laws())
    {
      RandomDeformation random(2);
      for (int i = 0; i < 50; ++i)
        {
          const PlaneTensor      F1  = random.near(identity, 0.1);
          const MaterialState    old = evaluate(*law, F1, {}, 1e-7).state;
          const MaterialResponse r =
            evaluate(*law, random.near(F1, 0.1), old, 1e-7);
          for (int p = 0; p < 5; ++p)
            for (int q = 0; q < p; ++q)
              EXPECT_NEAR(r.tangent[p][q],
                          r.tangent[q][p],
                          1e-13 * largest(r.tangent))
                << law->name();
        }
    }
}



TEST(Tangent, NearlyEqualStretchesJoinTheEqualOnes)
{
  const auto law = make_material_law(MaterialParameters());
  for (const double split :
       {0., 1e-16, 1e-12, 1e-8, 1e-5, 1e-3, 0.04, 0.05, 0.06})
    {
      const PlaneTensor F = {{1.02 + split, 0.3 * split, 0., 1.02, 0.96}};
      EXPECT_LT(tangent_error(*law, F, {}, 1e-6), 1e-6) << split;
    }
}



TEST(Tangent, AtSmallStrainIsHookesLaw)
{
  for (const auto &law : all_laws())
    {
      const double           E      = law->young_modulus();
      const double           nu     = law->poisson_ratio();
      const double           mu     = E / (2. * (1. + nu));
      const double           lambda = E * nu / ((1. + nu) * (1. - 2. * nu));
      const MaterialResponse r      = evaluate(*law, identity);
      const double           expected[5][5] = {
                  {lambda + 2. * mu, 0., 0., lambda, lambda},
                  {0., mu, mu, 0., 0.},
                  {0., mu, mu, 0., 0.},
                  {lambda, 0., 0., lambda + 2. * mu, lambda},
                  {lambda, 0., 0., lambda, lambda + 2. * mu}};
      for (int p = 0; p < 5; ++p)
        {
          EXPECT_NEAR(r.P[p], 0., 1e-14 * E) << law->name();
          for (int q = 0; q < 5; ++q)
            EXPECT_NEAR(r.tangent[p][q], expected[p][q], 1e-13 * E)
              << law->name();
        }
    }
}
