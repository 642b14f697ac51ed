#include <asperity/constitutive/return_map.h>

#include <gtest/gtest.h>

#include <sstream>

#include "law_tools.h"

using namespace asperity;
using namespace asperity::law_tools;

namespace
{
  constexpr double zero_celsius = 273.15;

  /** chi/(rho c_p) of the default steel [K/Pa]. */
  constexpr double heating = 0.9 / (7800. * 450.);



  /** dF F, dF being a shear and a stretch of equivalent strain about e. */
  Tensor<2, 3>
  strained(const Tensor<2, 3> &F, const double e)
  {
    const double k = 0.6 * e;
    const double s = 0.8 * e;
    return plane(std::exp(k), s, 0.1 * s, std::exp(-k), 1.) * F;
  }
} // namespace



TEST(ReturnMap, never_fails_over_rates_temperatures_and_increments)
{
  const auto        law = MaterialParameters().make_law();
  const JohnsonCook flow{JohnsonCookParameters()};
  const double      three_mu  = 3. * ElasticParameters().shear_modulus();
  int               n_plastic = 0, n_elastic = 0;
  double            worst = 0.;
  for (double rate = 1e-6; rate < 2e9; rate *= 10.)
    for (double celsius = 20.; celsius <= 1600.; celsius += 79.)
      for (double increment = 1e-8; increment < 2.; increment *= 10.)
        for (const double plastic_strain : {0., 0.02})
          {
            SCOPED_TRACE(testing::Message()
                         << "rate " << rate << ", " << celsius
                         << " degC, increment " << increment
                         << ", plastic strain " << plastic_strain);
            MaterialState old;
            old.temperature    = celsius + zero_celsius;
            old.plastic_strain = plastic_strain;
            // from the yield surface
            const Tensor<2, 3> at_yield = isochoric_stretch(
              flow.static_value(plastic_strain, old.temperature) / three_mu);
            const Tensor<2, 3> F     = strained(at_yield, increment);
            const double       dt    = increment / rate;
            const double       scale = std::fmin(increment, 1e-2);

            const MaterialResponse r = evaluate(*law, F, old, dt);
            ASSERT_EQ(r.status, LawStatus::ok);
            ASSERT_TRUE(std::isfinite(r.mises));
            ASSERT_GE(r.state.plastic_strain, old.plastic_strain);
            ASSERT_GE(r.state.temperature, old.temperature);
            (r.plastic ? n_plastic : n_elastic) += 1;

            // A step must be short compared with the increment, shorter still
            // next to a kink of the law, but not so short that round-off shows.
            double error = tangent_error(*law, F, old, dt, 0.4 * scale);
            for (double step = 0.2; step > 1e-4 && error > 1e-7; step *= 0.5)
              error =
                std::fmin(error, tangent_error(*law, F, old, dt, step * scale));
            worst = std::fmax(worst, error);
            EXPECT_LT(error, 1e-6);
          }
  std::ostringstream text;
  text << worst;
  RecordProperty("worst_tangent_error", text.str());
  EXPECT_GT(n_plastic, 5000);
}



TEST(ReturnMap, ends_on_the_yield_surface_and_heats_by_the_plastic_work)
{
  const auto        law = MaterialParameters().make_law();
  const JohnsonCook flow{JohnsonCookParameters()};
  RandomDeformation random(5);
  int               n_plastic = 0;
  for (const double dt : {1e-9, 1e-6, 1., 1e6})
    {
      Tensor<2, 3>  F = identity;
      MaterialState state;
      for (int step = 0; step < 300; ++step)
        {
          F                        = random.near(F, 0.01);
          const MaterialResponse r = evaluate(*law, F, state, dt);
          ASSERT_EQ(r.status, LawStatus::ok);
          EXPECT_NEAR(mises_of(r.P, F), r.mises, 1e-11 * r.mises + 1e-3);
          if (r.plastic)
            {
              ++n_plastic;
              const double increment =
                r.state.plastic_strain - state.plastic_strain;
              const double expected = flow
                                        .evaluate(r.state.plastic_strain,
                                                  increment / dt,
                                                  r.state.temperature)
                                        .value;
              // the increment is known to round-off of the strain only
              const double rate_error =
                2e-16 * r.state.plastic_strain / increment;
              EXPECT_NEAR(r.mises, expected, (1e-9 + rate_error) * expected);
              EXPECT_NEAR(r.state.temperature - state.temperature,
                          heating * r.mises * increment,
                          1e-10);
            }
          else
            EXPECT_LE(r.mises,
                      (1. + 1e-10) * flow.static_value(state.plastic_strain,
                                                       state.temperature));
          state = r.state;
        }
    }
  EXPECT_GT(n_plastic, 300);
}



TEST(ReturnMap, plastic_flow_keeps_the_volume)
{
  for (const auto &law : all_laws())
    {
      RandomDeformation random(6);
      Tensor<2, 3>      F = identity;
      MaterialState     state;
      for (int step = 0; step < 2000; ++step)
        {
          F     = random.near(F, 0.005);
          state = evaluate(*law, F, state, 1e-7).state;
        }
      EXPECT_NEAR(determinant(state.Cp_inverse), 1., 1e-12) << law->name();
    }
}



TEST(ReturnMap, a_step_that_does_not_move_does_not_yield_again)
{
  const auto        law = MaterialParameters().make_law();
  RandomDeformation random(7);
  for (int i = 0; i < 100; ++i)
    {
      const Tensor<2, 3>     F = random.near(identity, 0.3);
      const MaterialResponse r = evaluate(*law, F, {}, 1e9);
      ASSERT_TRUE(r.plastic);
      MaterialState state = r.state;
      for (int repeat = 0; repeat < 10; ++repeat)
        {
          const MaterialResponse again = evaluate(*law, F, state, 1e9);
          ASSERT_FALSE(again.plastic);
          EXPECT_EQ(again.state.plastic_strain, r.state.plastic_strain);
          state = again.state;
        }
    }
}



TEST(ReturnMap,
     held_after_a_fast_step_the_stress_relaxes_to_the_static_flow_stress)
{
  const auto         law = MaterialParameters().make_law();
  const JohnsonCook  flow{JohnsonCookParameters()};
  const Tensor<2, 3> F  = isochoric_stretch(0.05);
  MaterialResponse   r  = evaluate(*law, F, {}, 1e-7);
  double             dt = 1e-7;
  for (int step = 0; step < 40; ++step, dt *= 2.)
    {
      const double before = r.mises;
      r                   = evaluate(*law, F, r.state, dt);
      const double at_rest =
        flow.static_value(r.state.plastic_strain, r.state.temperature);
      EXPECT_LE(r.mises, before * (1. + 1e-12));
      EXPECT_GE(r.mises, at_rest * (1. - 1e-12));
    }
  EXPECT_NEAR(r.mises,
              flow.static_value(r.state.plastic_strain, r.state.temperature),
              1e-9 * r.mises);
}



TEST(ReturnMap, turns_inside_out_or_not_a_number_is_a_status)
{
  const double                    nan = std::nan(""), infinity = INFINITY;
  const std::vector<Tensor<2, 3>> impossible = {
    plane(-1., 0., 0., 1., 1.),
    plane(1., 2., 1., 1., 1.),
    plane(1., 1., 1., 1., 1.),
    plane(1., 0., 0., 1., 0.),
    plane(1., 0., 0., 1., -1.),
    plane(-1., 0., 0., 1., -1.),
    plane(0., 0., 0., 0., 0.),
    plane(nan, 0., 0., 1., 1.),
    plane(1., 0., nan, 1., 1.),
    plane(1., 0., 0., 1., nan),
    plane(infinity, 0., 0., 1., 1.),
    plane(1., 0., 0., 1., infinity)};
  for (const auto &law : all_laws())
    for (const Tensor<2, 3> &F : impossible)
      EXPECT_EQ(evaluate(*law, F).status, LawStatus::inverted)
        << law->name() << ' ' << F[0] << ' ' << F[1] << ' ' << F[2] << ' '
        << F[3] << ' ' << F[4];
}



TEST(ReturnMap, needs_few_evaluations_of_the_flow_stress)
{
  const JohnsonCook flow{JohnsonCookParameters()};
  const double      three_mu = 3. * ElasticParameters().shear_modulus();
  int               total = 0, worst = 0, n = 0;
  for (const double plastic_strain : {1e-4, 0.01, 0.3})
    for (const double increment : {1e-5, 1e-4, 1e-3, 1e-2, 0.1})
      for (const double rate : {1e2, 1e5, 1e7})
        {
          const double static_stress = flow.static_value(plastic_strain, 400.);
          const ReturnSolution<> solution =
            solve_return(flow,
                         ReturnProblem<>{static_stress + three_mu * increment,
                                         three_mu,
                                         plastic_strain,
                                         400.,
                                         rate / increment,
                                         heating},
                         static_stress);
          ASSERT_TRUE(solution.found);
          total += solution.evaluations;
          worst = std::max(worst, solution.evaluations);
          ++n;
        }
  EXPECT_LE(worst, 15);
  EXPECT_LE(total, 6 * n);
}



TEST(ReturnMap, starts_from_a_guess_and_finds_the_same_root)
{
  const JohnsonCook flow{JohnsonCookParameters()};
  const double      three_mu = 3. * ElasticParameters().shear_modulus();
  const double      nan      = std::numeric_limits<double>::quiet_NaN();
  for (const double increment : {1e-5, 1e-3, 0.1})
    {
      const double    static_stress = flow.static_value(0.01, 400.);
      ReturnProblem<> problem{static_stress + three_mu * increment,
                              three_mu,
                              0.01,
                              400.,
                              1e5 / increment,
                              heating};
      const double root = solve_return(flow, problem, static_stress).increment;
      for (const double guess :
           {root, 1.1 * root, 0.01 * root, 1e3, 1e-300, -1., nan})
        {
          problem.guess = guess;
          const ReturnSolution<> solution =
            solve_return(flow, problem, static_stress);
          ASSERT_TRUE(solution.found);
          EXPECT_NEAR(solution.increment, root, 1e-11 * root) << guess;
          EXPECT_TRUE(guess != root || solution.evaluations == 1);
        }
    }
}



TEST(ReturnMap, points_together_answer_as_each_alone)
{
  const std::vector<Tensor<2, 3>> F = {plane(1., 0., 0., 1., 1.),
                                       isochoric_stretch(0.3),
                                       plane(1., 1e-4, 0., 1., 1.),
                                       plane(-1., 0., 0., 1., 1.),
                                       plane(1.5, 2., 0.1, 0.9, 1.1),
                                       isochoric_stretch(0.01),
                                       plane(0.7, 0., 0., 0.7, 0.7)};
  for (const auto &law : all_laws())
    for (unsigned int n = 1; n <= F.size(); ++n)
      {
        const std::vector<MaterialState> old(n);
        std::vector<MaterialResponse>    together(n);
        law->evaluate_points(
          n, F.data(), old.data(), 1e-6, true, together.data());
        for (unsigned int q = 0; q < n; ++q)
          {
            MaterialResponse alone;
            law->evaluate(F[q], old[q], 1e-6, true, alone);
            ASSERT_EQ(together[q].status, alone.status) << law->name() << q;
            if (alone.status != LawStatus::ok)
              continue;
            EXPECT_EQ(together[q].plastic, alone.plastic);
            EXPECT_LE((together[q].P - alone.P).norm(), 1e-12 * alone.P.norm());
            EXPECT_LE((together[q].tangent - alone.tangent).norm(),
                      1e-12 * alone.tangent.norm());
            EXPECT_NEAR(together[q].state.plastic_strain,
                        alone.state.plastic_strain,
                        1e-13);
          }
      }
}
