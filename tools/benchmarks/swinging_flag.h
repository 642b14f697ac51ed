#ifndef asperity_benchmarks_swinging_flag_h
#define asperity_benchmarks_swinging_flag_h

#include <asperity/base/archive.h>
#include <asperity/base/atomic_file.h>

#include <deal.II/base/timer.h>
#include <deal.II/base/utilities.h>

#include <coupling/turek_fsi.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/**
 * Turek-Hron FSI2 and FSI3: the history of the swinging flag as a CSV file, a
 * row a step. Every so many steps all is saved beside it in FILE.csv.state,
 * from which a run that was stopped goes on; a state that is copied can be
 * continued with other steps.
 */
namespace turek_fsi
{
  /** Time steps, each up to a time [s]: "0.005:2,0.001:6". */
  class StepPlan
  {
  public:
    explicit StepPlan(const std::string &text)
    {
      for (const std::string &entry :
           dealii::Utilities::split_string_list(text, ','))
        {
          const auto pair = dealii::Utilities::split_string_list(entry, ':');
          parts.emplace_back(std::stod(pair.at(0)), std::stod(pair.at(1)));
        }
    }

    /** The step that starts at a time; 0 at the end. */
    double
    step_at(const double time) const
    {
      for (const auto &[dt, end] : parts)
        if (time < end - 0.5 * dt)
          return dt;
      return 0.;
    }

  private:
    std::vector<std::pair<double, double>> parts;
  };

  /** Two periods of a vertical body force on the fluid, 5 m/s^2, when the
   *  inflow has its final value: the swing is unstable from rest, but takes
   *  seconds to grow from round-off. Afterwards nothing is left of it but the
   *  swing. */
  inline FluidFunction
  shake(const double frequency)
  {
    return [frequency](const Point<2> &, const double t) {
      const double periods = (t - 2.) * frequency;
      Tensor<1, 2> b;
      if (periods > 0. && periods < 2.)
        b[1] = 5. * std::sin(2. * M_PI * periods);
      return b;
    };
  }

  class SwingingFlag
  {
  public:
    SwingingFlag(const Case           &data,
                 const Discretization &discretization,
                 const std::string    &file_name)
      : fsi(data, discretization, options(data))
      , file_name(file_name)
      , state_name(file_name + ".state")
    {
      if (std::filesystem::exists(state_name))
        resume();
      else
        std::ofstream(file_name) << "time,ux,uy,drag,lift,iterations,alpha\n";
    }

    /** Starts from the state of another mesh, unless there is a state of its
     *  own. */
    void
    continue_from(const SwingingFlag &other)
    {
      if (!std::filesystem::exists(state_name))
        fsi.problem->continue_from(*other.fsi.problem);
    }

    /** @return exit status */
    int
    run(const StepPlan &plan)
    {
      std::cout << fsi.problem->flow().space().dofs().n_dofs()
                << " unknowns of the fluid\n"
                << std::flush;
      dealii::Timer timer;
      unsigned int  n_steps = 0, n_iterations = 0, maximum = 0;
      while (const double dt = plan.step_at(fsi.problem->flow().time()))
        {
          const ConvergenceReport report = fsi.problem->advance(dt);
          if (!report.converged)
            {
              std::cerr << "t = " << fsi.problem->flow().time()
                        << " s: " << report.reason << ", residual "
                        << report.residual << '\n';
              return 1;
            }
          n_iterations += report.iterations;
          maximum = std::max(maximum, report.iterations);
          write_row(report.iterations);
          if (++n_steps % steps_between_states == 0)
            save();
        }
      save();
      const NewtonStatistics &counts = fsi.problem->flow().statistics();
      std::cout << n_steps << " steps, " << double(n_iterations) / n_steps
                << " coupling iterations a step, at most " << maximum << "; "
                << double(counts.linearizations) / n_steps
                << " tangents of the flow a step, "
                << double(counts.residuals) / n_steps << " residuals; "
                << timer.wall_time() << " s\n";
      return 0;
    }

  private:
    static FluidStructureOptions
    options(const Case &data)
    {
      FluidStructureOptions options          = default_options(data);
      options.fluid.kept_tangent_contraction = 0.3;
      options.fluid.tolerance                = 1e-11;
      options.fluid.model.body_force         = shake(data.frequency);
      return options;
    }

    void
    write_row(const unsigned int iterations)
    {
      const auto    tip   = fsi.tip();
      const auto    force = fsi.drag_and_lift();
      std::ofstream table(file_name, std::ios::app);
      table << std::setprecision(9) << fsi.problem->flow().time() << ','
            << tip[0] << ',' << tip[1] << ',' << force[0] << ',' << force[1]
            << ',' << iterations << ','
            << fsi.problem->coupling().robin_coefficient() << '\n';
    }

    void
    save()
    {
      write_atomically(state_name, [&](std::ostream &out) {
        out << to_bytes(
          [&](OutputArchive &archive) { fsi.problem->save(archive); });
      });
    }

    /** From the last state; rows after it are dropped. */
    void
    resume()
    {
      std::ifstream     in(state_name, std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(in), {}};
      from_bytes(bytes, "The file " + state_name, [&](InputArchive &archive) {
        fsi.problem->load(archive);
      });
      const double       time = fsi.problem->flow().time();
      std::ifstream      old(file_name);
      std::ostringstream kept;
      std::string        line;
      for (bool is_head = true; std::getline(old, line); is_head = false)
        if (is_head || std::stod(line) < time + 1e-9)
          kept << line << '\n';
      old.close();
      std::ofstream(file_name) << kept.str();
    }

    static constexpr unsigned int steps_between_states = 50;

    TurekFsi    fsi;
    std::string file_name, state_name;
  };
} // namespace turek_fsi

#endif
