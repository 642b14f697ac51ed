#ifndef asperity_splines_spline_sheet_h
#define asperity_splines_spline_sheet_h

#include <asperity/splines/spline_curve.h>

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace asperity
{
  /** Height of a sheet at a place, and its derivatives with respect to (x, y).
   */
  struct SheetJet
  {
    double                        height = 0.; ///< [m]
    dealii::Tensor<1, 2>          gradient;
    dealii::SymmetricTensor<2, 2> hessian; ///< [1/m]
  };



  /** A polynomial piece of a sheet, over the rectangle from begin to end [m].
   */
  struct SheetPiece
  {
    dealii::Point<2> begin, end;

    /** Control heights [m], (degree(0) + 1) (degree(1) + 1) of them, along x
     *  fastest, at equidistant places: the piece is in their convex hull. */
    std::vector<double> heights;
  };



  /**
   * A surface z = s(x, y) that repeats in x and in y: a tensor product of two
   * periodic B-spline bases whose parameters are x and y themselves [m]. It is
   * valid for all x and y.
   */
  class SplineSheet
  {
  public:
    SplineSheet() = default;

    /**
     * @param coefficients heights [m], n_basis(x) * n_basis(y) of them, those
     *   of the functions of x running fastest
     * @throws InputError if the knots are not periodic or the numbers do not
     *   agree
     */
    SplineSheet(const std::array<KnotVector, 2> &knot_vectors,
                const std::vector<double>       &coefficients);

    /** Direction 0 is x, 1 is y. */
    const KnotVector &
    knot_vector(const unsigned int direction) const;

    unsigned int
    degree(const unsigned int direction) const;

    /** What the sheet repeats after in a direction [m]. */
    double
    period(const unsigned int direction) const;

    const std::vector<double> &
    coefficients() const;

    /** Height [m] at (x, y). */
    double
    value(const dealii::Point<2> &place) const;

    /** At a knot the derivatives from the side of larger x or y. */
    SheetJet
    jet(const dealii::Point<2> &place) const;

    /** One piece a pair of spans of the first turn, along x fastest. */
    std::vector<SheetPiece>
    bezier_pieces() const;

    /** Lowest and highest point [m]. They are heights that the sheet has, and
     *  beyond which it is proved (by the control heights of ever smaller parts)
     *  to go by no more than 1e-9 of the range of its coefficients. */
    double
    minimum() const;

    double
    maximum() const;

    /** max |grad s|, proved as above up to 1e-9 of itself. */
    double
    largest_slope() const;

    /** max |ds/dx_d|, proved likewise.
     *  @param direction d, 0 for x and 1 for y */
    double
    largest_slope(const unsigned int direction) const;

    /** Integral of s over one period of both directions, divided by its area
     *  [m]. */
    double
    mean() const;

    /** factor s(x, y) + offset */
    SplineSheet
    mapped(const double factor, const double offset) const;

  private:
    std::array<KnotVector, 2> knot_vectors;
    std::vector<double>       coefficients_;
  };



  /**
   * The sheet s(x, y) = y(x) of the periodic graph (x, y(x)), with the degree
   * of the curve in both directions.
   * @param width the period in y [m], which begins at 0
   * @throws InputError if the curve is no periodic graph, or if there are fewer
   *   than degree + 1 spans in y
   */
  SplineSheet
  extrude(const SplineCurve &curve,
          const double       width,
          const unsigned int n_spans_y);
} // namespace asperity

#endif
