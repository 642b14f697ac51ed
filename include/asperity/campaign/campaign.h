#ifndef asperity_campaign_campaign_h
#define asperity_campaign_campaign_h

#include <asperity/base/progress.h>
#include <asperity/campaign/campaign_plan.h>
#include <asperity/campaign/campaign_results.h>
#include <asperity/postprocess/output_folder.h>

#include <mpi.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * Computes the runs of a plan on the ranks of a communicator, a scene a rank,
   * and grows the plan by active learning. Each run is a file as soon as it is
   * done, and a campaign that was ended by whatever means goes on from these
   * files: nothing is lost but the runs that were under way, and nothing is
   * computed twice.
   */
  class Campaign
  {
  public:
    /** How a scene is computed: from the base scene's file and an order. */
    using Runner =
      std::function<RunRecord(const std::string &, const RunOrder &)>;

    /**
     * Collective.
     * @throws InputError on all ranks if the parameters are wrong, or if the
     *   folder holds or runs another campaign
     */
    Campaign(const CampaignParameters  &parameters,
             const ParameterDeclarator &declarator,
             const MPI_Comm             communicator,
             const Runner              &runner = execute);

    /** What is going to be computed, for people. */
    std::string
    description() const;

    /** Collective: all runs, until the design is complete or its law is as good
     *  as asked for. */
    void
    run();

    /** All that the runs gave. */
    const CampaignResults &
    results() const;

    const CampaignPlan &
    plan() const;

  private:
    /** The file that the runs read. */
    std::string
    base_scene() const;

    /** Collective: the first rank holds the lock for all.
     *  @param where the entry that names the folder */
    void
    lock_folder(const std::string &where);

    /**
     * Collective: runs that are planned and not recorded. A run is recorded
     * only if the files of the base scene are still what they were when the
     * campaign began, lest one law be trained on two surfaces.
     * @throws InputError on all ranks if they are not
     */
    void
    perform();

    /** Collective: points that active learning adds; empty: it is done. */
    std::vector<double>
    next_batch();

    /** Whether active learning has reached its target: decided from all
     *  batches, so that an interrupted campaign decides alike. */
    bool
    target_is_met();

    std::vector<RunOrder>
    open_orders() const;

    void
    show_progress(const std::vector<RunOrder> &orders);

    const CampaignParameters     &parameters;
    const MPI_Comm                communicator;
    const Runner                  runner;
    const bool                    is_first;
    CampaignPlan                  plan_;
    CampaignResults               results_;
    std::unique_ptr<ProgressLine> progress;
    std::unique_ptr<OutputFolder> folder; ///< of the first rank
    bool                          first_try = true;

    std::size_t n_performed = 0; ///< runs of this session in earlier batches

    /** Of cross-validation, by the number of planned training points. */
    std::map<unsigned int, double> errors;
  };
} // namespace asperity

#endif
