#include <gtest/gtest.h>

#include "law_tools.h"

using namespace asperity;
using namespace asperity::law_tools;

// dP/dF of every component by every other, where F is any.
namespace
{
  double
  general_tangent_error(const MaterialLaw   &law,
                        const Tensor<2, 3>  &F,
                        const MaterialState &old)
  {
    return tangent_error(
      [&](const Tensor<2, 3> &any_F) {
        return evaluate_general(law, any_F, old, short_step);
      },
      all_components,
      F);
  }
} // namespace



TEST(GeneralTangent, agrees_with_finite_differences)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      const bool yields = std::isfinite(law->shear_limit(0., 1., 293.15));
      RandomDeformation random(12);
      for (int sample = 0; sample < 5; ++sample)
        {
          const MaterialState old = deformed_state_in_space(*law, random);
          const Tensor<2, 3>  F   = random.near_in_space(identity, 0.1);
          EXPECT_EQ(evaluate_general(*law, F, old, short_step).plastic, yields);
          EXPECT_LT(general_tangent_error(*law, F, old), 1e-6);
        }
    }
}



TEST(GeneralTangent, of_unloading_agrees_with_finite_differences)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      RandomDeformation random(13);
      for (int sample = 0; sample < 5; ++sample)
        {
          // From the yield surface to an elastic strain of half its size: F^T F
          // halfway between C and C_p, turned.
          const Tensor<2, 3>  F1 = random.near_in_space(identity, 0.05);
          const MaterialState old =
            evaluate_general(*law, F1, {}, short_step).state;
          const Tensor<2, 3> C =
            0.5 * (transpose(F1) * F1 + Tensor<2, 3>(invert(old.Cp_inverse)));
          const auto axes =
            eigenvectors(symmetrize(C),
                         dealii::SymmetricTensorEigenvectorMethod::jacobi);
          Tensor<2, 3> U;
          for (const auto &[square, axis] : axes)
            U += std::sqrt(square) * outer_product(axis, axis);
          const Tensor<2, 3> F = random.rotation() * U;
          EXPECT_FALSE(evaluate_general(*law, F, old, short_step).plastic);
          EXPECT_LT(general_tangent_error(*law, F, old), 1e-6);
        }
    }
}



TEST(GeneralTangent, is_exact_where_stretches_coincide)
{
  RandomDeformation random(14);
  for (const auto &law : all_laws())
    for (const double stretch : {1.0004, 1.03}) // elastic, plastic
      for (const double split : {0., 1e-15, 1e-10, 1e-6, 1e-4, 1e-2})
        for (const Tensor<2, 3> &U :
             {plane(stretch + split, 0., 0., stretch, 1.),
              plane(1., 0., 0., stretch + split, stretch),
              plane(stretch, 0., 0., 1., stretch + split),
              plane(1., 0., 0., 1. + split, 1. - split),
              plane(stretch, 0., 0., stretch + split, stretch - split)})
          {
            const Tensor<2, 3> Q = random.rotation();
            const Tensor<2, 3> F = random.rotation() * U * Q;
            EXPECT_LT(general_tangent_error(*law, F, {}), 1e-6)
              << law->name() << ", " << U;
          }
}



TEST(GeneralTangent, at_small_strain_is_hookes_law)
{
  for (const auto &law : all_laws())
    {
      const double           E      = law->young_modulus();
      const double           nu     = law->poisson_ratio();
      const double           mu     = E / (2. * (1. + nu));
      const double           lambda = E * nu / ((1. + nu) * (1. - 2. * nu));
      const MaterialResponse r      = evaluate_general(*law, identity);
      const Tensor<2, 3>    &I      = identity;
      EXPECT_LT(r.P.norm(), 1e-14 * E);
      for (const auto &[i, J] : all_components)
        for (const auto &[k, L] : all_components)
          EXPECT_NEAR(r.tangent[i][J][k][L],
                      lambda * I[i][J] * I[k][L] +
                        mu * (I[i][k] * I[J][L] + I[i][L] * I[J][k]),
                      1e-13 * E)
            << law->name();
    }
}
