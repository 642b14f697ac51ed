#ifndef asperity_splines_bezier_extraction_h
#define asperity_splines_bezier_extraction_h

#include <asperity/splines/knot_vector.h>

#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace asperity
{
  /**
   * Bezier extraction operators of a univariate basis, one a nonempty span:
   * C[span](a, b) is the Bernstein coefficient b of the a-th function of
   * span_functions(span), so N_a = sum_b C(a,b) B_b on the span mapped to
   * [0, 1]. Borden, Scott, Evans, Hughes, IJNME 87 (2011) 15-47.
   */
  std::vector<dealii::FullMatrix<double>>
  bezier_extraction(const KnotVector &knot_vector);

  /**
   * Two-scale relation to the dyadic refinement, one matrix a *fine* span:
   * S[fine span](a, b) with N^coarse_a = sum_b S(a,b) N^fine_b on that span,
   * a counts span_functions(fine span / 2) of the coarse basis, b those of the
   * fine one. @throws InputError unless `fine` is the refinement of `coarse`
   */
  std::vector<dealii::FullMatrix<double>>
  two_scale_relation(const KnotVector &coarse, const KnotVector &fine);
} // namespace asperity

#endif
