#include <gtest/gtest.h>

#include "law_tools.h"

using namespace asperity;
using namespace asperity::law_tools;

namespace
{
  /** In the plane, by an angle [rad]. */
  Tensor<2, 3>
  rotation(const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return plane(c, -s, s, c, 1.);
  }
} // namespace



TEST(Invariance, stress_turns_with_the_frame_and_the_state_stays)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      RandomDeformation random(3);
      for (int sample = 0; sample < 50; ++sample)
        {
          const Tensor<2, 3>     F1       = random.near(identity, 0.1);
          const Tensor<2, 3>     F2       = random.near(F1, 0.1);
          const Tensor<2, 3>     Q        = rotation(3. * random.number());
          const MaterialState    old      = evaluate(*law, F1, {}, 1e-7).state;
          const MaterialResponse r        = evaluate(*law, F2, old, 1e-7);
          const MaterialResponse turned   = evaluate(*law, Q * F2, old, 1e-7);
          const Tensor<2, 3>     expected = Q * r.P;
          const double           E        = law->young_modulus();
          for (const auto &[i, J] : components)
            EXPECT_NEAR(turned.P[i][J], expected[i][J], 1e-13 * E);
          EXPECT_EQ(turned.plastic, r.plastic);
          EXPECT_NEAR(turned.mises, r.mises, 1e-13 * E);
          EXPECT_NEAR(turned.state.plastic_strain,
                      r.state.plastic_strain,
                      1e-13);
          EXPECT_LT((turned.state.Cp_inverse - r.state.Cp_inverse).norm(),
                    1e-13);

          // dP_iJ/dF_kL turns in i and k
          for (const auto &[i, J] : components)
            for (const auto &[k, L] : components)
              {
                double entry = 0.;
                for (int m = 0; m < 3; ++m)
                  for (int n = 0; n < 3; ++n)
                    entry += Q[i][m] * Q[k][n] * r.tangent[m][J][n][L];
                EXPECT_NEAR(turned.tangent[i][J][k][L],
                            entry,
                            1e-12 * largest(r.tangent));
              }
        }
    }
}



TEST(Invariance, the_material_is_isotropic)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      RandomDeformation random(4);
      for (int sample = 0; sample < 50; ++sample)
        {
          const Tensor<2, 3>     F1  = random.near(identity, 0.1);
          const Tensor<2, 3>     F2  = random.near(F1, 0.1);
          const Tensor<2, 3>     Q   = rotation(3. * random.number());
          const MaterialState    old = evaluate(*law, F1, {}, 1e-7).state;
          const MaterialResponse r   = evaluate(*law, F2, old, 1e-7);
          MaterialState          old_turned = old;
          old_turned.Cp_inverse =
            symmetrize(Q * Tensor<2, 3>(old.Cp_inverse) * transpose(Q));
          const MaterialResponse turned =
            evaluate(*law, F2 * transpose(Q), old_turned, 1e-7);
          const Tensor<2, 3> expected = r.P * transpose(Q);
          for (const auto &[i, J] : components)
            EXPECT_NEAR(turned.P[i][J],
                        expected[i][J],
                        1e-13 * law->young_modulus());
        }
    }
}



TEST(Invariance, a_rigid_rotation_after_plastic_flow_changes_nothing)
{
  const auto         law   = MaterialParameters().make_law();
  const Tensor<2, 3> F     = plane(1.1, 0.2, -0.1, 0.95, 1.);
  MaterialState      state = evaluate(*law, F, {}, 1e6).state;
  for (int step = 1; step <= 100; ++step)
    {
      const Tensor<2, 3>     turned = rotation(0.1 * step) * F;
      const MaterialResponse r      = evaluate(*law, turned, state, 1e6);
      ASSERT_FALSE(r.plastic) << step;
      state = r.state;
    }
}
