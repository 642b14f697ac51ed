#ifndef asperity_splines_refinement_h
#define asperity_splines_refinement_h

#include <asperity/splines/spline_curve.h>

#include <vector>

namespace asperity
{
  /**
   * Discrete B-spline: the coefficient that function i on the knots t has with
   * respect to that function on a finer knot vector whose knots are
   * tau[0] .. tau[p] (and one more, which does not matter). Oslo algorithm;
   * E. Cohen, T. Lyche, R. Riesenfeld, CGIP 14 (1980) 87-111. Every step is a
   * sum of non-negative terms, so it is accurate for all degrees and its
   * structural zeros are exact. For other arguments it is the blossom
   * (polar form) of the function's polynomial on the span of tau[0], at
   * tau[1] .. tau[p].
   */
  double
  discrete_b_spline(const std::vector<double> &t,
                    const unsigned int         i,
                    const unsigned int         p,
                    const std::vector<double> &tau);

  /** New control points as sums of old ones. */
  struct BasisTransfer
  {
    struct Term
    {
      unsigned int function; ///< of the old basis, in [0, n_basis())
      int          turns;    ///< how often its index was wrapped
      double       factor;
    };

    KnotVector                     knot_vector; ///< the new basis
    std::vector<std::vector<Term>> rows;        ///< one a new function
  };

  /**
   * Knot insertion (Piegl and Tiller, section 5.2).
   * @param new_knots in (front, back), in any order; each repetition raises the
   *   multiplicity. Into a periodic basis only new simple knots can be
   * inserted. @throws InputError if a knot lies outside or its multiplicity
   * would exceed the degree (periodic: one).
   */
  BasisTransfer
  knot_insertion(const KnotVector          &knot_vector,
                 const std::vector<double> &new_knots);

  /** Degree elevation by one (Piegl and Tiller, section 5.5), by blossoms.
   *  @throws InputError for a periodic basis; clamp it first. */
  BasisTransfer
  degree_elevation(const KnotVector &knot_vector);

  /** One turn of a periodic basis on open knots (an open basis is unchanged).
   */
  BasisTransfer
  clamping(const KnotVector &knot_vector);

  /** The same curve in another basis. Its period is kept if both bases are
   *  periodic. */
  SplineCurve
  transfer(const SplineCurve &curve, const BasisTransfer &basis_transfer);

  inline SplineCurve
  insert_knots(const SplineCurve &curve, const std::vector<double> &new_knots)
  {
    return transfer(curve, knot_insertion(curve.knot_vector(), new_knots));
  }

  inline SplineCurve
  elevate_degree(const SplineCurve &curve)
  {
    return transfer(curve, degree_elevation(curve.knot_vector()));
  }

  /** One turn of a periodic curve as an open one. */
  inline SplineCurve
  clamp(const SplineCurve &curve)
  {
    return transfer(curve, clamping(curve.knot_vector()));
  }
} // namespace asperity

#endif
