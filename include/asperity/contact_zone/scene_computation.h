#ifndef asperity_contact_zone_scene_computation_h
#define asperity_contact_zone_scene_computation_h

#include <asperity/contact_zone/friction_result.h>
#include <asperity/contact_zone/scene_parameters.h>
#include <asperity/contact_zone/sliding_run.h>

#include <string>
#include <vector>

namespace asperity
{
  /** What a campaign keeps of a scene; SI. */
  struct SceneResult
  {
    FrictionResult friction;

    /** Whether `friction` is a result at all: means of runs that are not valid
     *  are not to be learnt from. */
    FrictionStatus status = FrictionStatus::valid;

    std::vector<DistanceMean> over_distance;
    FrictionRow               last; ///< state at the end
    double                    oil_load_share = 0.;
    std::string               lubricant;  ///< model, as in parameter files
    std::vector<std::string>  mechanisms; ///< of mu, see mechanisms_of()
    bool                      is_steady         = true;
    unsigned int              steps             = 0;
    unsigned int              newton_iterations = 0;
    unsigned int              unknowns          = 0;
    std::vector<std::string>  warnings;
  };

  /**
   * Computes a scene, and writes nothing but its fields if they are asked for.
   * @param parameters checked; models chosen by `automatic` go into them
   * @param ranks that compute a patch together
   * @param field_file which a profile's Output/Field times are written into;
   *   empty: none
   * @throws InputError if no scene can be built of them
   * @throws ComputationError if a step fails after all cuts
   */
  SceneResult
  compute_scene(SceneParameters   &parameters,
                const Ranks       &ranks      = Ranks(),
                const std::string &field_file = "");

  /** Warnings of the audit and of a run that has ended. */
  template <int dim>
  std::vector<std::string>
  warnings_of_run(const std::vector<std::string> &warnings_of_audit,
                  const SlidingRun<dim>          &run,
                  const SceneParameters          &parameters);
} // namespace asperity

#endif
