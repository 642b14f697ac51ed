#ifndef asperity_isogeometric_basis_table_h
#define asperity_isogeometric_basis_table_h

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <functional>
#include <vector>

namespace asperity
{
  template <int dim>
  class SplineSpace;

  /** The edges of the parameter rectangle or, in three dimensions, the faces of
   *  the parameter box: bottom and top are the ends of the last parameter in
   *  both. */
  enum class Edge : unsigned int
  {
    left   = 0, ///< first parameter minimal
    right  = 1,
    bottom = 2, ///< last parameter minimal
    top    = 3,
    front  = 4, ///< second of three parameters minimal
    back   = 5
  };

  /** All edges, in the order of deal.II's boundary ids. */
  template <int dim>
  std::vector<Edge>
  all_edges()
  {
    if constexpr (dim == 3)
      return {Edge::left,
              Edge::right,
              Edge::front,
              Edge::back,
              Edge::bottom,
              Edge::top};
    else
      return {Edge::left, Edge::right, Edge::bottom, Edge::top};
  }

  /** The direction of the parameter that is constant on an edge. */
  template <int dim>
  constexpr unsigned int
  normal_direction(const Edge edge)
  {
    return edge == Edge::left || edge == Edge::right ? 0 :
           edge == Edge::bottom || edge == Edge::top ? dim - 1 :
                                                       1;
  }

  /** Whether the constant parameter is maximal, rather than minimal. */
  constexpr bool
  is_at_end(const Edge edge)
  {
    return static_cast<unsigned int>(edge) % 2 == 1;
  }

  /** The directions along an edge, in order. */
  template <int dim>
  std::array<unsigned int, dim - 1>
  directions_along(const Edge edge)
  {
    std::array<unsigned int, dim - 1> directions;
    for (unsigned int k = 0; k < dim - 1; ++k)
      directions[k] = k < normal_direction<dim>(edge) ? k : k + 1;
    return directions;
  }

  /** deal.II's id of an edge as a boundary of the triangulation. */
  template <int dim>
  constexpr unsigned int
  boundary_id(const Edge edge)
  {
    return 2 * normal_direction<dim>(edge) + (is_at_end(edge) ? 1 : 0);
  }

  /** Points of a quadrature on an edge of the unit cell. */
  template <int dim>
  std::vector<dealii::Point<dim>>
  edge_points(const dealii::Quadrature<dim - 1> &quadrature, const Edge edge);

  /**
   * Everything that an integral over cells or over an edge needs, tabulated
   * once for a fixed reference geometry: a total Lagrangian assembly never
   * evaluates a basis function again.
   */
  template <int dim>
  struct BasisTable
  {
    /** One integration cell (or edge of a cell). */
    struct Element
    {
      unsigned int              cell = 0;
      std::vector<unsigned int> functions;
      unsigned int first_point = 0; ///< into the point arrays below

      /** [q * functions.size() + a] */
      std::vector<double> values;
      /** Gradient with respect to the reference position X [1/m], same
       *  layout. On an edge table: derivatives along the edge's tangents with
       *  respect to reference arc length in the components 0 .. dim - 2, along
       *  the reference outward normal in the last. */
      std::vector<dealii::Tensor<1, dim>> gradients;
    };

    unsigned int                    points_per_element = 0;
    std::vector<Element>            elements;
    std::vector<double>             JxW;       ///< per point, reference measure
    std::vector<dealii::Point<dim>> position;  ///< X, reference
    std::vector<dealii::Point<dim>> parameter; ///< (xi, eta, ...)
    std::vector<dealii::Tensor<1, dim>>
      normal; ///< edges only: outward, reference
    /** Edges only, dim - 1 a point: orthonormal, reference. The first one is
     *  along the first increasing parameter of the edge; in three dimensions
     *  the second is as near to the second parameter's direction as it can. */
    std::vector<dealii::Tensor<1, dim>> tangent;
  };

  /**
   * The reference geometry X(xi) = xi + sum_a N_a(xi) D_a: the identity plus an
   * offset in the spline space, so that the same words hold for periodic and
   * for open patches. D is empty for the identity.
   */
  template <int dim>
  struct PatchGeometry
  {
    std::vector<dealii::Tensor<1, dim>> offset;

    /** The geometry X = map(xi), projected to the space. */
    static PatchGeometry
    from_map(
      const SplineSpace<dim> &space,
      const std::function<dealii::Point<dim>(const dealii::Point<dim> &)> &map);

    /** X at a parameter; if the space is periodic, a parameter beyond the
     *  period gives the shifted image. */
    dealii::Point<dim>
    position(const SplineSpace<dim>   &space,
             const dealii::Point<dim> &parameter) const;
  };

  /** Table for integrals over the cells with a quadrature on the unit cell.
   *  @param wanted whether a cell's functions are tabulated; elements of other
   *    cells have none, but their points; empty: all are
   *  @throws ComputationError if the geometry folds at a point (det J <= 0). */
  template <int dim>
  BasisTable<dim>
  tabulate_cells(const SplineSpace<dim>                        &space,
                 const PatchGeometry<dim>                      &geometry,
                 const dealii::Quadrature<dim>                 &quadrature,
                 const std::function<bool(const unsigned int)> &wanted = {});

  /**
   * Table for integrals over one edge, elements in the order of edge_cells().
   * @param only_traces leave out the functions that vanish on the edge: right
   *   for traces and derivatives along the edge, not for normal derivatives
   */
  template <int dim>
  BasisTable<dim>
  tabulate_edge(const SplineSpace<dim>            &space,
                const PatchGeometry<dim>          &geometry,
                const Edge                         edge,
                const dealii::Quadrature<dim - 1> &quadrature,
                const bool                         only_traces = false);
} // namespace asperity

#endif
