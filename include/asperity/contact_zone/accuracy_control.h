#ifndef asperity_contact_zone_accuracy_control_h
#define asperity_contact_zone_accuracy_control_h

#include <asperity/contact_zone/error_estimate.h>

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity
{
  /** The entries by which a run that is so much finer differs from its scene,
   *  as a parameter file would say them. */
  std::vector<std::pair<std::string, std::string>>
  entries_of(const SceneParameters &parameters, const Fineness &fineness);

  /** A run at settings that `Accuracy/Control = adaptive` has tried. */
  struct AccuracyRound
  {
    Fineness        fineness;
    SceneParameters settings; ///< of this fineness
    FamilyMember    run;
    ErrorEstimate   error;
  };

  /** What is known of the error of a mu, and how. */
  struct AccuracyReport
  {
    std::optional<ErrorEstimate> error;
    double                       wanted = 0.; ///< relative

    /** Of `Accuracy/Control = adaptive`; the last is the run itself. */
    std::vector<AccuracyRound> rounds;

    /** Of all runs, companions and rounds: how many, and their unknowns times
     *  Newton iterations. */
    unsigned int runs = 0;
    double       cost = 0.;
  };

  /** As `accuracy` of summary.json shows it.
   *  @param mu of the run */
  nlohmann::ordered_json
  to_json(const AccuracyReport &report, const double mu);

  /** Where the choice begins: half of the time steps and penalty of the
   *  entries, and a quarter of their spans for a wanted error of 2 %, half for
   *  0.7 %, all for 0.2 %; no less than what leaves meshes for companions. */
  Fineness
  cheapest(const SceneParameters &parameters);

  /** Whether mu that is corrected for its errors keeps the wanted relative
   *  one; mu itself need not. */
  bool
  is_met(const ErrorEstimate &error, const double wanted);

  /** Relative time of a run over that of another that is coarser by this much,
   *  as measured on the reference scenes.
   *  @param dimension of the scene, 2 or 3 */
  double
  relative_cost(const Fineness &finer, const unsigned int dimension);

  /**
   * The cheapest finer settings of which the last round promises that a
   * corrected mu keeps the wanted error, with errors that fall by the orders of
   * their sources. Where none within a few halvings does, what dominates is
   * halved.
   * @param wanted relative error of mu
   * @param is_possible whether settings may be taken at all
   * @return nothing if the settings that are needed are not possible
   */
  std::optional<Fineness>
  next_fineness(const AccuracyRound                         &last,
                const double                                 wanted,
                const std::function<bool(const Fineness &)> &is_possible);

  /** One line on a round, with mu and its error. */
  std::string
  describe(const AccuracyRound &round);
} // namespace asperity

#endif
