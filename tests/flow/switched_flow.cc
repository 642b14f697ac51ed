#include <asperity/base/errors.h>

#include <gtest/gtest.h>

#include "flow_examples.h"

using namespace flow_examples;

namespace
{
  constexpr FluidTimeScheme schemes[]  = {FluidTimeScheme::implicit_euler,
                                          FluidTimeScheme::bdf2};
  constexpr FluidElement    elements[] = {FluidElement::taylor_hood,
                                          FluidElement::equal_order};

  /** Cells whose centre is where a function says so. */
  std::vector<bool>
  cells_where(const Mesh                                  &mesh,
              const std::function<bool(const Point<2> &)> &is_on)
  {
    std::vector<bool> active;
    for (const auto &cell : mesh.active_cell_iterators())
      active.push_back(is_on(cell->center()));
    return active;
  }
} // namespace



// The mesh is carried along by the flow, and swells and shrinks in its left
// half. The columns on the right go off and on again, in one piece, in two, and
// next to each other.
TEST(SwitchedFlow, uniform_flow_stays_uniform)
{
  const std::vector<std::vector<double>> off_columns = {
    {}, {2.5}, {2.5, 3.5}, {3.5}, {}, {4.5}, {2.5, 4.5}, {3.5, 4.5}};
  for (const auto scheme : schemes)
    for (const auto element : elements)
      {
        const auto   mesh = rectangle(6, 3, {0., 0.}, {6., 1.});
        FluidOptions options;
        options.model.density             = 1.;
        options.model.viscosity.viscosity = 0.01;
        options.scheme                    = scheme;
        options.element                   = element;
        options.tolerance                 = 1e-12;
        NavierStokes flow(*mesh, options);
        flow.boundary().set_velocity({0, 1, 2, 3}, constant(0.8, -0.3));
        flow.set_initial_velocity(constant(0.8, -0.3));
        for (unsigned int step = 0; step < 12; ++step)
          {
            const auto &off = off_columns[step % off_columns.size()];
            flow.set_active(cells_where(*mesh, [&off](const Point<2> &X) {
              return std::find(off.begin(), off.end(), X[0]) == off.end();
            }));
            flow.begin_step(0.1);
            const double t = flow.time();
            ASSERT_TRUE(flow.set_mesh_displacement(
              displacement(flow, [t](const Point<2> &X) {
                const double swell =
                  X[0] < 2. ? 0.1 * X[0] * (2. - X[0]) * std::sin(t) : 0.;
                return X + vector(0.8 * t + swell, -0.3 * t);
              })));
            solve(flow);
            flow.accept();
            const auto error = error_of(
              flow,
              constant(0.8, -0.3),
              [](const Point<2> &, double) { return 0.; },
              0.);
            EXPECT_LT(error.velocity, 1e-12) << "step " << step;
            EXPECT_LT(error.pressure, 1e-11) << "step " << step;
          }
      }
}



// A full box is drawn out along x and pressed flat, x = X e^t, y = Y e^-t: the
// stagnation flow v = (x, -y), p = p_0 - rho (x^2 + y^2)/2. The part of it
// between moving lines of constant x is a flow of its own, which any cells
// beyond may be off.
TEST(SwitchedFlow, pressure_of_enclosed_moving_parts_converges)
{
  for (const bool are_all_on : {true, false})
    {
      std::vector<double> errors;
      for (const unsigned int n : {3, 6, 12})
        {
          const auto   mesh = rectangle(2 * n, n, {0., 0.}, {2., 1.});
          FluidOptions options;
          options.model.density             = 1.;
          options.model.viscosity.viscosity = 0.1;
          options.tolerance                 = 1e-11;
          NavierStokes      flow(*mesh, options);
          const BoundaryIds walls = {0, 1, 2, 3};
          flow.set_initial_velocity([](const Point<2> &x, const double) {
            return vector(x[0], -x[1]);
          });
          // Two parts of different length, with cells between that are off.
          flow.set_active(cells_where(*mesh, [&](const Point<2> &X) {
            return are_all_on || X[0] < 1. || X[0] > 1.5;
          }));
          const std::vector<double> volumes = flow.part_volumes();
          ASSERT_EQ(volumes.size(), are_all_on ? 1 : 2);
          for (unsigned int step = 0; step < n; ++step)
            {
              flow.begin_step(0.5 / n);
              const double s = std::exp(flow.time());
              flow.set_mesh_displacement(
                displacement(flow, [s](const Point<2> &X) {
                  return Point<2>(s * X[0], X[1] / s);
                }));
              flow.boundary().set_wall_velocity(walls,
                                                flow.wall_mesh_velocity(walls));
              flow.set_part_volumes(volumes);
              solve(flow);
              flow.accept();
            }
          const double s = std::exp(0.5);
          // Each part has the mean zero.
          const auto error = error_of(
            flow,
            [](const Point<2> &x, double) { return vector(x[0], -x[1]); },
            [&](const Point<2> &x, double) {
              const double a = are_all_on || x[0] < 1.25 * s ? 0. : 1.5 * s;
              const double b = are_all_on || x[0] > 1.25 * s ? 2. * s : s;
              const double mean_square =
                (a * a + a * b + b * b) / 3. + 1. / (3. * s * s);
              return 0.5 * (mean_square - x.square());
            },
            0.);
          errors.push_back(error.pressure);
        }
      EXPECT_LT(errors[2], 0.02);
      EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2., 0.15)
        << errors[0] << " " << errors[1] << " " << errors[2];
    }
}



// Each part on its own bed: with the Robin condition on its lower wall the
// pressure is alpha times the velocity at which the part has to give way, but
// for the cells at its ends, which the inner walls hold.
TEST(SwitchedFlow, parts_have_their_own_pressure)
{
  for (const auto linear_solver :
       {FlowSolverKind::direct, FlowSolverKind::krylov})
    {
      const auto   mesh = rectangle(60, 1, {0., 0.}, {6., 1.});
      FluidOptions options;
      options.model.density             = 1e-3;
      options.model.viscosity.viscosity = 1e-6;
      options.scheme                    = FluidTimeScheme::implicit_euler;
      options.linear_solver             = linear_solver;
      NavierStokes flow(*mesh, options);
      flow.boundary().set_velocity({0, 1, 3}, constant(0., 0.));
      const unsigned int n     = flow.boundary().nodes({2}).size();
      const double       alpha = 100., dt = 0.1, surplus = 1e-3;
      flow.boundary().set_robin({2},
                                std::vector<double>(n, alpha),
                                NodalVectors(n),
                                NodalVectors(n));
      flow.set_active(cells_where(*mesh, [](const Point<2> &X) {
        return X[0] < 2. || X[0] > 3.;
      }));
      flow.begin_step(dt);
      flow.set_part_volumes({2. + surplus, 3. - surplus});
      solve(flow);
      EXPECT_FALSE(flow.is_enclosed());
      EXPECT_NEAR(flow.pressure_at({1., 0.9}) * 2. * dt / (alpha * surplus),
                  1.,
                  0.02);
      EXPECT_NEAR(flow.pressure_at({4.5, 0.9}) * 3. * dt / (alpha * surplus),
                  -1.,
                  0.02);
    }
}



// A part whose ends are the sides of the period.
TEST(SwitchedFlow, parts_go_on_across_the_period)
{
  const auto   mesh = rectangle(5, 2, {0., 0.}, {5., 1.});
  FluidOptions options;
  NavierStokes flow(*mesh, options, {{0, 1, 0}});
  flow.boundary().set_velocity({2, 3}, constant(0., 0.));
  const auto off = [&](const std::set<double> &columns) {
    flow.set_active(cells_where(*mesh, [&columns](const Point<2> &X) {
      return columns.count(X[0]) == 0;
    }));
    return flow.part_volumes();
  };
  EXPECT_EQ(off({2.5}).size(), 1U);
  EXPECT_NEAR(off({1.5, 3.5})[0] + off({1.5, 3.5})[1], 3., 1e-12);
  // Off at one side of the period: the other one is a wall.
  const auto parts = off({0.5, 2.5});
  ASSERT_EQ(parts.size(), 2U);
  flow.begin_step(0.1);
  solve(flow);
  EXPECT_LT(flow.solution().linfty_norm(), 1e-12);
}



TEST(SwitchedFlow, volume_that_walls_contradict_is_refused)
{
  const auto   mesh = rectangle(4, 2);
  NavierStokes flow(*mesh, FluidOptions());
  flow.boundary().set_velocity({0, 1, 2, 3}, constant(0., 0.));
  flow.set_active(
    cells_where(*mesh, [](const Point<2> &X) { return X[0] < 0.5; }));
  flow.begin_step(0.1);
  flow.set_part_volumes({0.6});
  const ConvergenceReport report = flow.solve();
  EXPECT_FALSE(report.converged);
  EXPECT_NE(report.reason.find("volume"), std::string::npos);
  EXPECT_THROW(flow.set_part_volumes({0.5, 0.5}), InputError);
  EXPECT_THROW(flow.set_active({true}), InputError);
}
