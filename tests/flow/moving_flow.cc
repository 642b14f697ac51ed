#include <gtest/gtest.h>

#include "flow_examples.h"

using namespace flow_examples;

namespace
{
  constexpr double pi = dealii::numbers::PI;

  constexpr FluidTimeScheme schemes[]  = {FluidTimeScheme::implicit_euler,
                                          FluidTimeScheme::bdf2};
  constexpr FluidElement    elements[] = {FluidElement::taylor_hood,
                                          FluidElement::equal_order};

  FluidOptions
  unit_options(const FluidTimeScheme scheme, const FluidElement element)
  {
    FluidOptions options;
    options.model.density             = 1.;
    options.model.viscosity.viscosity = 0.01;
    options.scheme                    = scheme;
    options.element                   = element;
    options.tolerance                 = 1e-12;
    return options;
  }
} // namespace



// x = X + 0.1 sin(2 pi X) sin(2 pi Y) sin(pi t) in both directions, inside and,
// by the shift of the phase, on the boundary.
TEST(MovingFlow, uniform_flow_stays_uniform)
{
  for (const auto scheme : schemes)
    for (const auto element : elements)
      {
        const auto   mesh = rectangle(6, 6);
        NavierStokes flow(*mesh, unit_options(scheme, element));
        flow.boundary().set_velocity({0, 2, 3}, constant(0.8, -0.3));
        flow.set_initial_velocity(constant(0.8, -0.3));
        for (const double dt : {0.1, 0.07, 0.12, 0.1, 0.1})
          {
            flow.begin_step(dt);
            const double t = flow.time();
            ASSERT_TRUE(flow.set_mesh_displacement(
              displacement(flow, [t](const Point<2> &X) {
                const double s = 0.05 * std::sin(2. * pi * X[0] + 0.3) *
                                 std::sin(2. * pi * X[1] + 0.7) *
                                 std::sin(pi * t);
                return X + vector(s, s);
              })));
            solve(flow);
            flow.accept();
            const auto error = error_of(
              flow,
              constant(0.8, -0.3),
              [](const Point<2> &, double) { return 0.; },
              0.);
            EXPECT_LT(error.velocity, 1e-12);
            EXPECT_LT(error.pressure, 1e-12);
          }
      }
}



// A full box that turns by a third of a radian a step. Its nodes cut the corner
// of their arcs, so the flux of their velocity through the walls does not
// vanish although the volume is the same at the end of each step: only the
// swept volume tells the truth.
TEST(MovingFlow, volume_between_material_walls_is_conserved)
{
  for (const auto scheme : schemes)
    for (const bool are_material : {false, true})
      {
        const auto        mesh = rectangle(4, 4);
        NavierStokes      flow(*mesh,
                          unit_options(scheme, FluidElement::taylor_hood));
        const BoundaryIds walls = {0, 1, 2, 3};
        if (are_material)
          flow.set_material_walls(walls);
        for (unsigned int step = 1; step <= 3; ++step)
          {
            flow.begin_step(0.1);
            const double c = std::cos(step / 3.), s = std::sin(step / 3.);
            flow.set_mesh_displacement(
              displacement(flow, [c, s](const Point<2> &X) {
                return Point<2>(c * X[0] - s * X[1], s * X[0] + c * X[1]);
              }));
            flow.boundary().set_wall_velocity(walls,
                                              flow.wall_mesh_velocity(walls));
            const ConvergenceReport report = flow.solve();
            EXPECT_EQ(report.converged, are_material) << report.reason;
            EXPECT_EQ(report.reason.find("volume") != std::string::npos,
                      !are_material);
            flow.accept();
          }
      }
}



TEST(MovingFlow, inverted_cell_is_reported)
{
  const auto   mesh = rectangle(2, 2);
  NavierStokes flow(*mesh,
                    unit_options(FluidTimeScheme::bdf2,
                                 FluidElement::taylor_hood));
  flow.begin_step(0.1);
  EXPECT_FALSE(
    flow.set_mesh_displacement(displacement(flow, [](const Point<2> &X) {
      return X + vector(X[0] == 0.5 ? 0.6 : 0., 0.);
    })));
  const ConvergenceReport report = flow.solve();
  EXPECT_FALSE(report.converged);
  EXPECT_NE(report.reason.find("inverted"), std::string::npos);
}



// Time steps from 1e-1 to 1e-8: the error of the pressure is that of the mesh.
// Without the projection of the initial velocity it grows as 1/dt.
TEST(MovingFlow, pressure_of_tiny_steps_is_bounded)
{
  Vortices vortices;
  vortices.viscosity = 0.01;
  vortices.f         = [](const double t) {
    return std::exp(-2. * pi * pi * 0.01 * t);
  };
  vortices.df = [&vortices](const double t) {
    return -2. * pi * pi * 0.01 * vortices.f(t);
  };
  for (const auto element : elements)
    for (const double dt : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8})
      {
        const auto   mesh    = rectangle(12, 12);
        FluidOptions options = vortices.options();
        options.element      = element;
        NavierStokes flow(*mesh, options);
        flow.boundary().set_velocity({0, 2, 3}, vortices.velocity_function());
        flow.boundary().set_traction(
          {1}, [&](const Point<2> &x, const Tensor<1, 2> &n, const double t) {
            return vortices.traction(x, n, t);
          });
        flow.set_initial_velocity(vortices.velocity_function());
        const auto projection = flow.project_initial_velocity();
        EXPECT_TRUE(projection.converged) << projection.residual;
        double pressure = 0.;
        for (unsigned int step = 0; step < 3; ++step)
          {
            flow.begin_step(dt);
            solve(flow);
            flow.accept();
            pressure =
              std::max(pressure, vortices.error(flow, flow.time()).pressure);
          }
        EXPECT_LT(pressure, 0.02);
      }
}
