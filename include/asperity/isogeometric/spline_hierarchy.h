#ifndef asperity_isogeometric_spline_hierarchy_h
#define asperity_isogeometric_spline_hierarchy_h

#include <asperity/splines/knot_vector.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace asperity
{
  /** A Bezier cell: its level and the spans of that level's knot vectors. */
  struct CellIndex
  {
    unsigned int level = 0;
    unsigned int i     = 0; ///< span in the first parameter
    unsigned int j     = 0; ///< span in the second parameter

    bool
    operator==(const CellIndex &other) const
    {
      return level == other.level && i == other.i && j == other.j;
    }
  };

  /**
   * The truncated hierarchical basis of a list of cells, without a mesh: an
   * immutable value, so that a shared pointer to it remembers the space before
   * a refinement (SplineSpace::hierarchy()).
   *
   * With Omega^l the union of the cells of level l and finer, a B-spline of
   * level l is active if its support lies inside Omega^l but not inside
   * Omega^(l+1). It is truncated: on each finer level the components along
   * B-splines whose support lies inside that level's Omega are dropped.
   * (C. Giannelli, B. Juettler, H. Speleers, CAGD 29 (2012) 485-498,
   * definitions 1 and 4.)
   *
   * On a cell of level l, the coefficient of an active level-l function along
   * its own B-spline is one and that of every other function is zero. Hence the
   * coefficient of a spline of the space can be read off any one such cell
   * (function_home()); H. Speleers, C. Manni, Numer. Math. 132 (2016) 155-184.
   */
  class SplineHierarchy
  {
  public:
    /**
     * @param knots_x, knots_y of level 0, equal degrees; level l has their l-th
     *   dyadic refinement
     * @param cells the active cells, which must tile the parameter rectangle;
     *   their order is the numbering of the cells
     */
    SplineHierarchy(const KnotVector             &knots_x,
                    const KnotVector             &knots_y,
                    const std::vector<CellIndex> &cells);

    unsigned int
    degree() const;

    bool
    periodic_x() const;

    unsigned int
    n_levels() const;

    unsigned int
    n_functions() const;

    unsigned int
    n_cells() const;

    /** Knots of a level (< n_levels()); direction 0 or 1. */
    const KnotVector &
    knots(const unsigned int level, const unsigned int direction) const;

    const CellIndex &
    cell_index(const unsigned int cell) const;

    /** Lower left and upper right corner, in parameters. */
    std::pair<dealii::Point<2>, dealii::Point<2>>
    cell_box(const unsigned int cell) const;

    /** Functions that do not vanish on a cell, coarse levels first. */
    const std::vector<unsigned int> &
    cell_functions(const unsigned int cell) const;

    /** Bernstein coefficients of cell_functions(cell), a row each. */
    const dealii::FullMatrix<double> &
    cell_extraction(const unsigned int cell) const;

    /** The cell from which the coefficient of a function is read, and the
     *  place 0 .. (degree+1)^2 - 1 of the function among the B-splines of the
     *  cell's level: of the cells of the function's level, the one that holds
     *  most of it. */
    const std::pair<unsigned int, unsigned int> &
    function_home(const unsigned int function) const;

    /** Univariate extraction operator of a span. */
    const dealii::FullMatrix<double> &
    span_extraction(const unsigned int level,
                    const unsigned int direction,
                    const unsigned int span) const;

    /** The active cell that holds a parameter (wrapped in x if periodic,
     *  clamped to the rectangle otherwise). */
    unsigned int
    find_cell(const dealii::Point<2> &parameter) const;

    /** A place in the tree of cells. */
    struct Node
    {
      CellIndex          index;
      int                cell   = -1; ///< active cell, or -1 if refined
      int                parent = -1;
      std::array<int, 4> children{{-1, -1, -1, -1}}; ///< x fastest
    };

    const std::vector<Node> &
    nodes() const;

    /** The node of a cell if it exists, otherwise the active node that
     *  contains it. */
    unsigned int
    find_node(const CellIndex &index) const;

    /** The parameter's image nearest to the cell, as a point of the unit
     *  square of the cell. */
    dealii::Point<2>
    to_unit_cell(const unsigned int      cell,
                 const dealii::Point<2> &parameter) const;

    /** Values and parametric gradients of cell_functions(cell). */
    void
    evaluate(const unsigned int                 cell,
             const dealii::Point<2>            &parameter,
             std::vector<double>               &values,
             std::vector<dealii::Tensor<1, 2>> *gradients = nullptr) const;

  private:
    /** What one level contributes: bases of both directions. */
    struct Level
    {
      explicit Level(const std::array<KnotVector, 2> &knots);

      std::array<KnotVector, 2>                              knots;
      std::array<std::vector<dealii::FullMatrix<double>>, 2> extraction;
      std::array<std::vector<dealii::FullMatrix<double>>, 2> two_scale;
      std::array<std::vector<std::vector<unsigned int>>, 2>  functions;
      std::array<std::vector<unsigned int>, 2>               support;
      /** B-splines with support inside Omega of the level: the number of the
       *  function, or inactive. */
      std::unordered_map<std::uint64_t, unsigned int> inside;
    };

    struct Cell
    {
      CellIndex                  index;
      std::vector<unsigned int>  functions;
      dealii::FullMatrix<double> extraction;
    };

    void
    build_levels(const KnotVector &knots_x, const KnotVector &knots_y);

    void
    build_tree();

    void
    select_functions();

    std::vector<std::uint64_t>
    bsplines_of(const CellIndex &index) const;

    /** Multi-level extraction down the tree; `operators` holds the functions of
     *  coarser levels on the parent in terms of its B-splines. */
    void
    extract(const Node                       &node,
            const std::vector<unsigned int>  &functions,
            const dealii::FullMatrix<double> &operators);

    void
    find_homes();

    std::vector<Level>                                 levels;
    std::vector<Cell>                                  cells;
    std::vector<Node>                                  tree;
    unsigned int                                       n_functions_ = 0;
    std::vector<std::pair<unsigned int, unsigned int>> homes;
  };
} // namespace asperity

#endif
