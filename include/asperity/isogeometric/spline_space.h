#ifndef asperity_isogeometric_spline_space_h
#define asperity_isogeometric_spline_space_h

#include <asperity/splines/knot_vector.h>

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/base/smartpointer.h>

#include <deal.II/grid/tria.h>

#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <memory>
#include <vector>

namespace asperity
{
  /** The edges of the parameter rectangle; deal.II's boundary ids. */
  enum class Edge : unsigned int
  {
    left   = 0, ///< first parameter minimal
    right  = 1,
    bottom = 2, ///< second parameter minimal
    top    = 3
  };

  /**
   * The truncated hierarchical B-spline space (THB; Giannelli, Juettler,
   * Speleers, CAGD 29 (2012) 485-498) on a deal.II triangulation of the
   * parameter rectangle. An active cell is a Bezier element, its level is the
   * level of the hierarchy; level l lives on the l-times dyadically refined
   * knot vectors. A mesh without local refinement gives plain tensor-product
   * B-splines.
   *
   * Functions are numbered 0 .. n_functions() - 1. On a cell they are
   * Bernstein polynomials times an extraction operator (multi-level Bezier
   * extraction; D'Angella et al., CMAME 328 (2018) 147-174).
   *
   * Cells are numbered 0 .. n_cells() - 1 in the order of the triangulation's
   * active cell iterators (active_cell_index()).
   */
  class SplineSpace
  {
  public:
    /** Level-0 knot vectors; both have the same degree; x may be periodic. */
    SplineSpace(const KnotVector &knots_x, const KnotVector &knots_y);

    unsigned int
    degree() const;

    bool
    periodic_x() const;

    unsigned int
    n_functions() const;

    unsigned int
    n_cells() const;

    /** Parameter domain [x0,x1] x [y0,y1] as a mesh. Boundary ids as Edge. */
    const dealii::Triangulation<2> &
    triangulation() const;

    /** Set refine/coarsen flags here, then call execute_refinement(). */
    dealii::Triangulation<2> &
    triangulation();

    /**
     * The deal.II flags are carried out (after adding the cells that keep
     * neighbouring levels within one, across the period, too) and the functions
     * rebuilt.
     */
    void
    execute_refinement();

    /** Refines until every cell for which `wanted(lower left, upper right)` (in
     *  parameters) holds has at least this level. */
    void
    refine_to_level(
      const unsigned int level,
      const std::function<bool(const dealii::Point<2> &, const dealii::Point<2> &)>
        &wanted);

    /** Functions that do not vanish on a cell. */
    const std::vector<unsigned int> &
    cell_functions(const unsigned int cell) const;

    /** Rows as cell_functions(cell); columns are the (degree+1)^2 Bernstein
     *  polynomials of the cell, x fastest. */
    const dealii::FullMatrix<double> &
    cell_extraction(const unsigned int cell) const;

    /** Lower left and upper right corner of a cell, in parameters. */
    std::pair<dealii::Point<2>, dealii::Point<2>>
    cell_box(const unsigned int cell) const;

    /** The cell that holds a parameter (wrapped in x if periodic). */
    unsigned int
    find_cell(const dealii::Point<2> &parameter) const;

    /** Cells with a face on the edge, sorted along it. */
    std::vector<unsigned int>
    edge_cells(const Edge edge) const;

    /** Functions whose trace on the edge does not vanish, sorted by index. */
    std::vector<unsigned int>
    edge_functions(const Edge edge) const;

    /** Values (and parametric gradients) of cell_functions(cell) at a
     *  parameter point. */
    void
    evaluate(const unsigned int                    cell,
             const dealii::Point<2>               &parameter,
             std::vector<double>                  &values,
             std::vector<dealii::Tensor<1, 2>>    *gradients = nullptr) const;

    /**
     * Coefficients of the L2 projection (in parameters) of n_components
     * functions, with `edge_weight` times the edge length scale added as an L2
     * term on all four edges, so that edges are met more closely than the inside.
     * @return [component][function]
     */
    std::vector<std::vector<double>>
    project(const std::function<std::vector<double>(const dealii::Point<2> &)> &f,
            const unsigned int n_components,
            const double       edge_weight = 10.) const;

    ~SplineSpace();

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };

  /**
   * Everything that an integral over cells or over an edge needs, tabulated
   * once for a fixed reference geometry: a total Lagrangian assembly never
   * evaluates a basis function again.
   */
  struct BasisTable
  {
    /** One integration cell (or edge of a cell). */
    struct Element
    {
      unsigned int              cell = 0;
      std::vector<unsigned int> functions;
      unsigned int              first_point = 0; ///< into the point arrays below

      /** [q * functions.size() + a] */
      std::vector<double> values;
      /** Gradient with respect to the reference position X [1/m], same
       *  layout. On an edge table: derivative along the edge with respect to
       *  reference arc length in component 0, along the reference outward normal in 1. */
      std::vector<dealii::Tensor<1, 2>> gradients;
    };

    unsigned int          points_per_element = 0;
    std::vector<Element>  elements;
    std::vector<double>   JxW;               ///< per point, reference measure
    std::vector<dealii::Point<2>> position;  ///< X, reference
    std::vector<dealii::Point<2>> parameter; ///< (xi, eta)
    std::vector<dealii::Tensor<1, 2>> normal; ///< edges only: outward, reference
  };

  /**
   * The reference geometry X(xi, eta) = (xi, eta) + sum_a N_a(xi, eta) D_a: the
   * identity plus an offset in the spline space, so that the same words hold for
   * periodic and for open patches. D is empty for the identity.
   */
  struct PatchGeometry
  {
    std::vector<dealii::Tensor<1, 2>> offset;

    /** The geometry X = map(xi, eta), projected to the space. */
    static PatchGeometry
    from_map(const SplineSpace &space,
             const std::function<dealii::Point<2>(const dealii::Point<2> &)> &map);
  };

  /** Table for integrals over the cells with a quadrature on the unit square. */
  BasisTable
  tabulate_cells(const SplineSpace           &space,
                 const PatchGeometry         &geometry,
                 const dealii::Quadrature<2> &quadrature);

  /** Table for integrals over one edge, elements sorted along it. */
  BasisTable
  tabulate_edge(const SplineSpace           &space,
                const PatchGeometry         &geometry,
                const Edge                   edge,
                const dealii::Quadrature<1> &quadrature);
} // namespace asperity

#endif
