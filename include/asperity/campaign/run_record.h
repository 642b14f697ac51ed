#ifndef asperity_campaign_run_record_h
#define asperity_campaign_run_record_h

#include <asperity/contact_zone/friction_result.h>
#include <asperity/contact_zone/scene_input.h>

#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /** One scene to be computed: a point of the plan on one profile. */
  struct RunOrder
  {
    unsigned int id      = 0; ///< of the point
    unsigned int profile = 0; ///< 0 for the first
    EntryValues  changes;     ///< of the base scene

    /** File that its fields go into, if the base scene has Output/Field times;
     *  or empty. */
    std::string field_file;

    /** "0012", or "0012_p3" on the third profile. */
    std::string
    name(const unsigned int n_profiles) const;
  };

  /** What a run of a campaign left behind; SI. */
  struct RunRecord
  {
    bool        done = false; ///< false: it failed
    std::string reason;       ///< why it failed

    /** Why its mean is no friction coefficient, see FrictionStatus; empty if it
     *  is one. */
    std::string no_result;

    double mu = 0., mu_end = 0., spread = 0.;
    double contact_fraction = 0.;
    double oil_pressure = 0., oil_load_share = 0.;
    double sliding_distance   = 0.;
    double max_plastic_strain = 0., max_temperature = 0.;

    /** At the end [Pa]; 0 in records of older programs. */
    double max_contact_pressure = 0.;

    std::vector<DistanceMean> over_distance;
    std::string               lubricant;
    std::vector<std::string>  mechanisms; ///< of its mu
    std::vector<std::string>  warnings;
    unsigned int              steps = 0, newton_iterations = 0;
    double                    seconds = 0.; ///< of one core
  };

  /**
   * Computes a scene; an error of the computation, or of an input that only
   * shows when the scene is built, becomes a record with its reason.
   */
  RunRecord
  execute(const std::string &base_scene, const RunOrder &order);

  /** Writes a record with its order, atomically. */
  void
  write_record(const std::string &path,
               const RunOrder    &order,
               const RunRecord   &record);

  /**
   * Nothing if the file does not exist.
   * @throws InputError if it is no record, or one of another order
   */
  std::optional<RunRecord>
  read_record(const std::string &path, const RunOrder &order);
} // namespace asperity

#endif
