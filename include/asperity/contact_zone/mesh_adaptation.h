#ifndef asperity_contact_zone_mesh_adaptation_h
#define asperity_contact_zone_mesh_adaptation_h

#include <asperity/contact_zone/load_protocol.h>
#include <asperity/contact_zone/scene.h>

#include <memory>
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

    /** Sum of what transfers have changed of the plastic work [J/m^(3 - dim)],
     *  and the work itself before the last of them. */
    double work_change = 0., plastic_work = 0.;

    /** By how much a transfer has left the range of the plastic strain, and of
     *  the temperature [K], whose conserving projection may overshoot. */
    double strain_excess = 0., temperature_excess = 0.;

    unsigned int most_unknowns = 0;

    /** Remeshes that Mesh/Maximum unknowns has made coarser than wanted, and
     * how many levels have been left out at the most. */
    unsigned int bounded = 0, missing_levels = 0;

    /** Which of the wanted meshes the present one is. */
    unsigned int taken = 0;

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
        &strain_excess &temperature_excess &most_unknowns &bounded
          &missing_levels &taken &unknown_iterations;
    }
  };

  /**
   * Which cells a chip needs whose finest levels are only at its contacts
   * (Mesh/Adaptive levels): those of a level within its strip, at most a few of
   * their lengths beside what touches, along x and along y. What touches is
   * known of the last evaluated displacement; what will is told by the gap,
   * under the tool that moves on by the Remesh distance and comes as much
   * closer as in the last step. Cells that are there stay where a coarsening
   * would lose plastic strain.
   *
   * Where this makes more unknowns than Mesh/Maximum unknowns, meshes are
   * wanted with fewer cells beside what touches, which lose more plastic
   * strain; then the same without the finest level, and so on.
   */
  template <int dim>
  class MeshAdaptation
  {
  public:
    using CellLevel = typename SplineSpace<dim>::CellLevel;

    /** The references must outlive this object. */
    MeshAdaptation(const SceneParameters &parameters,
                   const Scene<dim>      &scene,
                   const LoadProtocol    &protocol);

    /**
     * Whether cells are missing where something touches, or will within a part
     * of the Remesh distance, that the last mesh could afford.
     * @param time of the last evaluated displacement [s]
     * @param approach speed at which the mean gap closes [m/s]
     */
    bool
    is_needed(const double time, const double approach) const;

    /** The level that a cell should have for the whole of it, as above: of the
     *  wanted mesh, and of those to take if it has too many unknowns, each
     *  coarser than the one before; without a bound the first alone. */
    std::vector<CellLevel>
    wanted(const double time, const double approach) const;

    /** That this one of the wanted meshes has been taken. */
    void
    set_taken(const unsigned int number);

    /** How many of the levels that one of the wanted meshes lacks. */
    unsigned int
    missing_levels(const unsigned int number) const;

  private:
    /** What a mesh spares. */
    struct Thrift
    {
      double       halo, loss; ///< factors of cells beside, of a loss of strain
      unsigned int levels;     ///< left out
    };

    /** See wanted(). */
    static std::vector<Thrift>
    steps_of_thrift(const MeshParameters &mesh);

    /** Points of the edge that touch, by their parameters. */
    class Points;

    /** Those that touch or will within a sliding distance [m]. */
    std::shared_ptr<const Points>
    touching(const double time,
             const double approach,
             const double distance) const;

    /** For cells beside points of the edge. */
    CellLevel
    level_beside(const std::shared_ptr<const Points> &points,
                 const double                         halo,
                 const unsigned int                   finest) const;

    /** Cells of a level beside what touches after a change of the mesh. */
    double
    halo() const;

    /** Elements of the contact edge along a way of the chip. */
    double
    n_elements_of_way(const double distance) const;

    const SceneParameters &parameters;
    const Scene<dim>      &scene;
    const LoadProtocol    &protocol;
    std::vector<Thrift>    thrift;
    unsigned int           taken = 0;
  };

  /** Plastic work in the chip since its start, at the strength that it has at
   *  the temperature of its start and a rate of 1/s [J/m^(3 - dim)].
   *  @param states of its material points */
  template <int dim>
  double
  plastic_work(const SolidAssembler<dim>        &chip,
               const std::vector<MaterialState> &states,
               const LoadParameters             &start);
} // namespace asperity

#endif
