#include <asperity/base/atomic_file.h>
#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mpi_session.h>
#include <asperity/base/parameter_file.h>
#include <asperity/base/progress.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/contact_zone/scene_checkpoint.h>
#include <asperity/coupling/coupling_warnings.h>
#include <asperity/fluid_structure/commands.h>
#include <asperity/fluid_structure/fluid_structure_output.h>
#include <asperity/postprocess/output_folder.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <iostream>

namespace asperity
{
  namespace
  {
    /** A parameter file of a problem, declared, read and checked. */
    struct ProblemInput
    {
      explicit ProblemInput(const std::string &file)
        : declarator(handler)
      {
        parameters.declare(declarator);
        declarator.read_file(file);
        parameters.check(declarator);
        record = InputRecord(declarator);
      }

      dealii::ParameterHandler handler;
      ParameterDeclarator      declarator;
      FluidStructureParameters parameters;
      InputRecord              record;
    };

    /** @throws InputError that names the file */
    std::unique_ptr<FluidStructureProblem>
    build(const ProblemInput &input, const std::string &file)
    {
      try
        {
          return make_problem(input.parameters);
        }
      catch (const InputError &error)
        {
          throw InputError(file + ": " + error.what());
        }
    }

    std::vector<std::string>
    notes_on(const ProblemInput &input)
    {
      std::vector<std::string> notes;
      for (const std::string &note :
           {input.parameters.unused_entries(input.declarator),
            loose_tolerance_warning(input.parameters.coupling)})
        if (!note.empty())
          notes.push_back(note);
      return notes;
    }

    void
    print_problem(const FluidStructureParameters &parameters,
                  const FluidStructureProblem    &problem)
    {
      const FluidStructure &system = *problem.system;
      const FluidSpace     &space  = system.flow().space();
      std::cout << "Problem: " << name(parameters.problem.kind)
                << "\nFluid: " << problem.mesh.n_active_cells() << " cells, Q"
                << space.degree() << "/Q" << space.degree() - 1 << ", "
                << space.dofs().n_dofs() << " unknowns, "
                << format_quantity(system.flow().volume(), "m2", 6)
                << "\nBody: " << system.body().law->name() << ", degree "
                << system.body().space->degree() << ", "
                << system.body().space->n_cells() << " elements, "
                << 2 * system.body().space->n_functions()
                << " unknowns\nCoupling: "
                << (parameters.coupling.scheme ==
                        CouplingScheme::robin_neumann ?
                      "Robin-Neumann" :
                      "Dirichlet-Neumann")
                << "\n";
    }

    void
    print_notes(const std::vector<std::string> &notes)
    {
      for (const std::string &note : notes)
        std::cout << "Warning: " << note << "\n";
    }

    /** Starts from the end of another run, if the parameters name one.
     *  @throws InputError if it cannot be continued */
    void
    continue_from(const ProblemInput &input, FluidStructureRun &run)
    {
      const std::string &folder = input.parameters.problem.continue_from;
      if (folder.empty())
        return;
      try
        {
          const std::string  file = folder + "/parameters.prm";
          const ProblemInput earlier(file);
          const auto         problem = build(earlier, file);
          FluidStructureRun  end(earlier.parameters, *problem);
          end.load(CheckpointFolder(folder + "/checkpoint")
                     .read_newest()
                     .checkpoint.state);
          run.continue_from(end);
        }
      catch (const InputError &error)
        {
          throw InputError(input.declarator.where("Problem/Continue from") +
                           ": " + error.what());
        }
    }

    /** Loads what the parameters ask to go on from.
     *  @return warnings
     *  @throws InputError if there is none for these inputs */
    std::vector<std::string>
    resume(const ProblemInput &input, FluidStructureRun &run)
    {
      const OutputParameters &output = input.parameters.output;
      if (!output.restart)
        {
          continue_from(input, run);
          return {};
        }
      try
        {
          const auto found =
            find_checkpoint(CheckpointFolder(output.directory + "/checkpoint"),
                            input.record,
                            version_line());
          run.load(found.checkpoint.state);
          return found.warnings;
        }
      catch (const InputError &error)
        {
          throw InputError(input.declarator.where("Output/Restart") + ": " +
                           error.what());
        }
    }

    void
    compute(const FluidStructureParameters &parameters,
            FluidStructureOutput           &output,
            FluidStructureRun              &run)
    {
      ProgressLine progress(std::cout);
      try
        {
          run.run([&](const FluidStructureRun &now) {
            output.step(now);
            const FluidStructureRow &row = now.rows().back();
            progress.update(
              row.time / parameters.time.end(),
              "step " + std::to_string(now.rows().size()) + "  t = " +
                format_quantity(row.time, "s", 4) + "  displacement " +
                format_quantity(row.displacement.norm(), "mm", 4) + ", " +
                std::to_string(static_cast<unsigned int>(row.iterations)) +
                " iterations");
          });
          progress.note("");
        }
      catch (const ComputationError &error)
        {
          output.write_checkpoint(run);
          throw ComputationError(
            std::string(error.what()) + " The last good state is in " +
            quoted_name(parameters.output.directory + "/checkpoint") + ".");
        }
    }

    void
    print_result(const FluidStructureRun        &run,
                 const FluidStructureParameters &parameters,
                 const double                    seconds)
    {
      if (run.rows().empty())
        return;
      const FluidStructureRow &last = run.rows().back();
      std::cout << "At the end: displacement ("
                << format_quantity(last.displacement[0], "mm", 7) << ", "
                << format_quantity(last.displacement[1], "mm", 7) << "), drag "
                << format_quantity(last.force[0], "N/m", 7) << ", lift "
                << format_quantity(last.force[1], "N/m", 7)
                << ", mean pressure "
                << format_quantity(last.mean_pressure, "Pa", 6)
                << ", volume of the fluid "
                << format_quantity(last.volume, "m2", 8) << "\n"
                << run.rows().size() << " steps, "
                << format_quantity(seconds, "s", 3) << "; results in "
                << parameters.output.directory << "\n";
    }
  } // namespace



  namespace
  {
    /** A sentence if steps have been cut, after which the run is on another
     *  grid in time: by tools/stability, C2, the first steps of a pulse change
     *  by 5 to 25 %. */
    std::string
    warning_of_cuts(const FluidStructureRun &run)
    {
      if (run.n_cuts() == 0)
        return "";
      return "Steps had no solution at the length that Time/Steps asks for and "
             "were halved " +
             std::to_string(run.n_cuts()) +
             " times, where none is expected: motions that have just begun are "
             "5 to 25 % off on such a grid of times; take Coupling/Scheme = "
             "Robin-Neumann, raise Coupling/Maximum iterations or shorten "
             "Time/Steps.";
    }
  } // namespace



  bool
  describes_fluid_structure(const std::string &file)
  {
    const auto lines = read_parameter_lines(file);
    return std::any_of(lines.begin(),
                       lines.end(),
                       [](const ParameterLine &line) {
                         return !line.subsections.empty() &&
                                line.subsections.front() == "Problem";
                       });
  }



  int
  run_fluid_structure(const std::string &file)
  {
    if (!is_first_rank())
      return 0;
    const unsigned int n_ranks = MpiSession::n_ranks();
    if (n_ranks > 1)
      std::cout << "A problem runs on one rank; the other " << n_ranks - 1
                << " stay idle.\n";
    dealii::Timer                   timer;
    const ProblemInput              input(file);
    const FluidStructureParameters &parameters = input.parameters;
    const auto                      problem    = build(input, file);
    FluidStructureRun               run(parameters, *problem);

    std::vector<std::string> notes         = notes_on(input);
    const auto               restart_notes = resume(input, run);
    notes.insert(notes.end(), restart_notes.begin(), restart_notes.end());

    // Nothing has been written before all of the input is known to be good.
    const OutputFolder folder(parameters.output.directory,
                              input.declarator.where("Output/Output directory"),
                              FolderUse::run);
    if (!folder.warning().empty())
      notes.push_back(folder.warning());
    folder.clear(parameters.output.restart);
    write_atomically(parameters.output.directory + "/parameters.prm",
                     [&](std::ostream &out) {
                       input.declarator.write_prm(out);
                     });
    std::cout << version_line() << "\n";
    print_problem(parameters, *problem);
    print_notes(notes);
    if (run.time() > 0.)
      std::cout << "Goes on from t = " << format_quantity(run.time(), "s", 6)
                << "\n";
    FluidStructureOutput output(parameters, input.record, run);
    compute(parameters, output, run);
    if (const std::string warning = warning_of_cuts(run); !warning.empty())
      {
        print_notes({warning});
        notes.push_back(warning);
      }
    output.finish(run, notes, timer.wall_time());
    print_result(run, parameters, timer.wall_time());
    return 0;
  }



  int
  check_fluid_structure(const std::string &file)
  {
    if (!is_first_rank())
      return 0;
    const ProblemInput input(file);
    print_problem(input.parameters, *build(input, file));
    print_notes(notes_on(input));
    std::cout << file << " is valid.\n";
    return 0;
  }



  void
  declare_fluid_structure_parameters(ParameterDeclarator &parameters)
  {
    static FluidStructureParameters problem;
    problem.declare(parameters);
  }
} // namespace asperity
