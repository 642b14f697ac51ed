#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/contact_zone/scene_checkpoint.h>
#include <asperity/contact_zone/scene_computation.h>
#include <asperity/contact_zone/scene_run.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Keeps the last good state if there is room for it, and says where. */
    template <int dim>
    std::string
    kept_state(const SceneOutput<dim> &output,
               const SlidingRun<dim>  &run,
               const std::string      &directory)
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

    template <int dim>
    void
    show_step(const SlidingRun<dim> &run, ProgressLine &progress)
    {
      const FrictionRow &row = run.state().rows.back();
      progress.update(row.time / run.protocol().end_time(),
                      "step " + std::to_string(row.step) +
                        "  t = " + format_quantity(row.time, "us", 3) +
                        "  mu = " + format_quantity(row.mu, "1", 3));
    }
  } // namespace



  std::vector<std::string>
  notes_on_input(const SceneInput &input)
  {
    const auto &entries = input.declarator.entries();
    if (std::any_of(entries.begin(),
                    entries.end(),
                    [](const ParameterEntry &entry) {
                      return entry.given && entry.subsection != "Output";
                    }))
      return {};
    return {input.file +
            " sets no entry of the scene, so that this is the default "
            "scene; 'asperity parameters' lists its entries."};
  }



  template <int dim>
  SceneRun<dim>::SceneRun(const std::string &file,
                          const EntryValues &changes,
                          const Ranks       &ranks)
    : ranks(ranks)
    , input(file, changes)
    , audited_(input, ranks)
    , run_(input.parameters, *audited_.scene)
    , notes_(notes_on_input(input))
  {
    if (input.parameters.output.restart)
      restart();
  }



  template <int dim>
  void
  SceneRun<dim>::restart()
  {
    try
      {
        const auto found =
          find_checkpoint(CheckpointFolder(input.parameters.output.directory +
                                           "/checkpoint"),
                          input.record,
                          version_line());
        load(found.checkpoint.state, run_, *audited_.scene);
        if constexpr (dim == 2)
          if (!parameters().output.field_times.empty())
            FieldRecorder(parameters(), *audited_.scene)
              .go_on(parameters().output.directory + "/fields.h5",
                     run_.state());
        notes_.insert(notes_.end(),
                      found.warnings.begin(),
                      found.warnings.end());
      }
    catch (const InputError &error)
      {
        throw InputError(input.declarator.where("Output/Restart") + ": " +
                         error.what());
      }
  }



  template <int dim>
  std::unique_ptr<OutputFolder>
  SceneRun<dim>::lock_folder() const
  {
    std::unique_ptr<OutputFolder> folder;
    std::string                   problem;
    // All ranks have read the checkpoint before anything is written.
    ranks.meet();
    if (ranks.is_first())
      try
        {
          folder = std::make_unique<OutputFolder>(parameters().output.directory,
                                                  input.declarator.where(
                                                    "Output/Output directory"),
                                                  FolderUse::run);
        }
      catch (const InputError &error)
        {
          problem = error.what();
        }
    if (!ranks.all(!ranks.is_first() || folder != nullptr))
      throw InputError(problem);
    return folder;
  }



  template <int dim>
  void
  SceneRun<dim>::compute(const OutputFolder *folder, ProgressLine &progress)
  {
    if (folder != nullptr)
      {
        folder->clear(parameters().output.restart);
        write_parameters(input);
      }
    output                = std::make_unique<SceneOutput<dim>>(parameters(),
                                                input.record,
                                                *audited_.scene,
                                                run_.state());
    const auto after_step = [&](const SlidingRun<dim> &now) {
      output->step(now);
      show_step(now, progress);
    };
    const auto kept = [&]() -> std::string {
      if (folder == nullptr)
        return "";
      return kept_state(*output, run_, parameters().output.directory);
    };
    try
      {
        run_.run(after_step);
      }
    catch (const SharedError &error)
      {
        throw SharedError(error.what() + kept());
      }
    catch (const ComputationError &error)
      {
        throw ComputationError(error.what() + kept());
      }
  }



  template <int dim>
  void
  SceneRun<dim>::finish(const AccuracyReport           &accuracy,
                        const std::vector<std::string> &warnings,
                        const double                    seconds)
  {
    std::vector<std::string> all = notes_;
    for (const auto &list : {this->warnings(), warnings})
      all.insert(all.end(), list.begin(), list.end());
    output->finish(run_, audited_.audit, accuracy, all, seconds);
  }



  template <int dim>
  const SceneParameters &
  SceneRun<dim>::parameters() const
  {
    return input.parameters;
  }



  template <int dim>
  const AuditedScene<dim> &
  SceneRun<dim>::audited() const
  {
    return audited_;
  }



  template <int dim>
  const SlidingRun<dim> &
  SceneRun<dim>::run() const
  {
    return run_;
  }



  template <int dim>
  const std::vector<std::string> &
  SceneRun<dim>::notes() const
  {
    return notes_;
  }



  template <int dim>
  std::vector<std::string>
  SceneRun<dim>::warnings() const
  {
    return warnings_of_run(audited_.audit.warnings, run_, parameters());
  }



  template <int dim>
  FamilyMember
  SceneRun<dim>::member() const
  {
    // Also the way back, where the chip slides back.
    double way = 0., last = 0.;
    for (const FrictionRow &row : run_.state().rows)
      {
        way += std::abs(row.sliding_distance - last);
        last = row.sliding_distance;
      }
    return {run_.friction().mu,
            run_.mean_unknowns(),
            run_.newton_statistics().iterations,
            way / audited_.scene->contact_element_length()};
  }



  template class SceneRun<2>;
  template class SceneRun<3>;
} // namespace asperity
