#include <asperity/base/errors.h>
#include <asperity/splines/bezier_extraction.h>
#include <asperity/splines/refinement.h>

#include <vector>

namespace asperity
{
  namespace
  {
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
