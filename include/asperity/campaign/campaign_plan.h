#ifndef asperity_campaign_campaign_plan_h
#define asperity_campaign_campaign_plan_h

#include <asperity/campaign/campaign_parameters.h>
#include <asperity/campaign/run_record.h>
#include <asperity/contact_zone/scene_input.h>

#include <string>
#include <vector>

namespace asperity
{
  /** A point of a campaign. */
  struct PlannedPoint
  {
    unsigned int        id   = 0;     ///< 1, 2, ... in the order of planning
    bool                test = false; ///< judges the law, does not train it
    std::vector<double> x;            ///< SI, one number an input
  };

  /**
   * Which scenes a campaign computes. The plan is on disk before its runs
   * start, and only grows, so that a campaign that was killed goes on where it
   * stopped.
   */
  class CampaignPlan
  {
  public:
    /**
     * The inputs with their ranges in SI.
     * @throws InputError if an entry does not exist in the base scene, or a
     *   range is wrong or refused by the scene
     */
    CampaignPlan(const CampaignParameters  &parameters,
                 const ParameterDeclarator &declarator);

    /**
     * Goes on from a plan on disk, or makes the first design; writes nothing.
     * @throws InputError if the plan on disk is of another campaign: of
     *   another scene (also if one of its files has another content), other
     *   ranges, or another design
     */
    void
    start(const CampaignParameters &parameters, const std::string &path);

    /** A sentence if the plan on disk is of another program, else empty. */
    const std::string &
    warning() const;

    /** Which file of the base scene is not what it was when this plan was made,
     *  as InputRecord::change_since(); empty: none. */
    std::string
    changed_file() const;

    /** The base scene with all its entries and files by their full paths, so
     *  that later changes of its file do not change a campaign under way. */
    const std::string &
    base_scene_text() const;

    /** Scene, number of points, and the inputs with their ranges, for people.
     */
    std::string
    description(const CampaignParameters &parameters) const;

    void
    add(const bool test, const std::vector<double> &x);

    void
    save(const std::string &path) const;

    const std::vector<LawInput> &
    inputs() const;

    const std::vector<PlannedPoint> &
    points() const;

    unsigned int
    n_points(const bool test) const;

    /** At least one. */
    unsigned int
    n_profiles() const;

    /** Whether the base scene has Output/Field times. */
    bool
    wants_fields() const;

    RunOrder
    order(const PlannedPoint &point, const unsigned int profile) const;

  private:
    void
    read(const std::string &path);

    /** As the scene reads it: whole numbers where it wants them, and a number
     *  with a unit may be off by a rounding error. */
    std::vector<double>
    as_written(std::vector<double> x) const;

    /** Points that the design has and the plan lacks, in order; those that both
     *  have must agree. */
    void
    follow(const std::vector<double> &design, const bool test);

    std::vector<LawInput>     inputs_;
    std::vector<bool>         is_whole_number; ///< of each input's entry
    std::vector<std::string>  profiles;
    std::vector<PlannedPoint> points_;
    std::string               base_scene_text_;
    InputRecord               base_scene;
    bool                      wants_accuracy = false; ///< of the base scene
    bool                      wants_fields_  = false; ///< the same
    std::string               warning_;
  };
} // namespace asperity

#endif
