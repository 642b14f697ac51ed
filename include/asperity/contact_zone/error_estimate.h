#ifndef asperity_contact_zone_error_estimate_h
#define asperity_contact_zone_error_estimate_h

#include <asperity/contact_zone/scene_parameters.h>

#include <functional>
#include <string>

namespace asperity
{
  /** The numerical error of mu by source; each is relative to mu and not
   *  negative. */
  struct ErrorEstimate
  {
    double mesh = 0., step = 0., penalty = 0.;

    /** All of them; their signs are not known to be the same. */
    double
    total() const;

    /** "mesh", "step" or "penalty", whichever is largest. */
    std::string
    largest() const;
  };

  /**
   * The error of a run by three companions of half as many spans along the
   * contact edge, which cost a third of the run or less each: one as it is, one
   * with half as many time steps, one with half the penalty. The error by steps
   * and penalty, which is of first order, is what the halving changes on the
   * coarse mesh; that by the mesh is what halving the spans changes over 2^q -
   * 1 with the order q = 3/2 that the edges of contacts leave.
   *
   * @param parameters of the run, with models chosen by `automatic` in them
   * @param mu of the run
   * @param progress is told which companion runs, 1 to 3
   * @throws ComputationError if a companion fails
   */
  ErrorEstimate
  estimate_error(const SceneParameters                   &parameters,
                 const double                             mu,
                 const std::function<void(unsigned int)> &progress = {});

  /** The run with half as many spans and the same penalty [Pa/m]; the mesh
   *  must have a coarser one, MeshParameters::has_coarser(). */
  SceneParameters
  with_coarser_mesh(const SceneParameters &parameters);

  /** The run with half as many time steps. */
  SceneParameters
  with_longer_steps(const SceneParameters &parameters);

  /** The run with half the penalty. */
  SceneParameters
  with_softer_contact(const SceneParameters &parameters);
} // namespace asperity

#endif
