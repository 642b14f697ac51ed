#include <gtest/gtest.h>

#include <numeric>

#include "flow_examples.h"

using namespace flow_examples;

namespace
{
  constexpr double pi = dealii::numbers::PI;

  constexpr FluidTimeScheme schemes[]  = {FluidTimeScheme::implicit_euler,
                                          FluidTimeScheme::bdf2};
  constexpr FluidElement    elements[] = {FluidElement::taylor_hood,
                                          FluidElement::equal_order};
  constexpr FlowSolverKind  solvers[]  = {FlowSolverKind::direct,
                                          FlowSolverKind::krylov};

  const BoundaryIds walls = {0, 1, 2, 3};

  FluidOptions
  unit_options(const LubricantDensity &compressibility)
  {
    FluidOptions options;
    options.model.density             = 1.;
    options.model.viscosity.viscosity = 0.1;
    options.model.compressibility     = compressibility;
    options.tolerance                 = 1e-11;
    return options;
  }

  double
  content(const NavierStokes &flow)
  {
    const std::vector<double> contents = flow.cell_contents();
    return std::accumulate(contents.begin(), contents.end(), 0.);
  }

  /** One step, all walls with the velocity of the mesh. */
  void
  step_with_walls(NavierStokes                                    &flow,
                  const double                                     dt,
                  const std::function<Point<2>(const Point<2> &)> &motion)
  {
    flow.begin_step(dt);
    ASSERT_TRUE(flow.set_mesh_displacement(displacement(flow, motion)));
    flow.boundary().set_wall_velocity(walls, flow.wall_mesh_velocity(walls));
    solve(flow);
  }
} // namespace



// The oil of a micrometre between walls, of which one comes closer by a tenth
// and goes again at some metres a second. The content is kept, and the pressure
// is that of its mean density, but for what viscosity and inertia make of it:
// eta v/l and rho v^2 are a thousandth of it.
TEST(CompressibleFlow, pressure_of_a_box_is_that_of_its_mean_density)
{
  for (const auto scheme : schemes)
    for (const auto element : elements)
      for (const auto linear_solver : solvers)
        {
          const auto   mesh = rectangle(4, 3, {0., 0.}, {1e-6, 1e-6});
          FluidOptions options;
          options.model.compressibility = LubricantDensity();
          options.scheme                = scheme;
          options.element               = element;
          options.linear_solver         = linear_solver;
          NavierStokes flow(*mesh, options);
          EXPECT_TRUE(flow.is_compressible());
          flow.set_part_volumes({1e-12});
          for (unsigned int step = 1; step <= 10; ++step)
            {
              const double s = 1. - 0.1 * std::sin(0.1 * pi * step);
              step_with_walls(flow, 1e-8, [s](const Point<2> &X) {
                return Point<2>(s * X[0], X[1]);
              });
              flow.accept();
              EXPECT_NEAR(content(flow) / 1e-12, 1., 1e-8);
              const double p = options.model.compressibility.pressure(1. / s);
              EXPECT_NEAR(flow.pressure_at({0.3e-6, 0.4e-6}), p, 1e-3 * p + 1e5)
                << "step " << step;
            }
        }
}



// Under pressure, and while the mesh swells inside and goes with the flow.
// Columns are switched off and on again.
TEST(CompressibleFlow, uniform_flow_stays_uniform)
{
  for (const auto scheme : schemes)
    for (const auto element : elements)
      {
        const auto   mesh    = rectangle(6, 3, {0., 0.}, {6., 1.});
        FluidOptions options = unit_options({DensityLaw::murnaghan, 5., 4.});
        options.scheme       = scheme;
        options.element      = element;
        NavierStokes flow(*mesh, options);
        flow.boundary().set_velocity(walls, constant(0.8, -0.3));
        flow.set_initial_velocity(constant(0.8, -0.3));
        FluidState start = flow.state();
        for (unsigned int i = flow.space().n_velocity_dofs();
             i < start.u.size();
             ++i)
          start.u(i) = 2.;
        flow.set_state(start);
        for (unsigned int step = 0; step < 8; ++step)
          {
            std::vector<bool> active;
            for (const auto &cell : mesh->active_cell_iterators())
              active.push_back(step % 3 == 0 || cell->center()[0] < 4.);
            flow.set_active(active);
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
              [](const Point<2> &, double) { return 2.; },
              0.);
            EXPECT_LT(error.velocity, 1e-10) << "step " << step;
            EXPECT_LT(error.pressure, 1e-9) << "step " << step;
          }
      }
}



namespace
{
  /**
   * A liquid in a box of the length s(t) and the height h(t), the points of
   * which are at x = s X + A sin(2 pi X)/(2 pi), y = h Y, and which slips along
   * the walls. With J = s + A cos(2 pi X) its density ratio is
   * r_0/(h J), and the body force that balances its momentum follows.
   */
  struct Breathing
  {
    LubricantDensity density = {DensityLaw::murnaghan, 4., 3.};
    double           eta     = 0.1;

    double s, ds, dds, h, dh, ddh, A, dA, ddA;

    explicit Breathing(const double t)
    {
      s   = 1. + 0.1 * std::sin(2. * t);
      ds  = 0.2 * std::cos(2. * t);
      dds = -0.4 * std::sin(2. * t);
      h   = 1. - 0.15 * std::sin(3. * t);
      dh  = -0.45 * std::cos(3. * t);
      ddh = 1.35 * std::sin(3. * t);
      A   = 0.2 * std::sin(2. * t);
      dA  = 0.4 * std::cos(2. * t);
      ddA = -0.8 * std::sin(2. * t);
    }

    /** X of a place. */
    double
    origin(const double x) const
    {
      double X = x / s, correction = 1.;
      while (std::abs(correction) > 1e-14)
        {
          correction =
            (s * X + A * std::sin(2. * pi * X) / (2. * pi) - x) / J(X);
          X -= correction;
        }
      return X;
    }

    double
    J(const double X) const
    {
      return s + A * std::cos(2. * pi * X);
    }

    Tensor<1, 2>
    velocity(const Point<2> &x) const
    {
      const double X = origin(x[0]);
      return vector(ds * X + dA * std::sin(2. * pi * X) / (2. * pi),
                    dh / h * x[1]);
    }

    double
    pressure(const Point<2> &x) const
    {
      return density.pressure(ratio_0() / (h * J(origin(x[0]))));
    }

    double
    ratio_0() const
    {
      return 1.2;
    }

    Tensor<1, 2>
    body_force(const Point<2> &x) const
    {
      const double X  = origin(x[0]);
      const double sn = std::sin(2. * pi * X), c = std::cos(2. * pi * X);
      const double J_X = -2. * pi * A * sn, V = ds + dA * c,
                   V_X  = -2. * pi * dA * sn;
      const double v_xx = (V_X * J(X) - V * J_X) / std::pow(J(X), 3);
      const double r    = ratio_0() / (h * J(X));
      const double p_x =
        -r * J_X / J(X) / density.derivative(density.pressure(r)) / J(X);
      return vector(dds * X + ddA * sn / (2. * pi) + p_x - 2. * eta * v_xx,
                    ddh / h * x[1]);
    }
  };

  FlowError
  breathing_error(const FluidElement    element,
                  const FluidTimeScheme scheme,
                  const unsigned int    n,
                  const unsigned int    n_steps)
  {
    const auto      mesh = rectangle(n, 1); // linear in y
    const Breathing start(0.);
    FluidOptions    options  = unit_options(start.density);
    options.element          = element;
    options.scheme           = scheme;
    options.model.body_force = [](const Point<2> &x, const double t) {
      return Breathing(t).body_force(x);
    };
    NavierStokes flow(*mesh, options);
    const auto   v = [](const Point<2> &x, const double t) {
      return Breathing(t).velocity(x);
    };
    flow.set_initial_velocity(v);
    FluidState state = flow.state();
    for (unsigned int i = flow.space().n_velocity_dofs(); i < state.u.size();
         ++i)
      state.u(i) = start.pressure({0.5, 0.5}); // uniform at t = 0
    flow.set_state(state);
    const double dt = 0.5 / n_steps;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        flow.begin_step(dt);
        const Breathing now(flow.time());
        // Inside, the mesh moves past the liquid.
        EXPECT_TRUE(flow.set_mesh_displacement(
          displacement(flow, [&now](const Point<2> &X) {
            return Point<2>(now.s * X[0], now.h * X[1]);
          })));
        NodalVectors velocity = flow.wall_mesh_velocity(walls);
        const auto   places =
          flow.boundary().nodes(walls).positions(flow.mapping());
        for (unsigned int k = 0; k < places.size(); ++k)
          if (places[k][0] > 1e-9 && places[k][0] < now.s - 1e-9)
            velocity[k][0] = now.velocity(places[k])[0];
        flow.boundary().set_wall_velocity(walls, velocity);
        flow.set_part_volumes({start.ratio_0()});
        solve(flow);
        EXPECT_NEAR(content(flow), start.ratio_0(), 1e-8);
        flow.accept();
      }
    return error_of(
      flow,
      v,
      [](const Point<2> &x, const double t) {
        return Breathing(t).pressure(x);
      },
      flow.time());
  }
} // namespace



TEST(CompressibleFlow, converges_in_an_enclosed_moving_domain)
{
  for (const auto element : elements)
    {
      std::vector<FlowError> errors;
      for (const unsigned int n : {8, 16, 32})
        errors.push_back(
          breathing_error(element, FluidTimeScheme::bdf2, n, 2 * n));
      EXPECT_GT(std::log2(errors[1].pressure / errors[2].pressure), 1.9);
      EXPECT_GT(std::log2(errors[1].velocity / errors[2].velocity), 1.8);
      EXPECT_LT(errors[2].pressure, 0.005);
    }
}



TEST(CompressibleFlow, converges_in_time)
{
  for (const auto scheme : schemes)
    {
      const double order = scheme == FluidTimeScheme::implicit_euler ? 1. : 2.;
      std::vector<FlowError> errors;
      for (const unsigned int n_steps : {8, 16, 32})
        errors.push_back(
          breathing_error(FluidElement::taylor_hood, scheme, 64, n_steps));
      EXPECT_NEAR(std::log2(errors[1].pressure / errors[2].pressure),
                  order,
                  0.2);
    }
}



// A film between a wall that slides and one that gives way against a Robin
// coefficient, on a moving mesh: what compression changes falls with the
// compressibility.
TEST(CompressibleFlow, stiff_liquid_is_incompressible)
{
  const auto pressures = [](const LubricantDensity &law,
                            const FluidElement      element,
                            const FlowSolverKind    kind) {
    const double L        = 4.;
    const auto   mesh     = rectangle(12, 3, {0., 0.}, {L, 1.});
    FluidOptions options  = unit_options(law);
    options.element       = element;
    options.linear_solver = kind;
    NavierStokes flow(*mesh, options, {{0, 1, 0}});
    flow.boundary().set_velocity({2}, constant(1.5, 0.));
    const double volume = flow.part_volumes()[0];
    for (unsigned int step = 1; step <= 2; ++step)
      {
        flow.begin_step(0.1);
        flow.set_mesh_displacement(displacement(flow, [=](const Point<2> &X) {
          const double s = std::sin(2. * pi * X[0] / L);
          return Point<2>(X[0], X[1] * (1. + 0.1 * step * s));
        }));
        const unsigned int n = flow.boundary().nodes({3}).size();
        flow.boundary().set_robin({3},
                                  std::vector<double>(n, 2.),
                                  flow.wall_mesh_velocity({3}),
                                  NodalVectors(n, vector(0., -1.)));
        flow.set_part_volumes({volume});
        solve(flow);
        flow.accept();
      }
    return flow.solution();
  };
  for (const auto element : elements)
    for (const auto kind : solvers)
      {
        const Vector rigid =
          pressures({DensityLaw::incompressible}, element, kind);
        std::vector<double> difference;
        for (const double modulus : {1e4, 1e5})
          {
            Vector u =
              pressures({DensityLaw::murnaghan, modulus, 10.}, element, kind);
            u -= rigid;
            difference.push_back(u.linfty_norm());
          }
        EXPECT_NEAR(difference[0] / difference[1], 10., 0.2);
      }
}
