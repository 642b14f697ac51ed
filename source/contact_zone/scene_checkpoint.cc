#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/contact_zone/scene_checkpoint.h>
#include <asperity/contact_zone/scene_heat.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    /** Rows are stored by column, so these have to be the same. */
    std::vector<std::string>
    column_names()
    {
      std::vector<std::string> names;
      for (const FrictionColumn &column : friction_columns())
        names.push_back(column.heading());
      return names;
    }

    void
    check_columns(InputArchive &archive)
    {
      std::vector<std::string> columns;
      archive >> columns;
      if (columns != column_names())
        throw InputError("The checkpoint is of a program whose friction.csv "
                         "has other columns; expected one of this program.");
    }

    void
    load_state(InputArchive &archive, RunState &state)
    {
      const std::size_t n = state.u.size(), n_points = state.coverage.size();
      archive >> state;
      require_length("displacements", state.u.size(), n);
      require_length("displacements", state.u_previous.size(), n);
      require_length("points of the contact", state.coverage.size(), n_points);
    }

    /** Level and spans of each cell. */
    template <int dim>
    void
    save_mesh(OutputArchive &archive, const SplineHierarchy<dim> &hierarchy)
    {
      std::vector<unsigned int> numbers;
      for (unsigned int cell = 0; cell < hierarchy.n_cells(); ++cell)
        {
          const CellIndex<dim> &index = hierarchy.cell_index(cell);
          numbers.push_back(index.level);
          numbers.insert(numbers.end(), index.spans.begin(), index.spans.end());
        }
      archive << numbers;
    }

    template <int dim>
    void
    load_mesh(InputArchive &archive, SlidingRun<dim> &run)
    {
      std::vector<unsigned int> numbers;
      archive >> numbers;
      std::vector<CellIndex<dim>> cells(numbers.size() / (dim + 1));
      require_length("cells", numbers.size(), (dim + 1) * cells.size());
      for (std::size_t cell = 0; cell < cells.size(); ++cell)
        {
          const unsigned int *number = &numbers[(dim + 1) * cell];
          cells[cell].level          = *number;
          std::copy(number + 1, number + 1 + dim, cells[cell].spans.begin());
        }
      run.set_mesh(cells);
    }
  } // namespace



  template <int dim>
  std::string
  save(const SlidingRun<dim> &run, const Scene<dim> &scene)
  {
    return to_bytes([&](OutputArchive &archive) {
      archive << column_names();
      if (run.changes_mesh())
        save_mesh(archive, *scene.space->hierarchy());
      archive << run.state() << scene.chip->history()
              << scene.contact->multipliers() << scene.contact->hints();
      if (const ShearTraction<dim> *shear = scene.contact->shear())
        archive << shear->history().tractions << shear->history().pressures
                << shear->history().positions;
      if (scene.lubricant)
        scene.lubricant->save(archive);
      if (scene.heat)
        scene.heat->save(archive);
      if (const LubricatedStep *step = run.lubricated_step())
        step->save(archive);
      const SolidStep::State motion = run.solid_step().state();
      if (run.solid_step().is_dynamic())
        archive << motion.v << motion.a << motion.forces << motion.energy;
    });
  }



  template <int dim>
  void
  load(const std::string &bytes, SlidingRun<dim> &run, Scene<dim> &scene)
  {
    RunState                             state;
    SolidStep::State                     motion;
    std::vector<MaterialState>           history;
    std::vector<double>                  multipliers;
    std::vector<dealii::Point<dim - 1>>  hints;
    typename ShearTraction<dim>::History shear;
    from_bytes(bytes, "The state of the run", [&](InputArchive &archive) {
      check_columns(archive);
      if (run.changes_mesh())
        load_mesh(archive, run);
      state       = run.state();
      motion      = run.solid_step().state();
      history     = scene.chip->history();
      multipliers = scene.contact->multipliers();
      hints       = scene.contact->hints();
      if (scene.contact->shear() != nullptr)
        shear = scene.contact->shear()->history();
      load_state(archive, state);
      archive >> fixed_length(history, "material points") >>
        fixed_length(multipliers, "pressures of the contact") >>
        fixed_length(hints, "positions of the contact");
      if (scene.contact->shear() != nullptr)
        archive >> fixed_length(shear.tractions, "shear tractions") >>
          fixed_length(shear.pressures, "pressures of spots") >>
          fixed_length(shear.positions, "points of the contact");
      if (scene.lubricant)
        scene.lubricant->load(archive);
      if (scene.heat)
        scene.heat->load(archive);
      if (LubricatedStep *step = run.lubricated_step())
        step->load(archive);
      if (run.solid_step().is_dynamic())
        archive >> fixed_length(motion.v, "velocities") >>
          fixed_length(motion.a, "accelerations") >>
          fixed_length(motion.forces, "forces") >> motion.energy;
    });
    motion.u = state.u;
    run.solid_step().set_state(motion);
    scene.chip->set_history(history);
    scene.contact->set_multipliers(multipliers);
    scene.contact->set_hints(hints);
    if (scene.contact->shear() != nullptr)
      scene.contact->shear()->set_history(shear);
    run.set_state(state);
  }



  template std::string
  save(const SlidingRun<2> &, const Scene<2> &);
  template std::string
  save(const SlidingRun<3> &, const Scene<3> &);
  template void
  load(const std::string &, SlidingRun<2> &, Scene<2> &);
  template void
  load(const std::string &, SlidingRun<3> &, Scene<3> &);



  bool
  may_differ_on_restart(const std::string &path)
  {
    static const std::vector<std::string> entries = {
      // how mu is averaged, and how long a `steady` run goes on
      "Protocol/Window fraction",
      "Protocol/Steady distance",
      "Protocol/Steady tolerance",
      "Protocol/Maximum distance",
      // what is told of its error
      "Accuracy/Control",
      "Accuracy/Error",
      "Accuracy/Maximum unknowns",
      // how a solution is found, not what it is
      "Solver/Maximum iterations",
      "Solver/Maximum cuts",
      "Solver/Linear solver",
      "Coupling/Maximum iterations",
      // a fluid-structure problem goes on with other steps
      "Time/Steps",
      "Time/Ends",
      "Time/Maximum cuts"};
    return path.compare(0, 7, "Output/") == 0 ||
           std::find(entries.begin(), entries.end(), path) != entries.end();
  }



  CheckpointFolder::Found
  find_checkpoint(const CheckpointFolder &folder,
                  const InputRecord      &inputs,
                  const std::string      &program)
  {
    CheckpointFolder::Found found = folder.read_newest();
    const std::string       change =
      inputs.change_since(found.checkpoint.inputs, may_differ_on_restart);
    if (!change.empty())
      throw InputError("the checkpoint " + quoted_name(found.path) +
                       " is of a run with other inputs: " + change +
                       "; expected the inputs of that run, or a new run "
                       "(false).");
    if (found.checkpoint.program != program)
      found.warnings.push_back("The checkpoint " + quoted_name(found.path) +
                               " was written by another program, " +
                               found.checkpoint.program +
                               ", than the one that goes on from it.");
    return found;
  }
} // namespace asperity
