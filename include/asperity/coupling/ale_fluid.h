#ifndef asperity_coupling_ale_fluid_h
#define asperity_coupling_ale_fluid_h

#include <asperity/coupling/coupling_sides.h>
#include <asperity/flow/navier_stokes.h>

#include <functional>
#include <vector>

namespace asperity
{
  /**
   * A flow on a mesh that follows its wall, as one side of a coupled step. The
   * interface's nodes are the wall's velocity nodes.
   *
   * The flow's own boundary conditions are the caller's, but for that of the
   * wall. Where the wall ends, its neighbour must prescribe the velocity, not a
   * traction: the node that they share would have the forces of both. To
   * conserve volume it has to know the wall as a material one
   * (NavierStokes::set_material_walls()).
   */
  class AleFluid : public FluidSide
  {
  public:
    /** From the displacement of the wall to that of the whole mesh, both by
     *  geometry_dofs() of the flow's space. */
    using MeshUpdate = std::function<Vector(const Vector &)>;

    /**
     * @param flow must outlive this object; velocity and geometry of the same
     *   degree, so that mesh and flow have their nodes in common
     * @param wall boundary ids of the interface
     * @throws InputError if the degrees differ
     */
    AleFluid(NavierStokes      &flow,
             const BoundaryIds &wall,
             const MeshUpdate  &mesh_update);

    /** Rigid motion over time [m]. */
    using Motion = std::function<dealii::Tensor<1, 2>(const double)>;

    /** A further wall, which moves without turning and takes the fluid along,
     *  before the first step. */
    void
    add_moving_wall(const BoundaryIds &ids, const Motion &motion);

    /** Boundaries that the fluid does not cross although it may slide along
     *  them: the caller prescribes the velocity normal to them. */
    void
    set_sliding_walls(const BoundaryIds &ids);

    void
    begin_step(const double dt) override;

    ConvergenceReport
    solve(const WallCondition &condition, WallResponse &response) override;

    void
    accept() override;

    bool
    is_sealed() const override;

    double
    rate_coefficient() const override;

    Vector
    lengths() const override;

    std::vector<Vector>
    uniform_loads() const override;

    /** Displacement of the whole mesh, by geometry_dofs() of the flow's space,
     *  for one of the interface [m], with moving walls where they are at this
     *  time [s]. */
    Vector
    mesh_displacement(const Vector &displacement, const double time) const;

    /** Reference positions of the nodes of the interface [m]. */
    std::vector<dealii::Point<2>>
    positions() const;

  private:
    struct MovingWall
    {
      BoundaryIds               ids;
      Motion                    motion;
      std::vector<unsigned int> geometry_dof;
    };

    /** The unknowns of the geometry space at the nodes of a wall, by their
     *  components. */
    std::vector<unsigned int>
    match_geometry(const BoundaryIds &ids) const;

    /** The integrals over the wall of each node's function, and of it times
     *  the outward normal, on the present mesh. */
    void
    integrate(std::vector<double> &length, NodalVectors &normal) const;

    NavierStokes &flow;
    BoundaryIds   wall;
    MeshUpdate    mesh_update;

    std::vector<unsigned int> geometry_dof; ///< of the interface
    std::vector<MovingWall>   moving_walls;
    BoundaryIds               sliding_walls;
  };
} // namespace asperity

#endif
