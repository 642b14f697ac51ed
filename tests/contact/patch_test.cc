#include <asperity/splines/refinement.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact_problem.h"

namespace
{
  using namespace asperity;
  using dealii::Point;

  /**
   * Pressure of a neo-Hooke block of height 1 under a ceiling that has come
   * down by `shift`, sides free in one direction: P11 = 0 gives the lateral
   * stretch, -P22 = penalty (shift - (1 - stretch)) the vertical one.
   */
  double
  exact_pressure(const double shift, const double penalty)
  {
    const double lambda = example::elasticity().lame_lambda(),
                 mu     = example::elasticity().shear_modulus();
    const auto stress   = [&](const double a, const double b) {
      return mu * (a - 1. / a) + lambda * std::log(a * b) / a;
    };
    const auto lateral = [&](const double b) {
      double low = 0.5, high = 2.;
      for (unsigned int i = 0; i < 200; ++i)
        (stress(0.5 * (low + high), b) < 0. ? low : high) = 0.5 * (low + high);
      return low;
    };
    double low = 0.5, high = 1.;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const double b = 0.5 * (low + high);
        const double p = penalty * (shift - (1. - b));
        // A longer block presses less than the penalty asks.
        (-stress(b, lateral(b)) > p ? low : high) = b;
      }
    return penalty * (shift - (1. - low));
  }

  KnotVector
  block_columns(const unsigned int degree)
  {
    return KnotVector(degree, {0., 0.3, 0.5, 0.9, 1.3, 1.5, 2.});
  }

  std::shared_ptr<SplineSpace<2>>
  block(const unsigned int degree, const bool refined)
  {
    auto space = std::make_shared<SplineSpace<2>>(
      block_columns(degree), KnotVector(degree, {0., 0.3, 0.6, 0.8, 1.}));
    if (refined)
      space->refine_to_level(2, [](const Point<2> &low, const Point<2> &high) {
        return low[0] < 0.35 && high[1] > 0.9;
      });
    return space;
  }

  /**
   * A block under a rigid ceiling, a half-plane or a spline whose knots lie
   * elsewhere: (degree, formulation, locally refined edge, spline). The scene's
   * tool is rigid, so this is the patch test it needs; contact of two meshes,
   * which this program has not, would need that of two blocks.
   */
  class PatchTest : public testing::TestWithParam<
                      std::tuple<unsigned int, ContactFormulation, bool, bool>>
  {};

  TEST_P(PatchTest, pressure_of_a_uniformly_pressed_block_is_uniform)
  {
    const auto [degree, formulation, refined, spline] = GetParam();
    ContactOptions options;
    options.formulation = formulation;
    options.penalty     = 1e8;
    std::shared_ptr<const RigidObstacle<2>> ceiling =
      std::make_shared<example::Ceiling>(1.);
    if (spline)
      ceiling = example::periodic_tool([](const double) { return 1.; }, 2., 7);
    example::ContactProblem problem(block(degree, refined),
                                    std::make_shared<NeoHooke>(
                                      example::elasticity()),
                                    ceiling,
                                    options,
                                    example::Support::rollers);
    problem.options.tolerance      = 1e-8;
    const ConvergenceReport report = problem.solve(0., -0.01);
    ASSERT_TRUE(report.converged) << report.reason;
    const auto  &p       = problem.contact->pressure();
    const auto   extreme = std::minmax_element(p.begin(), p.end());
    const double exact   = exact_pressure(0.01, options.penalty);
    EXPECT_LT(*extreme.second - *extreme.first, 1e-10 * exact);
    EXPECT_NEAR(*extreme.second, exact, 1e-10 * exact);
    EXPECT_NEAR(problem.force(), 2. * exact, 1e-10 * exact);
    EXPECT_DOUBLE_EQ(problem.contact->state().contact_fraction, 1.);
  }

  INSTANTIATE_TEST_SUITE_P(
    ,
    PatchTest,
    testing::Combine(testing::Values(1u, 2u, 3u),
                     testing::Values(ContactFormulation::mortar,
                                     ContactFormulation::gauss_point),
                     testing::Bool(),
                     testing::Bool()),
    [](const auto &info) {
      return std::string(std::get<1>(info.param) == ContactFormulation::mortar ?
                           "Mortar" :
                           "GaussPoint") +
             "Degree" + std::to_string(std::get<0>(info.param)) +
             (std::get<2>(info.param) ? "Refined" : "Uniform") +
             (std::get<3>(info.param) ? "Spline" : "Plane");
    });

  /** The parallel of a curve at a distance, on the side of the body; of its
   *  curvature, which the residual does not need, nothing is said. */
  class Parallel : public RigidObstacle<2>
  {
  public:
    Parallel(const SplineCurve &curve, const double distance)
      : curve(curve, CurveSide::right)
      , distance(distance)
    {}

    GapPoint<2>
    gap(const Point<2> &x, Point<1> &hint) const override
    {
      GapPoint<2> gap = curve.gap(x, hint);
      gap.gap -= distance;
      return gap;
    }

  private:
    CurveObstacle curve;
    double        distance;
  };

  class CurvedPatchTest : public testing::TestWithParam<
                            std::tuple<unsigned int, ContactFormulation>>
  {};

  // Under one pressure from all sides a body of any shape shrinks by one
  // stretch s. Its curved edge, shrunk, is a spline again, so that a tool with
  // other knots can follow it at a distance, and the exact solution is one of
  // the discrete problem: all forces on functions without other supports
  // vanish.
  TEST_P(CurvedPatchTest, hydrostatic_pressure_is_in_equilibrium)
  {
    const auto [degree, formulation] = GetParam();
    const auto             space     = block(degree, false);
    const PatchGeometry<2> geometry =
      PatchGeometry<2>::from_map(*space, [](const Point<2> &xi) {
        return Point<2>(xi[0], xi[1] * (1. + 0.1 * std::sin(3. * xi[0])));
      });
    const auto identity = space->project(
      [](const Point<2> &xi) {
        return std::vector<double>{xi[0], xi[1]};
      },
      2);
    const auto position = [&](const unsigned int a) {
      return Point<2>(identity[0][a] + geometry.offset[a][0],
                      identity[1][a] + geometry.offset[a][1]);
    };

    const double s      = 0.97;
    const double lambda = example::elasticity().lame_lambda(),
                 mu     = example::elasticity().shear_modulus();
    // nominal stress mu (s - 1/s) + 2 lambda ln s/s, here as a pressure
    const double pressure = mu * (1. / s - s) - 2. * lambda * std::log(s) / s;
    const double penalty  = 1e8;

    std::vector<Point<2>> points;
    for (const unsigned int a : space->edge_functions(Edge::top))
      points.emplace_back(s * position(a)[0], s * position(a)[1]);
    const SplineCurve edge(block_columns(degree), points);
    ContactOptions    options;
    options.formulation = formulation;
    options.penalty     = penalty;
    SolidAssembler<2>   solid(space,
                            geometry,
                            std::make_shared<NeoHooke>(example::elasticity()));
    ContactAssembler<2> contact(
      space,
      geometry,
      Edge::top,
      std::make_shared<Parallel>(
        insert_knots(edge, {0.15, 0.7, 0.75, 1.1, 1.9}), pressure / penalty),
      options);

    dealii::Vector<double> u(2 * space->n_functions()), R(u), forces(u);
    for (unsigned int a = 0; a < space->n_functions(); ++a)
      for (unsigned int i = 0; i < 2; ++i)
        u(2 * a + i) = (s - 1.) * position(a)[i];
    ASSERT_TRUE(contact.add(u, R, nullptr));
    const double contact_force = R.linfty_norm();
    ASSERT_TRUE(solid.add(u, R, nullptr));
    for (const Edge supported : {Edge::left, Edge::right, Edge::bottom})
      for (const unsigned int a : space->edge_functions(supported))
        R(2 * a) = R(2 * a + 1) = 0.;
    EXPECT_GT(contact_force, 0.01 * pressure);
    EXPECT_LT(R.linfty_norm(), 1e-11 * pressure);
    for (const double p : contact.pressure())
      EXPECT_NEAR(p, pressure, 1e-9 * pressure);
  }

  INSTANTIATE_TEST_SUITE_P(
    ,
    CurvedPatchTest,
    testing::Combine(testing::Values(1u, 2u, 3u),
                     testing::Values(ContactFormulation::mortar,
                                     ContactFormulation::gauss_point)),
    [](const auto &info) {
      return std::string(std::get<1>(info.param) == ContactFormulation::mortar ?
                           "Mortar" :
                           "GaussPoint") +
             "Degree" + std::to_string(std::get<0>(info.param));
    });

  TEST(ActiveSet, settles_when_flat_bodies_touch_without_load)
  {
    // All gaps are zero at the start, and the ceiling comes and goes by less
    // and more than round-off: the active set must not flip for ever.
    for (const ContactFormulation formulation :
         {ContactFormulation::mortar, ContactFormulation::gauss_point})
      {
        ContactOptions options;
        options.formulation = formulation;
        options.penalty     = 1e9;
        example::ContactProblem problem(block(2, true),
                                        std::make_shared<NeoHooke>(
                                          example::elasticity()),
                                        std::make_shared<example::Ceiling>(1.),
                                        options,
                                        example::Support::rollers);
        // Rounding a position costs penalty times 1e-16 times the length.
        problem.options.tolerance = 1e-6;
        for (const double shift :
             {0., 1e-15, -1e-15, -1e-9, 1e-9, -1e-4, 1e-4, -1e-3, 0.})
          {
            const ConvergenceReport report = problem.solve(0., shift);
            EXPECT_TRUE(report.converged) << shift << ": " << report.reason;
            EXPECT_LE(report.iterations, 3u) << shift;
          }
      }
  }
} // namespace
