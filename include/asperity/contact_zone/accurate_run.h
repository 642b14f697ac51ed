#ifndef asperity_contact_zone_accurate_run_h
#define asperity_contact_zone_accurate_run_h

#include <asperity/contact_zone/scene_run.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace asperity
{
  /** A run with what is known of its numerical error. */
  template <int dim>
  struct AccurateRun
  {
    std::unique_ptr<SceneRun<dim>> scene;
    AccuracyReport                 accuracy;
    std::vector<std::string>       notes;    ///< from before it
    std::vector<std::string>       warnings; ///< of its accuracy
  };

  /** Lets companions tell the error of a run that has ended.
   *  @param ranks that have computed it, and compute them */
  template <int dim>
  void
  estimate_accuracy(AccurateRun<dim> &run,
                    ProgressLine     &progress,
                    const Ranks      &ranks = Ranks());

  /**
   * Replaces the run, which has not begun, by those at finer and finer settings
   * until mu that is corrected for its errors keeps the wanted one or no finer
   * settings are possible; each becomes a companion of the next.
   * @param file of the scene
   * @param folder of the results, which each round writes anew; null on other
   *   ranks than the first
   * @param ranks that compute each run together
   * @param finish is called after each round, to write its summary
   * @throws ComputationError if a run at the settings of the file fails
   */
  template <int dim>
  void
  run_adaptively(AccurateRun<dim>            &run,
                 const std::string           &file,
                 const OutputFolder          *folder,
                 ProgressLine                &progress,
                 const Ranks                 &ranks,
                 const std::function<void()> &finish);
} // namespace asperity

#endif
