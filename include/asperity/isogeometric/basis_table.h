#ifndef asperity_isogeometric_basis_table_h
#define asperity_isogeometric_basis_table_h

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>

#include <functional>
#include <vector>

namespace asperity
{
  class SplineSpace;

  /** The edges of the parameter rectangle; deal.II's boundary ids. */
  enum class Edge : unsigned int
  {
    left   = 0, ///< first parameter minimal
    right  = 1,
    bottom = 2, ///< second parameter minimal
    top    = 3
  };

  /** Points of a quadrature on an edge of the unit square. */
  std::vector<dealii::Point<2>>
  edge_points(const dealii::Quadrature<1> &quadrature, const Edge edge);

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
      unsigned int first_point = 0; ///< into the point arrays below

      /** [q * functions.size() + a] */
      std::vector<double> values;
      /** Gradient with respect to the reference position X [1/m], same
       *  layout. On an edge table: derivative along the edge with respect to
       *  reference arc length in component 0, along the reference outward
       *  normal in 1. */
      std::vector<dealii::Tensor<1, 2>> gradients;
    };

    unsigned int                  points_per_element = 0;
    std::vector<Element>          elements;
    std::vector<double>           JxW;       ///< per point, reference measure
    std::vector<dealii::Point<2>> position;  ///< X, reference
    std::vector<dealii::Point<2>> parameter; ///< (xi, eta)
    std::vector<dealii::Tensor<1, 2>>
      normal; ///< edges only: outward, reference
    std::vector<dealii::Tensor<1, 2>>
      tangent; ///< edges only: along the increasing parameter, unit, reference
  };

  /**
   * The reference geometry X(xi, eta) = (xi, eta) + sum_a N_a(xi, eta) D_a: the
   * identity plus an offset in the spline space, so that the same words hold
   * for periodic and for open patches. D is empty for the identity.
   */
  struct PatchGeometry
  {
    std::vector<dealii::Tensor<1, 2>> offset;

    /** The geometry X = map(xi, eta), projected to the space. */
    static PatchGeometry
    from_map(
      const SplineSpace                                               &space,
      const std::function<dealii::Point<2>(const dealii::Point<2> &)> &map);

    /** X at a parameter; if the space is periodic, a parameter beyond the
     *  period gives the shifted image. */
    dealii::Point<2>
    position(const SplineSpace &space, const dealii::Point<2> &parameter) const;
  };

  /** Table for integrals over the cells with a quadrature on the unit square.
   *  @throws ComputationError if the geometry folds at a point (det J <= 0). */
  BasisTable
  tabulate_cells(const SplineSpace           &space,
                 const PatchGeometry         &geometry,
                 const dealii::Quadrature<2> &quadrature);

  /**
   * Table for integrals over one edge, elements sorted along it; the direction
   * along the edge is that of the increasing parameter.
   * @param only_traces leave out the functions that vanish on the edge: right
   *   for traces and derivatives along the edge, not for normal derivatives
   */
  BasisTable
  tabulate_edge(const SplineSpace           &space,
                const PatchGeometry         &geometry,
                const Edge                   edge,
                const dealii::Quadrature<1> &quadrature,
                const bool                   only_traces = false);
} // namespace asperity

#endif
