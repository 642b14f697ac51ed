#ifndef asperity_campaign_campaign_results_h
#define asperity_campaign_campaign_results_h

#include <asperity/campaign/campaign_plan.h>
#include <asperity/campaign/law_test.h>
#include <asperity/campaign/profile_scatter.h>
#include <asperity/surrogate/sample_table.h>

#include <string>
#include <vector>

namespace asperity
{
  /** A law trained on the first runs of a campaign. */
  struct HistoryRow
  {
    unsigned int n_runs              = 0;
    double       leave_one_out_error = 0.;
    TestReport   test;
  };

  /** The records of a campaign, and the laws that they make. */
  class CampaignResults
  {
  public:
    CampaignResults(const CampaignParameters &parameters,
                    const CampaignPlan       &plan);

    std::string
    path_of(const RunOrder &order) const;

    /** Where a run keeps its fields, beside its record. */
    std::string
    field_file_of(const RunOrder &order) const;

    /** Reads all records of the plan. */
    void
    collect();

    /** One row a point: means over its profiles. Where a profile has failed,
     *  the mean of the law's output is estimated from the others, with its
     *  deviation and the reason. */
    const SampleTable &
    table() const;

    /** The law's output of the first training points that were planned, as far
     *  as they are finished. */
    SampleData
    training_data(const unsigned int n_points) const;

    /** The test runs, with those of the test table. */
    SampleData
    test_data() const;

    /** Numbers of training points at which laws are compared: after the first
     *  design and each batch, up to those planned. */
    std::vector<unsigned int>
    steps_of_learning() const;

    /** Training points whose runs failed, n x d. */
    std::vector<double>
    failed_points() const;

    /** @throws ComputationError if too few runs have succeeded */
    FrictionLaw
    train(const SampleData &data) const;

    /** Laws of growing numbers of runs, at the steps of learning. */
    std::vector<HistoryRow>
    history() const;

    /** Time of all runs on one core [s]. */
    double
    seconds() const;

    /** Runs that ended, but whose mean is no friction coefficient. */
    unsigned int
    n_without_result() const;

    /** How the law's output differs between profiles, from the training points
     *  that have all of them. */
    const ProfileScatter &
    scatter() const;

    /** Warnings of the runs, each with the number of runs that gave it. */
    std::vector<std::string>
    warnings() const;

  private:
    Sample
    combine(const PlannedPoint           &point,
            const std::vector<RunRecord> &records) const;

    /** Adds up time, mechanisms and warnings. */
    void
    note(const RunRecord &record);

    const CampaignParameters &parameters;
    const CampaignPlan       &plan;
    SampleTable               table_;
    SampleData                further_tests; ///< of the test table
    std::vector<ChoiceSpread> choices;       ///< of the sensitivity file
    double                    seconds_ = 0.;
    ShearLimit                shear_limit;

    ProfileScatter scatter_;
    unsigned int   n_points_with_gaps_ = 0;
    unsigned int   n_without_result_   = 0;

    std::vector<std::string> mechanisms_; ///< of all runs that are learnt from

    std::vector<std::pair<std::string, unsigned int>> warnings_;
  };
} // namespace asperity

#endif
