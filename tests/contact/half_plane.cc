#include <gtest/gtest.h>

#include <cmath>

#include "contact_examples.h"

namespace
{
  using namespace asperity;

  class HalfPlaneContact : public testing::TestWithParam<ContactFormulation>
  {
  protected:
    HalfPlaneContact()
    {
      discretization.formulation    = GetParam();
      discretization.penalty_factor = 10.;
    }

    example::Discretization discretization;
  };

  TEST_P(HalfPlaneContact, hertz_cylinder_has_peak_pressure_and_half_width)
  {
    example::HalfPlane body = example::hertz(discretization);
    ASSERT_TRUE(std::isfinite(body.problem->press(body.force, body.depth)))
      << body.problem->last.reason;
    const ContactState<2> state  = body.problem->contact->state();
    const double          length = 96.;
    EXPECT_NEAR(state.max_pressure,
                example::hertz_pressure(body, 0.),
                0.01 * example::hertz_pressure(body, 0.));
    EXPECT_NEAR(0.5 * length * state.contact_fraction, 1., body.element_length);
    // <x^2> = a^2/4 of the semi-ellipse: the half-width without the grid.
    const double half_width =
      2. * std::sqrt(example::pressure_mean(*body.problem, [](const double x) {
        return x * x;
      }));
    EXPECT_NEAR(half_width, 1., 0.01);
    EXPECT_LT(example::pressure_error(*body.problem,
                                      2.,
                                      [&](const double x) {
                                        return example::hertz_pressure(body, x);
                                      }),
              0.03);
    EXPECT_LT(std::abs(state.force[0]), 1e-6 * body.force);
  }

  TEST_P(HalfPlaneContact, wavy_surface_follows_westergaard)
  {
    discretization.resolution = 128.;
    example::Westergaard wave(discretization);
    for (const double a : {0.1, 0.2, 0.25, 0.3})
      {
        ASSERT_TRUE(wave.press(a)) << wave.problem->last.reason;
        EXPECT_NEAR(wave.half_width(), a, 0.01 * a) << a;
        // <sin^2> = sin^2(pi a)/4: the half-width without the grid.
        const double s2 =
          example::pressure_mean(*wave.problem, [](const double x) {
            return std::pow(std::sin(M_PI * x), 2);
          });
        EXPECT_NEAR(std::asin(2. * std::sqrt(s2)) / M_PI, a, 0.01 * a) << a;
        const double gap = example::Westergaard::exact_mean_gap(a);
        EXPECT_NEAR(wave.mean_gap(), gap, 0.015 * gap) << a;
        EXPECT_LT(example::pressure_error(*wave.problem,
                                          0.5,
                                          [&](const double x) {
                                            return wave.exact_pressure(a, x);
                                          }),
                  0.04)
          << a;
      }
  }

  TEST(MortarContact,
       fraction_is_that_of_the_touching_zone_for_a_hard_penalty_too)
  {
    // Points within a hard contact open and close at random.
    example::Discretization discretization;
    discretization.penalty_factor = 1000.;
    discretization.resolution     = 128.;
    example::Westergaard wave(discretization);
    for (const double a : {0.1, 0.25})
      {
        ASSERT_TRUE(wave.press(a)) << wave.problem->last.reason;
        EXPECT_NEAR(wave.half_width(), a, wave.element_length) << a;
      }
  }

  TEST_P(HalfPlaneContact, augmentation_removes_what_a_soft_penalty_penetrates)
  {
    discretization.resolution     = 64.;
    discretization.penalty_factor = 0.3;
    example::Westergaard wave(discretization);
    ASSERT_TRUE(wave.press(0.25)) << wave.problem->last.reason;
    const double soft = wave.problem->contact->state().constraint_violation;
    double       last = soft;
    for (unsigned int k = 0; k < 20; ++k)
      {
        wave.problem->contact->augment();
        ASSERT_TRUE(wave.problem->solve(0., -wave.depth).converged);
        const double now = wave.problem->contact->state().constraint_violation;
        if (k < 6)
          {
            EXPECT_LT(now, last) << k;
          }
        last = now;
      }
    EXPECT_LT(last, 5e-3 * soft);

    // At a fixed depth the force tends to that of a hard contact.
    const double augmented        = wave.problem->force();
    discretization.penalty_factor = 1e4;
    example::Westergaard hard(discretization);
    ASSERT_TRUE(hard.problem->solve(0., -wave.depth).converged);
    EXPECT_NEAR(augmented, hard.problem->force(), 0.002 * augmented);
  }

  INSTANTIATE_TEST_SUITE_P(,
                           HalfPlaneContact,
                           testing::Values(ContactFormulation::mortar,
                                           ContactFormulation::gauss_point),
                           [](const auto &info) {
                             return info.param == ContactFormulation::mortar ?
                                      "Mortar" :
                                      "GaussPoint";
                           });
} // namespace
