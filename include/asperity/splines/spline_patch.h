#ifndef asperity_splines_spline_patch_h
#define asperity_splines_spline_patch_h

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



  /** Operator of one element from those of its two spans: rows are the
   * functions of the element, columns the Bernstein polynomials, xi fastest in
   * both. */
  dealii::FullMatrix<double>
  tensor_product(const dealii::FullMatrix<double> &xi,
                 const dealii::FullMatrix<double> &eta);
} // namespace asperity

#endif
