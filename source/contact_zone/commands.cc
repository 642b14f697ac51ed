#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>
#include <asperity/base/version.h>
#include <asperity/contact_zone/accuracy_forecast.h>
#include <asperity/contact_zone/accurate_run.h>
#include <asperity/contact_zone/commands.h>
#include <asperity/contact_zone/scene_report.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <functional>
#include <iostream>

namespace asperity
{
  namespace
  {
    /** What is known before the first step.
     *  @param notes beside those of the run */
    template <int dim>
    void
    begin_report(const SceneRun<dim>            &scene,
                 const std::vector<std::string> &notes)
    {
      const AuditedScene<dim> &audited = scene.audited();
      print_scene(*audited.scene,
                  audited.audit,
                  scene.parameters().heat_model(),
                  false);
      print_ranks(*audited.scene);
      print_unused(audited.audit.unused);
      print_warnings(scene.notes());
      print_warnings(notes);
      if (scene.parameters().output.restart)
        std::cout << "Restart after step " << scene.run().state().step << "\n";
    }

    /** Computes the scene and, if that is wanted, what is known of its error.
     *  @param folder null on other ranks than the first
     *  @param finish writes the summary */
    template <int dim>
    void
    compute(AccurateRun<dim>            &accurate,
            const std::string           &file,
            const OutputFolder          *folder,
            ProgressLine                &progress,
            const Ranks                 &ranks,
            const std::function<void()> &finish)
    {
      const AccuracyParameters accuracy = accurate.scene->parameters().accuracy;
      if (accuracy.is_adaptive())
        {
          run_adaptively(accurate, file, folder, progress, ranks, finish);
          finish();
          return;
        }
      accurate.scene->compute(folder, progress);
      // The results are safe before companions run, which may be killed.
      finish();
      if (!accuracy.is_wanted())
        return;
      estimate_accuracy(accurate, progress, ranks);
      finish();
    }

    /** @param ranks that compute it together; the first one writes */
    template <int dim>
    void
    run(const std::string &file, const Ranks &ranks)
    {
      dealii::Timer    timer;
      AccurateRun<dim> accurate;
      accurate.scene =
        std::make_unique<SceneRun<dim>>(file, EntryValues(), ranks);
      accurate.accuracy.wanted = accurate.scene->parameters().accuracy.error;

      // Nothing has been written before all of the input is known to be good.
      const auto folder = accurate.scene->lock_folder();
      if (folder && !folder->warning().empty())
        accurate.notes.push_back(folder->warning());
      if (folder)
        {
          std::cout << version_line() << "\n";
          begin_report(*accurate.scene, accurate.notes);
        }
      ProgressLine progress(std::cout,
                            folder ? ProgressLine::Mode::automatic :
                                     ProgressLine::Mode::silent);
      compute<dim>(accurate, file, folder.get(), progress, ranks, [&]() {
        std::vector<std::string> told = accurate.notes;
        told.insert(told.end(),
                    accurate.warnings.begin(),
                    accurate.warnings.end());
        accurate.scene->finish(accurate.accuracy, told, timer.wall_time());
      });
      if (!folder)
        return;
      progress.note("");
      print_result(accurate.scene->run(),
                   accurate.scene->parameters(),
                   accurate.accuracy.error,
                   timer.wall_time());
      print_warnings(accurate.scene->warnings());
      print_warnings(accurate.warnings);
    }

    template <int dim>
    void
    check(SceneInput &input)
    {
      const AuditedScene<dim> audited(input);
      print_scene(*audited.scene,
                  audited.audit,
                  input.parameters.heat_model(),
                  true);
      print_ranks(*audited.scene);
      print_unused(audited.audit.unused);
      if constexpr (dim == 2)
        for (const std::string &sentence :
             advise(input.parameters, *audited.scene))
          std::cout << sentence << "\n";
      print_warnings(notes_on_input(input));
      print_warnings(audited.audit.warnings);
    }
  } // namespace



  int
  run_scene(const std::string &file)
  {
    if (SceneInput(file).parameters.geometry.dimension == 3)
      {
        run<3>(file, Ranks::together());
        return 0;
      }
    // Others would write the same files.
    if (!is_first_rank())
      return 0;
    const unsigned int n_ranks = MpiSession::n_ranks();
    if (n_ranks > 1)
      std::cout << "A scene in two dimensions runs on one rank; the other "
                << n_ranks - 1 << " stay idle.\n";
    run<2>(file, Ranks());
    return 0;
  }



  int
  check_scene(const std::string &file)
  {
    if (!is_first_rank())
      return 0;
    SceneInput input(file);
    if (input.parameters.geometry.dimension == 3)
      check<3>(input);
    else
      check<2>(input);
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
