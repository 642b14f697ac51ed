#ifndef asperity_optimization_direct_h
#define asperity_optimization_direct_h

#include <asperity/optimization/evaluation_record.h>

namespace asperity
{
  struct DirectOptions
  {
    unsigned int max_evaluations = 1000;

    /** Fewer rectangles are divided, of which the best are preferred
     *  (Gablonsky and Kelley 2001). */
    bool locally_biased = false;

    /** Ends when the objective is as small as this. */
    double target = -std::numeric_limits<double>::infinity();
  };

  /**
   * Minimises over a box by DIRECT (Jones et al. 1993): rectangles whose
   * centre could be the best for some Lipschitz constant are divided into
   * three. Deterministic. A point whose evaluation fails counts as infeasible
   * and takes the value of its neighbours. By NLopt (its GN_ORIG_DIRECT).
   *
   * @throws InputError if there is no budget, ComputationError if NLopt fails,
   *   and what the objective throws but ComputationError
   */
  SearchResult
  search_by_direct(const Objective     &objective,
                   EvaluationRecord    &record,
                   const DirectOptions &options = DirectOptions());
} // namespace asperity

#endif
