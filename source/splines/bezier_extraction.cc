#include <asperity/base/errors.h>
#include <asperity/splines/bezier_extraction.h>

#include <vector>

namespace asperity
{
  namespace
  {
    /**
     * Discrete B-spline: the coefficient that function i on the knots t has
     * with respect to that function on a finer knot vector whose knots are
     * tau[0] .. tau[p] (and one more, which does not matter). Oslo algorithm;
     * E. Cohen, T. Lyche, R. Riesenfeld, CGIP 14 (1980) 87-111. Every step is a
     * sum of non-negative terms, so it is accurate for all degrees and its
     * structural zeros are exact.
     */
    double
    discrete_b_spline(const std::vector<double> &t,
                      const unsigned int         i,
                      const unsigned int         p,
                      const std::vector<double> &tau)
    {
      std::vector<double> alpha(p + 1);
      for (unsigned int j = 0; j <= p; ++j)
        alpha[j] = (t[i + j] <= tau[0] && tau[0] < t[i + j + 1]) ? 1. : 0.;
      for (unsigned int k = 1; k <= p; ++k)
        for (unsigned int j = 0; j + k <= p; ++j)
          {
            const double left = t[i + j], right = t[i + j + k + 1];
            double       sum = 0.;
            if (alpha[j] != 0.)
              sum += (tau[k] - left) / (t[i + j + k] - left) * alpha[j];
            if (alpha[j + 1] != 0.)
              sum += (right - tau[k]) / (right - t[i + j + 1]) * alpha[j + 1];
            alpha[j] = sum;
          }
      return alpha[0];
    }



    /** Index of the knot at which each nonempty span begins. */
    std::vector<unsigned int>
    span_starts(const KnotVector &knot_vector)
    {
      const std::vector<double> &t = knot_vector.knots();
      std::vector<unsigned int>  starts;
      for (unsigned int i = knot_vector.degree();
           i + knot_vector.degree() + 1 < t.size();
           ++i)
        if (t[i] < t[i + 1])
          starts.push_back(i);
      return starts;
    }
  } // namespace



  std::vector<dealii::FullMatrix<double>>
  bezier_extraction(const KnotVector &knot_vector)
  {
    const unsigned int         p = knot_vector.degree();
    const std::vector<double> &t = knot_vector.knots();

    std::vector<dealii::FullMatrix<double>> operators;
    std::vector<double>                     tau(p + 1);
    for (const unsigned int start : span_starts(knot_vector))
      {
        dealii::FullMatrix<double> C(p + 1, p + 1);
        for (unsigned int b = 0; b <= p; ++b)
          {
            // The Bernstein polynomial b lives on the two ends of the span,
            // the left one p + 1 - b times.
            for (unsigned int k = 0; k <= p; ++k)
              tau[k] = (k + b <= p ? t[start] : t[start + 1]);
            for (unsigned int a = 0; a <= p; ++a)
              C(a, b) = discrete_b_spline(t, start - p + a, p, tau);
          }
        operators.push_back(C);
      }
    return operators;
  }



  std::vector<dealii::FullMatrix<double>>
  two_scale_relation(const KnotVector &coarse, const KnotVector &fine)
  {
    const unsigned int p = coarse.degree();
    if (fine.degree() != p || fine.n_spans() != 2 * coarse.n_spans() ||
        fine.is_periodic() != coarse.is_periodic())
      throw InputError(
        "A two-scale relation was asked for between knot vectors "
        "of which one is not the dyadic refinement of the other.");

    const std::vector<unsigned int> coarse_starts = span_starts(coarse);
    const std::vector<unsigned int> fine_starts   = span_starts(fine);

    std::vector<dealii::FullMatrix<double>> relation;
    std::vector<double>                     tau(p + 1);
    for (unsigned int span = 0; span < fine.n_spans(); ++span)
      {
        dealii::FullMatrix<double> S(p + 1, p + 1);
        for (unsigned int b = 0; b <= p; ++b)
          {
            const unsigned int function = fine_starts[span] - p + b;
            for (unsigned int k = 0; k <= p; ++k)
              tau[k] = fine.knots()[function + k];
            for (unsigned int a = 0; a <= p; ++a)
              S(a, b) = discrete_b_spline(coarse.knots(),
                                          coarse_starts[span / 2] - p + a,
                                          p,
                                          tau);
          }
        relation.push_back(S);
      }
    return relation;
  }
} // namespace asperity
