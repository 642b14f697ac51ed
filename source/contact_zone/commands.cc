#include <asperity/base/atomic_file.h>
#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mpi_session.h>
#include <asperity/base/progress.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/contact_zone/commands.h>
#include <asperity/contact_zone/scene_checkpoint.h>
#include <asperity/contact_zone/scene_computation.h>
#include <asperity/contact_zone/scene_input.h>
#include <asperity/contact_zone/scene_output.h>
#include <asperity/postprocess/output_folder.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>
#include <stdexcept>

namespace asperity
{
  namespace
  {
    /** What was made of the file of a measured surface. */
    void
    print_treatment(const Surface &surface)
    {
      if (!surface.topography)
        return;
      const TopographyReport &report = *surface.topography;
      std::cout << "  " << report.sanity.format << ", " << report.sanity.nx
                << " x " << report.sanity.ny << " points, "
                << format_quantity(report.sanity.length_x, "um", 4) << " x "
                << format_quantity(report.sanity.length_y, "um", 4) << "\n";
      for (const std::string &step : report.steps)
        std::cout << "  " << step << "\n";
      const ProfileRoughness &roughness = report.profile_roughness;
      std::cout << "  Finished profile: Rq "
                << format_quantity(roughness.Rq, "um", 3) << ", Rz "
                << format_quantity(roughness.Rz, "um", 3)
                << ", root mean square slope "
                << format_quantity(roughness.Rdq, "1", 3) << "; spline within "
                << format_quantity(surface.fit_rms, "nm", 2) << " rms\n";
    }

    /** @param heat the model in use
     *  @param explain with the treatment of measured surfaces, and what the
     *  numbers of the audit say */
    void
    print_scene(const Scene      &scene,
                const SceneAudit &audit,
                const HeatModel   heat,
                const bool        explain)
    {
      std::cout << "Tool: " << scene.tool_surface.description << ", period "
                << format_quantity(scene.length, "um", 4) << ", peak to valley "
                << format_quantity(scene.tool_surface.maximum() -
                                     scene.tool_surface.minimum(),
                                   "um",
                                   3)
                << "\n";
      if (explain)
        print_treatment(scene.tool_surface);
      std::cout << "Chip: " << scene.chip_surface.description << ", "
                << scene.law->name() << ", degree " << scene.space->degree()
                << ", " << scene.space->n_cells() << " elements, "
                << scene.n_unknowns() << " unknowns, penalty "
                << format_quantity(scene.penalty(), "Pa/m", 3) << "\n";
      if (explain)
        print_treatment(scene.chip_surface);
      if (audit.lubricant != LubricantModel::none)
        std::cout << "Oil: " << format_quantity(scene.oil.thickness, "nm", 4)
                  << " over the period, "
                  << format_quantity(100. * scene.oil.part_at_start, "1", 3)
                  << " % of the void at the start\n";
      std::cout << "Scene audit:\n";
      for (const AuditEntry &entry : audit.entries)
        {
          std::cout << "  " << std::left << std::setw(48) << entry.name
                    << (std::isfinite(entry.value) ?
                          format_quantity(entry.value, "1", 3) :
                          "undefined")
                    << "\n";
          if (explain)
            std::cout << "      " << entry.meaning << "\n";
        }
      std::cout << "Models: "
                << (audit.lubricant == LubricantModel::none ?
                      "dry" :
                      "oil by " + name(audit.lubricant))
                << ", "
                << (audit.inertia == Inertia::dynamic ? "dynamic" :
                                                        "quasi-static")
                << ", " << name(heat) << "\n";
    }

    /** The entries that the models do not read, by what they count with. */
    void
    print_unused(const std::vector<UnusedEntry> &entries)
    {
      std::map<std::string, std::vector<std::string>> by_condition;
      for (const UnusedEntry &entry : entries)
        by_condition[entry.counts_with].push_back(entry.path);
      for (const auto &[counts_with, paths] : by_condition)
        std::cout << "Not used here: " << join(paths, ", ") << " (only with "
                  << counts_with << ").\n";
    }

    void
    print_result(const SlidingRun                   &run,
                 const double                        scene_length,
                 const SceneParameters              &parameters,
                 const std::optional<ErrorEstimate> &error,
                 const std::vector<std::string>     &warnings,
                 const double                        seconds)
    {
      const FrictionResult friction = run.friction();
      std::cout << std::setprecision(4) << "mu = " << friction.mu << " +- "
                << friction.spread << " (spread over time)";
      if (error)
        std::cout << " +- " << std::setprecision(2)
                  << error->total() * std::abs(friction.mu)
                  << " (numerics: mesh " << 100. * error->mesh << " %, steps "
                  << 100. * error->step << " %, penalty "
                  << 100. * error->penalty << " %)" << std::setprecision(4);
      std::cout << ", at the end " << friction.mu_end << ", contact fraction "
                << friction.contact_fraction << "\n";
      if (parameters.interface.law != InterfaceShear::none)
        std::cout << "of it " << friction.ploughing << " by ploughing, "
                  << friction.interface_shear << " by shear of the interface, "
                  << friction.oil_shear << " by shear of the oil\n";
      if (friction.oil_pressure > 0.)
        std::cout << "oil at "
                  << format_quantity(friction.oil_pressure, "MPa", 4)
                  << " carries "
                  << format_quantity(100. * friction.oil_pressure *
                                       scene_length / std::abs(friction.T_y),
                                     "1",
                                     3)
                  << " % of the load\n";
      const FrictionRow &last = run.state().rows.back();
      const double       heat = last.plastic_heat + last.friction_heat;
      if (heat > 0.)
        std::cout << "of " << format_quantity(1e3 * heat, "1", 3)
                  << " mJ/m of heat "
                  << format_quantity(100. * last.tool_heat / heat, "1", 3)
                  << " % have gone into the tool; the interface is at up to "
                  << format_quantity(last.flash_temperature, "degC", 4) << "\n";
      std::cout << run.state().step << " steps, "
                << run.newton_statistics().iterations << " Newton iterations, "
                << std::setprecision(3) << seconds << " s; results in "
                << parameters.output.directory << "\n";
      for (const std::string &warning : warnings)
        std::cout << "Warning: " << warning << "\n";
    }

    /** That nothing says what is to be computed; nothing if something does. */
    std::vector<std::string>
    notes_on_input(const SceneInput &input, const std::string &file)
    {
      const auto &entries = input.declarator.entries();
      if (std::any_of(entries.begin(),
                      entries.end(),
                      [](const ParameterEntry &entry) {
                        return entry.given && entry.subsection != "Output";
                      }))
        return {};
      return {file + " sets no entry of the scene, so that this is the default "
                     "scene; 'asperity parameters' lists its entries."};
    }

    /** Keeps the last good state if there is room for it, and says where. */
    std::string
    kept_state(const SceneOutput &output,
               const SlidingRun  &run,
               const std::string &directory)
    {
      try
        {
          output.write_checkpoint(run);
          return " The last good state is in " +
                 quoted_name(directory + "/checkpoint") + ".";
        }
      catch (const ComputationError &)
        {
          return ""; // the disk that has no room for results has none for it
        }
    }

    void
    write_parameters(const SceneInput &input)
    {
      write_atomically(input.parameters.output.directory + "/parameters.prm",
                       [&](std::ostream &out) {
                         input.declarator.write_prm(out);
                       });
    }

    /** Loads the checkpoint to go on from, if the parameters ask for one, and
     *  prints what is to be known of it.
     *  @return warnings
     *  @throws InputError if there is none for these inputs */
    std::vector<std::string>
    restart(const SceneInput &input, SlidingRun &run, Scene &scene)
    {
      const OutputParameters &output = input.parameters.output;
      if (!output.restart)
        return {};
      try
        {
          const auto found =
            find_checkpoint(CheckpointFolder(output.directory + "/checkpoint"),
                            input.record,
                            version_line());
          load(found.checkpoint.state, run, scene);
          return found.warnings;
        }
      catch (const InputError &error)
        {
          throw InputError(input.declarator.where("Output/Restart") + ": " +
                           error.what());
        }
    }

    std::string
    per_cent(const double share)
    {
      return format_quantity(100. * share, "1", 2) + " %";
    }

    /** What makes the largest part of an error, and what makes it smaller. */
    std::string
    remedy_of(const ErrorEstimate &error)
    {
      const std::string source = error.largest();
      return source == "mesh" ?
               "mesh, for which Mesh/Spans and Refinement levels help" :
             source == "step" ?
               "time steps, for which Protocol/Slide steps and Ramp steps help" :
               "penalty, for which Contact/Penalty factor helps";
    }

    /** The numerical error of mu if it is wanted and can be told. */
    std::optional<ErrorEstimate>
    estimate(const SceneParameters    &parameters,
             const SlidingRun         &run,
             ProgressLine             &progress,
             std::vector<std::string> &warnings)
    {
      const AccuracyParameters &wanted = parameters.accuracy;
      if (!wanted.is_wanted())
        return {};
      try
        {
          const ErrorEstimate error = estimate_error(
            parameters, run.friction().mu, [&](const unsigned int companion) {
              progress.note("companion " + std::to_string(companion) +
                            " of 3, for the error of mu");
            });
          if (error.total() > wanted.error)
            warnings.push_back(
              "mu may be off by " + per_cent(error.total()) +
              " for numerical reasons, more than the " +
              per_cent(wanted.error) +
              " that Accuracy/Error wants, most of it by the " +
              remedy_of(error) + ".");
          return error;
        }
      catch (const std::runtime_error &failure)
        {
          warnings.push_back(
            "The numerical error of mu is not known, since a coarser companion "
            "of the run failed: " +
            std::string(failure.what()));
          return {};
        }
    }

    void
    show_step(const SlidingRun &run, ProgressLine &progress)
    {
      const FrictionRow &row = run.state().rows.back();
      progress.update(row.time / run.protocol().end_time(),
                      "step " + std::to_string(row.step) +
                        "  t = " + format_quantity(row.time, "us", 3) +
                        "  mu = " + format_quantity(row.mu, "1", 3));
    }
  } // namespace



  int
  run_scene(const std::string &file)
  {
    // A scene is solved by one rank; others would write the same files.
    if (!is_first_rank())
      return 0;
    const unsigned int n_ranks = MpiSession::n_ranks();
    if (n_ranks > 1)
      std::cout << "A scene runs on one rank; the other " << n_ranks - 1
                << " stay idle.\n";
    dealii::Timer      timer;
    SceneInput         input(file);
    SceneParameters   &parameters = input.parameters;
    const AuditedScene audited(input);
    Scene             &scene = *audited.scene;
    const SceneAudit  &audit = audited.audit;
    SlidingRun         run(parameters, scene);

    std::vector<std::string> notes         = notes_on_input(input, file);
    const auto               restart_notes = restart(input, run, scene);
    notes.insert(notes.end(), restart_notes.begin(), restart_notes.end());

    // Nothing has been written before all of the input is known to be good.
    const OutputFolder folder(parameters.output.directory,
                              input.declarator.where("Output/Output directory"),
                              FolderUse::run);
    if (!folder.warning().empty())
      notes.push_back(folder.warning());
    folder.clear(parameters.output.restart);
    write_parameters(input);
    std::cout << version_line() << "\n";
    print_scene(scene, audit, parameters.heat_model(), false);
    print_unused(audit.unused);
    for (const std::string &note : notes)
      std::cout << "Warning: " << note << "\n";
    if (parameters.output.restart)
      std::cout << "Restart after step " << run.state().step << "\n";
    SceneOutput output(parameters, input.record, scene, run.state());

    ProgressLine progress(std::cout);
    try
      {
        run.run([&](const SlidingRun &now) {
          output.step(now);
          show_step(now, progress);
        });
      }
    catch (const ComputationError &error)
      {
        throw ComputationError(
          error.what() + kept_state(output, run, parameters.output.directory));
      }
    auto       warnings = warnings_of_run(audit.warnings, run, parameters);
    const auto finish   = [&](const std::optional<ErrorEstimate> &error) {
      std::vector<std::string> all = notes;
      all.insert(all.end(), warnings.begin(), warnings.end());
      output.finish(run, audit, error, all, timer.wall_time());
    };
    // The results are safe before companions run, which may be killed.
    finish({});
    const auto error = estimate(parameters, run, progress, warnings);
    if (parameters.accuracy.is_wanted())
      finish(error);
    progress.note("");
    print_result(
      run, scene.length, parameters, error, warnings, timer.wall_time());
    return 0;
  }



  int
  check_scene(const std::string &file)
  {
    if (!is_first_rank())
      return 0;
    SceneInput         input(file);
    const AuditedScene audited(input);
    print_scene(*audited.scene,
                audited.audit,
                input.parameters.heat_model(),
                true);
    print_unused(audited.audit.unused);
    for (const auto &list :
         {notes_on_input(input, file), audited.audit.warnings})
      for (const std::string &warning : list)
        std::cout << "Warning: " << warning << "\n";
    std::cout << file << " is valid.\n";
    return 0;
  }



  void
  declare_all_parameters(ParameterDeclarator &parameters)
  {
    static SceneParameters scene;
    scene.declare(parameters);
  }
} // namespace asperity
