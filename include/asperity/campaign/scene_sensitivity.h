#ifndef asperity_campaign_scene_sensitivity_h
#define asperity_campaign_scene_sensitivity_h

#include <asperity/campaign/run_record.h>
#include <asperity/contact_zone/scene_input.h>
#include <asperity/surrogate/friction_law.h>

#include <nlohmann/json.hpp>

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace asperity
{
  /** Whose choice an entry is. */
  enum class ChoiceKind
  {
    preparation, ///< of the measured surface: filters, length of the profile
    profile,     ///< which profile stands for the surface
    scene,       ///< way, state and height of the chip, gap at the start
    constants    ///< of the material and the interface, within 10 %
  };

  /** "preparation", "profile", "scene" or "constants". */
  std::string
  name(const ChoiceKind kind);

  /** Another value of an entry that a user decides by hand or does not know. */
  struct Variation
  {
    std::string entry; ///< "Geometry/Chip height"
    std::string value; ///< "20 um"
    ChoiceKind  kind = ChoiceKind::scene;

    /** Entries that go along, such as the steps of a longer way. */
    EntryValues also = {};
  };

  /**
   * What is varied in a scene, each alone: filters by factors of 2 (and 0.3),
   * half the profile, four other profiles, the way by 0.5, 2 and 4, chip height
   * and gap by factors of 2, strains of 0 to 2, and constants by 10 %; what
   * does not count in the scene is left out. At most 40.
   * @throws InputError if the map of a measured tool cannot be read
   */
  std::vector<Variation>
  variations_of(const SceneInput &input);

  /** A variation and what became of mu. */
  struct VariationResult
  {
    Variation   variation;
    double      mu = 0.; ///< without meaning if there is a reason
    std::string reason;  ///< why there is no mu; empty if there is one
  };

  /**
   * Computes variations of a scene, shared by the ranks of MPI_COMM_WORLD; one
   * without an entry has only what goes along. All ranks get all results.
   * @param progress is told how many of how many are done
   */
  std::vector<VariationResult>
  run_variations(
    const std::string                                               &file,
    const std::vector<Variation>                                    &variations,
    const std::function<void(const std::size_t, const std::size_t)> &progress);

  /** How far mu may lie below and above, as shares of it. */
  struct Spread
  {
    double below = 0., above = 0.;
  };

  /** mu of a scene and of its variations. */
  struct SceneSensitivity
  {
    double mu = 0.;

    /** Those of the entry with the largest effect first. */
    std::vector<VariationResult> results;

    /** The largest change that an entry has made, as a share of mu. */
    double
    effect(const std::string &entry) const;

    /** The largest changes of all entries of a kind to either side, added as
     *  independent ones are, by their squares. Holds each single one. */
    Spread
    spread(const ChoiceKind kind) const;

    /** The same over all kinds. */
    Spread
    spread() const;
  };

  /**
   * Computes a scene and its variations, shared by the ranks of MPI_COMM_WORLD.
   * @param progress is told on the first rank how many of how many are done
   * @throws InputError if the file is wrong
   * @throws ComputationError if the scene itself fails
   */
  SceneSensitivity
  compute_sensitivity(
    const std::string                                               &file,
    const std::vector<Variation>                                    &variations,
    const std::function<void(const std::size_t, const std::size_t)> &progress);

  /** The table and the interval, for people. */
  void
  print_sensitivity(const SceneSensitivity &sensitivity, std::ostream &out);

  /** sensitivity.csv and sensitivity.json in a folder, which is made.
   *  @param indices Sobol's, see to_json(); null if there are none
   *  @throws ComputationError if they cannot be written */
  void
  write_sensitivity(const SceneSensitivity       &sensitivity,
                    const nlohmann::ordered_json &indices,
                    const std::string            &directory);

  /** The spreads of all kinds of choices in a sensitivity.json, but for kinds
   *  that have none.
   *  @throws InputError if the file is missing or something else */
  std::vector<ChoiceSpread>
  read_spreads(const std::string &path);
} // namespace asperity

#endif
