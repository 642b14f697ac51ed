#ifndef asperity_mesh_motion_column_mesh_h
#define asperity_mesh_motion_column_mesh_h

#include <asperity/base/convergence_report.h>
#include <asperity/splines/spline_curve.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace asperity
{
  /** How the gap is divided. */
  struct ColumnLayout
  {
    /** Parameters of the columns' sides on the chip's edge, increasing; the
     *  last is the first one plus the period of the knots, see
     *  columns_on_spans(). */
    std::vector<double> columns;

    /** Heights of the rows' sides, from 0 at the chip to 1 at the tool. */
    std::vector<double> rows;

    /** Height that the mesh keeps where the surfaces touch [m]. */
    double residual_film = 5e-9;
  };



  /**
   * A mesh of quadratic cells between two graphs over x with one period: the
   * deformed edge of the chip below, the rigid tool above. Its nodes lie on
   * lines of constant x. The lowest is at a material point of the chip's edge
   * and goes with it, the highest is vertically above it on the tool, wherever
   * the tool is by now. Sliding therefore shears nothing: the mesh depends on
   * the present shape of the gap only, neither on the path nor on the distance.
   *
   * Walls. At the chip the mesh velocity w is that of the wall, v. At the tool
   * only the normal components agree: the nodes slide along it. A fluid needs
   * v there, not w.
   *
   * Residual film. Where the gap is smaller than the residual film, the upper
   * wall is lifted off the tool: gap := max(gap, residual film) at the columns'
   * sides. In the middle of a column it is at least what keeps the quadratic
   * gap of the column above the residual film. There the upper wall is no
   * material surface, and even w.n differs from that of the tool: see
   * tool_wall_velocity().
   *
   * With x(xi) the positions along a column's lower side and h(xi) its gap, the
   * Jacobian determinant of the cells is x'(xi) h(xi) up to a factor, so no
   * cell can be inverted as long as the chip's edge is a graph; update()
   * refuses one that is not.
   *
   * Unit m, y from the chip to the tool.
   */
  class ColumnMesh
  {
  public:
    using Vector = dealii::Vector<double>;

    /** Boundary indicators. */
    static constexpr dealii::types::boundary_id left_side  = 0;
    static constexpr dealii::types::boundary_id right_side = 1;
    static constexpr dealii::types::boundary_id chip_wall  = 2;
    static constexpr dealii::types::boundary_id tool_wall  = 3;

    /** A node of a wall; the last one is the image of the first one. */
    struct WallNode
    {
      double       parameter = 0.; ///< on the chip's edge
      unsigned int dof_x     = 0;
      unsigned int dof_y     = 0;
    };

    /** Where the residual film is active. */
    struct Film
    {
      double smallest_gap = 0.; ///< at nodes, negative if they overlap [m]
      double fraction     = 0.; ///< of the period where the wall is lifted
      double largest_lift = 0.; ///< [m]
    };

    /**
     * @param chip periodic; only its period and knots matter
     * @param tool a graph whose parameter is x, with the period of the chip
     * @throws InputError if the layout or the curves are not as said
     */
    ColumnMesh(const SplineCurve  &chip,
               const SplineCurve  &tool,
               const ColumnLayout &layout);

    /** Cells of a rectangle; only displaced they are the gap. */
    const dealii::Triangulation<2> &
    triangulation() const;

    /** FESystem<2>(FE_Q<2>(2), 2), numbered as distribute_dofs() does. */
    const dealii::DoFHandler<2> &
    dofs() const;

    /**
     * Places the nodes.
     * @param chip the present edge, in the parametrization of the layout
     * @param tool_shift what the tool has moved by [m]
     * @return not converged if the edge is not a graph over x; then nothing
     *   changes
     */
    ConvergenceReport
    update(const SplineCurve &chip, const dealii::Tensor<1, 2> &tool_shift);

    /** Positions of the nodes minus those of the rectangle [m]. */
    const Vector &
    displacement() const;

    const Film &
    film() const;

    /** From left to right. */
    const std::vector<WallNode> &
    chip_nodes() const;

    /** The nodes above chip_nodes(), by the same parameters. */
    const std::vector<WallNode> &
    tool_nodes() const;

    /** Gap between chip and tool in each column, the smallest at its three
     *  nodes, negative if they overlap [m]. */
    const std::vector<double> &
    smallest_gaps() const;

    /** The column of a cell, by active_cell_index(), from the left. */
    unsigned int
    column_of_cell(const unsigned int cell) const;

    /** By how much the node is above the tool [m], zero off the film. */
    const std::vector<double> &
    lift() const;

    /**
     * Velocity of the fluid at tool_nodes() [m/s]: that of the tool, with the
     * normal component of the mesh. Where the wall is lifted the film keeps
     * its volume that way when the chip carries it up or down. On the tool the
     * two normal components are one but for the error of quadratic
     * interpolation. It is taken there, too: a switch at the edge of the film
     * would be a jump, which no coupling iteration gets past. The normals are
     * those by which a motion along the wall moves no fluid through it (M. S.
     * Engelman, R. L. Sani, P. M. Gresho, Int. J. Numer. Meth. Fluids 2 (1982)
     * 225): parallel to the integral of n and the node's shape function.
     * @param w nodal mesh velocity
     */
    std::vector<dealii::Tensor<1, 2>>
    tool_wall_velocity(const dealii::Tensor<1, 2> &tool, const Vector &w) const;

  private:
    struct Columns;

    void
    make_rectangle();

    /** At tool_nodes(), of unit length, out of the gap; see
     *  tool_wall_velocity(). */
    std::vector<dealii::Tensor<1, 2>>
    tool_wall_normals() const;

    void
    number_nodes();

    /** Nodes on the chip and gaps above them; gaps may be negative. */
    Columns
    measure(const SplineCurve          &chip,
            const dealii::Tensor<1, 2> &tool_shift) const;

    void
    lift_to_residual_film(Columns &columns) const;

    void
    place_nodes(const Columns &columns);

    void
    report_film(const Columns &columns, const std::vector<double> &true_gap);

    SplineCurve              tool;
    ColumnLayout             layout;
    double                   period;
    dealii::Triangulation<2> mesh;
    dealii::DoFHandler<2>    dof_handler;

    /** Parameters on the chip (heights) of the nodes, middle ones included. */
    std::vector<double> node_parameters, node_heights;

    /** Reference position of nodes along x and y. */
    std::vector<double> reference_x, reference_y;

    /** dof_x and dof_y of node (column i, row j), at i * n_rows + j. */
    std::vector<std::pair<unsigned int, unsigned int>> node_dofs;

    std::vector<WallNode>     chip_wall_nodes, tool_wall_nodes;
    Vector                    displacement_;
    Film                      film_;
    std::vector<double>       lift_, smallest_gaps_;
    std::vector<unsigned int> column_of_cell_;
  };
} // namespace asperity

#endif
