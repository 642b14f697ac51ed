#include <gtest/gtest.h>

#include "law_tools.h"

using namespace asperity;
using namespace asperity::law_tools;

TEST(ShearLimit, of_johnson_cook_is_its_flow_stress_over_the_root_of_three)
{
  JohnsonCookParameters p;
  p.A                      = 300e6;
  p.B                      = 400e6;
  p.n                      = 0.5;
  p.C                      = 0.02;
  p.reference_rate         = 1.;
  p.m                      = 2.;
  p.transition_temperature = 300.;
  p.melting_temperature    = 1300.;
  MaterialParameters material;
  material.choose(p);
  // (300 + 400 sqrt(0.25)) MPa (1 + 0.02 ln(e^5)) (1 - 0.5^2)
  EXPECT_NEAR(material.make_law()->shear_limit(0.25, std::exp(5.), 800.),
              500e6 * 1.1 * 0.75 / std::sqrt(3.),
              1e-6);
}



TEST(ShearLimit, of_voce_depends_on_strain_alone)
{
  MaterialParameters material;
  material.choose(VoceParameters{450e6, 715e6, 16.93, 129e6});
  const auto law = material.make_law();
  EXPECT_NEAR(law->shear_limit(0., 1., 300.), 450e6 / std::sqrt(3.), 1e-6);
  EXPECT_NEAR(law->shear_limit(10., 1., 300.), 2005e6 / std::sqrt(3.), 1e-6);
  EXPECT_EQ(law->shear_limit(0.3, 1e6, 900.), law->shear_limit(0.3, 1., 300.));
}



TEST(ShearLimit, is_reached_in_flow_and_infinite_for_elastic_laws)
{
  // so slow that no law feels the rate
  Tensor<2, 3> F = identity;
  F[0][1]        = 0.1;
  for (const auto &law : all_laws())
    {
      const MaterialResponse r = evaluate(*law, F, {}, 1e9);
      const double           k =
        law->shear_limit(r.state.plastic_strain, 0., r.state.temperature);
      if (r.plastic)
        EXPECT_NEAR(r.mises / std::sqrt(3.), k, 1e-9 * k) << law->name();
      else
        EXPECT_EQ(k, std::numeric_limits<double>::infinity()) << law->name();
    }
}



// Exported laws know no more than hardening_law() of the plastic strain.
TEST(ShearLimit, of_Johnson_and_Cook_depends_on_strain_by_the_hardening_alone)
{
  unsigned int n = 0;
  for (const auto &law : all_laws())
    if (const auto hardening = law->hardening_law())
      {
        ++n;
        const double k_0 = law->shear_limit(0., 1e3, 500.);
        for (const double strain : {1e-3, 0.2, 1.9, 30.})
          {
            const ValueAndSlope factor = hardening->factor(strain);
            EXPECT_NEAR(law->shear_limit(strain, 1e3, 500.),
                        factor.value * k_0,
                        1e-12 * k_0);
            EXPECT_NEAR(factor.slope,
                        (hardening->factor(strain + 1e-6).value -
                         hardening->factor(strain - 1e-6).value) /
                          2e-6,
                        1e-4 * factor.slope);
          }
      }
  EXPECT_GT(n, 0u);
}



// Exported laws and messages about melting know no more than softening().
TEST(ShearLimit, depends_on_temperature_by_the_softening_alone)
{
  for (const auto &law : all_laws())
    {
      const double k_0 = law->shear_limit(0.3, 1e3, 0.);
      if (!std::isfinite(k_0))
        {
          EXPECT_FALSE(law->softening()) << law->name();
          continue;
        }
      for (const double T : {200., 500., 1100., 1700., 1900.})
        {
          const double factor =
            law->softening() ? law->softening()->factor(T).value : 1.;
          EXPECT_NEAR(law->shear_limit(0.3, 1e3, T), factor * k_0, 1e-12 * k_0)
            << law->name() << ' ' << T;
        }
    }
}
