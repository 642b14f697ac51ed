#include <asperity/base/errors.h>

#include <deal.II/base/parameter_handler.h>

#include <gtest/gtest.h>

#include <cmath>

#include "scene_examples.h"

// Oil that can leave the gap at the ends of the period.

using namespace asperity;

namespace
{
  constexpr double gap = 0.1e-6;

  /** A flat chip that is pressed to a flat tool, oil between them that gives
   * way to a load small enough for both to stay flat. */
  SceneParameters
  squeezed_scene()
  {
    SceneParameters parameters             = coarse_scene();
    parameters.tool.kind                   = SurfaceKind::flat;
    parameters.chip.kind                   = SurfaceKind::flat;
    parameters.geometry.initial_gap        = gap;
    parameters.load.pressure               = 5e6;
    parameters.load.velocity               = 0.02;
    parameters.protocol.inertia            = Inertia::dynamic;
    parameters.lubrication.model           = LubricantModel::stokes;
    parameters.lubrication.flow.left.kind  = GapEndKind::pressure;
    parameters.lubrication.flow.right.kind = GapEndKind::pressure;
    return parameters;
  }

  /** Velocity at which the plates approach in the last step [m/s]. */
  double
  approach(const CompleteRun &run)
  {
    const FrictionRow &last     = run.rows().back(),
                      &previous = run.rows()[run.rows().size() - 2];
    return (previous.void_volume - last.void_volume) /
           (last.time - previous.time) / run.scene.length;
  }

  std::string
  complaint(const std::vector<std::pair<std::string, std::string>> &entries)
  {
    SceneParameters          parameters;
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    parameters.declare(declarator);
    declarator.set("Lubrication/Model", "Stokes");
    try
      {
        for (const auto &[path, value] : entries)
          declarator.set(path, value);
        parameters.check(declarator);
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace

// Long bearing: the mean of p = 6 eta V (L^2/4 - x^2)/h^3 is eta V L^2/h^3, and
// a reservoir's pressure and what a resistance R adds at both ends, R V L/(2
// h), come on top of it.
TEST(OpenGap, gives_way_as_a_long_bearing)
{
  for (const double R : {0., 2e7})
    {
      SceneParameters parameters = squeezed_scene();
      FlowParameters &flow       = parameters.lubrication.flow;
      for (GapEnd *end : {&flow.left, &flow.right})
        {
          end->kind = R > 0. ? GapEndKind::resistance : GapEndKind::pressure;
          end->pressure   = 1e6;
          end->resistance = R;
        }
      const CompleteRun  run(parameters);
      const FrictionRow &last = run.rows().back();
      const double       L = run.scene.length, V = approach(run),
                   h   = last.void_volume / L,
                   eta = parameters.lubrication.oil.viscosity.viscosity;
      EXPECT_GT(V, 0.);
      EXPECT_NEAR((eta * V * L * L / (h * h * h) + R * V * L / (2. * h) + 1e6) /
                    last.oil_pressure,
                  1.,
                  0.03)
        << "R = " << R;
      EXPECT_EQ(last.contact_fraction, 0.);
    }
}

// The ends go with the chip, so that the tool drags U h/2 out of one of them
// and into the other one. What is missing of the oil has left, as precisely as
// chip and oil agree.
TEST(OpenGap, accounts_for_the_oil_that_comes_and_goes)
{
  SceneParameters parameters                = squeezed_scene();
  parameters.load.velocity                  = 0.5;
  parameters.lubrication.model              = LubricantModel::navier_stokes;
  parameters.lubrication.coupling.tolerance = 1e-8;
  const CompleteRun run(parameters);
  const double      start =
    run.rows()[1].void_volume + run.rows()[1].oil_out - run.rows()[1].oil_in;
  for (std::size_t i = 1; i < run.rows().size(); ++i)
    {
      const FrictionRow &row = run.rows()[i];
      EXPECT_NEAR(row.void_volume + row.oil_out - row.oil_in,
                  start,
                  1e-8 * start)
        << "step " << i;
      EXPECT_NEAR(row.oil_reference_volume, row.void_volume, 1e-8 * start);
    }
  const FrictionRow &last = run.rows().back();
  EXPECT_NEAR((last.oil_in + last.oil_out) /
                (0.5 * gap * last.sliding_distance * 2.),
              1.,
              0.01);
  EXPECT_GT(last.oil_out, last.oil_in);
}

// At the start the oil presses with its initial pressure P. In
// generalized-alpha the first step is
//   m (1 - alpha_m) a_1 = (1 - alpha_f) (T_1 + p_1 L) - alpha_f P L.
TEST(OpenGap, starts_with_the_initial_pressure)
{
  SceneParameters parameters                   = squeezed_scene();
  parameters.lubrication.flow.initial_pressure = 2e6;
  parameters.lubrication.flow.left.pressure    = 2e6;
  parameters.lubrication.flow.right.pressure   = 2e6;
  const double rho     = parameters.protocol.spectral_radius;
  const double alpha_m = (2. * rho - 1.) / (rho + 1.),
               alpha_f = rho / (rho + 1.);
  Scene<2>      scene(parameters);
  SlidingRun<2> run(parameters, scene);
  for (const double x : {0., 0.3, 0.9})
    EXPECT_NEAR(scene.lubricant->pressure({x * scene.length, 0.}), 2e6, 1e-6);
  const auto mass = scene.equilibrium->make_matrix();
  scene.chip->assemble_mass(*mass);
  const dealii::Vector<double> lift = scene.translation(0., 1.);
  dealii::Vector<double>       inertia(lift.size());
  run.run([&](const SlidingRun<2> &now) {
    const FrictionRow &row = now.state().rows.back();
    if (row.step > 1)
      return;
    mass->vmult(inertia, now.solid_step().state().a);
    EXPECT_NEAR((1. - alpha_m) * (lift * inertia),
                (1. - alpha_f) * (row.T_y + now.protocol().pressure(row.time) *
                                              scene.length) -
                  alpha_f * 2e6 * scene.length,
                1e-4 * 2e6 * scene.length);
  });
}

TEST(OpenGap, refuses_ends_that_do_not_go_together)
{
  const std::string one = complaint({{"Flow/Boundary left", "pressure"}});
  EXPECT_NE(one.find("Flow/Boundary right"), std::string::npos) << one;
  EXPECT_NE(one.find("found periodic, but the other end is open"),
            std::string::npos)
    << one;
  const std::string other = complaint({{"Flow/Boundary right", "resistance"}});
  EXPECT_NE(other.find("Flow/Boundary left"), std::string::npos) << other;
  const std::string sealed = complaint({{"Flow/Boundary left", "pressure"},
                                        {"Flow/Boundary right", "resistance"},
                                        {"Lubrication/Sealing gap", "20 nm"}});
  EXPECT_NE(sealed.find("an end of the gap is open"), std::string::npos)
    << sealed;
  const std::string mass = complaint({{"Flow/Boundary left", "pressure"},
                                      {"Flow/Boundary right", "pressure"},
                                      {"Flow/Compressible", "true"}});
  EXPECT_NE(mass.find("found true, but an end of the gap is open"),
            std::string::npos)
    << mass;
  EXPECT_EQ(complaint({{"Flow/Boundary left", "pressure"},
                       {"Flow/Boundary right", "resistance"}}),
            "");
  // What no model reads does no harm.
  EXPECT_EQ(complaint({{"Lubrication/Model", "pocket"},
                       {"Lubrication/Sealing gap", "20 nm"},
                       {"Flow/Boundary left", "pressure"}}),
            "");
}
