#ifndef asperity_coupling_gap_flow_h
#define asperity_coupling_gap_flow_h

#include <asperity/constitutive/lubricant_parameters.h>
#include <asperity/coupling/ale_fluid.h>
#include <asperity/coupling/gap_pockets.h>
#include <asperity/coupling/interface.h>
#include <asperity/isogeometric/edge_trace.h>
#include <asperity/lubricant/lubricant.h>
#include <asperity/mesh_motion/column_mesh.h>
#include <asperity/mesh_motion/elastic_mesh_update.h>

#include <memory>
#include <optional>
#include <ostream>
#include <utility>
#include <vector>

namespace asperity
{
  /** How the nodes between the walls follow them; those on the walls are
   *  ColumnMesh's in either case. */
  enum class MeshUpdateKind
  {
    columns, ///< in fixed shares of the gap: no cell can be inverted
    elastic  ///< like an elastic body, ElasticMeshUpdate, as in Lee (2025)
  };

  enum class GapEndKind
  {
    periodic,  ///< one with the other end
    pressure,  ///< open to a reservoir
    resistance ///< open to a reservoir behind a resistance
  };

  /** An end of the period, as the oil sees it; see FluidOutlets. */
  struct GapEnd
  {
    GapEndKind kind       = GapEndKind::periodic;
    double     pressure   = 0.;  ///< of the reservoir [Pa]
    double     resistance = 1e8; ///< where it counts [Pa s/m]
  };

  struct GapFlowOptions
  {
    LubricantParameters oil;

    /** Whether its density law counts; if not, the flow is incompressible. */
    bool compressible = false;

    /** Whether the oil has inertia: Navier-Stokes; if not, Stokes. */
    bool inertia = true;

    /** Film that stays where the surfaces touch [m]. */
    double residual_film = 2e-9;

    /** Gap below which columns are switched off, in place of the residual film
     *  [m]; 0: none is, and the gap is one. */
    double sealing_gap = 0.;

    /** With a sealing gap: oil over void at the start, in the pockets that
     *  hold any. */
    double wetting = 1.;

    /** With a sealing gap: intervals of x [m] that lie in the pockets that hold
     *  oil at the start, one in each; empty: all do. */
    std::vector<std::pair<double, double>> pockets;

    /** Of the oil alone: both are periodic or both are open. */
    GapEnd left, right;

    double initial_pressure = 0.; ///< [Pa]

    unsigned int columns_per_span = 1; ///< of the chip's edge
    unsigned int rows             = 2; ///< between chip and tool

    MeshUpdateKind mesh_update = MeshUpdateKind::columns;

    /** If elastic, ElasticMeshOptions::stiffening_exponent. */
    double stiffening = 1.;

    FluidTimeScheme scheme        = FluidTimeScheme::bdf2;
    FluidElement    element       = FluidElement::taylor_hood;
    FlowSolverKind  linear_solver = FlowSolverKind::direct;

    /** Of the flow on a ColumnMesh: the two ends, if they are one. */
    std::vector<PeriodicSides>
    periodic_sides() const;

    /** The same: the ends, if they are open. */
    std::vector<FluidOutlet>
    outlets() const;
  };



  /**
   * Oil that fills the gap between the top edge of a periodic chip and a rigid
   * tool at rest above it: Navier-Stokes or Stokes flow, plane, per metre of
   * thickness, on a ColumnMesh. The sides of the period are one, or open ends
   * that go with the chip; the tool has no slip, the chip's wall is the
   * interface of a coupled step.
   *
   * With a sealing gap the oil is that of GapPockets, and each pocket has its
   * own pressure and conserves its content. What is open is decided at the
   * start of a step, by the gap there, so that the iterations of the step see
   * one smooth problem; a column that closes further within the step keeps the
   * sealing gap until its end. The oil of a seal has the pressure of its
   * pocket's flow beside it, and loads the chip with it: columns open and close
   * without a jump of the load. A pocket that is not full is still and has no
   * pressure; a step in which it would be overfilled is refused, so that a
   * shorter one finds the moment at which it fills.
   *
   * To the chip it is a dead load, the force that the coupled step has found so
   * far. Since the gap is enclosed, Robin's condition at the chip's wall is
   * what determines the level of the pressure, or with compressible oil its
   * density.
   */
  class GapFlow : public Lubricant
  {
  public:
    using Vector = dealii::Vector<double>;

    /** @param tool a graph whose parameter is x, with the period of the chip
     *  @throws InputError if the gap cannot be meshed */
    GapFlow(const SplineSpace<2>   &space,
            const PatchGeometry<2> &geometry,
            const SplineCurve      &tool,
            const GapFlowOptions   &options);

    // The coupled step

    /** Nodes of the chip's wall on the edge of the chip. */
    const Interface &
    interface() const;

    /** The flow as one side of a coupled step. The mesh follows the chip that
     *  set_chip() has told, not the nodes' displacement. */
    FluidSide &
    side();

    /** The chip's displacement at the end of the step [m]. */
    void
    set_chip(const Vector &u);

    /** Force on the chip at the nodes of the interface [N/m]. */
    void
    set_force(const Vector &force);

    // The lubricant

    void
    set_oil(const LubricantParameters &oil) override;

    void
    begin_step(const Vector      &u,
               const unsigned int step,
               const double       time,
               const double       dt) override;

    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const override;

    bool
    add(const Vector                 &u,
        Vector                       &residual,
        dealii::SparseMatrix<double> *tangent) override;

    void
    accept(const Vector &u) override;

    /** The force of the pressure is the integral of p n, that of the shear the
     *  rest of the consistent force of the wall. */
    LubricantState
    state() const override;

    double
    pressure(const dealii::Point<2> &parameter) const override;

    /** That of the pocket, at the last accepted step: oil that flows fills the
     *  gap. */
    double
    coverage(const dealii::Point<2> &parameter) const override;

    void
    save(OutputArchive &archive) const override;

    void
    load(InputArchive &archive) override;

    /** Of the present step; empty without a sealing gap. */
    const std::optional<GapPockets> &
    pockets() const;

    /** Largest difference between the oil of a pocket and the integral of its
     *  density ratio, over all oil, at the last accepted step. */
    double
    volume_error() const;

    const NavierStokes &
    flow() const;

    const ColumnMesh &
    mesh() const;

    /** Seconds in the solution of the flow, mesh motion included. */
    double
    seconds() const;

    /** Velocity [m/s] and pressure [Pa] as VTU. */
    void
    write(std::ostream &out, const double time, const unsigned int step) const;

  private:
    /** Follows the chip before it solves. */
    class Side : public AleFluid
    {
    public:
      explicit Side(GapFlow &gap);

      void
      begin_step(const double dt) override;

      ConvergenceReport
      solve(const WallCondition &condition, WallResponse &response) override;

    private:
      /** Without a full pocket there is no flow. */
      ConvergenceReport
      rest(WallResponse &response);

      GapFlow &gap;
    };

    /** Parameters on the chip of the wall's nodes, in the flow's order. */
    std::vector<EdgePoint>
    chip_points();

    /** For each node of a wall in the flow's order, its number from left to
     *  right. */
    std::vector<unsigned int>
    numbers_from_left(const dealii::types::boundary_id         wall,
                      const std::vector<ColumnMesh::WallNode> &nodes);

    void
    find_wall_pressures();

    /** ColumnMesh::tool_wall_velocity() as condition of the flow. */
    void
    set_tool_velocity();

    /** Sums of the columns from values of the cells. */
    std::vector<double>
    by_column(const std::vector<double> &of_cells) const;

    /** Void of each column between the present chip and the tool, without what
     *  the mesh is lifted by [m^2]. */
    std::vector<double>
    column_voids() const;

    /** Which columns hold oil at the start.
     *  @throws InputError if an interval is not within one pocket */
    std::vector<bool>
    find_wet_columns(
      const GapPockets                             &empty,
      const std::vector<std::pair<double, double>> &intervals) const;

    /** The oil at the start. */
    void
    fill_pockets(const GapFlowOptions &options);

    /** Switches the columns by the present gap. */
    void
    switch_columns();

    /** Mean pressure in each column, in seals that of the flow beside. */
    std::vector<double>
    find_column_pressures() const;

    /** The same as ratios of densities. */
    std::vector<double>
    column_ratios() const;

    /** Why the present void contradicts the still pockets; or empty. */
    std::string
    overfilled() const;

    /** The oil at the end of an accepted step. */
    void
    account_for_oil();

    /** The column that holds a parameter of the chip's edge. */
    unsigned int
    column_at(const double parameter) const;

    /** What has passed the ends of the gap. */
    void
    account_for_ends();

    /** The pressure that the oil has before the first step. */
    void
    set_initial_pressure(const double pressure);

    /** What is left for the flow beside the seals, by the parts of the flow,
     *  which are numbered otherwise than pockets. */
    std::vector<double>
    oil_of_parts() const;

    /** Integrals of the pressure in seals times the velocity functions times n,
     *  over the chip's wall, by unknowns of the flow [N/m]. */
    Vector
    seal_forces() const;

    /** Of the present chip. */
    SplineCurve
    chip_curve() const;

    /** Of all nodes of the mesh from their reference positions [m]. */
    Vector
    mesh_displacement() const;

    /** Makes the mesh update that starts from the present columns. */
    void
    make_elastic_update(const double stiffening);

    /** The integral of the flow's p n over the chip's wall, and the largest
     *  p. */
    std::pair<dealii::Tensor<1, 2>, double>
    integrate_pressure() const;

    const bool             inertia; ///< of the oil
    const PatchGeometry<2> geometry;
    const EdgeTrace        edge;
    double                 length;
    Vector                 chip; ///< displacement
    ColumnMesh             mesh_;

    /** If that is the mesh update; displacements from elastic_start. */
    std::unique_ptr<ElasticMeshUpdate> elastic;
    Vector                             elastic_start;

    NavierStokes              flow_;
    Side                      side_;
    Interface                 interface_;
    InterfaceLoad             load_;
    Vector                    force;
    std::vector<unsigned int> tool_numbers; ///< see numbers_from_left()

    /** Parameter on the chip and unknown of the pressure, from left to right;
     *  the last is the image of the first one. */
    std::vector<std::pair<double, unsigned int>> wall_pressures;

    LubricantDensity          density; ///< incompressible unless it counts
    std::optional<GapPockets> pockets_;
    std::vector<double>       column_pressures; ///< of the last solution
    std::vector<double>       pocket_coverage;  ///< of the accepted step
    double                    volume_error_ = 0.;

    double         initial_content = 0.; ///< volume of the oil at p = 0
    unsigned int   n_solutions     = 0;  ///< in the present step
    LubricantState state_;
    double         seconds_ = 0.;
  };
} // namespace asperity

#endif
