// Fluid-structure benchmarks that take longer than a test should:
//
//   fsi_benchmarks fsi1
//   fsi_benchmarks fsi2|fsi3 REFINEMENTS WALL_LAYERS DT END_TIME FILE.csv
//   fsi_benchmarks box
//   fsi_benchmarks pulse
//   fsi_benchmarks added_mass
//
// fsi2 and fsi3 write a row a step: time, tip displacement, drag and lift,
// coupling iterations, and print the mean number of iterations;
// tools/benchmarks/fsi_charts.py draws and measures them. The others print
// tables: the flag over meshes, the volume of the inflatable box, the speed of
// a pulse in a lined channel, and which schemes bear which ratio of densities.

#include <asperity/base/environment.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <coupling/inflatable_box.h>
#include <coupling/lined_channel.h>
#include <coupling/turek_fsi.h>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

namespace
{
  using namespace turek_fsi;

  void
  steady_flag()
  {
    std::cout
      << "| refinements | wall layers | fluid unknowns | flag | ux 1e-5 "
         "m | uy 1e-4 m | drag N/m | lift N/m | iterations | seconds "
         "|\n";
    for (const auto &[refinements, layers] :
         {std::pair<unsigned int, unsigned int>{0, 0},
          {1, 0},
          {1, 1},
          {2, 0},
          {2, 1},
          {3, 0},
          {3, 1}})
      {
        Discretization discretization;
        discretization.refinements    = refinements;
        discretization.wall_layers    = layers;
        discretization.degree         = 4;
        discretization.spans_x        = 48;
        discretization.spans_y        = 5;
        FluidStructureOptions options = default_options(fsi1);
        options.coupling.tolerance    = 1e-7;
        dealii::Timer           timer;
        TurekFsi                fsi(fsi1, discretization, options);
        const ConvergenceReport report = fsi.problem->advance(1.);
        const auto              tip    = fsi.tip();
        const auto              force  = fsi.drag_and_lift();
        std::cout << "| " << refinements << " | " << layers << " | "
                  << fsi.problem->flow().space().dofs().n_dofs()
                  << " | p = 4, 48 x 5 | " << std::setprecision(7)
                  << 1e5 * tip[0] << " | " << 1e4 * tip[1] << " | " << force[0]
                  << " | " << force[1] << " | "
                  << (report.converged ? std::to_string(report.iterations) :
                                         report.reason)
                  << " | " << std::setprecision(3) << timer.wall_time()
                  << " |\n"
                  << std::flush;
      }
  }



  int
  swinging_flag(const Case           &data,
                const Discretization &discretization,
                const double          dt,
                const double          end_time,
                const std::string    &file_name)
  {
    TurekFsi fsi(data, discretization, default_options(data));
    std::cout << fsi.problem->flow().space().dofs().n_dofs()
              << " unknowns of the fluid\n"
              << std::flush;
    std::ofstream table(file_name);
    table << "time,ux,uy,drag,lift,iterations,alpha\n" << std::setprecision(9);
    const unsigned int n_steps      = std::lround(end_time / dt);
    unsigned int       n_iterations = 0, maximum = 0;
    dealii::Timer      timer;
    for (unsigned int i = 1; i <= n_steps; ++i)
      {
        const ConvergenceReport report = fsi.problem->advance(dt);
        if (!report.converged)
          {
            std::cerr << "t = " << i * dt << " s: " << report.reason
                      << ", residual " << report.residual << '\n';
            return 1;
          }
        n_iterations += report.iterations;
        maximum          = std::max(maximum, report.iterations);
        const auto tip   = fsi.tip();
        const auto force = fsi.drag_and_lift();
        table << i * dt << ',' << tip[0] << ',' << tip[1] << ',' << force[0]
              << ',' << force[1] << ',' << report.iterations << ','
              << fsi.problem->coupling().robin_coefficient() << '\n'
              << std::flush;
      }
    std::cout << n_steps << " steps, " << double(n_iterations) / n_steps
              << " coupling iterations a step, at most " << maximum << ", "
              << timer.wall_time() << " s\n";
    return 0;
  }



  void
  inflate_box(const unsigned int refinements, const double end_time)
  {
    using inflatable_box::InflatableBox;
    InflatableBox      box(refinements, 4, InflatableBox::default_options());
    NavierStokes      &flow = box.problem->flow();
    const double       dt = 0.02, start = flow.volume();
    const unsigned int n_steps = std::lround(end_time / dt);
    double             volume = start, inflow = 0., largest_error = 0.;
    unsigned int       n_iterations = 0;
    std::cout << "| t s | volume m^2 | error of a step | error of the sum | p "
                 "at (-1, 2.2) Pa | iterations a step |\n";
    for (unsigned int i = 1; i <= n_steps; ++i)
      {
        const ConvergenceReport report = box.problem->advance(dt);
        if (!report.converged)
          {
            std::cout << i * dt << ": " << report.reason << '\n';
            return;
          }
        n_iterations += report.iterations;
        const double step = dt * InflatableBox::inflow(i * dt);
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
    const lined_channel::LinedChannel data;
    std::cout << "| dt s | speed m/s | over sqrt(M h/(rho H)) | iterations a "
                 "step |\n";
    for (const double dt : {2e-4, 1e-4, 5e-5})
      {
        dealii::Triangulation<2> mesh;
        const auto               problem = data.problem(mesh, data.options());
        std::vector<double>      near(1), far(1);
        const unsigned int       n_steps      = std::lround(0.017 / dt);
        unsigned int             n_iterations = 0;
        for (unsigned int i = 0; i < n_steps; ++i)
          {
            n_iterations += problem->advance(dt).iterations;
            near.push_back(problem->displacement({0.25, 0.})[1]);
            far.push_back(problem->displacement({0.65, 0.})[1]);
          }
        const double speed = 0.4 * (data.length - 2. * data.end()) /
                             (time_of_peak(far, dt) - time_of_peak(near, dt));
        std::cout << "| " << dt << " | " << std::setprecision(4) << speed
                  << " | " << speed / data.wave_speed() << " | "
                  << double(n_iterations) / n_steps << " |\n"
                  << std::flush;
      }
  }



  /** Mean iterations of ten steps, or a dash. */
  std::string
  iterations_of(const lined_channel::LinedChannel &data,
                const FluidStructureOptions       &options,
                const double                       dt)
  {
    dealii::Triangulation<2> mesh;
    const auto               problem      = data.problem(mesh, options);
    const unsigned int       n_steps      = 10;
    double                   n_iterations = 0.;
    for (unsigned int i = 0; i < n_steps; ++i)
      {
        const ConvergenceReport report = problem->advance(dt);
        if (!report.converged)
          return "-";
        n_iterations += report.iterations;
      }
    std::ostringstream text;
    text << std::setprecision(3) << n_iterations / n_steps;
    return text.str();
  }



  void
  added_mass()
  {
    std::cout << "| density of solid/fluid | dt s | D-N | D-N, Aitken | D-N, "
                 "IQN-ILS | R-N | R-N, Aitken | R-N, IQN-ILS |\n";
    for (const double ratio : {0.1, 1., 10., 100.})
      for (const double dt : {1e-3, 1e-4, 1e-5, 1e-6})
        {
          lined_channel::LinedChannel data;
          data.cells         = 20;
          data.solid_density = ratio * data.fluid_density;
          data.pulse_time    = 20. * dt;
          std::cout << "| " << ratio << " | " << dt;
          for (const auto scheme : {CouplingScheme::dirichlet_neumann,
                                    CouplingScheme::robin_neumann})
            for (const auto kind : {AccelerationKind::relaxation,
                                    AccelerationKind::aitken,
                                    AccelerationKind::iqn_ils})
              {
                FluidStructureOptions options       = data.options();
                options.coupling.scheme             = scheme;
                options.coupling.acceleration.kind  = kind;
                options.coupling.maximum_iterations = 60;
                std::cout << " | " << iterations_of(data, options, dt)
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
        steady_flag();
        return 0;
      }
    if (command == "box")
      {
        inflate_box(2, 4.);
        return 0;
      }
    if (command == "pulse")
      {
        travelling_pulse();
        return 0;
      }
    if (command == "added_mass")
      {
        added_mass();
        return 0;
      }
    if ((command == "fsi2" || command == "fsi3") && arguments.size() == 6)
      {
        Discretization discretization;
        discretization.refinements = std::stoul(arguments[1]);
        discretization.wall_layers = std::stoul(arguments[2]);
        return swinging_flag(command == "fsi2" ? fsi2 : fsi3,
                             discretization,
                             std::stod(arguments[3]),
                             std::stod(arguments[4]),
                             arguments[5]);
      }
    std::cerr << "usage: fsi_benchmarks fsi1|box|pulse|added_mass, or\n"
                 "       fsi_benchmarks fsi2|fsi3 REFINEMENTS WALL_LAYERS DT "
                 "END_TIME FILE.csv\n";
    return 2;
  }
} // namespace



int
main(int argc, char **argv)
{
  asperity::use_one_thread_per_rank();
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
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
