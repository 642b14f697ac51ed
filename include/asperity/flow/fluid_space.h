#ifndef asperity_flow_fluid_space_h
#define asperity_flow_fluid_space_h

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/affine_constraints.h>

#include <set>
#include <vector>

namespace asperity
{
  using BoundaryIds = std::set<dealii::types::boundary_id>;

  enum class FluidElement
  {
    taylor_hood, ///< velocity Q_k, pressure Q_{k-1}: inf-sup stable
    equal_order  ///< both Q_k, stabilised (SUPG, PSPG, LSIC)
  };

  /** Two sides of a mesh that are one, each other's image by a translation
   *  along x (direction 0) or y (direction 1). */
  struct PeriodicSides
  {
    dealii::types::boundary_id left, right;
    unsigned int               direction = 0;
  };

  /**
   * The finite element spaces of a plane flow: velocity (components 0, 1) and
   * pressure (component 2), unknowns numbered velocity first, and the space of
   * the mesh displacement. The mesh may have hanging nodes and must not change
   * while this object lives.
   *
   * Cells can be switched off, as the domain of a flow falls into pieces and
   * joins again (activated and deactivated elements, Lee (2025), section
   * 2.2). Unknowns keep their numbers. Those of cells that are
   * off only are idle; where cells that are on and off meet is an inner wall.
   * With hp::FECollection and FE_Nothing the equations would be the same, but
   * all unknowns would be numbered anew by each switch.
   */
  class FluidSpace
  {
  public:
    /**
     * @param mesh its manifolds describe curved boundaries; no copy is kept
     * @param degree of the velocity
     * @param geometry_degree of the cells' shape and of the mesh displacement,
     *   at least 2
     * @throws InputError if a degree is too low for the element
     */
    FluidSpace(const dealii::Triangulation<2>   &mesh,
               const FluidElement                element,
               const unsigned int                degree,
               const unsigned int                geometry_degree,
               const std::vector<PeriodicSides> &periodic);

    FluidElement
    element() const;

    /** Degree of the velocity. */
    unsigned int
    degree() const;

    /** Velocity and pressure, sorted for a small profile. */
    const dealii::DoFHandler<2> &
    dofs() const;

    unsigned int
    n_velocity_dofs() const;

    /** FESystem<2>(FE_Q<2>(geometry_degree), 2), numbered as distribute_dofs()
     *  does: a vector of any other handler of this element on the same mesh has
     *  the same order. */
    const dealii::DoFHandler<2> &
    geometry_dofs() const;

    /** The same cell, seen by geometry_dofs(). */
    dealii::DoFHandler<2>::active_cell_iterator
    geometry_cell(
      const dealii::DoFHandler<2>::active_cell_iterator &cell) const;

    /** The shape of cells without displacement. */
    const dealii::Mapping<2> &
    reference_mapping() const;

    /** Hanging nodes and periodicity. */
    const dealii::AffineConstraints<double> &
    topology() const;

    /** Boundary ids that are sides of a periodic pair. */
    const BoundaryIds &
    periodic_ids() const;

    using Cell = dealii::DoFHandler<2>::active_cell_iterator;

    /** Switches cells on and off, by active_cell_index(); at first all are on.
     *  @throws InputError if there are not as many values as cells */
    void
    set_active(const std::vector<bool> &active);

    const std::vector<bool> &
    active() const;

    /** The cells that are on, as seen by dofs(). */
    const std::vector<Cell> &
    cells() const;

    /** An unknown of cells that are off only; so are its images by
     *  periodicity. */
    bool
    is_idle(const unsigned int unknown) const;

    /** Idle unknowns that topology() does not constrain. */
    std::vector<unsigned int>
    idle_dofs() const;

    /** An unknown of a cell that is on and of one that is off. */
    bool
    is_on_inner_wall(const unsigned int unknown) const;

    /** Pressure unknowns by connected part of the cells that are on, in
     *  ascending order: each part has a pressure level of its own. */
    const std::vector<std::vector<unsigned int>> &
    parts() const;

    /** Cell index (active_cell_index()) of a cell that is on -> part. */
    unsigned int
    part_of_cell(const unsigned int cell) const;

  private:
    void
    number_dofs();

    void
    make_topology(const std::vector<PeriodicSides> &periodic);

    /** Which unknowns belong to cells that are on and off. */
    void
    mark_unknowns();

    void
    find_parts();

    FluidElement                           element_;
    unsigned int                           degree_;
    dealii::FESystem<2>                    fe, geometry_fe;
    dealii::MappingQ<2>                    mapping;
    dealii::DoFHandler<2>                  dofs_, geometry_dofs_;
    dealii::AffineConstraints<double>      topology_;
    BoundaryIds                            periodic_ids_;
    std::vector<bool>                      active_;
    std::vector<Cell>                      cells_;
    std::vector<bool>                      in_active, in_inactive; ///< unknowns
    std::vector<std::vector<unsigned int>> parts_;
    std::vector<unsigned int>              part_of_cell_;
    unsigned int                           n_velocity = 0;
  };
} // namespace asperity

#endif
