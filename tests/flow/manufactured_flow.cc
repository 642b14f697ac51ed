#include <gtest/gtest.h>

#include <array>

#include "flow_examples.h"

using namespace flow_examples;

namespace
{
  constexpr double pi = dealii::numbers::PI;

  double
  order(const double coarse, const double fine)
  {
    return std::log2(coarse / fine);
  }



  /** Steady vortices on n x n cells, curved inside; velocity on three sides,
   *  traction or Robin on the right. */
  FlowError
  steady_error(const FluidElement element,
               const unsigned int degree,
               const unsigned int n,
               const double       robin)
  {
    const Vortices vortices;
    const auto     mesh     = rectangle(n, n);
    FluidOptions   options  = vortices.options();
    options.element         = element;
    options.degree          = degree;
    options.geometry_degree = std::max(degree, 2U);
    options.scheme          = FluidTimeScheme::steady;
    NavierStokes flow(*mesh, options);
    flow.set_mesh_displacement(displacement(flow, [](const Point<2> &X) {
      const double s = 0.03 * std::sin(pi * X[0]) * std::sin(2. * pi * X[1]);
      return X + vector(s, s);
    }));
    flow.boundary().set_velocity({0, 2, 3}, vortices.velocity_function());
    const auto traction = [&vortices, robin](const Point<2>     &x,
                                             const Tensor<1, 2> &n,
                                             const double        t) {
      return vortices.traction(x, n, t);
    };
    if (robin == 0.)
      flow.boundary().set_traction({1}, traction);
    else
      {
        // sigma n + alpha v = alpha v_wall with nodal v_wall
        const WallNodes &wall = flow.boundary().nodes({1});
        NodalVectors     v_wall;
        for (const auto &x : wall.positions(flow.mapping()))
          v_wall.push_back(vortices.velocity(x, 0.) +
                           traction(x, vector(1., 0.), 0.) / robin);
        flow.boundary().set_robin({1},
                                  std::vector<double>(wall.size(), robin),
                                  v_wall,
                                  NodalVectors(wall.size()));
      }
    solve(flow);
    return vortices.error(flow, 0.);
  }



  using Motion = std::function<Point<2>(const Point<2> &, double)>;

  /** Largest errors over the steps to t = 1 of vortices that pulsate, on a mesh
   *  that moves. */
  FlowError
  unsteady_error(const FluidTimeScheme scheme,
                 const unsigned int    n_steps,
                 const Motion         &motion,
                 const bool            vary_steps)
  {
    Vortices vortices;
    vortices.f        = [](const double t) { return 1.5 + std::sin(4. * t); };
    vortices.df       = [](const double t) { return 4. * std::cos(4. * t); };
    const auto   mesh = rectangle(4, 4);
    FluidOptions options = vortices.options();
    options.degree       = 4;
    options.scheme       = scheme;
    NavierStokes flow(*mesh, options);
    flow.boundary().set_velocity({0, 2, 3}, vortices.velocity_function());
    flow.boundary().set_traction(
      {1}, [&](const Point<2> &x, const Tensor<1, 2> &n, const double t) {
        return vortices.traction(x, n, t);
      });
    const auto position = [&](const double t) {
      return displacement(flow, [&motion, t](const Point<2> &X) {
        return motion(X, t);
      });
    };
    flow.set_initial_displacement(position(0.));
    flow.set_initial_velocity(vortices.velocity_function());
    FlowError largest;
    for (unsigned int step = 0; step < n_steps; ++step)
      {
        const double dt =
          (vary_steps ? (step % 2 == 0 ? 0.7 : 1.3) : 1.) / n_steps;
        flow.begin_step(dt);
        flow.set_mesh_displacement(position(flow.time()));
        solve(flow);
        const FlowError error = vortices.error(flow, flow.time());
        flow.accept();
        largest.velocity = std::max(largest.velocity, error.velocity);
        if (step > 1) // the first step of BDF2 is of first order in p
          largest.pressure = std::max(largest.pressure, error.pressure);
      }
    return largest;
  }



  const Motion at_rest = [](const Point<2> &X, const double) { return X; };

  /** All walls and the interior. */
  const Motion swaying = [](const Point<2> &X, const double t) {
    const double s =
      0.05 * std::sin(pi * X[0]) * std::sin(pi * X[1]) * std::sin(3. * t);
    return X + vector(0.1 * X[1] * std::sin(2. * t) + s,
                      0.1 * X[0] * X[0] * std::sin(3. * t) - s);
  };
} // namespace



TEST(ManufacturedFlow, taylor_hood_has_optimal_orders_in_space)
{
  for (const unsigned int degree : {2U, 3U})
    {
      const auto coarse =
        steady_error(FluidElement::taylor_hood, degree, 8, 0.);
      const auto fine = steady_error(FluidElement::taylor_hood, degree, 16, 0.);
      // Degree 3 is on the way to its order: 3.65, 3.86 from 8 to 16 to 32.
      const double margin = degree == 2 ? 0.15 : 0.4;
      EXPECT_GT(order(coarse.velocity, fine.velocity), degree + 1. - margin);
      EXPECT_GT(order(coarse.pressure, fine.pressure), degree - margin);
    }
}



TEST(ManufacturedFlow, equal_order_has_optimal_orders_in_space)
{
  for (const unsigned int degree : {1U, 2U})
    {
      const auto coarse =
        steady_error(FluidElement::equal_order, degree, 12, 0.);
      const auto fine = steady_error(FluidElement::equal_order, degree, 24, 0.);
      EXPECT_GT(order(coarse.velocity, fine.velocity), degree + 0.85);
      EXPECT_GT(order(coarse.pressure, fine.pressure), degree - 0.15);
    }
}



TEST(ManufacturedFlow, robin_boundary)
{
  for (const double alpha : {1e-3, 1., 1e3})
    {
      const auto coarse = steady_error(FluidElement::taylor_hood, 2, 8, alpha);
      const auto fine   = steady_error(FluidElement::taylor_hood, 2, 16, alpha);
      EXPECT_GT(order(coarse.velocity, fine.velocity), 2.85);
      EXPECT_GT(order(coarse.pressure, fine.pressure), 1.85);
    }
}



TEST(ManufacturedFlow, orders_in_time)
{
  for (const auto &motion : {at_rest, swaying})
    for (const auto scheme :
         {FluidTimeScheme::implicit_euler, FluidTimeScheme::bdf2})
      {
        const double expected =
          scheme == FluidTimeScheme::implicit_euler ? 1. : 2.;
        const auto coarse = unsteady_error(scheme, 10, motion, false);
        const auto fine   = unsteady_error(scheme, 20, motion, false);
        EXPECT_NEAR(order(coarse.velocity, fine.velocity), expected, 0.15);
        EXPECT_NEAR(order(coarse.pressure, fine.pressure), expected, 0.15);
      }
}



TEST(ManufacturedFlow, variable_steps_keep_the_second_order)
{
  const auto coarse = unsteady_error(FluidTimeScheme::bdf2, 20, swaying, true);
  const auto fine   = unsteady_error(FluidTimeScheme::bdf2, 40, swaying, true);
  EXPECT_NEAR(order(coarse.velocity, fine.velocity), 2., 0.2);
}
