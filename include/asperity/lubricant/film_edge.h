#ifndef asperity_lubricant_film_edge_h
#define asperity_lubricant_film_edge_h

#include <asperity/isogeometric/element_view.h>
#include <asperity/isogeometric/spline_space.h>
#include <asperity/lubricant/film_gap.h>
#include <asperity/splines/curve_pieces.h>

#include <deal.II/lac/vector.h>

#include <boost/container/small_vector.hpp>

#include <utility>
#include <vector>

namespace asperity
{
  /** The derivative of a number: (degree of freedom, derivative), a degree may
   *  occur more than once. Up to cubic splines it allocates no memory. */
  using SparseGradient =
    boost::container::small_vector<std::pair<unsigned int, double>, 24>;

  /**
   * The gap between the deformed top edge of a periodic chip and the graph Y(x)
   * of the tool above it, divided into cells that are fixed to the chip: each
   * span of the edge holds the same number of them. Gaps are vertical, Y(x) -
   * y, with the cut-off of FilmGap; face i is the start of cell i.
   */
  class FilmEdge
  {
  public:
    /**
     * @param tool graph (x, Y(x)) with period, as SplineCurve::graph [m]
     * @throws InputError if the chip or the tool is not periodic in x
     */
    FilmEdge(const SplineSpace<2>   &space,
             const PatchGeometry<2> &geometry,
             const SplineCurve      &tool,
             const FilmGap          &gap,
             const unsigned int      cells_per_span);

    unsigned int
    n_cells() const;

    /** Length of the period [m]. */
    double
    period() const;

    /** Takes positions from a displacement u, interleaved as in ForceTerm, with
     *  the tool moved by an offset [m].
     *  @return false if the edge folds: x does not increase along it */
    bool
    measure(const dealii::Vector<double> &u,
            const dealii::Tensor<1, 2>   &tool_offset);

    /** Parameter of the edge at the start of a cell [m]. */
    double
    parameter(const unsigned int cell) const;

    /** Reference length of a cell [m]. */
    double
    reference_length(const unsigned int cell) const;

    /** int h dx over the deformed cell [m^2]. */
    double
    volume(const unsigned int cell) const;

    SparseGradient
    volume_gradient(const unsigned int cell) const;

    /** Current x of a face [m], not wrapped into the period. */
    double
    position(const unsigned int face) const;

    SparseGradient
    position_gradient(const unsigned int face) const;

    /** Thickness of the film at a face [m]. */
    double
    gap(const unsigned int face) const;

    SparseGradient
    gap_gradient(const unsigned int face) const;

    /** int n ds of each function over a cell, n out of the chip: the force of a
     *  unit pressure against the chip, with opposite sign [m]. */
    SparseGradient
    area_vector(const unsigned int cell) const;

    /** Calls action(i, j, value) for the derivatives of area_vector(): entry
     *  of degree of freedom i by degree of freedom j. */
    template <typename Action>
    void
    for_each_area_derivative(const unsigned int cell,
                             const Action      &action) const;

    /** Degrees of freedom that move a cell. */
    std::vector<unsigned int>
    cell_dofs(const unsigned int cell) const;

  private:
    ElementView<2>
    element_of(const unsigned int cell) const;

    /** Of a cell: its start; points 1 .. n_gauss behind it are inside. */
    unsigned int
    first_point(const unsigned int cell) const;

    /** Number of a point among those of its element. */
    unsigned int
    local_point(const unsigned int cell, const unsigned int point) const;

    CurvePieces   tool;
    FilmGap       film_gap;
    unsigned int  cells_per_span;
    unsigned int  n_gauss;
    BasisTable<2> table;

    // At the points of the table:
    std::vector<dealii::Tensor<1, 2>> x;         ///< current position [m]
    std::vector<dealii::Tensor<1, 2>> stretch;   ///< its derivative along X [-]
    std::vector<double>               thickness; ///< h [m]
    std::vector<double>               thickness_slope; ///< dh/dgap [-]
    std::vector<double>               tool_slope;      ///< Y' [-]
  };



  template <typename Action>
  void
  FilmEdge::for_each_area_derivative(const unsigned int cell,
                                     const Action      &action) const
  {
    const ElementView<2> element = element_of(cell);
    const unsigned int   n       = element.n_functions();
    const unsigned int   first   = first_point(cell);
    const unsigned int   q       = local_point(cell, first);
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = 0; b < n; ++b)
        {
          // n ds = (-y', x') dS
          double value = 0.;
          for (unsigned int k = 1; k <= n_gauss; ++k)
            value += table.JxW[first + k] * element.N(q + k, a) *
                     element.gradient(q + k, b)[0];
          action(element.dof(a, 0), element.dof(b, 1), -value);
          action(element.dof(a, 1), element.dof(b, 0), value);
        }
  }
} // namespace asperity

#endif
