#ifndef asperity_campaign_choice_indices_h
#define asperity_campaign_choice_indices_h

#include <asperity/campaign/scene_sensitivity.h>
#include <asperity/surrogate/sensitivity.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace asperity
{
  /** A choice between two values, when several are varied at a time. */
  struct ChoiceRange
  {
    std::string entry;              ///< "Geometry/Chip height"
    std::string unit;               ///< "um"; "1" of a number
    double      lower, upper;       ///< SI
    Variation   at_lower, at_upper; ///< with what goes along
  };

  /**
   * The entries with the largest effects, at most n_choices, each between its
   * smallest and its largest value that has given a mu, that of the scene
   * included.
   * @param input of the scene
   */
  std::vector<ChoiceRange>
  ranges_of_choices(const SceneSensitivity &sensitivity,
                    const SceneInput       &input,
                    const unsigned int      n_choices);

  /** The changes of a scene at a point of the unit cube; what goes along is
   *  linear in between, and whole where it is whole at both ends. */
  EntryValues
  choice_at(const std::vector<ChoiceRange> &ranges, const double *unit);

  /**
   * Sobol's indices of mu over all choices at once, each as likely between its
   * limits as another value, from a Gaussian process through some runs.
   */
  struct ChoiceIndices
  {
    std::vector<ChoiceRange>      ranges;
    std::vector<SensitivityIndex> indices; ///< one a range
    std::size_t                   n_runs   = 0;
    std::size_t                   n_failed = 0;

    /** Leave-one-out error of the process, a mean share of mu: what it does not
     *  explain is in no index. */
    double error = 0.;

    /** Median of mu, and the interval of 95 % of all choices. */
    double median = 0., lower = 0., upper = 0.;
  };

  /**
   * Computes n_runs points of Sobol's sequence over the ranges, shared by the
   * ranks of MPI_COMM_WORLD, and trains the process.
   * @throws ComputationError if fewer runs have a mu than the process needs
   */
  ChoiceIndices
  compute_indices(
    const std::string                                               &file,
    const std::vector<ChoiceRange>                                  &ranges,
    const std::size_t                                                n_runs,
    const std::function<void(const std::size_t, const std::size_t)> &progress);

  /** The indices, and the interval, for people. */
  void
  print_indices(const ChoiceIndices &indices, std::ostream &out);

  nlohmann::ordered_json
  to_json(const ChoiceIndices &indices);
} // namespace asperity

#endif
