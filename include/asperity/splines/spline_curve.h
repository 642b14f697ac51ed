#ifndef asperity_splines_spline_curve_h
#define asperity_splines_spline_curve_h

#include <asperity/splines/knot_vector.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace asperity
{
  /** A polynomial (or rational) piece of a curve, on [begin, end]. */
  struct BezierPiece
  {
    double                        begin = 0.;
    double                        end   = 1.;
    std::vector<dealii::Point<2>> points;  ///< degree + 1 control points [m]
    std::vector<double>           weights; ///< as many; empty if polynomial
  };

  /**
   * A plane B-spline or NURBS curve (Piegl and Tiller, chapters 3 and 4).
   *
   * On a periodic knot vector the curve goes on for all parameters and moves by
   * `period` in each turn: C(t + T) = C(t) + period, T the period of the knots.
   * Zero closes the curve; (L, 0) makes the graph of an L-periodic function one
   * curve that is valid for every x.
   */
  class SplineCurve
  {
  public:
    SplineCurve() = default;

    /**
     * @param control_points one a function of the basis [m]; of a periodic
     * curve those of the unwrapped functions 0 .. n_basis() - 1 (as
     *   KnotVector::greville())
     * @param weights of a NURBS curve, positive; empty for a B-spline
     * @param period [m], only with periodic knots
     * @throws InputError if the numbers do not agree or a weight is not
     * positive.
     */
    SplineCurve(const KnotVector                    &knot_vector,
                const std::vector<dealii::Point<2>> &control_points,
                const std::vector<double>           &weights = {},
                const dealii::Tensor<1, 2>          &period  = {});

    /** The graph (t, y(t)) of a scalar spline; the period of a periodic one is
     *  that of its knots. @param values coefficients of y [m] */
    static SplineCurve
    graph(const KnotVector &knot_vector, const std::vector<double> &values);

    const KnotVector &
    knot_vector() const;

    unsigned int
    degree() const;

    bool
    is_periodic() const;

    bool
    is_rational() const;

    const std::vector<dealii::Point<2>> &
    control_points() const;

    const std::vector<double> &
    weights() const;

    /** What the curve moves by in one turn [m]; zero if closed or open. */
    const dealii::Tensor<1, 2> &
    period() const;

    /** As many others: cheap. @throws InputError if there are not as many. */
    void
    set_control_points(const std::vector<dealii::Point<2>> &control_points);

    /** The point at t [m]; beyond the ends of an open curve its last span is
     *  continued. */
    dealii::Point<2>
    value(const double t) const;

    /** Derivatives 0 .. n with respect to t; [0] is the point. At a knot those
     *  from the right (at the last one from the left). */
    std::vector<dealii::Tensor<1, 2>>
    derivatives(const double t, const unsigned int n) const;

    /** As above with the polynomials of a given span, at t in [front, back] or
     *  beyond: the one-sided derivatives at a knot. */
    std::vector<dealii::Tensor<1, 2>>
    derivatives_on_span(const unsigned int span,
                        const double       t,
                        const unsigned int n) const;

    /** One piece a nonempty span, of the first turn. */
    std::vector<BezierPiece>
    bezier_pieces() const;

    /** Arc length between two parameters [m], by Gauss quadrature with
     *  `n_points` points a span: exact only where the speed is a polynomial of
     *  degree 2 n_points - 1. */
    double
    length(const double       t0,
           const double       t1,
           const unsigned int n_points = 8) const;

  private:
    /** Homogeneous control point (w x, w y, w) of function j of a span. */
    dealii::Tensor<1, 3>
    homogeneous_control_point(const unsigned int span,
                              const unsigned int j,
                              const unsigned int function) const;

    KnotVector                    knot_vector_;
    std::vector<dealii::Point<2>> control_points_;
    std::vector<double>           weights_;
    dealii::Tensor<1, 2>          period_;
  };
} // namespace asperity

#endif
