#ifndef asperity_isogeometric_spline_space_h
#define asperity_isogeometric_spline_space_h

#include <asperity/isogeometric/basis_table.h>
#include <asperity/isogeometric/spline_hierarchy.h>
#include <asperity/splines/knot_vector.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/tria.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace asperity
{
  /**
   * The truncated hierarchical B-spline space (THB; Giannelli, Juettler,
   * Speleers, CAGD 29 (2012) 485-498) on a deal.II triangulation of the
   * parameter box. An active cell is a Bezier element, its level is the
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
  template <int dim>
  class SplineSpace
  {
  public:
    /** Level-0 knot vectors of one degree; all directions but the last may be
     *  periodic: bottom and top bound the domain.
     *  @throws InputError if they are not so */
    explicit SplineSpace(const std::array<KnotVector, dim> &knots);

    /** The same, with the knot vectors one by one: SplineSpace<2>(x, y). */
    template <typename... KnotVectors,
              typename = std::enable_if_t<sizeof...(KnotVectors) == dim>>
    explicit SplineSpace(const KnotVectors &...knots)
      : SplineSpace(std::array<KnotVector, dim>{{knots...}})
    {}

    unsigned int
    degree() const;

    bool
    is_periodic(const unsigned int direction) const;

    unsigned int
    n_functions() const;

    unsigned int
    n_cells() const;

    /** The parameter box as a mesh; boundary ids as boundary_id(). */
    const dealii::Triangulation<dim> &
    triangulation() const;

    /** Set refine/coarsen flags here, then call execute_refinement(). */
    dealii::Triangulation<dim> &
    triangulation();

    /**
     * Carries out the deal.II flags and rebuilds the functions. First the flags
     * are graded, so that the functions of a cell stem from at most two
     * successive levels: with a cell of level l, all level-l cells within
     * `degree` spans of it (across periods, too) must exist. Cells are
     * flagged for refinement and coarsening is refused as this needs.
     * (A. Buffa, C. Giannelli, M3AS 26 (2016) 1-25, algorithm REFINE, m = 2.)
     */
    void
    execute_refinement();

    /** Of a cell, by its corners of least and largest parameters. */
    using CellCondition = std::function<bool(const dealii::Point<dim> &,
                                             const dealii::Point<dim> &)>;
    using CellLevel     = std::function<unsigned int(const dealii::Point<dim> &,
                                                 const dealii::Point<dim> &)>;

    /** Refines until every cell for which the condition holds has at least this
     *  level. */
    void
    refine_to_level(const unsigned int level, const CellCondition &wanted);

    /**
     * Refines until every cell has at least the level that is wanted of it, and
     * coarsens cells that are finer, where the grading lets them. A cell must
     * want at least what its parts want.
     */
    void
    adapt(const CellLevel &wanted);

    /** Refines and coarsens until the cells are those of `target`, which has
     *  the same level-0 knots (their numbers may differ). */
    void
    refine_like(const SplineHierarchy<dim> &target);

    /** The functions as an immutable value; keep the pointer to remember the
     *  space before a refinement. */
    std::shared_ptr<const SplineHierarchy<dim>>
    hierarchy() const;

    /** Functions that do not vanish on a cell. */
    const std::vector<unsigned int> &
    cell_functions(const unsigned int cell) const;

    /** Rows as cell_functions(cell); columns are the (degree+1)^dim Bernstein
     *  polynomials of the cell, x fastest. */
    const dealii::FullMatrix<double> &
    cell_extraction(const unsigned int cell) const;

    /** Of a cell, in parameters. */
    CellBox<dim>
    cell_box(const unsigned int cell) const;

    /** The cell that holds a parameter (wrapped in periodic directions). */
    unsigned int
    find_cell(const dealii::Point<dim> &parameter) const;

    /** Cells with a face on the edge, sorted along it. */
    std::vector<unsigned int>
    edge_cells(const Edge edge) const;

    /** Functions whose trace on the edge does not vanish, sorted by index. */
    std::vector<unsigned int>
    edge_functions(const Edge edge) const;

    /** Values (and parametric gradients) of cell_functions(cell) at a
     *  parameter point. */
    void
    evaluate(const unsigned int                   cell,
             const dealii::Point<dim>            &parameter,
             std::vector<double>                 &values,
             std::vector<dealii::Tensor<1, dim>> *gradients = nullptr) const;

    /**
     * Coefficients of the L2 projection (in parameters) of n_components
     * functions, with `edge_weight` times the edge length scale added as an L2
     * term on the edges that bound the domain (boundary_edges()), so that they
     * are met more closely than the inside.
     * @return [component][function]
     */
    std::vector<std::vector<double>>
    project(
      const std::function<std::vector<double>(const dealii::Point<dim> &)> &f,
      const unsigned int n_components,
      const double       edge_weight = 10.) const;

    ~SplineSpace();

  private:
    /** Flags cells by the number of levels that they lack (positive) or have
     *  too many, and executes the flags. @return whether there are any */
    bool
    step_towards(const std::function<int(const unsigned int)> &missing_levels);

    struct Implementation;
    std::unique_ptr<Implementation> implementation;
  };
} // namespace asperity

#endif
