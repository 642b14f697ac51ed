/*
 * Published benchmarks of the flow over mesh, degree and step, as Markdown
 * tables:
 *
 *   fluid_benchmarks dfg1 | dfg2 | cfd | ghia | krylov | all
 *
 * The example problems are those of the tests.
 */

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>

#include <deal.II/base/timer.h>

#include <flow/channel_examples.h>

#include <string>

#include "markdown_table.h"

namespace
{
  using namespace flow_examples;
  using namespace markdown_table;

  std::string
  element_name(const FluidElement element, const unsigned int degree)
  {
    const std::string k = std::to_string(degree);
    return element == FluidElement::taylor_hood ?
             "Q" + k + "/Q" + std::to_string(degree - 1) :
             "Q" + k + "/Q" + k + " stabilised";
  }

  void
  dfg1()
  {
    std::cout << "\nDFG 2D-1: references 5.57953523384, 0.010618948146, "
                 "0.11752016697\n\n";
    row("elements", "refinements", "unknowns", "drag", "lift", "dp", "seconds");
    row("---", "---", "---", "---", "---", "---", "---");
    struct Row
    {
      FluidElement element;
      unsigned int degree, uniform, layers;
    };
    constexpr auto TH = FluidElement::taylor_hood;
    constexpr auto EO = FluidElement::equal_order;
    for (const Row &r : {Row{TH, 2, 1, 0},
                         Row{TH, 2, 2, 0},
                         Row{TH, 2, 2, 1},
                         Row{TH, 2, 2, 2},
                         Row{TH, 2, 3, 0},
                         Row{TH, 2, 3, 2},
                         Row{TH, 3, 1, 0},
                         Row{TH, 3, 1, 1},
                         Row{TH, 3, 2, 0},
                         Row{TH, 3, 2, 1},
                         Row{TH, 4, 1, 0},
                         Row{TH, 4, 1, 1},
                         Row{TH, 4, 2, 0},
                         Row{EO, 1, 2, 0},
                         Row{EO, 1, 3, 0},
                         Row{EO, 2, 2, 0},
                         Row{EO, 2, 3, 0}})
      attempt([&r]() {
        dealii::Timer timer;
        const auto    c = dfg_2d_1(r.uniform, r.layers, r.degree, r.element);
        row(element_name(r.element, r.degree),
            std::to_string(r.uniform) + " + " + std::to_string(r.layers),
            c.n_dofs,
            c.drag,
            c.lift,
            c.pressure_difference,
            timer.wall_time());
      });
  }

  /** DFG 2D-2 from rest on; the extrema and the frequency of the last three
   *  periods. */
  void
  dfg2_run(const unsigned int degree,
           const unsigned int n_refinements,
           const double       dt,
           const double       end)
  {
    dealii::Timer timer;
    FluidOptions  options            = channel_options(1., 1e-3);
    options.degree                   = degree;
    options.geometry_degree          = degree;
    options.kept_tangent_contraction = 0.3;
    const auto          inflow       = [](const double) { return 1.; };
    ChannelFlow         channel(false, n_refinements, 0, options, inflow);
    NavierStokes       &flow = *channel.flow;
    std::vector<double> t, drag, lift;
    while (flow.time() < end)
      {
        // Coarse steps until the vortex street is there; a swing of the
        // cylinder's velocity wakes it up.
        flow.begin_step(flow.time() < 0.5 * end ? 2. * dt : dt);
        const double t_swing = std::min(flow.time() / 0.33, 1.);
        const double push    = std::sin(2. * dealii::numbers::PI * t_swing);
        flow.boundary().set_velocity(channel.walls, constant(0., push));
        solve(flow);
        flow.accept();
        t.push_back(flow.time());
        drag.push_back(20. * channel.force()[0]);
        lift.push_back(20. * channel.force()[1]);
      }
    // Periods between upward crossings of the mean lift, the last three.
    std::vector<double> crossings;
    for (unsigned int i = 1; i < t.size(); ++i)
      if (t[i] > 0.6 * end && lift[i - 1] < 0. && lift[i] >= 0.)
        crossings.push_back(t[i] - (t[i] - t[i - 1]) * lift[i] /
                                     (lift[i] - lift[i - 1]));
    const unsigned int last     = crossings.size() - 1;
    const double       begin    = crossings[last - 3];
    double             drag_max = -1e9, drag_min = 1e9;
    double             lift_max = -1e9, lift_min = 1e9;
    for (unsigned int i = 0; i < t.size(); ++i)
      if (t[i] >= begin && t[i] <= crossings[last])
        {
          drag_max = std::max(drag_max, drag[i]);
          drag_min = std::min(drag_min, drag[i]);
          lift_max = std::max(lift_max, lift[i]);
          lift_min = std::min(lift_min, lift[i]);
        }
    row(element_name(FluidElement::taylor_hood, degree),
        n_refinements,
        flow.space().dofs().n_dofs(),
        dt,
        drag_max,
        drag_min,
        lift_max - lift_min,
        0.1 * 3. / (crossings[last] - begin),
        timer.wall_time());
  }

  void
  dfg2()
  {
    std::cout << "\nDFG 2D-2: references 3.227393, 3.164263, 2.007871, "
                 "0.301841\n\n";
    row("elements",
        "refinements",
        "unknowns",
        "dt",
        "drag max",
        "drag min",
        "lift peak to peak",
        "St",
        "seconds");
    row("---", "---", "---", "---", "---", "---", "---", "---", "---");
    attempt([]() { dfg2_run(3, 1, 0.005, 8.); });
    attempt([]() { dfg2_run(3, 1, 0.0025, 8.); });
    attempt([]() { dfg2_run(4, 1, 0.0025, 8.); });
    attempt([]() { dfg2_run(3, 2, 0.0025, 8.); });
  }

  void
  cfd()
  {
    std::cout << "\nCFD1 and CFD2: references 14.292672, 1.118978 and "
                 "136.699862, 10.532045\n\n";
    row("elements", "refinements", "CFD1 drag", "lift", "CFD2 drag", "lift");
    row("---", "---", "---", "---", "---", "---");
    struct Row
    {
      unsigned int degree, uniform, layers;
    };
    for (const Row &r : {Row{2, 1, 1},
                         Row{2, 1, 3},
                         Row{2, 2, 1},
                         Row{2, 2, 3},
                         Row{2, 3, 1},
                         Row{2, 3, 3},
                         Row{3, 1, 3},
                         Row{3, 2, 1},
                         Row{3, 2, 3},
                         Row{4, 2, 3}})
      attempt([&r]() {
        const auto slow = turek_hron_cfd(0.2, r.uniform, r.layers, r.degree);
        const auto fast = turek_hron_cfd(1., r.uniform, r.layers, r.degree);
        row(element_name(FluidElement::taylor_hood, r.degree),
            std::to_string(r.uniform) + " + " + std::to_string(r.layers),
            slow[0],
            slow[1],
            fast[0],
            fast[1]);
      });
  }

  void
  ghia()
  {
    std::cout << "\nLid cavity: Ghia's minima of u are -0.21090, -0.32726, "
                 "-0.38289; Botella and Peyret at Re = 1000: -0.3885698\n\n";
    row("cells", "Re 100", "Re 400", "Re 1000", "seconds");
    row("---", "---", "---", "---", "---");
    for (const unsigned int n : {16, 32, 64})
      attempt([n]() {
        dealii::Timer       timer;
        LidCavity           cavity(n);
        std::vector<double> minima;
        for (const double Re : {100., 400., 1000.})
          {
            cavity.solve_at(Re);
            double minimum = 0.;
            for (unsigned int i = 1; i < 1000; ++i)
              minimum = std::min(minimum,
                                 cavity.flow->velocity_at({0.5, i / 1000.})[0]);
            minima.push_back(minimum);
          }
        row(std::to_string(n) + " x " + std::to_string(n),
            minima[0],
            minima[1],
            minima[2],
            timer.wall_time());
      });
  }

  /** What one flow costs with a solver. */
  struct Cost
  {
    double           seconds; ///< of the processor, for solve()
    NewtonStatistics statistics;
    unsigned int     n_dofs;
  };

  /** A flow on a mesh of some refinement, ready to be solved. */
  struct CostProblem
  {
    std::string                               name;
    FluidOptions                              options;
    std::function<void(Mesh &, unsigned int)> make_mesh;
    std::function<void(NavierStokes &)>       prepare;
    unsigned int first = 1, last = 4; ///< refinements
  };

  Cost
  cost(const CostProblem   &problem,
       const unsigned int   n_refinements,
       const FlowSolverKind kind)
  {
    Mesh mesh;
    problem.make_mesh(mesh, n_refinements);
    FluidOptions options  = problem.options;
    options.linear_solver = kind;
    NavierStokes flow(mesh, options);
    problem.prepare(flow);
    const NewtonStatistics before = flow.statistics();
    dealii::Timer          timer;
    solve(flow);
    Cost result;
    result.seconds    = timer.cpu_time();
    result.statistics = flow.statistics();
    result.statistics.iterations -= before.iterations;
    result.statistics.linear_iterations -= before.linear_iterations;
    result.n_dofs = flow.space().dofs().n_dofs();
    return result;
  }

  CostProblem
  cylinder_problem(const std::string    &name,
                   const FluidTimeScheme scheme,
                   const double          U,
                   const double          dt)
  {
    CostProblem problem;
    problem.name           = name;
    problem.options        = channel_options(1., 1e-3);
    problem.options.scheme = scheme;
    problem.make_mesh      = [](Mesh &mesh, const unsigned int n) {
      make_channel_with_cylinder(mesh, n, 0);
    };
    problem.prepare = [U, dt](NavierStokes &flow) {
      flow.boundary().set_velocity({channel_inlet},
                                   channel_inflow([U](double) { return U; }));
      flow.boundary().set_velocity({channel_walls, channel_cylinder},
                                   constant(0., 0.));
      if (dt > 0.)
        {
          flow.project_initial_velocity();
          flow.begin_step(dt);
        }
    };
    return problem;
  }

  CostProblem
  cavity_problem()
  {
    CostProblem problem;
    problem.name                     = "Stokes, cavity";
    problem.options.model.convection = false;
    problem.options.scheme           = FluidTimeScheme::steady;
    problem.make_mesh                = [](Mesh &mesh, const unsigned int n) {
      dealii::GridGenerator::hyper_cube(mesh, 0., 1., true);
      mesh.refine_global(n + 3);
    };
    problem.prepare = [](NavierStokes &flow) {
      flow.boundary().set_velocity({0, 1, 2}, constant(0., 0.));
      flow.boundary().set_velocity({3}, constant(1., 0.));
    };
    return problem;
  }

  void
  krylov()
  {
    std::cout << "\nDirect against Krylov: Newton iterations, linear "
                 "iterations a tangent, processor time of solve()\n\n";
    row("flow",
        "unknowns",
        "Newton, direct",
        "Newton, Krylov",
        "iterations",
        "seconds, direct",
        "seconds, Krylov",
        "direct/Krylov");
    row("---", "---", "---", "---", "---", "---", "---", "---");
    for (const CostProblem &problem :
         {cavity_problem(),
          cylinder_problem(
            "cylinder, steady, Re 20", FluidTimeScheme::steady, 0.2, 0.),
          cylinder_problem(
            "cylinder, Re 100, dt 5 ms", FluidTimeScheme::bdf2, 1., 0.005)})
      for (unsigned int n = problem.first; n <= problem.last; ++n)
        attempt([&]() {
          const Cost d = cost(problem, n, FlowSolverKind::direct);
          const Cost k = cost(problem, n, FlowSolverKind::krylov);
          row(problem.name,
              k.n_dofs,
              d.statistics.iterations,
              k.statistics.iterations,
              double(k.statistics.linear_iterations) / k.statistics.iterations,
              d.seconds,
              k.seconds,
              d.seconds / k.seconds);
        });
  }
} // namespace



int
main(int argc, char **argv)
{
  asperity::use_one_thread_per_rank();
  const asperity::MpiSession mpi(argc, argv);
  std::cout.precision(8);
  const std::string which = argc > 1 ? argv[1] : "all";
  if (which == "dfg1" || which == "all")
    dfg1();
  if (which == "cfd" || which == "all")
    cfd();
  if (which == "ghia" || which == "all")
    ghia();
  if (which == "krylov" || which == "all")
    krylov();
  if (which == "dfg2" || which == "all")
    dfg2();
}
