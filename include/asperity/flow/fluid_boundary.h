#ifndef asperity_flow_fluid_boundary_h
#define asperity_flow_fluid_boundary_h

#include <asperity/flow/fluid_assembler.h>
#include <asperity/flow/wall_nodes.h>

#include <map>
#include <memory>

namespace asperity
{
  /** A traction over position [m], outward normal of the flow, and time [s]. */
  using TractionFunction =
    std::function<dealii::Tensor<1, 2>(const dealii::Point<2> &,
                                       const dealii::Tensor<1, 2> &,
                                       const double)>;

  /**
   * What holds on the boundary of a flow. Conditions belong to disjoint sets of
   * boundary ids; setting one again for the same set replaces it. Where nothing
   * is set the traction vanishes. A node of two sets takes the velocity that is
   * prescribed on either, of two velocities that of the set that comes first
   * (sets compare by their smallest id).
   *
   * n is the outward normal of the flow, so sigma n acts on the fluid.
   *
   * @throws InputError from each function that sets a condition, if its set
   *   overlaps another one or a periodic side, if there are not as many nodal
   *   values as nodes, or if a coefficient is negative
   */
  class FluidBoundary
  {
  public:
    using Vector = dealii::Vector<double>;

    FluidBoundary(const FluidSpace &space, const MovingMesh &mesh);

    ~FluidBoundary();

    /** v = function of position and time.
     *  @param components those prescribed; the traction of the other is 0 */
    void
    set_velocity(const BoundaryIds        &ids,
                 const FluidFunction      &velocity,
                 const std::array<bool, 2> components = {{true, true}});

    /** v = nodal values [m/s], in the order of nodes(ids). */
    void
    set_wall_velocity(const BoundaryIds &ids, const NodalVectors &velocity);

    /** sigma n = function of position, n, and time [Pa]. */
    void
    set_traction(const BoundaryIds &ids, const TractionFunction &traction);

    /**
     * sigma n + alpha v = alpha v_wall + t, with t given by its consistent
     * nodal forces: the weak form gets  int alpha (v - v_wall).w - sum_a
     * F_a.w_a. All in the order of nodes(ids).
     * @param alpha nodal [Pa s/m], not negative
     * @param velocity v_wall [m/s]
     * @param force F, on the fluid, per metre of thickness [N/m]
     */
    void
    set_robin(const BoundaryIds         &ids,
              const std::vector<double> &alpha,
              const NodalVectors        &velocity,
              const NodalVectors        &force);

    /** Nothing holds any more but sigma n = 0. */
    void
    release(const BoundaryIds &ids);

    const WallNodes &
    nodes(const BoundaryIds &ids) const;

    /** Prescribed unknowns and their values at a time. */
    std::map<unsigned int, double>
    prescribed(const double time) const;

    /** Every velocity component is prescribed on this boundary. */
    bool
    prescribes_velocity(const dealii::types::boundary_id id) const;

    /** Traction and Robin terms, as FluidAssembler::add() does. */
    void
    add(const Vector                            &u,
        const double                             time,
        const dealii::AffineConstraints<double> &constraints,
        Vector                                  &R,
        Vector                                  &scale,
        dealii::SparseMatrix<double>            *tangent) const;

    /** Adds the diagonal of the Robin terms' derivative. */
    void
    add_robin_diagonal(Vector &diagonal) const;

  private:
    enum class Kind
    {
      velocity,
      wall_velocity,
      traction,
      robin
    };

    struct Condition
    {
      Kind                kind;
      FluidFunction       function; ///< velocity
      TractionFunction    traction;
      std::array<bool, 2> components = {{true, true}};
      NodalVectors        nodal; ///< velocity, or force of Robin
      Vector alpha, velocity;    ///< of Robin, as fields of the flow's space
    };

    struct Shapes; // shape functions on the faces of the reference cell
    struct Face;

    void
    set(const BoundaryIds &ids, const Condition &condition);

    void
    check_size(const BoundaryIds &ids, const std::size_t n) const;

    const Condition *
    condition_on(const dealii::types::boundary_id id) const;

    /** The nodal values in the cell of a face. */
    void
    reinit(Face                   &face,
           const FluidSpace::Cell &cell,
           const unsigned int      number,
           const Condition        &condition,
           const Vector           &u) const;

    void
    integrate(Face            &face,
              const Condition &condition,
              const double     time,
              const bool       with_tangent) const;

    const FluidSpace                                         &space;
    const MovingMesh                                         &mesh;
    const std::unique_ptr<const Shapes>                       shapes;
    std::map<BoundaryIds, Condition>                          conditions;
    mutable std::map<BoundaryIds, std::unique_ptr<WallNodes>> nodes_;
  };
} // namespace asperity

#endif
