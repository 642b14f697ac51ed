#ifndef asperity_flow_navier_stokes_h
#define asperity_flow_navier_stokes_h

#include <asperity/base/convergence_report.h>
#include <asperity/flow/fluid_boundary.h>
#include <asperity/flow/fluid_options.h>
#include <asperity/flow/fluid_schur.h>
#include <asperity/flow/pressure_level.h>
#include <asperity/solvers/newton.h>

#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/numerics/data_out.h>

#include <memory>

namespace asperity
{
  /**
   * The plane Navier-Stokes or Stokes flow of an incompressible or compressible
   * fluid on a moving mesh, per metre of thickness, in SI units. One step:
   *
   *   flow.begin_step(dt);                    // from the last accepted state
   *   repeat, as often as needed (coupling):
   *     flow.set_mesh_displacement(d);        // at the end of the step
   *     flow.boundary().set_robin(...);       // or any other condition
   *     report = flow.solve();                // starts from the last iterate
   *     F      = flow.wall_force(ids);
   *   flow.accept();                          // or begin_step() again: retry
   *
   * A steady flow only needs boundary conditions and solve().
   *
   * Small time steps (equal order only). The stabilisation tau falls with dt,
   * so a defect of the discrete divergence, which the interpolated velocities
   * of a boundary always have, would raise the pressure as 1/dt. The continuity
   * equation is therefore solved as
   *   B v_{n+1} - theta B v_n + stabilisation = 0, theta = 1/(1 + dt/T),
   * with T = 1/(2 V/h + 34 nu/h^2), the tau of the steady problem: for large
   * steps the usual equation, for small ones the differential equation
   * T d(B v)/dt + B v = ..., whose pressure does not depend on dt
   * (J. Baumgarte's stabilisation, CMAME 1 (1972) 1-16). Taylor-Hood
   * elements need no more than project_initial_velocity().
   *
   * Walls are sets of boundary ids; nodal values on them are in the order of
   * boundary().nodes(ids), which are the velocity nodes.
   *
   * Cells that are off (set_active()) hold no fluid. Where they meet those that
   * are on, the fluid has the velocity of the mesh, also where a boundary
   * begins there: no fluid crosses an inner wall.
   */
  class NavierStokes : private NonlinearSystem
  {
  public:
    using Vector = dealii::Vector<double>;

    /** @param mesh is not copied and must not change
     *  @param outlets sides without any other condition
     *  @throws InputError as FluidSpace and FluidOutlets */
    NavierStokes(const dealii::Triangulation<2>   &mesh,
                 const FluidOptions               &options,
                 const std::vector<PeriodicSides> &periodic = {},
                 const std::vector<FluidOutlet>   &outlets  = {});

    FluidBoundary &
    boundary();

    /** Another fluid from the next step on: a warmer one. What has flowed keeps
     *  its velocity. */
    void
    set_model(const FluidModel &model);

    /** Walls that the fluid does not cross: the volume between them is
     * conserved to round-off when they move and the fluid at them has the
     * velocity wall_mesh_velocity(). */
    void
    set_material_walls(const BoundaryIds &ids);

    // Domain

    /**
     * Switches cells on and off between two steps, by active_cell_index(); at
     * first all are on. Cells that become part of the flow have the velocity
     * that the mesh had in the last step as their history, and the mean of the
     * pressures that the part has that they join. Forgets what
     * set_part_volumes() said.
     * @throws InputError as FluidSpace::set_active()
     */
    void
    set_active(const std::vector<bool> &active);

    /**
     * The areas of space().parts() at the end of the step [m^2], from which
     * errors do not accumulate, whatever the path: the continuity equation of a
     * part becomes, up to what is spread evenly over it,
     *   int (div v - div w) = a_0 (area wanted - area of the mesh),
     * a_0 = mesh_rate(). Where the walls have the velocity of the fluid, the
     * area is the wanted one. An enclosed part has no solution unless it is by
     * itself. Of a compressible fluid it is the integral of the density ratio
     * over the part, its volume at p = 0 and the reference temperature, that is
     * the wanted one. Empty: none is wanted.
     * @throws InputError if there are not as many values as parts
     */
    void
    set_part_volumes(const std::vector<double> &volumes);

    /** Areas of space().parts() on the present mesh [m^2]. */
    std::vector<double>
    part_volumes() const;

    /** Area of each cell, on or off, by active_cell_index() [m^2]. */
    std::vector<double>
    cell_areas() const;

    /** The integral of the density ratio over each cell of the space, by
     *  active_cell_index() [m^2]; zero where it is off. */
    std::vector<double>
    cell_contents() const;

    bool
    is_compressible() const;

    // Mesh motion

    /** Nodal displacement from reference_positions(), by geometry_dofs() of
     *  space(), at the end of the step [m].
     *  @return false if a cell is inverted; solve() then fails, too */
    bool
    set_mesh_displacement(const Vector &displacement);

    /** The same for t = 0, where the mesh is at rest. */
    bool
    set_initial_displacement(const Vector &displacement);

    /** Node positions without displacement, by geometry_dofs() [m]. */
    Vector
    reference_positions() const;

    /** Rate of the mesh displacement at the wall's nodes by the formula of the
     *  time scheme [m/s]: the velocity of a wall that moves with the mesh. */
    NodalVectors
    wall_mesh_velocity(const BoundaryIds &ids) const;

    /** Derivative of the mesh velocity with respect to the displacement in the
     *  present step [1/s]; zero in a steady flow. */
    double
    mesh_rate() const;

    // Steps

    /** Nodal values at t = 0, on the present mesh. */
    void
    set_initial_velocity(const FluidFunction &velocity);

    /**
     * Replaces the initial velocity by the nearest one whose discrete
     * divergence vanishes and that takes the prescribed values: otherwise the
     * pressure of the first step grows as 1/dt. Equal-order elements carry the
     * divergence along instead (see above), for them nothing is done.
     */
    ConvergenceReport
    project_initial_velocity();

    /** @param dt [s]. A BDF2 step more than twice as long as the last one is
     *    one of implicit Euler. */
    void
    begin_step(const double dt);

    /** The next solution starts with a new tangent also where
     *  FluidOptions::kept_tangent_contraction keeps them, so that it does not
     *  depend on what was solved before. */
    void
    forget_tangent();

    /** Solves for the end of the step. report.residual is relative, see
     *  FluidOptions::tolerance. */
    ConvergenceReport
    solve();

    void
    accept();

    /** End of the present step [s]. */
    double
    time() const;

    // Results

    /** Velocity [m/s] and pressure [Pa] by dofs() of space(). */
    const Vector &
    solution() const;

    /** Starts the next solve() from these values. */
    void
    set_solution(const Vector &u);

    NodalVectors
    wall_velocity(const BoundaryIds &ids) const;

    /**
     * Consistent nodal forces of the fluid on a wall [N/m], the reaction of the
     * momentum balance: the flow solved for last is in exact balance with them.
     * A node shared with another boundary, unless that is an outlet, has the
     * force of both; of two nodes that are one by periodicity the first has the
     * force of both.
     */
    NodalVectors
    wall_force(const BoundaryIds &ids) const;

    /** What leaves through each outlet in the present step [m^2/s]. */
    std::vector<double>
    outflow() const;

    /** What has passed each outlet until the last accepted step. */
    const std::vector<PassedVolume> &
    passed_volumes() const;

    /** Sum of wall_force(): drag and lift [N/m]. */
    dealii::Tensor<1, 2>
    total_wall_force(const BoundaryIds &ids) const;

    /** The pressure level of a part is undetermined: its whole boundary has
     *  prescribed velocities. */
    bool
    is_enclosed() const;

    /** Area of the cells that are on [m^2]. */
    double
    volume() const;

    dealii::Tensor<1, 2>
    velocity_at(const dealii::Point<2> &x) const;

    double
    pressure_at(const dealii::Point<2> &x) const;

    /** Adds "velocity" [m/s] and "pressure" [Pa]; build patches with mapping().
     */
    void
    attach_to(dealii::DataOut<2> &output) const;

    const dealii::Mapping<2> &
    mapping() const;

    const FluidSpace &
    space() const;

    // Checkpoints

    /** The last accepted state. */
    FluidState
    state() const;

    void
    set_state(const FluidState &state);

    const NewtonStatistics &
    statistics() const;

  private:
    bool
    residual(const Vector &u, Vector &R) override;

    bool
    linearize(const Vector &u, Vector &R) override;

    bool
    direction(const Vector &R, Vector &d) override;

    bool
    has_tangent() const override;

    std::string
    direction_failure() const override;

    double
    norm(const Vector &R) const override;

    /** @return false if there is no residual at u */
    bool
    assemble(const Vector &u, Vector &R, dealii::SparseMatrix<double> *tangent);

    /** Constraints, prescribed values in u, source of the continuity equation.
     *  @return what is wrong, or empty */
    std::string
    prepare();

    /** Hanging nodes, periodicity, what is prescribed, held and idle. */
    void
    constrain(const std::map<unsigned int, double> &prescribed);

    /** Velocity of the mesh at inner walls, in place of what boundaries say. */
    void
    prescribe_inner_walls(std::map<unsigned int, double> &prescribed) const;

    /** Gives the unknowns of cells that were off a history.
     *  @param was_idle by unknowns */
    void
    start_unknowns(const std::vector<bool> &was_idle);

    /** See set_active(). */
    void
    start_pressures(const std::vector<bool> &was_idle);

    /** The divergence at t_n of the cells that are on now.
     *  @param was_active before */
    void
    restart_divergence(const std::vector<bool> &was_active);

    /** Sees to wanted_volumes, and to content_source. */
    void
    account_for_content();

    /** A line of the matrix that no cell has written to gets the diagonal 1. */
    void
    fill_empty_rows();

    void
    update_scales();

    /** Continuity residual of the Galerkin method at u in the present step:
     *  without stabilisation and memory. */
    Vector
    galerkin_divergence() const;

    /** Against viscosity and the time derivative, in the whole flow: its
     *  Reynolds number, as far as the step is long enough to feel it. */
    bool
    convection_dominates() const;

    /** theta, see above. */
    double
    divergence_memory() const;

    FluidOptions                      options;
    FluidSpace                        space_;
    MovingMesh                        mesh;
    FluidBoundary                     boundary_;
    FluidAssembler                    assembler;
    FluidOutlets                      outlets;
    PressureLevel                     level;
    BoundaryIds                       material_walls;
    std::unique_ptr<WallNodes>        inner_walls; ///< null: all cells are on
    std::vector<double>               wanted_volumes; ///< of parts, or empty
    dealii::AffineConstraints<double> constraints;    ///< homogeneous
    dealii::SparsityPattern           pattern;
    dealii::SparseMatrix<double>      matrix;
    FluidSchur                        schur;
    std::unique_ptr<FlowSolver>       solver;
    std::string                       linear_failure; ///< of the last direction
    std::vector<unsigned int>         constrained;    ///< unknowns, in order
    bool                              is_factorised = false;

    Vector           u, u_old, u_older; ///< iterate, t_n, t_{n-1}
    Vector           cell_forces;       ///< residual of cells and outlets at u
    Vector           volume_source;     ///< of walls and enclosed parts [m^2/s]
    Vector           content_source;    ///< of a compressible fluid [m^2/s]
    Vector           source;     ///< those and the memory of the divergence
    Vector           scale;      ///< absolute contributions at u
    Vector           divergence; ///< Galerkin continuity at t_n [m^2/s]
    double           momentum_scale = 0., continuity_scale = 0.;
    double           cell_size = 0.; ///< square root of the mean area [m]
    double           time_old = 0., dt = 0., dt_old = 0.;
    unsigned int     n_steps = 0;
    NewtonStatistics statistics_;
  };
} // namespace asperity

#endif
