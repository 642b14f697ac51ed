#include <gtest/gtest.h>

#include "law_tools.h"

using namespace asperity;
using namespace asperity::law_tools;

namespace
{
  /** Q A for the in-plane part, Q a rotation by the angle. */
  PlaneTensor
  rotate_left(const double angle, const PlaneTensor &A)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return {{c * A[0] - s * A[2],
             c * A[1] - s * A[3],
             s * A[0] + c * A[2],
             s * A[1] + c * A[3],
             A[4]}};
  }



  /** A Q^T for the in-plane part. */
  PlaneTensor
  rotate_right(const double angle, const PlaneTensor &A)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return {{c * A[0] - s * A[1],
             s * A[0] + c * A[1],
             c * A[2] - s * A[3],
             s * A[2] + c * A[3],
             A[4]}};
  }



  std::array<double, 4>
  rotated(const double angle, const std::array<double, 4> &C)
  {
    const PlaneTensor full = {{C[0], C[2], C[2], C[1], C[3]}};
    const PlaneTensor r    = rotate_left(angle, rotate_right(angle, full));
    return {{r[0], r[3], r[1], r[4]}};
  }
} // namespace



TEST(Invariance, StressTurnsWithTheFrameAndTheStateStays)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      RandomDeformation random(3);
      for (int i = 0; i < 50; ++i)
        {
          const PlaneTensor      F1    = random.near(identity, 0.1);
          const PlaneTensor      F2    = random.near(F1, 0.1);
          const double           angle = 3. * random.number();
          const MaterialState    old   = evaluate(*law, F1, {}, 1e-7).state;
          const MaterialResponse r     = evaluate(*law, F2, old, 1e-7);
          const MaterialResponse turned =
            evaluate(*law, rotate_left(angle, F2), old, 1e-7);
          const PlaneTensor expected = rotate_left(angle, r.P);
          const double      E        = law->young_modulus();
          for (int p = 0; p < 5; ++p)
            EXPECT_NEAR(turned.P[p], expected[p], 1e-13 * E);
          EXPECT_EQ(turned.plastic, r.plastic);
          EXPECT_NEAR(turned.mises, r.mises, 1e-13 * E);
          EXPECT_NEAR(turned.state.plastic_strain,
                      r.state.plastic_strain,
                      1e-13);
          for (int c = 0; c < 4; ++c)
            EXPECT_NEAR(turned.state.Cp_inverse[c],
                        r.state.Cp_inverse[c],
                        1e-13);

          // dP_iJ/dF_kL turns in i and k
          PlaneTangent half, full;
          for (int q = 0; q < 5; ++q)
            {
              PlaneTensor column;
              for (int p = 0; p < 5; ++p)
                column[p] = r.tangent[p][q];
              column = rotate_left(angle, column);
              for (int p = 0; p < 5; ++p)
                half[p][q] = column[p];
            }
          for (int p = 0; p < 5; ++p)
            full[p] = rotate_left(angle, half[p]);
          for (int p = 0; p < 5; ++p)
            for (int q = 0; q < 5; ++q)
              EXPECT_NEAR(turned.tangent[p][q],
                          full[p][q],
                          1e-12 * largest(r.tangent));
        }
    }
}



TEST(Invariance, TheMaterialIsIsotropic)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      RandomDeformation random(4);
      for (int i = 0; i < 50; ++i)
        {
          const PlaneTensor      F1    = random.near(identity, 0.1);
          const PlaneTensor      F2    = random.near(F1, 0.1);
          const double           angle = 3. * random.number();
          const MaterialState    old   = evaluate(*law, F1, {}, 1e-7).state;
          const MaterialResponse r     = evaluate(*law, F2, old, 1e-7);
          MaterialState          old_turned = old;
          old_turned.Cp_inverse             = rotated(angle, old.Cp_inverse);
          const MaterialResponse turned =
            evaluate(*law, rotate_right(angle, F2), old_turned, 1e-7);
          const PlaneTensor expected = rotate_right(angle, r.P);
          for (int p = 0; p < 5; ++p)
            EXPECT_NEAR(turned.P[p], expected[p], 1e-13 * law->young_modulus());
        }
    }
}



TEST(Invariance, ARigidRotationAfterPlasticFlowChangesNothing)
{
  const auto        law   = make_material_law(MaterialParameters());
  const PlaneTensor F     = {{1.1, 0.2, -0.1, 0.95, 1.}};
  MaterialState     state = evaluate(*law, F, {}, 1e6).state;
  for (int step = 1; step <= 100; ++step)
    {
      const PlaneTensor      turned = rotate_left(0.1 * step, F);
      const MaterialResponse r      = evaluate(*law, turned, state, 1e6);
      ASSERT_FALSE(r.plastic) << step;
      state = r.state;
    }
}
