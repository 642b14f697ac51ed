// Fluid-structure benchmarks that take longer than a test should; the problems
// are those of parameter_files/fluid_structure:
//
//   fsi_benchmarks fsi1 [DEGREE REFINEMENTS WALL_LAYERS CORNER_LAYERS SPANS_X
//     SPANS_Y]
//   fsi_benchmarks box
//   fsi_benchmarks pulse
//   fsi_benchmarks added_mass [DENSITY_RATIO DT]
//
// prints tables: the flag over meshes, the volume of the inflatable box, the
// speed of a pulse in a lined channel, and which schemes bear which ratio of
// densities. The swinging flags, FSI2 and FSI3, are run by their parameter
// files.

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>

#include <deal.II/base/timer.h>

#include <fluid_structure/problems.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

namespace
{
  using namespace asperity;
  using dealii::Point;

  struct SteadyRow
  {
    unsigned int degree, refinements, wall_layers, corner_layers;
    unsigned int spans_x, spans_y;
  };

  void
  steady_flag(const std::vector<SteadyRow> &rows)
  {
    std::cout << "| elements | refinements | fluid unknowns | flag | ux 1e-5 m "
                 "| uy 1e-4 m | drag N/m | lift N/m | iterations | seconds |\n";
    for (const SteadyRow &row : rows)
      {
        FluidStructureParameters parameters = read_problem("fsi1");
        parameters.fluid.degree             = row.degree;
        parameters.fluid.refinements        = row.refinements;
        parameters.fluid.wall_layers        = row.wall_layers;
        parameters.fluid.corner_layers      = row.corner_layers;
        parameters.body.degree              = 4;
        parameters.body.spans_along         = row.spans_x;
        parameters.body.spans_across        = row.spans_y;
        parameters.coupling.tolerance       = 1e-7;
        dealii::Timer           timer;
        const auto              problem = make_problem(parameters);
        NavierStokes           &flow    = problem->system->flow();
        const ConvergenceReport report  = problem->system->advance(1.);
        const auto              tip     = problem->displacement();
        const auto              force = flow.total_wall_force(problem->loaded);
        std::cout << "| Q" << row.degree << "/Q" << row.degree - 1 << " | "
                  << row.refinements << " + " << row.wall_layers << " + "
                  << row.corner_layers << " | " << flow.space().dofs().n_dofs()
                  << " | p = 4, " << row.spans_x << " x " << row.spans_y
                  << " | " << std::setprecision(7) << 1e5 * tip[0] << " | "
                  << 1e4 * tip[1] << " | " << force[0] << " | " << force[1]
                  << " | "
                  << (report.converged ? std::to_string(report.iterations) :
                                         report.reason)
                  << " | " << std::setprecision(3) << timer.wall_time()
                  << " |\n"
                  << std::flush;
      }
  }



  void
  inflate_box(const unsigned int refinements, const double end_time)
  {
    FluidStructureParameters parameters = read_problem("inflatable_box");
    parameters.fluid.refinements        = refinements;
    const auto         box              = make_problem(parameters);
    NavierStokes      &flow             = box->system->flow();
    const double       dt = 0.02, start = flow.volume();
    const unsigned int n_steps = std::lround(end_time / dt);
    double             volume = start, inflow = 0., largest_error = 0.;
    unsigned int       n_iterations = 0;
    std::cout << "| t s | volume m^2 | error of a step | error of the sum | p "
                 "at (-1, 2.2) Pa | iterations a step |\n";
    for (unsigned int i = 1; i <= n_steps; ++i)
      {
        const ConvergenceReport report = box->system->advance(dt);
        if (!report.converged)
          {
            std::cout << i * dt << ": " << report.reason << '\n';
            return;
          }
        n_iterations += report.iterations;
        const double step = dt * inflow_of_box(parameters.problem, i * dt);
        inflow += step;
        largest_error =
          std::max(largest_error,
                   std::abs((flow.volume() - volume) / step - 1.));
        volume = flow.volume();
        if (i % std::max(n_steps / 8, 1u) == 0)
          std::cout << "| " << i * dt << " | " << std::setprecision(7) << volume
                    << " | " << std::setprecision(2) << largest_error << " | "
                    << (volume - start) / inflow - 1. << " | "
                    << std::setprecision(5)
                    << flow.pressure_at(Point<2>(-1., 2.2 - 1e-9)) << " | "
                    << std::setprecision(3) << double(n_iterations) / i
                    << " |\n"
                    << std::flush;
      }
  }



  /** Pressure of a box that is filled and then shut: at rest it belongs to the
   *  volume, however many steps have passed. */
  void
  shut_box(const unsigned int refinements, const double end_time)
  {
    FluidStructureParameters parameters = read_problem("inflatable_box");
    parameters.fluid.refinements        = refinements;
    parameters.problem.inflow_end       = 0.5;
    std::cout << "| dt s | t s | volume m^2 | p at (-1, 2.2) Pa: mean | half "
                 "range | iterations a step |\n";
    for (const double dt : {0.04, 0.02, 0.01})
      {
        const auto         box          = make_problem(parameters);
        NavierStokes      &flow         = box->system->flow();
        const unsigned int n_steps      = std::lround(end_time / dt);
        const unsigned int per_second   = std::lround(1. / dt);
        unsigned int       n_iterations = 0;
        double             sum = 0., lowest = INFINITY, highest = -INFINITY;
        for (unsigned int i = 1; i <= n_steps; ++i)
          {
            const ConvergenceReport report = box->system->advance(dt);
            if (!report.converged)
              {
                std::cout << i * dt << ": " << report.reason << '\n';
                break;
              }
            n_iterations += report.iterations;
            const double p = flow.pressure_at(Point<2>(-1., 2.2 - 1e-9));
            sum += p;
            lowest  = std::min(lowest, p);
            highest = std::max(highest, p);
            if (i % per_second == 0)
              {
                std::cout << "| " << dt << " | " << std::setprecision(3)
                          << i * dt << " | " << std::setprecision(12)
                          << flow.volume() << " | " << std::setprecision(8)
                          << sum / per_second << " | " << std::setprecision(3)
                          << 0.5 * (highest - lowest) << " | "
                          << double(n_iterations) / i << " |\n"
                          << std::flush;
                sum     = 0.;
                lowest  = INFINITY;
                highest = -INFINITY;
              }
          }
      }
  }



  /** Time at which the wall's displacement is largest, by a parabola through
   *  three values. */
  double
  time_of_peak(const std::vector<double> &values, const double dt)
  {
    const auto i =
      std::max_element(values.begin(), values.end()) - values.begin();
    if (i == 0 || i + 1 == static_cast<long>(values.size()))
      return NAN;
    const double slope  = 0.5 * (values[i + 1] - values[i - 1]);
    const double second = values[i + 1] - 2. * values[i] + values[i - 1];
    return (i - slope / second) * dt;
  }



  void
  travelling_pulse()
  {
    FluidStructureParameters parameters = read_problem("lined_channel");
    // between the watched points, of the lining without its ends
    const double length = 0.1 * (1. - 2. / parameters.fluid.cells_along);
    std::cout << "| dt s | speed m/s | over sqrt(M h/(rho H)) | iterations a "
                 "step |\n";
    for (const double dt : {2e-4, 1e-4, 5e-5})
      {
        const auto          problem = make_problem(parameters);
        FluidStructure     &system  = *problem->system;
        std::vector<double> near(1), far(1);
        const unsigned int  n_steps      = std::lround(0.017 / dt);
        unsigned int        n_iterations = 0;
        for (unsigned int i = 0; i < n_steps; ++i)
          {
            n_iterations += system.advance(dt).iterations;
            near.push_back(system.displacement({0.25, 0.})[1]);
            far.push_back(system.displacement({0.65, 0.})[1]);
          }
        const double speed =
          0.4 * length / (time_of_peak(far, dt) - time_of_peak(near, dt));
        std::cout << "| " << dt << " | " << std::setprecision(4) << speed
                  << " | " << speed / wave_speed_of_lined_channel(parameters)
                  << " | " << double(n_iterations) / n_steps << " |\n"
                  << std::flush;
      }
  }



  /** Mean iterations of ten steps, or a dash. */
  std::string
  iterations_of(const FluidStructureParameters &parameters, const double dt)
  {
    const auto         problem      = make_problem(parameters);
    const unsigned int n_steps      = 10;
    double             n_iterations = 0.;
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        const ConvergenceReport report = problem->system->advance(dt);
        if (!report.converged)
          return "-";
        n_iterations += report.iterations;
      }
    std::ostringstream text;
    text << std::setprecision(3) << n_iterations / n_steps;
    return text.str();
  }



  void
  added_mass(const std::vector<double> &ratios,
             const std::vector<double> &time_steps)
  {
    std::cout << "| density of solid/fluid | dt s | D-N | D-N, Aitken | D-N, "
                 "IQN-ILS | R-N | R-N, Aitken | R-N, IQN-ILS |\n";
    for (const double ratio : ratios)
      for (const double dt : time_steps)
        {
          FluidStructureParameters parameters = read_problem("lined_channel");
          parameters.fluid.cells_along        = 20;
          parameters.material.elasticity.density =
            ratio * parameters.fluid.density;
          parameters.problem.pulse_duration      = 20. * dt;
          parameters.coupling.maximum_iterations = 60;
          std::cout << "| " << ratio << " | " << dt;
          for (const auto scheme : {CouplingScheme::dirichlet_neumann,
                                    CouplingScheme::robin_neumann})
            for (const auto kind : {AccelerationKind::relaxation,
                                    AccelerationKind::aitken,
                                    AccelerationKind::iqn_ils})
              {
                parameters.coupling.scheme            = scheme;
                parameters.coupling.acceleration.kind = kind;
                std::cout << " | " << iterations_of(parameters, dt)
                          << std::flush;
              }
          std::cout << " |\n";
        }
  }



  int
  run(const std::vector<std::string> &arguments)
  {
    const std::string command = arguments.empty() ? "" : arguments[0];
    if (command == "fsi1")
      {
        std::vector<SteadyRow> rows = {{2, 2, 0, 0, 48, 5},
                                       {2, 2, 2, 2, 48, 5},
                                       {3, 1, 1, 2, 48, 5},
                                       {3, 1, 2, 3, 48, 5},
                                       {3, 2, 1, 3, 48, 5},
                                       {3, 2, 1, 3, 72, 8},
                                       {3, 2, 2, 4, 72, 8},
                                       {4, 2, 1, 4, 72, 8}};
        if (arguments.size() == 7)
          {
            std::vector<unsigned int> n;
            for (unsigned int i = 1; i < arguments.size(); ++i)
              n.push_back(std::stoul(arguments[i]));
            rows = {{n[0], n[1], n[2], n[3], n[4], n[5]}};
          }
        steady_flag(rows);
        return 0;
      }
    if (command == "box")
      {
        inflate_box(2, 4.);
        shut_box(1, 6.);
        return 0;
      }
    if (command == "pulse")
      {
        travelling_pulse();
        return 0;
      }
    if (command == "added_mass")
      {
        if (arguments.size() == 3)
          added_mass({std::stod(arguments[1])}, {std::stod(arguments[2])});
        else
          added_mass({0.1, 1., 10., 100.}, {1e-3, 1e-4, 1e-5, 1e-6});
        return 0;
      }
    std::cerr
      << "usage: fsi_benchmarks fsi1 [...]|box|pulse|added_mass [...]\n";
    return 2;
  }
} // namespace



int
main(int argc, char **argv)
{
  asperity::use_one_thread_per_rank();
  const asperity::MpiSession mpi(argc, argv);
  try
    {
      return run({argv + 1, argv + argc});
    }
  catch (const std::exception &exception)
    {
      std::cerr << exception.what() << '\n';
      return 1;
    }
}
