#include <asperity/constitutive/hyperelasticity.h>

#include <gtest/gtest.h>

#include <cmath>

#include "contact_examples.h"

namespace
{
  using namespace asperity;

  class Sliding : public testing::TestWithParam<ContactFormulation>
  {};

  /** A skew wave, so that the lateral force has no symmetry. */
  double
  skew_wave(const double x)
  {
    return 0.02 * (1.4 - std::cos(2. * M_PI * x) -
                   0.4 * std::sin(4. * M_PI * x + 0.3));
  }

  TEST_P(Sliding, frictionless_loop_conserves_energy)
  {
    ElasticParameters elasticity;
    elasticity.young_modulus = 1.;
    ContactOptions options;
    options.formulation = GetParam();
    options.penalty     = 100.;
    const auto space    = std::make_shared<SplineSpace<2>>(
      KnotVector(2, example::equal_steps(0., 1., 20), true),
      KnotVector(2, example::equal_steps(-0.5, 0., 6)));
    // The body has a wave, too: the asperities push each other aside.
    const auto geometry =
      PatchGeometry<2>::from_map(*space, [](const dealii::Point<2> &p) {
        return dealii::Point<2>(p[0],
                                p[1] + (0.02 + 0.04 * p[1]) *
                                         (std::cos(2. * M_PI * p[0]) - 1.));
      });
    example::ContactProblem problem(space,
                                    std::make_shared<NeoHooke>(elasticity),
                                    example::periodic_tool(skew_wave, 1., 48),
                                    options,
                                    example::Support::clamped_bottom,
                                    geometry);
    problem.options.tolerance = 1e-10;
    for (unsigned int k = 1; k <= 4; ++k)
      ASSERT_TRUE(problem.solve(0., -0.012 * k).converged)
        << problem.last.reason;
    const auto         start   = problem.contact->state().force;
    const unsigned int n_steps = 100;
    double             work = 0., absolute_work = 0.;
    for (unsigned int k = 1; k <= n_steps; ++k)
      {
        ASSERT_TRUE(problem.solve(double(k) / n_steps, -0.048).converged)
          << problem.last.reason;
        const double T_x = problem.contact->state().force[0];
        work += T_x / n_steps;
        absolute_work += std::abs(T_x) / n_steps;
      }
    // The trapezoidal rule over a period; the lateral force does work both ways
    // on the way but none in the sum, and the end is the start.
    EXPECT_GT(absolute_work, 1e-4);
    EXPECT_LT(std::abs(work), 2e-3 * absolute_work);
    const auto end = problem.contact->state().force;
    EXPECT_LT((end - start).norm(), 1e-7 * start.norm());
  }

  /** Rms of the force over one element, over the mean vertical force. */
  double
  ripple(const ContactFormulation formulation,
         const unsigned int       degree,
         const double             resolution)
  {
    example::Discretization discretization;
    discretization.formulation    = formulation;
    discretization.degree         = degree;
    discretization.resolution     = resolution;
    const example::Ironing result = example::ironing(discretization, 8);
    EXPECT_TRUE(result.converged) << degree;
    return std::hypot(result.vertical_ripple, result.lateral_ripple);
  }

  TEST_P(Sliding, ironing_ripple_falls_as_the_mesh_is_refined)
  {
    const double coarse = ripple(GetParam(), 2, 16.);
    EXPECT_LT(coarse, 0.01);
    EXPECT_LT(ripple(GetParam(), 2, 32.), coarse / 3.);
  }

  TEST_P(Sliding, ironing_without_an_edge_of_contact_has_no_ripple)
  {
    // All of the ripple comes from the edge of contact passing the elements:
    // where everything touches, forces are those of smooth integrands.
    for (unsigned int degree = 1; degree <= 3; ++degree)
      {
        example::Discretization discretization;
        discretization.formulation = GetParam();
        discretization.degree      = degree;
        const example::Ironing result =
          example::ironing(discretization,
                           8,
                           example::IroningTool::wave_without_edge);
        ASSERT_TRUE(result.converged);
        EXPECT_DOUBLE_EQ(result.contact_fraction, 1.);
        EXPECT_LT(result.vertical_ripple, 1e-6);
        EXPECT_LT(result.lateral_ripple, 1e-6);
      }
  }

  // The mortar form does not resolve the edge better with the order: a function
  // across the edge has one pressure, and it is the wider the higher the order.
  TEST(Ironing, ripple_of_the_gauss_point_form_falls_as_the_order_rises)
  {
    const auto   formulation = ContactFormulation::gauss_point;
    const double linear      = ripple(formulation, 1, 16.),
                 quadratic   = ripple(formulation, 2, 16.),
                 cubic       = ripple(formulation, 3, 16.);
    EXPECT_LT(quadratic, 0.7 * linear);
    EXPECT_LT(cubic, 0.7 * quadratic);
  }

  TEST(Ironing, ripple_of_the_mortar_form_stays_below_a_percent_for_all_orders)
  {
    for (unsigned int degree = 1; degree <= 3; ++degree)
      EXPECT_LT(ripple(ContactFormulation::mortar, degree, 16.), 0.01);
  }

  INSTANTIATE_TEST_SUITE_P(,
                           Sliding,
                           testing::Values(ContactFormulation::mortar,
                                           ContactFormulation::gauss_point),
                           [](const auto &info) {
                             return info.param == ContactFormulation::mortar ?
                                      "Mortar" :
                                      "GaussPoint";
                           });
} // namespace
