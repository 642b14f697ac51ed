#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/fluid_structure/fluid_structure_run.h>

#include <cmath>

namespace asperity
{
  std::vector<double>
  FluidStructureRow::values() const
  {
    return {time,
            displacement[0],
            displacement[1],
            force[0],
            force[1],
            mean_pressure,
            volume,
            iterations};
  }



  std::vector<TableColumn>
  FluidStructureRow::columns()
  {
    return {{"time [s]", "time [s]"},
            {"displacement x [m]", "displacement x [mm]", 1e3},
            {"displacement y [m]", "displacement y [mm]", 1e3},
            {"drag [N/m]", "drag [N/m]"},
            {"lift [N/m]", "lift [N/m]"},
            {"mean pressure [Pa]", "mean pressure [Pa]"},
            {"volume of the fluid [m^2]", "volume of the fluid [m^2]"},
            {"coupling iterations [-]", "coupling iterations [-]"}};
  }



  FluidStructureRun::FluidStructureRun(
    const FluidStructureParameters &parameters,
    FluidStructureProblem          &problem)
    : parameters(parameters)
    , problem_(problem)
    , initial_volume_(problem.system->flow().volume())
  {}



  void
  FluidStructureRun::run(
    const std::function<void(const FluidStructureRun &)> &after_step)
  {
    while (const double dt = parameters.time.step_at(time_))
      {
        const double end = time_ + dt;
        // A step that was cut leaves a rest.
        while (time_ < end - 1e-6 * dt)
          {
            step(end - time_);
            after_step(*this);
          }
      }
  }



  void
  FluidStructureRun::step(double dt)
  {
    FluidStructure   &system = *problem_.system;
    ConvergenceReport report = system.advance(dt);
    for (unsigned int cut = 0;
         !report.converged && cut < parameters.time.maximum_cuts;
         ++cut)
      {
        ++n_cuts_;
        dt *= 0.5;
        report = system.advance(dt);
      }
    if (!report.converged)
      throw ComputationError(
        "The step from t = " + format_quantity(time_, "s", 4) + " to " +
        format_quantity(time_ + dt, "s", 4) + " has no solution" +
        (parameters.time.maximum_cuts > 0 ?
           " although it has been halved " +
             std::to_string(parameters.time.maximum_cuts) + " times" :
           "") +
        ": " + report.reason + ".");
    time_ += dt;
    FluidStructureRow row;
    row.time          = time_;
    row.displacement  = problem_.displacement();
    row.force         = system.flow().total_wall_force(problem_.loaded);
    row.mean_pressure = problem_.mean_pressure();
    row.volume        = system.flow().volume();
    row.iterations    = report.iterations;
    rows_.push_back(row);
  }



  void
  FluidStructureRun::continue_from(const FluidStructureRun &other)
  {
    problem_.system->continue_from(*other.problem_.system);
    time_ = other.time_;
  }



  double
  FluidStructureRun::time() const
  {
    return time_;
  }



  const std::vector<FluidStructureRow> &
  FluidStructureRun::rows() const
  {
    return rows_;
  }



  unsigned int
  FluidStructureRun::n_cuts() const
  {
    return n_cuts_;
  }



  double
  FluidStructureRun::initial_volume() const
  {
    return initial_volume_;
  }



  const FluidStructureProblem &
  FluidStructureRun::problem() const
  {
    return problem_;
  }



  std::string
  FluidStructureRun::save() const
  {
    problem_.system->flow().forget_tangent();
    return to_bytes([&](OutputArchive &archive) {
      archive << time_ << n_cuts_ << rows_;
      problem_.system->save(archive);
    });
  }



  void
  FluidStructureRun::load(const std::string &bytes)
  {
    from_bytes(bytes, "The state of the run", [&](InputArchive &archive) {
      archive >> time_ >> n_cuts_ >> rows_;
      problem_.system->load(archive);
    });
    problem_.system->flow().forget_tangent();
  }
} // namespace asperity
