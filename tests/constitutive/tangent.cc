#include <gtest/gtest.h>

#include "law_tools.h"

using namespace asperity;
using namespace asperity::law_tools;

namespace
{
  /** Bounds of what a step must reach to lie on its branch. */
  struct Bounds
  {
    double low  = 0.;
    double high = std::numeric_limits<double>::max();
  };

  /** A point, with the branch of the law it must lie on. */
  struct Branch
  {
    std::string   name;
    Tensor<2, 3>  F;
    MaterialState old;
    double        dt;
    bool          plastic     = false;
    Bounds        rate        = {}; ///< of plastic strain [1/s]
    Bounds        temperature = {}; ///< after the step [K]
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
  elastic_branches(const MaterialLaw &law)
  {
    return {{"elastic", plane(1.0005, 2e-4, 1e-4, 1.0002, 1.), {}, 1.},
            {"elastic coincident", plane(1.002, 0., 0., 1.002, 1.002), {}, 1.},
            {"elastic identity", identity, {}, 1.},
            {"unloading", isochoric_stretch(0.0285), deformed_state(law), 1.}};
  }



  std::vector<Branch>
  plastic_branches(const MaterialLaw &law)
  {
    const MaterialState deformed     = deformed_state(law);
    const Tensor<2, 3>  sheared      = plane(1.03, 0.04, -0.01, 0.98, 1.);
    const Tensor<2, 3>  axisymmetric = plane(1.02, 0.03, -0.02, 0.97, 1.04);
    const Bounds        slow{0., 0.004}, fast{1e5}, any{};
    const auto          at = [&](const double temperature) {
      MaterialState state = deformed;
      state.temperature   = temperature;
      return state;
    };
    return {
      {"slow", sheared, deformed, 1e3, true, slow},
      {"static", sheared, deformed, 0., true, any},
      {"fast", sheared, deformed, 1e-8, true, fast},
      {"hot", sheared, at(950.), 1e-7, true, fast, {900., 1500.}},
      {"near melting", sheared, at(1740.), 1e-7, true, fast, {1700., 1772.}},
      {"molten", sheared, at(1800.), 1e-7, true, fast, {1773.15}},
      {"coincident in plane",
       plane(1.02, 0., 0., 1.02, 0.96),
       {},
       1e-6,
       true,
       {1e3}},
      {"all coincident but rotated",
       plane(0.6, -0.8, 0.8, 0.6, 0.97),
       {},
       1e-6,
       true,
       {1e3}},
      {"axisymmetric", axisymmetric, deformed, 1e-7, true, fast},
      {"large strain",
       plane(1.8, 0.9, -0.2, 0.7, 0.9),
       deformed,
       1e-6,
       true,
       fast}};
  }



  void
  expect_exact_tangent(const MaterialLaw &law, const Branch &b)
  {
    SCOPED_TRACE(b.name);
    const MaterialResponse r = evaluate(law, b.F, b.old, b.dt);
    ASSERT_EQ(r.status, LawStatus::ok);
    ASSERT_EQ(r.plastic, b.plastic);
    if (b.plastic && b.dt > 0.)
      {
        const double rate =
          (r.state.plastic_strain - b.old.plastic_strain) / b.dt;
        ASSERT_GT(rate, b.rate.low);
        ASSERT_LT(rate, b.rate.high);
      }
    ASSERT_GE(r.state.temperature, b.temperature.low);
    ASSERT_LE(r.state.temperature, b.temperature.high);
    EXPECT_LT(tangent_error(law, b.F, b.old, b.dt), 1e-6);
  }
} // namespace



TEST(Tangent, every_branch_of_johnson_cook_agrees_with_finite_differences)
{
  const auto law = MaterialParameters().make_law();
  for (const Branch &branch : elastic_branches(*law))
    expect_exact_tangent(*law, branch);
  for (const Branch &branch : plastic_branches(*law))
    expect_exact_tangent(*law, branch);
}



TEST(Tangent, every_law_agrees_with_finite_differences)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      RandomDeformation random(1);
      for (int sample = 0; sample < 30; ++sample)
        {
          const Tensor<2, 3>  F1  = random.near(identity, 0.05);
          const MaterialState old = evaluate(*law, F1, {}, 1e-7).state;
          const Tensor<2, 3>  F2  = random.near(F1, 0.05);
          EXPECT_LT(tangent_error(*law, F2, old, 1e-7), 1e-6);
          EXPECT_LT(tangent_error(*law, identity, {}, 1e-7), 1e-6);
        }
    }
}



TEST(Tangent, is_major_symmetric)
{
  for (const auto &law : all_laws())
    {
      RandomDeformation random(2);
      for (int sample = 0; sample < 50; ++sample)
        {
          const Tensor<2, 3>     F1  = random.near(identity, 0.1);
          const MaterialState    old = evaluate(*law, F1, {}, 1e-7).state;
          const MaterialResponse r =
            evaluate(*law, random.near(F1, 0.1), old, 1e-7);
          for (const auto &[i, J] : components)
            for (const auto &[k, L] : components)
              EXPECT_NEAR(r.tangent[i][J][k][L],
                          r.tangent[k][L][i][J],
                          1e-13 * largest(r.tangent))
                << law->name();
        }
    }
}



TEST(Tangent, nearly_equal_stretches_join_the_equal_ones)
{
  const auto law = MaterialParameters().make_law();
  for (const double split :
       {0., 1e-16, 1e-12, 1e-8, 1e-5, 1e-3, 0.04, 0.05, 0.06})
    {
      const Tensor<2, 3> F = plane(1.02 + split, 0.3 * split, 0., 1.02, 0.96);
      EXPECT_LT(tangent_error(*law, F, {}, 1e-6), 1e-6) << split;
    }
}



TEST(Tangent, at_small_strain_is_hookes_law)
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
          const auto [i, J] = components[p];
          EXPECT_NEAR(r.P[i][J], 0., 1e-14 * E) << law->name();
          for (int q = 0; q < 5; ++q)
            {
              const auto [k, L] = components[q];
              EXPECT_NEAR(r.tangent[i][J][k][L], expected[p][q], 1e-13 * E)
                << law->name();
            }
        }
    }
}
