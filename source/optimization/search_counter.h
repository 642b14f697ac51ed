#ifndef source_optimization_search_counter_h
#define source_optimization_search_counter_h

#include <asperity/optimization/evaluation_record.h>

#include <set>

namespace asperity
{
  /** Evaluates for a search and keeps its SearchResult. */
  class SearchCounter
  {
  public:
    /** @throws InputError if there is no budget */
    SearchCounter(const Objective   &objective,
                  EvaluationRecord  &record,
                  const unsigned int max_evaluations,
                  const double       target);

    /** A point in the box, from the record or computed. */
    const Evaluation &
    evaluate(const std::vector<double> &point);

    /** Whether the budget is spent or the target reached; then result.end says
     *  which. */
    bool
    has_ended() const
    {
      return !result.end.empty();
    }

    SearchResult result;

  private:
    const Objective              &objective;
    EvaluationRecord             &record;
    unsigned int                  max_evaluations;
    double                        target;
    std::set<std::vector<double>> asked;
  };
} // namespace asperity

#endif
