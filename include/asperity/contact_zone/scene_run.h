#ifndef asperity_contact_zone_scene_run_h
#define asperity_contact_zone_scene_run_h

#include <asperity/base/progress.h>
#include <asperity/contact_zone/accuracy_control.h>
#include <asperity/contact_zone/scene_input.h>
#include <asperity/contact_zone/scene_output.h>
#include <asperity/postprocess/output_folder.h>

#include <memory>
#include <string>
#include <vector>

namespace asperity
{
  /** That nothing says what is to be computed; nothing if something does. */
  std::vector<std::string>
  notes_on_input(const SceneInput &input);

  /** The run of a parameter file, with all that it writes. */
  template <int dim>
  class SceneRun
  {
  public:
    /**
     * Builds the scene, and loads the checkpoint if the file asks for one;
     * writes nothing.
     * @param changes entries that are set after the file has been read
     * @param ranks that compute it together; the first one writes
     * @throws InputError if the file is wrong or there is no checkpoint
     */
    explicit SceneRun(const std::string &file,
                      const EntryValues &changes = {},
                      const Ranks       &ranks   = Ranks());

    /** The folder of its results, locked. Collective, and null on other ranks
     *  than the first. */
    std::unique_ptr<OutputFolder>
    lock_folder() const;

    /** Clears the folder and computes all steps, which are written as they
     *  come.
     *  @param folder null on other ranks than the first
     *  @throws ComputationError if a step fails; it names the last good state,
     *    which is kept */
    void
    compute(const OutputFolder *folder, ProgressLine &progress);

    /** Writes the summary, with warnings of the run and these.
     *  @param seconds that all of it has taken */
    void
    finish(const AccuracyReport           &accuracy,
           const std::vector<std::string> &warnings,
           const double                    seconds);

    /** Entries, with models that the audit has chosen. */
    const SceneParameters &
    parameters() const;

    const AuditedScene<dim> &
    audited() const;

    const SlidingRun<dim> &
    run() const;

    /** Of the input, before the run. */
    const std::vector<std::string> &
    notes() const;

    /** Of the audit and of the run, once it has ended. */
    std::vector<std::string>
    warnings() const;

    /** As a member of its family, once it has ended. */
    FamilyMember
    member() const;

  private:
    void
    restart();

    Ranks                             ranks;
    SceneInput                        input;
    const AuditedScene<dim>           audited_;
    SlidingRun<dim>                   run_;
    std::vector<std::string>          notes_;
    std::unique_ptr<SceneOutput<dim>> output;
  };
} // namespace asperity

#endif
