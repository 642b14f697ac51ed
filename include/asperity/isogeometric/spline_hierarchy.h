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
  /** A Bezier cell: its level and, in each direction, the span of that level's
   *  knot vector. */
  template <int dim>
  struct CellIndex
  {
    unsigned int                  level = 0;
    std::array<unsigned int, dim> spans{};

    bool
    operator==(const CellIndex &other) const
    {
      return level == other.level && spans == other.spans;
    }

    /** The cell `levels` above that holds this one. */
    CellIndex
    ancestor(const unsigned int levels) const
    {
      CellIndex result = *this;
      result.level -= levels;
      for (unsigned int &span : result.spans)
        span >>= levels;
      return result;
    }

    /** Its place among the children of its parent, the first direction
     *  fastest. */
    unsigned int
    child_number() const
    {
      unsigned int number = 0;
      for (unsigned int d = 0; d < dim; ++d)
        number += (spans[d] % 2) << d;
      return number;
    }
  };

  /** A cell by its corners of least and largest parameters. */
  template <int dim>
  using CellBox = std::pair<dealii::Point<dim>, dealii::Point<dim>>;

  /** Product of the edge lengths of a box. */
  template <int dim>
  double
  measure(const CellBox<dim> &box)
  {
    double result = 1.;
    for (unsigned int d = 0; d < dim; ++d)
      result *= box.second[d] - box.first[d];
    return result;
  }

  /** The point of a box that has these coordinates in its unit cell. */
  template <int dim>
  dealii::Point<dim>
  from_unit_cell(const CellBox<dim> &box, const dealii::Point<dim> &unit)
  {
    dealii::Point<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = box.first[d] + unit[d] * (box.second[d] - box.first[d]);
    return result;
  }

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
  template <int dim>
  class SplineHierarchy
  {
  public:
    /**
     * @param knots of level 0 in each direction, equal degrees; level l has
     *   their l-th dyadic refinement
     * @param cells the active cells, which must tile the parameter box; their
     *   order is the numbering of the cells
     */
    SplineHierarchy(const std::array<KnotVector, dim> &knots,
                    const std::vector<CellIndex<dim>> &cells);

    unsigned int
    degree() const;

    bool
    is_periodic(const unsigned int direction) const;

    unsigned int
    n_levels() const;

    unsigned int
    n_functions() const;

    unsigned int
    n_cells() const;

    /** Knots of a level (< n_levels()) in a direction. */
    const KnotVector &
    knots(const unsigned int level, const unsigned int direction) const;

    const CellIndex<dim> &
    cell_index(const unsigned int cell) const;

    /** In parameters. */
    CellBox<dim>
    cell_box(const unsigned int cell) const;

    /** Functions that do not vanish on a cell, coarse levels first. */
    const std::vector<unsigned int> &
    cell_functions(const unsigned int cell) const;

    /** Bernstein coefficients of cell_functions(cell), a row each. */
    const dealii::FullMatrix<double> &
    cell_extraction(const unsigned int cell) const;

    /** The cell from which the coefficient of a function is read, and the
     *  place 0 .. (degree+1)^dim - 1 of the function among the B-splines of the
     *  cell's level: of the cells of the function's level, the one that holds
     *  most of it. */
    const std::pair<unsigned int, unsigned int> &
    function_home(const unsigned int function) const;

    /** Univariate extraction operator of a span. */
    const dealii::FullMatrix<double> &
    span_extraction(const unsigned int level,
                    const unsigned int direction,
                    const unsigned int span) const;

    /** The active cell that holds a parameter (wrapped in periodic directions,
     *  clamped to the box in the others). */
    unsigned int
    find_cell(const dealii::Point<dim> &parameter) const;

    /** A place in the tree of cells. */
    struct Node
    {
      static constexpr unsigned int n_children = 1u << dim;

      Node(const CellIndex<dim> &index, const int parent)
        : index(index)
        , parent(parent)
      {
        children.fill(-1);
      }

      CellIndex<dim>              index;
      int                         cell = -1; ///< active cell, -1 if refined
      int                         parent;    ///< -1: none, of level 0
      std::array<int, n_children> children;  ///< first direction fastest
    };

    const std::vector<Node> &
    nodes() const;

    /** The node of a cell if it exists, otherwise the active node that
     *  contains it. */
    unsigned int
    find_node(const CellIndex<dim> &index) const;

    /** The parameter's image nearest to the cell, as a point of its unit
     *  cell. */
    dealii::Point<dim>
    to_unit_cell(const unsigned int        cell,
                 const dealii::Point<dim> &parameter) const;

    /** Values and parametric gradients of cell_functions(cell). */
    void
    evaluate(const unsigned int                   cell,
             const dealii::Point<dim>            &parameter,
             std::vector<double>                 &values,
             std::vector<dealii::Tensor<1, dim>> *gradients = nullptr) const;

  private:
    /** What one level contributes: bases of all directions. */
    struct Level
    {
      explicit Level(const std::array<KnotVector, dim> &knots);

      std::array<KnotVector, dim>                              knots;
      std::array<std::vector<dealii::FullMatrix<double>>, dim> extraction;
      std::array<std::vector<dealii::FullMatrix<double>>, dim> two_scale;
      std::array<std::vector<std::vector<unsigned int>>, dim>  functions;
      std::array<std::vector<unsigned int>, dim>               support;
      /** B-splines with support inside Omega of the level: the number of the
       *  function, or inactive. */
      std::unordered_map<std::uint64_t, unsigned int> inside;
    };

    struct Cell
    {
      CellIndex<dim>             index;
      std::vector<unsigned int>  functions;
      dealii::FullMatrix<double> extraction;
    };

    void
    build_levels(const std::array<KnotVector, dim> &knots);

    void
    build_tree();

    /** The node of a cell of level 0. */
    unsigned int
    root(const CellIndex<dim> &index) const;

    void
    select_functions();

    /** Of a cell, those of its level that do not vanish on it, the first
     *  direction fastest. */
    std::vector<std::uint64_t>
    bsplines_of(const CellIndex<dim> &index) const;

    /** Number of cells of its level in the support of a B-spline. */
    unsigned int
    support_of(const Level &level, std::uint64_t bspline) const;

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
