#ifndef asperity_splines_spline_patch_h
#define asperity_splines_spline_patch_h

#include <asperity/splines/refinement.h>
#include <asperity/splines/spline_curve.h>

#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

namespace asperity
{
  /**
   * A plane region as a tensor-product B-spline or NURBS map of the parameters
   * (xi, eta). Control points and weights are stored with the function of xi
   * running fastest. In a periodic direction the map goes on for all parameters
   * and moves by that direction's period in each turn, as SplineCurve.
   */
  class SplinePatch
  {
  public:
    SplinePatch() = default;

    /**
     * @param control_points [m], n_basis(xi) * n_basis(eta) of them
     * @param weights as many and positive, or none (B-spline)
     * @param periods [m], zero in open directions
     * @throws InputError if the numbers do not agree or a weight is not
     * positive.
     */
    SplinePatch(const std::array<KnotVector, 2>           &knot_vectors,
                const std::vector<dealii::Point<2>>       &control_points,
                const std::vector<double>                 &weights = {},
                const std::array<dealii::Tensor<1, 2>, 2> &periods = {});

    /** The patch swept by `curve` along `path` (eta = 0 .. 1, linear): the
     * ruled region between the curve and its copy moved by `path` [m]. */
    static SplinePatch
    extrude(const SplineCurve &curve, const dealii::Tensor<1, 2> &path);

    const KnotVector &
    knot_vector(const unsigned int direction) const;

    const std::vector<dealii::Point<2>> &
    control_points() const;

    const std::vector<double> &
    weights() const;

    bool
    is_rational() const;

    const dealii::Tensor<1, 2> &
    period(const unsigned int direction) const;

    dealii::Point<2>
    value(const double xi, const double eta) const;

    /** Partial derivatives (Piegl and Tiller, equation 4.20).
     *  @return [k][l] differentiated k times by xi, l by eta, k + l <= n */
    std::vector<std::vector<dealii::Tensor<1, 2>>>
    derivatives(const double xi, const double eta, const unsigned int n) const;

    /** The curve eta = front or back (direction 1), xi = front or back
     *  (direction 0) of an open direction.
     *  @throws InputError if the direction is periodic */
    SplineCurve
    edge(const unsigned int direction, const bool at_back) const;

    /** The curve on which all control points have index `function` in the given
     *  direction. */
    SplineCurve
    control_row(const unsigned int direction,
                const unsigned int function) const;

    /** A patch of which control_row(direction, j) are the given curves.
     *  @throws InputError if there are not as many as functions */
    static SplinePatch
    from_control_rows(const unsigned int              direction,
                      const KnotVector               &knot_vector,
                      const std::vector<SplineCurve> &rows,
                      const dealii::Tensor<1, 2>     &period = {});

  private:
    unsigned int
    index(const unsigned int direction,
          const unsigned int function,
          const unsigned int other) const;

    std::array<KnotVector, 2>           knot_vectors;
    std::vector<dealii::Point<2>>       control_points_;
    std::vector<double>                 weights_;
    std::array<dealii::Tensor<1, 2>, 2> periods;
  };



  /** The same patch with another basis in one direction. */
  SplinePatch
  transfer(const SplinePatch   &patch,
           const unsigned int   direction,
           const BasisTransfer &basis_transfer);

  SplinePatch
  insert_knots(const SplinePatch         &patch,
               const unsigned int         direction,
               const std::vector<double> &new_knots);

  SplinePatch
  elevate_degree(const SplinePatch &patch, const unsigned int direction);

  /** Operator of one element from those of its two spans: rows are the
   * functions of the element, columns the Bernstein polynomials, xi fastest in
   * both. */
  dealii::FullMatrix<double>
  tensor_product(const dealii::FullMatrix<double> &xi,
                 const dealii::FullMatrix<double> &eta);
} // namespace asperity

#endif
