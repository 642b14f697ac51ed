#include <asperity/base/errors.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <gtest/gtest.h>

#include "flow_examples.h"

using namespace flow_examples;

namespace
{
  FluidOptions
  steady(const double viscosity, const double density)
  {
    FluidOptions options;
    options.model.viscosity.viscosity = viscosity;
    options.model.density             = density;
    options.scheme                    = FluidTimeScheme::steady;
    return options;
  }



  /** Norm of the difference of tangent and difference quotient along a random
   *  direction, over the norm of the quotient. */
  double
  tangent_error(const FluidElement element,
                const unsigned int degree,
                const FluidModel  &model)
  {
    const auto       mesh = rectangle(3, 2);
    const FluidSpace space(*mesh, element, degree, 2, {});
    MovingMesh       motion(space);
    Vector           d(space.geometry_dofs().n_dofs());
    const auto       random = [](const unsigned int i) {
      return std::sin(12.9898 * (i + 1)) * std::cos(78.233 * i);
    };
    for (unsigned int i = 0; i < d.size(); ++i)
      d(i) = 0.02 * random(i);
    motion.set_rate(BackwardDifference::implicit_euler(0.1));
    motion.set_displacement(d);
    FluidBoundary boundary(space, motion);
    const auto    n = boundary.nodes({2}).size();
    boundary.set_robin({2},
                       std::vector<double>(n, 0.7),
                       NodalVectors(n, vector(0.3, -0.2)),
                       NodalVectors(n, vector(0.1, 0.1)));
    FluidAssembler     assembler(space, motion, model);
    const unsigned int n_dofs = space.dofs().n_dofs();
    Vector             history(n_dofs), u(n_dofs), direction(n_dofs);
    for (unsigned int i = 0; i < n_dofs; ++i)
      {
        u(i)         = 1. + random(i);
        history(i)   = random(i + 7);
        direction(i) = random(i + 1000);
      }
    assembler.set_step(BackwardDifference::implicit_euler(0.1), history, 0.);

    dealii::DynamicSparsityPattern full(n_dofs);
    for (unsigned int i = 0; i < n_dofs; ++i)
      for (unsigned int j = 0; j < n_dofs; ++j)
        full.add(i, j);
    dealii::SparsityPattern pattern;
    pattern.copy_from(full);
    dealii::SparseMatrix<double> K(pattern);
    const auto                   residual = [&](const double                  step,
                              dealii::SparseMatrix<double> *tangent) {
      Vector R(n_dofs), scale(n_dofs), x(u);
      x.add(step, direction);
      assembler.add(x, space.topology(), R, scale, tangent);
      boundary.add(x, 0., space.topology(), R, scale, tangent);
      return R;
    };
    residual(0., &K);
    const double step     = 1e-5;
    Vector       quotient = residual(step, nullptr), product(n_dofs);
    quotient -= residual(-step, nullptr);
    quotient /= 2. * step;
    K.vmult(product, direction);
    product -= quotient;
    return product.l2_norm() / quotient.l2_norm();
  }
} // namespace



TEST(NavierStokes, tangent_is_the_derivative_of_the_residual)
{
  ViscosityParameters newtonian, complex;
  newtonian.viscosity              = 0.8;
  complex.viscosity                = 0.8;
  complex.shear_law                = ShearLaw::carreau;
  complex.time_constant            = 0.5;
  complex.infinite_shear_viscosity = 0.1;
  complex.pressure_law             = PressureLaw::barus;
  complex.pressure_coefficient     = 0.2;
  complex.stress_limit             = StressLimit::circular;
  complex.limiting_stress          = 3.;
  // Pressures are between 0 and 2.
  const LubricantDensity rigid    = {DensityLaw::incompressible};
  const LubricantDensity liquid   = {DensityLaw::murnaghan, 3., 5.};
  const LubricantDensity constant = {DensityLaw::constant_modulus, 3.};
  for (const bool convection : {false, true})
    for (const auto &viscosity : {newtonian, complex})
      for (const auto &compressibility : {rigid, liquid, constant})
        {
          FluidModel model;
          model.density         = 1.3;
          model.viscosity       = viscosity;
          model.convection      = convection;
          model.compressibility = compressibility;
          EXPECT_LT(tangent_error(FluidElement::taylor_hood, 2, model), 1e-8);
          EXPECT_LT(tangent_error(FluidElement::equal_order, 1, model), 1e-8);
          EXPECT_LT(tangent_error(FluidElement::equal_order, 2, model), 1e-8);
        }
}



// v_x = U y/h between walls that slide; sides periodic. The shear stress is
// eta U/h everywhere.
TEST(NavierStokes, couette_flow)
{
  const double eta = 0.032, U = 1.5, h = 1e-6, L = 3e-6;
  for (const auto element :
       {FluidElement::taylor_hood, FluidElement::equal_order})
    {
      const auto   mesh    = rectangle(3, 4, {0., 0.}, {L, h});
      FluidOptions options = steady(eta, 800.);
      options.element      = element;
      NavierStokes flow(*mesh, options, {{0, 1, 0}});
      flow.boundary().set_velocity({2}, constant(0., 0.));
      flow.boundary().set_velocity({3}, constant(U, 0.));
      EXPECT_LE(solve(flow).iterations, 2);
      EXPECT_TRUE(flow.is_enclosed());
      EXPECT_NEAR(flow.velocity_at({1.1e-6, 0.3e-6})[0], 0.3 * U, 1e-9 * U);
      const Tensor<1, 2> drag = flow.total_wall_force({3});
      EXPECT_NEAR(drag[0], -eta * U / h * L, 1e-9 * eta * U / h * L);
      EXPECT_NEAR(drag[1], 0., 1e-9 * eta * U / h * L);
      EXPECT_NEAR(flow.total_wall_force({2})[0], -drag[0], 1e-9 * -drag[0]);
    }
}



// The drag of Couette flow is as the viscosity, whatever it was before.
TEST(NavierStokes, shears_as_the_oil_that_it_is_told_of)
{
  const double U = 0.25, h = 1e-6, L = 2e-6;
  const auto   mesh    = rectangle(3, 4, {0., 0.}, {L, h});
  FluidOptions options = steady(0.032, 800.);
  NavierStokes flow(*mesh, options, {{0, 1, 0}});
  flow.boundary().set_velocity({2}, constant(0., 0.));
  flow.boundary().set_velocity({3}, constant(U, 0.));
  for (const double eta : {0.032, 0.016, 0.002, 0.01})
    {
      options.model.viscosity.viscosity = eta;
      flow.set_model(options.model);
      solve(flow);
      EXPECT_NEAR(flow.total_wall_force({3})[0] / (-eta * U / h * L), 1., 1e-9);
    }
}



// A body force G/rho along a periodic channel: v = G y (h - y)/(2 eta), and
// each wall carries half of the force.
TEST(NavierStokes, poiseuille_flow)
{
  const double eta = 0.5, G = 3., h = 2., L = 1.;
  for (const auto element :
       {FluidElement::taylor_hood, FluidElement::equal_order})
    {
      const auto   mesh        = rectangle(2, 4, {0., 0.}, {L, h});
      FluidOptions options     = steady(eta, 2.);
      options.element          = element;
      options.model.body_force = constant(G / 2., 0.);
      NavierStokes flow(*mesh, options, {{0, 1, 0}});
      flow.boundary().set_velocity({2, 3}, constant(0., 0.));
      solve(flow);
      EXPECT_NEAR(flow.velocity_at({0.3, 0.5 * h})[0],
                  G * h * h / 8. / eta,
                  1e-9);
      EXPECT_NEAR(flow.total_wall_force({2})[0], 0.5 * G * h * L, 1e-9);
      EXPECT_NEAR(flow.total_wall_force({2, 3})[0], G * h * L, 1e-9);
      EXPECT_NEAR(flow.pressure_at({0.4, 0.7}), 0., 1e-9);
    }
}



// Flow rate and centre velocity of a Carreau fluid between plates at y = -1, 1
// under a pressure gradient of 1, eta_0 = 1, eta_inf = 0.01; computed from the
// one-dimensional balance eta(gamma) gamma = y.
TEST(NavierStokes, carreau_channel)
{
  struct Case
  {
    double lambda, n, rate, centre;
  };
  for (const Case &c : {Case{1., 0.5, 0.771877, 0.565543},
                        Case{10., 0.5, 4.413794, 2.972690},
                        Case{10., 0.25, 28.20823, 18.82341}})
    {
      const auto   mesh    = rectangle(1, 32, {0., -1.}, {0.1, 1.});
      FluidOptions options = steady(1., 1.);
      options.model.viscosity.shear_law                = ShearLaw::carreau;
      options.model.viscosity.infinite_shear_viscosity = 0.01;
      options.model.viscosity.time_constant            = c.lambda;
      options.model.viscosity.power_index              = c.n;
      options.model.body_force                         = constant(1., 0.);
      NavierStokes flow(*mesh, options, {{0, 1, 0}});
      flow.boundary().set_velocity({2, 3}, constant(0., 0.));
      solve(flow);
      const auto profile = [&flow](const double y) {
        return flow.velocity_at({0.05, y})[0];
      };
      const dealii::QIterated<1> quadrature(dealii::QGauss<1>(3), 32);
      double                     rate = 0.;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        rate +=
          2. * quadrature.weight(q) * profile(2. * quadrature.point(q)[0] - 1.);
      EXPECT_NEAR(rate, c.rate, 1e-4 * c.rate);
      EXPECT_NEAR(profile(0.), c.centre, 1e-4 * c.centre);
    }
}



TEST(NavierStokes, mean_pressure_of_enclosed_flows_is_the_one_asked_for)
{
  const auto   mesh     = rectangle(6, 6);
  FluidOptions options  = steady(0.01, 1.);
  options.mean_pressure = 5.;
  // With convection the forces would differ by the momentum that flows where
  // the divergence vanishes in the mean only.
  options.model.convection = false;
  NavierStokes flow(*mesh, options);
  flow.boundary().set_velocity({3}, constant(1., 0.));
  flow.boundary().set_velocity({0, 1, 2}, constant(0., 0.));
  solve(flow);
  EXPECT_TRUE(flow.is_enclosed());
  const auto error = error_of(
    flow, constant(0., 0.), [](const Point<2> &, double) { return 0.; }, 0.);
  EXPECT_GT(error.pressure, 5.); // |p - 5| > 0 somewhere
  // Pressure pushes outwards on every wall: the sum cancels.
  EXPECT_NEAR(flow.total_wall_force({0, 1, 2, 3}).norm(), 0., 1e-9);
  EXPECT_NEAR(flow.total_wall_force({2})[1], -5., 0.2);
}



TEST(NavierStokes, enclosed_flow_that_loses_volume_is_refused)
{
  const auto   mesh = rectangle(4, 4);
  NavierStokes flow(*mesh, steady(1., 1.));
  flow.boundary().set_velocity({0, 1, 2}, constant(0., 0.));
  flow.boundary().set_velocity({3}, constant(0., -0.1));
  const ConvergenceReport report = flow.solve();
  EXPECT_FALSE(report.converged);
  EXPECT_NE(report.reason.find("enclosed"), std::string::npos);
}



TEST(NavierStokes, boundary_has_one_condition)
{
  const auto   mesh = rectangle(2, 2);
  NavierStokes flow(*mesh, steady(1., 1.), {{0, 1, 0}});
  flow.boundary().set_velocity({2, 3}, constant(0., 0.));
  EXPECT_THROW(flow.boundary().set_traction({3}, nullptr), InputError);
  EXPECT_THROW(flow.boundary().set_velocity({0}, constant(0., 0.)), InputError);
  EXPECT_THROW(flow.boundary().set_wall_velocity({2, 3}, NodalVectors(1)),
               InputError);
}
