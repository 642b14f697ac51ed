#ifndef asperity_splines_knot_vector_h
#define asperity_splines_knot_vector_h

#include <vector>

namespace asperity
{
  /**
   * Degree and knots of a univariate B-spline basis. Open (clamped) bases
   * interpolate their ends; periodic ones wrap: function i and function
   * i + n_basis() are one, and the knots reach degree() spans beyond both
   * ends of the period.
   *
   * Notation of L. Piegl, W. Tiller, The NURBS Book, 2nd ed., Springer 1997.
   */
  class KnotVector
  {
  public:
    KnotVector() = default;

    /**
     * Every interior breakpoint, of a periodic basis each, is a knot as many
     * times as its multiplicity: the functions are degree - multiplicity times
     * continuously differentiable there, splines with 1, the functions of
     * finite elements with the degree.
     * @param breakpoints strictly increasing, from the first to the last
     *   parameter (periodic: from the start of the period to its end)
     * @throws InputError if degree < 1 or breakpoints do not increase or, when
     * periodic, if there are fewer than degree + 1 spans, or if the
     * multiplicity is not in 1 .. degree.
     */
    KnotVector(const unsigned int         degree,
               const std::vector<double> &breakpoints,
               const bool                 periodic     = false,
               const unsigned int         multiplicity = 1);

    /** Periodic, n_spans equal spans from `begin` to `begin` + `period`.
     *  @throws InputError as above, or if the period is not positive */
    static KnotVector
    uniform_periodic(const unsigned int degree,
                     const unsigned int n_spans,
                     const double       begin,
                     const double       period);

    /** Open, any multiplicities. @throws InputError if the knots are none. */
    static KnotVector
    from_knots(const unsigned int degree, const std::vector<double> &knots);

    unsigned int
    degree() const;

    bool
    is_periodic() const;

    /** Of new breakpoints, and of all that the constructor was given. */
    unsigned int
    multiplicity() const;

    /** Distinct functions; of a periodic basis each counts once. */
    unsigned int
    n_basis() const;

    /** Nonempty spans. */
    unsigned int
    n_spans() const;

    /** Ends of the nonempty spans, n_spans() + 1 values. */
    const std::vector<double> &
    breakpoints() const;

    /** All knots; of a periodic basis those of the unwrapped one. */
    const std::vector<double> &
    knots() const;

    double
    front() const;

    double
    back() const;

    /** Index of the nonempty span that holds t; wraps a periodic basis,
     *  clamps t to the ends of an open one. The last span is closed. */
    unsigned int
    find_span(const double t) const;

    /** t itself, or its image in [front, back) if periodic. */
    double
    wrap(const double t) const;

    /** The degree + 1 functions that live on a span, in order of their
     *  unwrapped index; wrapped to [0, n_basis()) if periodic. */
    std::vector<unsigned int>
    span_functions(const unsigned int span) const;

    /** Whether the j-th of span_functions(span) is the one of a periodic basis
     *  that begins in the next period, wrapped. */
    bool
    is_wrapped(const unsigned int span, const unsigned int j) const;

    /**
     * Values and derivatives (Piegl and Tiller A2.3) of the degree + 1
     * functions of the span at t, which is evaluated with the span's
     * polynomials even if it lies outside.
     * @return [k][j]: k-th derivative, 0 <= k <= n_derivatives, of the j-th
     *   function of span_functions(span)
     */
    std::vector<std::vector<double>>
    evaluate(const unsigned int span,
             const double       t,
             const unsigned int n_derivatives = 0) const;

    /** Greville abscissae, one a function: the control values of the identity
     *  (open), and of the identity modulo the period (periodic, unwrapped
     *  index 0 .. n_basis() - 1). */
    std::vector<double>
    greville() const;

    /** Every span halved; continuity at old knots as before, and new ones of
     *  the same multiplicity. */
    KnotVector
    dyadic_refinement() const;

  private:
    void
    finish();

    unsigned int        degree_       = 0;
    bool                periodic_     = false;
    unsigned int        multiplicity_ = 1;
    std::vector<double> knots_;
    std::vector<double> breakpoints_;
    std::vector<unsigned int>
      span_knot_; ///< nonempty span -> index of its left knot
  };
} // namespace asperity

#endif
