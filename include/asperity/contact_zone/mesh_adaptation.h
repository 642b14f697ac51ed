#ifndef asperity_contact_zone_mesh_adaptation_h
#define asperity_contact_zone_mesh_adaptation_h

#include <asperity/contact_zone/load_protocol.h>
#include <asperity/contact_zone/scene.h>

#include <vector>

namespace asperity
{
  /** What changes of the mesh have done to a run. */
  struct RemeshReport
  {
    unsigned int remeshes = 0;

    /** Largest relative change of mu by a remesh, at the same place of the
     *  tool: while the load grows, and under the full load. */
    double change_in_ramp = 0., change = 0.;

    /** Sum of what transfers have changed of the plastic work [J/m], and the
     *  work itself before the last of them. */
    double work_change = 0., plastic_work = 0.;

    /** By how much a transfer has left the range of the plastic strain. */
    double strain_excess = 0.;

    unsigned int most_unknowns = 0;

    /** Of the run, whose cost its product sums up: unknowns times Newton
     *  iterations. */
    double unknown_iterations = 0.;

    /** Relative change of the plastic work by all transfers. */
    double
    work_drift() const
    {
      return plastic_work > 0. ? work_change / plastic_work : 0.;
    }

    /** For archives of Boost.Serialization. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &remeshes &change_in_ramp &change &work_change &plastic_work
        &strain_excess &most_unknowns &unknown_iterations;
    }
  };

  /**
   * Which cells a chip needs whose finest levels are only at its contacts
   * (Mesh/Adaptive levels): those of a level within its strip, at most a few of
   * their lengths beside what touches. What touches is known of the last
   * evaluated displacement; what will is told by the gap, under the tool that
   * moves on by the Remesh distance and comes as much closer as in the last
   * step. Cells that are there stay where a coarsening would lose plastic
   * strain.
   */
  class MeshAdaptation
  {
  public:
    /** The references must outlive this object. */
    MeshAdaptation(const SceneParameters &parameters,
                   const Scene<2>        &scene,
                   const LoadProtocol    &protocol);

    /**
     * Whether cells are missing where something touches, or will within a part
     * of the Remesh distance.
     * @param time of the last evaluated displacement [s]
     * @param approach speed at which the mean gap closes [m/s]
     */
    bool
    is_needed(const double time, const double approach) const;

    /** The level that a cell should have for the whole of it; as above. */
    SplineSpace<2>::CellLevel
    wanted(const double time, const double approach) const;

  private:
    /** Points of the edge that touch or will within a sliding distance [m], by
     *  their parameters. */
    std::vector<double>
    touching(const double time,
             const double approach,
             const double distance) const;

    /** For cells beside points of the edge. */
    SplineSpace<2>::CellLevel
    level_beside(const std::vector<double> &points, const double halo) const;

    const SceneParameters &parameters;
    const Scene<2>        &scene;
    const LoadProtocol    &protocol;
  };

  /** Plastic work in the chip since its start, at the strength that it has at
   *  the temperature of its start and a rate of 1/s [J/m].
   *  @param states of its material points */
  double
  plastic_work(const SolidAssembler<2>          &chip,
               const std::vector<MaterialState> &states,
               const LoadParameters             &start);
} // namespace asperity

#endif
