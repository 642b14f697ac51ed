#include <gtest/gtest.h>

#include <algorithm>

#include "channel_examples.h"

using namespace flow_examples;

namespace
{
  /** Sets the conditions of a flow and takes its steps. */
  using Problem = std::function<void(NavierStokes &)>;

  struct Result
  {
    Vector           u;
    unsigned int     n_velocity;
    NewtonStatistics statistics;
  };



  Result
  result(const Mesh                       &mesh,
         FluidOptions                      options,
         const FlowSolverKind              kind,
         const Problem                    &problem,
         const std::vector<PeriodicSides> &periodic)
  {
    options.linear_solver = kind;
    NavierStokes flow(mesh, options, periodic);
    problem(flow);
    return {flow.solution(), flow.space().n_velocity_dofs(), flow.statistics()};
  }



  /** Largest difference over the largest value, of the unknowns in a range. */
  double
  difference(const Vector      &a,
             const Vector      &b,
             const unsigned int begin,
             const unsigned int end)
  {
    double largest = 0., size = 0.;
    for (unsigned int i = begin; i < end; ++i)
      {
        largest = std::max(largest, std::abs(a(i) - b(i)));
        size    = std::max(size, std::abs(b(i)));
      }
    return largest / size;
  }



  /** Both solvers come to the same flow in about as many Newton iterations. */
  void
  expect_same_flow(const Mesh                       &mesh,
                   const FluidOptions               &options,
                   const Problem                    &problem,
                   const std::vector<PeriodicSides> &periodic = {})
  {
    const Result direct =
      result(mesh, options, FlowSolverKind::direct, problem, periodic);
    const Result krylov =
      result(mesh, options, FlowSolverKind::krylov, problem, periodic);
    EXPECT_EQ(direct.statistics.linear_iterations, 0U);
    EXPECT_GT(krylov.statistics.linear_iterations, 0U);
    EXPECT_LE(krylov.statistics.iterations, direct.statistics.iterations + 2);
    EXPECT_LT(difference(krylov.u, direct.u, 0, direct.n_velocity), 1e-7);
    EXPECT_LT(
      difference(krylov.u, direct.u, direct.n_velocity, direct.u.size()), 1e-6);
  }



  FluidOptions
  unit_fluid(const double viscosity, const FluidTimeScheme scheme)
  {
    FluidOptions options;
    options.model.density             = 1.;
    options.model.viscosity.viscosity = viscosity;
    options.scheme                    = scheme;
    return options;
  }



  /** The lid has a velocity without jump, 16 x^2 (1 - x)^2. */
  void
  set_cavity(NavierStokes &flow)
  {
    flow.boundary().set_velocity({0, 1, 2}, constant(0., 0.));
    flow.boundary().set_velocity({3}, [](const Point<2> &x, const double) {
      const double s = x[0] * (1. - x[0]);
      return vector(16. * s * s, 0.);
    });
  }



  /** Two steps of the same length from a flow without divergence. */
  Problem
  two_steps_of_cavity(const double dt)
  {
    return [dt](NavierStokes &flow) {
      set_cavity(flow);
      ASSERT_TRUE(flow.project_initial_velocity().converged);
      for (unsigned int n = 0; n < 2; ++n)
        {
          flow.begin_step(dt);
          solve(flow);
          flow.accept();
        }
    };
  }
} // namespace



TEST(KrylovSolver, solves_a_steady_enclosed_flow)
{
  const auto mesh = rectangle(12, 12);
  expect_same_flow(*mesh,
                   unit_fluid(0.01, FluidTimeScheme::steady),
                   [](NavierStokes &flow) {
                     set_cavity(flow);
                     solve(flow);
                   });
}



TEST(KrylovSolver, solves_a_channel_with_hanging_nodes_and_curved_cells)
{
  Mesh mesh;
  make_channel_with_cylinder(mesh, 0, 1);
  ASSERT_TRUE(mesh.has_hanging_nodes());
  expect_same_flow(
    mesh, unit_fluid(1e-3, FluidTimeScheme::steady), [](NavierStokes &flow) {
      flow.boundary().set_velocity({channel_inlet},
                                   channel_inflow([](double) { return 0.2; }));
      flow.boundary().set_velocity({channel_walls, channel_cylinder},
                                   constant(0., 0.));
      solve(flow);
    });
}



TEST(KrylovSolver, solves_steps_of_any_length)
{
  const auto mesh = rectangle(12, 12);
  for (const double dt : {1e-8, 1e-2, 1e4})
    for (const auto scheme :
         {FluidTimeScheme::implicit_euler, FluidTimeScheme::bdf2})
      expect_same_flow(*mesh,
                       unit_fluid(0.01, scheme),
                       two_steps_of_cavity(dt));
}



// A film of a shear-thinning oil, a micrometre high, between a wall that slides
// and one that the oil may cross against a Robin coefficient; the mesh moves.
TEST(KrylovSolver, solves_a_periodic_film_over_a_robin_wall_on_a_moving_mesh)
{
  const double         h = 1e-6, L = 4e-6;
  const auto           mesh    = rectangle(12, 6, {0., 0.}, {L, h});
  FluidOptions         options = unit_fluid(0.03, FluidTimeScheme::bdf2);
  ViscosityParameters &oil     = options.model.viscosity;
  options.model.density        = 800.;
  oil.shear_law                = ShearLaw::carreau;
  for (const double alpha : {1e2, 1e6, 1e10})
    expect_same_flow(*mesh,
                     options,
                     [=](NavierStokes &flow) {
                       const auto wave = [=](const Point<2> &X) {
                         const double s =
                           std::sin(2. * dealii::numbers::PI * X[0] / L);
                         return Point<2>(X[0], X[1] * (1. + 0.2 * s));
                       };
                       flow.boundary().set_velocity({2}, constant(1.5, 0.));
                       flow.begin_step(1e-8);
                       flow.set_mesh_displacement(displacement(flow, wave));
                       const unsigned int n = flow.boundary().nodes({3}).size();
                       flow.boundary().set_robin({3},
                                                 std::vector<double>(n, alpha),
                                                 flow.wall_mesh_velocity({3}),
                                                 NodalVectors(n));
                       solve(flow);
                     },
                     {{0, 1, 0}});
}



TEST(KrylovSolver, solves_stabilised_elements_of_equal_order)
{
  const auto mesh = rectangle(12, 12);
  for (const unsigned int degree : {1, 2})
    for (const double dt : {1e-8, 1e-2})
      {
        FluidOptions options = unit_fluid(0.01, FluidTimeScheme::bdf2);
        options.element      = FluidElement::equal_order;
        options.degree       = degree;
        expect_same_flow(*mesh, options, two_steps_of_cavity(dt));
      }
}



// The number of iterations of one solution does not follow the mesh.
TEST(KrylovSolver, iterations_are_bounded_under_refinement)
{
  for (const double dt : {0., 1e-4, 1e-2})
    {
      unsigned int last = 0;
      for (const unsigned int n : {16, 32, 64})
        {
          const auto   mesh        = rectangle(n, n);
          FluidOptions options     = unit_fluid(1.,
                                            dt == 0. ? FluidTimeScheme::steady :
                                                           FluidTimeScheme::bdf2);
          options.model.convection = false;
          options.linear_solver    = FlowSolverKind::krylov;
          NavierStokes flow(*mesh, options);
          set_cavity(flow);
          if (dt > 0.)
            flow.begin_step(dt);
          solve(flow);
          const auto        &counts = flow.statistics();
          const unsigned int now = counts.linear_iterations / counts.iterations;
          if (last > 0)
            {
              EXPECT_LE(now, last + 5) << "dt " << dt << ", " << n;
            }
          EXPECT_LE(now, 60U);
          last = now;
        }
    }
}



TEST(KrylovSolver, says_why_there_is_no_solution)
{
  const auto   mesh                 = rectangle(8, 8);
  FluidOptions options              = unit_fluid(1., FluidTimeScheme::steady);
  options.linear_solver             = FlowSolverKind::krylov;
  options.krylov.maximum_iterations = 2;
  NavierStokes flow(*mesh, options);
  set_cavity(flow);
  const ConvergenceReport report = flow.solve();
  EXPECT_FALSE(report.converged);
  EXPECT_NE(report.reason.find("2 iterations"), std::string::npos)
    << report.reason;
}
