#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/contact_zone/accurate_run.h>

#include <algorithm>
#include <stdexcept>

namespace asperity
{
  namespace
  {
    /** That a number is off by more than is wanted, most of it by the largest
     *  source.
     *  @param remedy what makes this smaller */
    std::string
    excess_of(const std::string &number,
              const double       error,
              const double       wanted,
              const std::string &remedy)
    {
      return number + " may be off by " + per_cent(error) +
             " for numerical reasons, more than the " + per_cent(wanted) +
             " that Accuracy/Error wants, most of it by the " + remedy + ".";
    }

    /** mu that is corrected for its errors, and how far it may be off. */
    std::string
    corrected(const ErrorEstimate &error, const double mu)
    {
      return "mu corrected for its errors, " +
             format_quantity(error.corrected(mu), "1", 4) + " +- " +
             per_cent(error.uncertainty());
    }

    /** The largest part of an error, and what makes it smaller. */
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

    /** A family that tells which of its members it computes. */
    RunFamily
    family_of(const SceneParameters &parameters,
              ProgressLine          &progress,
              const Ranks           &ranks = Ranks())
    {
      return RunFamily(
        parameters,
        [&progress, n = 0u](const Fineness &) mutable {
          progress.note("companion " + std::to_string(++n) +
                        ", for the error of mu");
        },
        ranks);
    }

    /** Whether all ranks have found it: a scene that cannot be built, or a step
     *  that has no solution. */
    bool
    is_shared(const std::runtime_error &failure)
    {
      return dynamic_cast<const SharedError *>(&failure) != nullptr ||
             dynamic_cast<const InputError *>(&failure) != nullptr;
    }

    void
    count(const RunFamily &family, AccuracyReport &report)
    {
      report.runs = family.size();
      report.cost = family.cost();
    }

    /** Whether a mesh exists, and has no more unknowns than are allowed. */
    template <int dim>
    bool
    is_affordable(const SceneParameters &scene,
                  const Fineness        &fineness,
                  const Ranks           &ranks)
    {
      if (!has_mesh(scene, fineness.mesh))
        return false;
      try
        {
          return Scene<dim>(with_fineness(scene, fineness), ranks)
                   .n_unknowns() <= scene.accuracy.maximum_unknowns;
        }
      catch (const InputError &)
        {
          return false; // larger than any scene may be
        }
    }

    /** Which number keeps the wanted error. */
    std::string
    success_of(const AccuracyRound &round, const double wanted)
    {
      const double total = round.error.total();
      return corrected(round.error, round.run.mu) + ", keeps the " +
             per_cent(wanted) + " that Accuracy/Error wants; mu of the run " +
             (total <= wanted ? "does, too" :
                                "may be off by " + per_cent(total)) +
             ".";
    }

    /** That the wanted error needs more unknowns than it may. */
    std::string
    limit_of(const ErrorEstimate &error, const AccuracyParameters &accuracy)
    {
      return excess_of(
        "mu corrected for its errors",
        error.uncertainty(),
        accuracy.error,
        error.largest() +
          ", and settings that are finer where it matters need more than the " +
          std::to_string(accuracy.maximum_unknowns) +
          " unknowns of Accuracy/Maximum unknowns");
    }



    /** The run at other settings of the scene. */
    template <int dim>
    std::unique_ptr<SceneRun<dim>>
    at_settings(const std::string     &file,
                const SceneParameters &scene,
                const Fineness        &fineness,
                const Ranks           &ranks)
    {
      EntryValues changes = entries_of(scene, fineness);
      // The run can be repeated by its parameters.prm.
      changes.emplace_back("Accuracy/Control", "estimate");
      return std::make_unique<SceneRun<dim>>(file, changes, ranks);
    }
  } // namespace



  template <int dim>
  void
  estimate_accuracy(AccurateRun<dim> &run,
                    ProgressLine     &progress,
                    const Ranks      &ranks)
  {
    const SceneParameters &parameters = run.scene->parameters();
    RunFamily              family     = family_of(parameters, progress, ranks);
    family.add({}, run.scene->member());
    try
      {
        const ErrorEstimate error = estimate_error(family, {});
        run.accuracy.error        = error;
        const double wanted       = parameters.accuracy.error;
        if (error.total() > wanted)
          run.warnings.push_back(
            excess_of("mu", error.total(), wanted, remedy_of(error)) +
            (is_met(error, wanted) ?
               " " + corrected(error, run.scene->member().mu) + ", is not." :
               ""));
      }
    catch (const std::runtime_error &failure)
      {
        // The other ranks would wait for one that fails alone.
        if (ranks.are_several() && !is_shared(failure))
          throw;
        run.warnings.push_back(
          "The numerical error of mu is not known, since a companion of "
          "the run failed: " +
          std::string(failure.what()));
      }
    count(family, run.accuracy);
  }



  template void
  estimate_accuracy(AccurateRun<2> &, ProgressLine &, const Ranks &);
  template void
  estimate_accuracy(AccurateRun<3> &, ProgressLine &, const Ranks &);



  template <int dim>
  void
  run_adaptively(AccurateRun<dim>            &run,
                 const std::string           &file,
                 const OutputFolder          *folder,
                 ProgressLine                &progress,
                 const Ranks                 &ranks,
                 const std::function<void()> &finish)
  {
    const SceneParameters scene  = run.scene->parameters();
    const double          wanted = scene.accuracy.error;
    RunFamily             family = family_of(scene, progress, ranks);
    Fineness              at     = cheapest(scene);
    for (;;)
      {
        AccuracyRound round;
        try
          {
            run.scene = at_settings<dim>(file, scene, at, ranks);
            run.scene->compute(folder, progress);
            run.accuracy.error.reset();
            finish();
            family.add(at, run.scene->member());
            round = {at,
                     run.scene->parameters(),
                     run.scene->member(),
                     estimate_error(family, at)};
          }
        catch (const ComputationError &error)
          {
            // Settings may be too coarse for the steps of a hard scene.
            if (!(at.mesh < 0 || at.step < 0) ||
                (ranks.are_several() && !is_shared(error)))
              throw;
            progress.note("no solution at coarser settings than those of " +
                          file + ": " + error.what());
            at = {0, 0, 0};
            continue;
          }
        run.accuracy.error = round.error;
        run.accuracy.rounds.push_back(round);
        count(family, run.accuracy);
        progress.note("round " + std::to_string(run.accuracy.rounds.size()) +
                      ": " + describe(round));
        if (is_met(round.error, wanted))
          {
            progress.note(success_of(round, wanted));
            return;
          }
        const auto next =
          next_fineness(round, wanted, [&](const Fineness &finer) {
            return is_affordable<dim>(scene, finer, ranks);
          });
        if (!next)
          {
            run.warnings.push_back(limit_of(round.error, scene.accuracy));
            return;
          }
        at = *next;
      }
  }



  template void
  run_adaptively(AccurateRun<2> &,
                 const std::string &,
                 const OutputFolder *,
                 ProgressLine &,
                 const Ranks &,
                 const std::function<void()> &);
  template void
  run_adaptively(AccurateRun<3> &,
                 const std::string &,
                 const OutputFolder *,
                 ProgressLine &,
                 const Ranks &,
                 const std::function<void()> &);
} // namespace asperity
