#ifndef asperity_coupling_interface_h
#define asperity_coupling_interface_h

#include <asperity/isogeometric/force_term.h>
#include <asperity/isogeometric/spline_space.h>

#include <utility>
#include <vector>

namespace asperity
{
  /** A place on the edge of a patch. */
  struct EdgePoint
  {
    Edge   edge;
    double parameter; ///< along the edge
  };

  /**
   * The places on some edges of a patch next to given positions, by projection
   * onto the edges' own spline curves.
   * @param tolerance [m]
   * @throws InputError if a position is farther away from all edges
   */
  std::vector<EdgePoint>
  find_on_edges(const SplineSpace<2>                &space,
                const PatchGeometry<2>              &geometry,
                const std::vector<Edge>             &edges,
                const std::vector<dealii::Point<2>> &positions,
                const double                         tolerance);



  /**
   * What the nodes of a fluid's wall and the edges of a spline solid tell each
   * other, by finite interpolation (Lee 2025, section 1.3.4): a node
   * that sits at parameter xi of an edge moves with it,
   *
   *   d_i = sum_a N_a(xi_i) u_a = (H u)_i,
   *
   * exactly, and its force acts on the control points by the transpose, so that
   * the work is the same on both sides,
   *
   *   f_a = sum_i N_a(xi_i) F_i = (H^T F)_a.
   *
   * As the N_a sum to one, forces are conserved to round-off, and as positions
   * are interpolated by the same H, so are moments about the nodes' positions.
   * Nothing is fitted or integrated.
   *
   * Vectors of nodes are interleaved as those of the solid are: component c of
   * node i has index 2 i + c.
   */
  class Interface
  {
  public:
    using Vector = dealii::Vector<double>;

    Interface(const SplineSpace<2>         &space,
              const PatchGeometry<2>       &geometry,
              const std::vector<EdgePoint> &points);

    unsigned int
    n_points() const;

    /** H u: displacement of the nodes from that of the solid [m]; anything else
     *  that has the solid's unknowns, too. */
    Vector
    interpolate(const Vector &u) const;

    /** H^T F: adds to the loads of the solid [N/m]. */
    void
    add_loads(const Vector &force, Vector &loads) const;

    /** Reference positions X of the places [m]. */
    const std::vector<dealii::Point<2>> &
    reference_positions() const;

  private:
    /** A row of H: functions and values. */
    using Row = std::vector<std::pair<unsigned int, double>>;

    unsigned int                  n_dofs;
    std::vector<Row>              rows;
    std::vector<dealii::Point<2>> positions;
  };



  /** Given nodal forces as a dead load of the solid. */
  class InterfaceLoad : public ForceTerm
  {
  public:
    /** The interface must outlive this object. */
    explicit InterfaceLoad(const Interface &interface);

    /** At the nodes of the interface [N/m]. */
    void
    set_force(const dealii::Vector<double> &force);

    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const override;

    bool
    add(const dealii::Vector<double> &u,
        dealii::Vector<double>       &residual,
        dealii::SparseMatrix<double> *tangent) override;

  private:
    const Interface       &interface;
    dealii::Vector<double> force; ///< the negative
  };
} // namespace asperity

#endif
