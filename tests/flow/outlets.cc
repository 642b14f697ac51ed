#include <asperity/base/errors.h>
#include <asperity/flow/navier_stokes.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <gtest/gtest.h>

#include <cmath>

#include "flow_examples.h"

// Flows with open ends.

using namespace asperity;
using namespace flow_examples;

namespace
{
  constexpr double eta = 0.032, L = 10e-6, h = 0.2e-6;

  FluidOptions
  steady(const double viscosity)
  {
    FluidOptions options;
    options.model.density             = 800.;
    options.model.viscosity.viscosity = viscosity;
    options.scheme                    = FluidTimeScheme::steady;
    return options;
  }

  /** A channel between walls 2 and 3, open on the left and on the right. */
  NavierStokes
  channel(const dealii::Triangulation<2> &mesh,
          const std::vector<FluidOutlet> &outlets,
          const FluidElement              element = FluidElement::taylor_hood)
  {
    FluidOptions options = steady(eta);
    options.element      = element;
    return NavierStokes(mesh, options, {}, outlets);
  }
} // namespace



// Poiseuille's flow through the whole channel, both of whose ends are as the
// rest of it: q = h^3 (P_l - P_r)/(12 eta L), and each wall carries half of the
// pressure.
TEST(Outlets, let_a_developed_flow_through)
{
  const double P_l = 5e6, P_r = 2e6;
  const double q    = h * h * h * (P_l - P_r) / (12. * eta * L);
  const auto   mesh = rectangle(5, 2, {0., 0.}, {L, h});
  for (const auto element :
       {FluidElement::taylor_hood, FluidElement::equal_order})
    {
      auto flow = channel(*mesh, {{0, P_l, 0.}, {1, P_r, 0.}}, element);
      flow.boundary().set_velocity({2, 3}, constant(0., 0.));
      solve(flow);
      EXPECT_FALSE(flow.is_enclosed());
      EXPECT_NEAR(flow.outflow()[0] / -q, 1., 1e-8);
      EXPECT_NEAR(flow.outflow()[1] / q, 1., 1e-8);
      EXPECT_NEAR(flow.pressure_at({0.3 * L, 0.4 * h}),
                  P_l + 0.3 * (P_r - P_l),
                  1e-8 * P_l);
      EXPECT_NEAR(flow.velocity_at({1e-3 * L, 0.5 * h})[0] / (1.5 * q / h),
                  1.,
                  1e-8);
      EXPECT_NEAR(flow.velocity_at({L, 0.5 * h})[1], 0., 1e-9 * q / h);
      for (const dealii::types::boundary_id wall : {2, 3})
        EXPECT_NEAR(flow.total_wall_force({wall})[0] / (0.5 * h * (P_l - P_r)),
                    1.,
                    1e-8);
    }
}



// A wall that slides with U carries h U/2 along; the shear at the ends is that
// of the channel.
TEST(Outlets, let_a_sheared_flow_through)
{
  const double U    = 0.5;
  const auto   mesh = rectangle(4, 2, {0., 0.}, {L, h});
  auto         flow = channel(*mesh, {{0, 1e5, 0.}, {1, 1e5, 0.}});
  flow.boundary().set_velocity({2}, constant(U, 0.));
  flow.boundary().set_velocity({3}, constant(0., 0.));
  solve(flow);
  EXPECT_NEAR(flow.outflow()[1] / (0.5 * h * U), 1., 1e-9);
  EXPECT_NEAR(flow.pressure_at({0.2 * L, 0.7 * h}), 1e5, 1e-3);
  EXPECT_NEAR(flow.total_wall_force({2})[0] / (-eta * U / h * L), 1., 1e-9);
}



// Channel and resistance are in series: with v = q/h, P_l = (12 eta L/h^2 + R)
// v and the pressure at the right end is R v.
TEST(Outlets, resist_in_series_with_the_channel)
{
  const double P_l  = 5e6;
  const auto   mesh = rectangle(5, 2, {0., 0.}, {L, h});
  for (const double R : {1e4, 1e8, 1e12})
    for (const auto solver : {FlowSolverKind::direct, FlowSolverKind::krylov})
      {
        FluidOptions options  = steady(eta);
        options.linear_solver = solver;
        NavierStokes flow(*mesh, options, {}, {{0, P_l, 0.}, {1, 0., R}});
        flow.boundary().set_velocity({2, 3}, constant(0., 0.));
        solve(flow);
        const double v = P_l / (12. * eta * L / (h * h) + R);
        EXPECT_NEAR(flow.outflow()[1] / (v * h), 1., 1e-6) << R;
        EXPECT_NEAR(flow.pressure_at({L, 0.3 * h}), R * v, 1e-6 * P_l) << R;
      }
}



// A plate that comes down with V presses oil out of a long bearing,
//   p = 6 eta V (L^2/4 - x^2)/h^3, x from the middle (Reynolds 1886),
// and what leaves is what it sweeps.
TEST(Outlets, let_out_what_a_plate_squeezes)
{
  const double V = 0.01, dt = 1e-7;
  const auto   mesh    = rectangle(60, 2, {0., 0.}, {L, h});
  FluidOptions options = steady(eta);
  for (const auto scheme :
       {FluidTimeScheme::implicit_euler, FluidTimeScheme::bdf2})
    {
      options.scheme           = scheme;
      options.model.convection = false;
      options.model.density    = 0.;
      NavierStokes flow(*mesh, options, {}, {{0, 0., 0.}, {1, 0., 0.}});
      flow.set_material_walls({3});
      flow.boundary().set_velocity({2}, constant(0., 0.));
      const double initial = flow.volume();
      for (unsigned int step = 1; step <= 5; ++step)
        {
          flow.begin_step(dt * (step == 3 ? 0.5 : 1.));
          const double height = h - V * flow.time();
          ASSERT_TRUE(flow.set_mesh_displacement(
            displacement(flow, [height](const Point<2> &X) {
              return Point<2>(X[0], X[1] * height / h);
            })));
          flow.boundary().set_wall_velocity({3}, flow.wall_mesh_velocity({3}));
          const ConvergenceReport report = flow.solve();
          ASSERT_TRUE(report.converged) << report.reason;
          for (const double x : {0., 0.2, 0.4})
            EXPECT_NEAR(flow.pressure_at({(0.5 + x) * L, 0.5 * height}) /
                          (6. * eta * V * L * L * (0.25 - x * x) /
                           (height * height * height)),
                        1.,
                        2e-3);
          for (const double q : flow.outflow())
            EXPECT_NEAR(q / (0.5 * V * L), 1., 1e-6);
          flow.accept();
          double out = 0.;
          for (const PassedVolume &volume : flow.passed_volumes())
            {
              out += volume.out;
              EXPECT_EQ(volume.in, 0.);
            }
          EXPECT_NEAR((initial - flow.volume()) / out, 1., 1e-8);
        }
    }
}



// On each branch: with and without resistance, with viscosities that depend on
// the rate of shear and on the pressure.
TEST(Outlets, tangent_is_the_derivative)
{
  const auto mesh = rectangle(2, 3, {0., 0.}, {1., 1.5});
  for (const double resistance : {0., 3.})
    for (const bool is_newtonian : {true, false})
      {
        FluidModel model;
        model.density             = 1.;
        model.viscosity.viscosity = 1.3;
        if (!is_newtonian)
          {
            model.viscosity.shear_law                = ShearLaw::carreau;
            model.viscosity.infinite_shear_viscosity = 0.1;
            model.viscosity.time_constant            = 2.;
            model.viscosity.pressure_law             = PressureLaw::barus;
            model.viscosity.pressure_coefficient     = 0.2;
          }
        const FluidSpace     space(*mesh, FluidElement::taylor_hood, 2, 2, {});
        const MovingMesh     motion(space);
        const FluidAssembler assembler(space, motion, model);
        const FluidOutlets   outlets(space,
                                   motion,
                                   assembler,
                                   {{0, 0.7, resistance}, {1, 0.2, 0.}});

        const unsigned int             n = space.dofs().n_dofs();
        dealii::DynamicSparsityPattern couplings(n);
        dealii::DoFTools::make_sparsity_pattern(space.dofs(), couplings);
        outlets.add_couplings(couplings);
        dealii::SparsityPattern pattern;
        pattern.copy_from(couplings);
        dealii::SparseMatrix<double> K(pattern);
        dealii::Vector<double>       u(n), direction(n), scale(n), R(n);
        for (unsigned int i = 0; i < n; ++i)
          {
            u(i)         = std::sin(3.7 * i + 0.3);
            direction(i) = std::cos(2.3 * i + 1.1);
          }
        dealii::AffineConstraints<double> none;
        none.close();
        outlets.add(u, none, R, scale, &K);
        dealii::Vector<double> expected(n);
        K.vmult(expected, direction);

        const double           step = 1e-6;
        dealii::Vector<double> difference(n), minus(n), v(u);
        v.add(step, direction);
        outlets.add(v, none, difference, scale, nullptr);
        v.add(-2. * step, direction);
        outlets.add(v, none, minus, scale, nullptr);
        difference -= minus;
        difference /= 2. * step;
        difference -= expected;
        EXPECT_GT(expected.linfty_norm(), 0.1);
        EXPECT_LT(difference.linfty_norm(), 1e-8 * expected.linfty_norm())
          << "resistance " << resistance << ", newtonian " << is_newtonian;
      }
}



TEST(Outlets, negative_resistances_are_refused)
{
  const auto mesh = rectangle(2, 2);
  try
    {
      const NavierStokes flow(*mesh, steady(1.), {}, {{1, 0., -2.}});
      FAIL() << "no exception";
    }
  catch (const InputError &error)
    {
      EXPECT_NE(std::string(error.what())
                  .find("expected none that is "
                        "negative"),
                std::string::npos)
        << error.what();
    }
}
