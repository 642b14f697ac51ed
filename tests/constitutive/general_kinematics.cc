#include <gtest/gtest.h>

#include "law_tools.h"

using namespace asperity;
using namespace asperity::law_tools;

// The laws where F is any: against their plane form and closed forms, and by
// what isotropy and frame indifference demand.
namespace
{
  /** The response in other axes, R of space and S of the material: P, the
   *  tangent and C_p^{-1} turn by the frame that each index belongs to. */
  MaterialResponse
  turned(const MaterialResponse &response,
         const Tensor<2, 3>     &R,
         const Tensor<2, 3>     &S)
  {
    MaterialResponse result = response;
    result.P                = R * response.P * transpose(S);
    result.state.Cp_inverse =
      symmetrize(S * Tensor<2, 3>(response.state.Cp_inverse) * transpose(S));
    Tensor<4, 3> half; // turned in its last two indices
    for (const auto &[i, J] : all_components)
      half[i][J] = R * response.tangent[i][J] * transpose(S);
    for (const auto &[k, L] : all_components)
      {
        Tensor<2, 3> dP;
        for (const auto &[i, J] : all_components)
          dP[i][J] = half[i][J][k][L];
        dP = R * dP * transpose(S);
        for (const auto &[i, J] : all_components)
          result.tangent[i][J][k][L] = dP[i][J];
      }
    return result;
  }



  /** Stress, tangent and state are the same, up to a share of the modulus. */
  void
  expect_equal(const MaterialLaw      &law,
               const MaterialResponse &a,
               const MaterialResponse &b)
  {
    const double tolerance = 1e-12;
    ASSERT_EQ(a.status, LawStatus::ok);
    ASSERT_EQ(b.status, LawStatus::ok);
    EXPECT_EQ(a.plastic, b.plastic);
    EXPECT_LT((a.P - b.P).norm(), tolerance * law.young_modulus());
    EXPECT_NEAR(a.mises, b.mises, tolerance * law.young_modulus());
    EXPECT_LT(largest(a.tangent - b.tangent), 1e-10 * largest(b.tangent));
    EXPECT_NEAR(a.state.plastic_strain, b.state.plastic_strain, tolerance);
    EXPECT_NEAR(a.state.temperature, b.state.temperature, 1e-9);
    EXPECT_LT((a.state.Cp_inverse - b.state.Cp_inverse).norm(), tolerance);
  }



  /** What every plane law answers of a response: no derivative by or of what a
   *  plane deformation has not. */
  MaterialResponse
  plane_part(MaterialResponse response)
  {
    const Tensor<4, 3> all = response.tangent;
    response.tangent       = Tensor<4, 3>();
    for (const auto &[i, J] : components)
      for (const auto &[k, L] : components)
        response.tangent[i][J][k][L] = all[i][J][k][L];
    return response;
  }
} // namespace



TEST(GeneralKinematics, of_a_plane_deformation_is_the_plane_law)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      RandomDeformation random(11);
      int               n_plastic = 0, n_elastic = 0;
      for (const double size : {1e-4, 1e-3, 0.1})
        for (const double step : {0., 1e-7, 1e3})
          for (int sample = 0; sample < 10; ++sample)
            {
              const Tensor<2, 3>  F1  = random.near(identity, 0.1);
              const MaterialState old = evaluate(*law, F1).state;
              const Tensor<2, 3>  F2  = random.near(F1, size);
              const auto          r   = evaluate_general(*law, F2, old, step);
              expect_equal(*law,
                           plane_part(r),
                           plane_part(evaluate(*law, F2, old, step)));
              ++(r.plastic ? n_plastic : n_elastic);
            }
      EXPECT_GT(n_elastic, 0);
      if (std::isfinite(law->shear_limit(0., 1., 293.15)))
        {
          EXPECT_GT(n_plastic, 0);
        }
    }
}



TEST(GeneralKinematics, equal_stretches_give_the_pressure_of_the_bulk_modulus)
{
  MaterialParameters parameters;
  for (const auto &law :
       {parameters.make_law(),
        (parameters.choose(HenckyParameters()), parameters.make_law())})
    {
      const double bulk =
        law->young_modulus() / (3. * (1. - 2. * law->poisson_ratio()));
      for (const double stretch : {0.5, 0.97, 1.04})
        {
          const auto r = evaluate_general(
            *law, plane(stretch, 0., 0., stretch, stretch), {}, short_step);
          EXPECT_FALSE(r.plastic);
          // tau = K ln J, P = tau/stretch
          const double expected = bulk * 3. * std::log(stretch) / stretch;
          EXPECT_LT((r.P - expected * identity).norm(),
                    1e-12 * std::abs(expected));
        }
    }
}



TEST(GeneralKinematics, stress_turns_with_the_frame_and_the_state_stays)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      RandomDeformation random(15);
      for (int sample = 0; sample < 20; ++sample)
        {
          const MaterialState    old = deformed_state_in_space(*law, random);
          const Tensor<2, 3>     F   = random.near_in_space(identity, 0.1);
          const Tensor<2, 3>     Q   = random.rotation();
          const MaterialResponse r = evaluate_general(*law, F, old, short_step);
          expect_equal(*law,
                       evaluate_general(*law, Q * F, old, short_step),
                       turned(r, Q, identity));
        }
    }
}



TEST(GeneralKinematics, the_material_is_isotropic)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      RandomDeformation random(16);
      for (int sample = 0; sample < 20; ++sample)
        {
          MaterialResponse start;
          start.state          = deformed_state_in_space(*law, random);
          const Tensor<2, 3> F = random.near_in_space(identity, 0.1);
          const Tensor<2, 3> Q = random.rotation();
          const auto r = evaluate_general(*law, F, start.state, short_step);
          expect_equal(*law,
                       evaluate_general(*law,
                                        F * transpose(Q),
                                        turned(start, identity, Q).state,
                                        short_step),
                       turned(r, identity, Q));
        }
    }
}



TEST(GeneralKinematics, shear_in_any_plane_of_axes_is_that_in_x_and_y)
{
  Tensor<2, 3> next_axes; // x, y, z become y, z, x
  next_axes[1][0] = next_axes[2][1] = next_axes[0][2] = 1.;
  for (const auto &law : all_laws())
    for (const Tensor<2, 3> &Q : {next_axes, next_axes * next_axes})
      {
        SCOPED_TRACE(law->name());
        MaterialResponse in_plane, r;
        for (int step = 1; step <= 20; ++step)
          {
            const Tensor<2, 3> F = plane(1., 0.03 * step, 0., 1., 1.);
            in_plane =
              plane_part(evaluate(*law, F, in_plane.state, short_step));
            r =
              evaluate_general(*law, Q * F * transpose(Q), r.state, short_step);
            expect_equal(*law,
                         plane_part(turned(r, transpose(Q), transpose(Q))),
                         in_plane);
          }
      }
}



TEST(GeneralKinematics, tension_along_any_axis_stays_on_the_yield_curve)
{
  const JohnsonCook  flow{JohnsonCookParameters()};
  MaterialParameters parameters;
  parameters.heating.adiabatic = false;
  const auto         law       = parameters.make_law();
  const Tensor<2, 3> Q         = RandomDeformation(17).rotation();
  const Tensor<2, 3> back      = transpose(Q);
  MaterialState      state;
  for (int i = 1; i <= 20; ++i)
    {
      const double     axial   = std::exp(0.02 * i);
      double           lateral = std::pow(axial, -0.4);
      Tensor<2, 3>     F;
      MaterialResponse r, along;
      for (int iteration = 0; iteration < 20; ++iteration)
        {
          F     = Q * plane(lateral, 0., 0., lateral, axial) * back;
          r     = evaluate_general(*law, F, state, short_step);
          along = turned(r, back, back);
          lateral -= along.P[0][0] /
                     (along.tangent[0][0][0][0] + along.tangent[0][0][1][1]);
        }
      const double rate =
        (r.state.plastic_strain - state.plastic_strain) / short_step;
      const double sigma =
        flow.evaluate(r.state.plastic_strain, rate, state.temperature).value;
      EXPECT_TRUE(r.plastic);
      EXPECT_NEAR(along.P[0][0], 0., 1.);
      EXPECT_NEAR(along.P[1][1], 0., 1.);
      EXPECT_NEAR(along.P[2][2] * axial, sigma, 1e-8 * sigma); // tau = P F^T
      EXPECT_NEAR(r.mises, sigma, 1e-9 * sigma);
      EXPECT_NEAR(mises_of(r.P, F), sigma, 1e-9 * sigma);
      EXPECT_NEAR(determinant(r.state.Cp_inverse), 1., 1e-14);
      state = r.state;
    }
}



TEST(GeneralKinematics, plastic_flow_heats_by_its_work)
{
  const auto   law = MaterialParameters().make_law();
  const double k   = HeatingParameters().temperature_per_work(law->density());
  RandomDeformation random(18);
  for (int sample = 0; sample < 20; ++sample)
    {
      const MaterialState    old = deformed_state_in_space(*law, random);
      const MaterialResponse r   = evaluate_general(
        *law, random.near_in_space(identity, 0.1), old, short_step);
      const double heat =
        k * r.mises * (r.state.plastic_strain - old.plastic_strain);
      EXPECT_GT(heat, 1.);
      EXPECT_NEAR(r.state.temperature, old.temperature + heat, 1e-9 * heat);
    }
}



TEST(GeneralKinematics, a_closed_elastic_cycle_returns_without_work)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      // A triangle of deformations; Simpson's rule on short chords, whose error
      // is far below that of a law without a potential.
      const Tensor<2, 3> A =
        RandomDeformation(19).near_in_space(Tensor<2, 3>(), 4e-4);
      const Tensor<2, 3> B =
        RandomDeformation(20).near_in_space(Tensor<2, 3>(), 4e-4);
      const Tensor<2, 3> corners[] = {identity,
                                      identity + A,
                                      identity + B,
                                      identity};
      MaterialResponse   r;
      double             work = 0., exchanged = 0.;
      constexpr int      n_chords = 20;
      for (int side = 0; side < 3; ++side)
        for (int chord = 0; chord < n_chords; ++chord)
          {
            const Tensor<2, 3> dF =
              (corners[side + 1] - corners[side]) / n_chords;
            for (const auto &[place, weight] :
                 {std::pair(0., 1.), std::pair(0.5, 4.), std::pair(1., 1.)})
              {
                r = evaluate_general(*law,
                                     corners[side] + (chord + place) * dF,
                                     r.state,
                                     1.);
                ASSERT_FALSE(r.plastic);
                const double part = scalar_product(r.P, dF) * weight / 6.;
                work += part;
                exchanged += std::abs(part);
              }
          }
      EXPECT_LT(r.P.norm(), 1e-12 * law->young_modulus());
      EXPECT_LT(std::abs(work), 1e-9 * exchanged);
    }
}



TEST(GeneralKinematics, an_inverted_point_is_known_and_a_turned_one_is_none)
{
  for (const auto &law : all_laws())
    {
      SCOPED_TRACE(law->name());
      const auto status = [&](const Tensor<2, 3> &F) {
        return evaluate_general(*law, F, {}, short_step).status;
      };
      RandomDeformation  random(21);
      const Tensor<2, 3> Q = random.rotation();
      EXPECT_EQ(status(Q * plane(1., 0., 0., -0.9, 1.)), LawStatus::inverted);
      EXPECT_EQ(status(-1. * Q), LawStatus::inverted);
      EXPECT_EQ(status(plane(1., 0., 0., 0., 1.)), LawStatus::inverted);
      EXPECT_EQ(status(plane(1., 0., 0., std::nan(""), 1.)),
                LawStatus::inverted);
      EXPECT_EQ(status(plane(1e200, 0., 0., 1e200, 1.)), LawStatus::inverted);
      // half a turn about x: F_33 < 0, which no plane deformation may have
      EXPECT_EQ(status(plane(1., 0., 0., -1., -1.)), LawStatus::ok);
    }
}
