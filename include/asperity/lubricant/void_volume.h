#ifndef asperity_lubricant_void_volume_h
#define asperity_lubricant_void_volume_h

#include <asperity/isogeometric/basis_table.h>
#include <asperity/isogeometric/spline_space.h>
#include <asperity/splines/spline_curve.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <vector>

namespace asperity
{
  /**
   * The area between the deformed top edge of a periodic chip, (x(s), y(s)),
   * and the graph Y(x) of the tool above, over one period: for a stretch of
   * the edge from a to b
   *
   *   V = int_{x(a)}^{x(b)} Y dx - int_a^b y x' ds,
   *
   * with its first and second derivatives with respect to the displacement.
   * They are exact: the tool is integrated in closed form, and Gauss' rule
   * integrates the polynomials of the edge. Where the surfaces overlap the area
   * counts as negative. Over the whole period the derivative is the nodal area
   * vector, dV = - int n . du ds, n out of the chip.
   *
   * Stretches consist of elements of the edge, the first of which begins at the
   * period's start.
   */
  class VoidVolume
  {
  public:
    /** A stretch of the edge: n elements from `first`, going on beyond the end
     *  of the period with its first element. */
    struct Stretch
    {
      unsigned int first = 0;
      unsigned int n     = 0;
    };

    /** @param tool graph (x, Y(x)) with period, as SplineCurve::graph [m] */
    VoidVolume(const SplineSpace<2>   &space,
               const PatchGeometry<2> &geometry,
               const SplineCurve      &tool);

    unsigned int
    n_elements() const;

    unsigned int
    n_dofs() const;

    /** Parameter of the edge at the start of an element, in [0, L) [m]. */
    double
    parameter(const unsigned int element) const;

    /** The elements between two parameters, 0 <= begin < L, end <= begin + L,
     *  both rounded to starts of elements. */
    Stretch
    stretch(const double begin, const double end) const;

    /** The whole period. */
    Stretch
    period() const;

    /** Takes the positions of the edge from a displacement. */
    void
    measure(const dealii::Vector<double> &u);

    /** Vertical distance of the tool over the start of an element [m]. */
    double
    gap(const unsigned int element) const;

    /** Current x of the start of an element [m]. */
    double
    position(const unsigned int element) const;

    /** V [m^2] */
    double
    volume(const Stretch &stretch) const;

    /** g += factor dV/du */
    void
    add_gradient(const Stretch          &stretch,
                 const double            factor,
                 dealii::Vector<double> &g) const;

    /** K += factor d^2V/du^2 */
    void
    add_hessian(const Stretch                &stretch,
                const double                  factor,
                dealii::SparseMatrix<double> &K) const;

    void
    add_couplings(dealii::DynamicSparsityPattern &pattern) const;

  private:
    /** int_0^x Y [m^2] */
    double
    tool_integral(const double x) const;

    bool
    is_closed(const Stretch &stretch) const;

    /** The end of a stretch as the start of an element, and by how much x has
     *  gone beyond it [m]. */
    std::pair<unsigned int, double>
    end_of(const Stretch &stretch) const;

    SplineCurve         tool;
    double              length; ///< period L [m]
    unsigned int        n_dofs_;
    std::vector<double> tool_knots;      ///< breakpoints over one period [m]
    std::vector<double> tool_cumulative; ///< int of Y up to each [m^2]

    BasisTable<2> table; ///< Gauss points of the edge, traces only
    BasisTable<2> ends;  ///< two points an element: its start and end

    std::vector<dealii::Point<2>>     point;   ///< current Gauss points
    std::vector<dealii::Tensor<1, 2>> tangent; ///< dx/dS there
    std::vector<dealii::Point<2>>     node;    ///< current starts of elements
  };
} // namespace asperity

#endif
