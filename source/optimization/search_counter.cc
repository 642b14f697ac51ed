#include "search_counter.h"

#include <asperity/base/errors.h>

namespace asperity
{
  SearchCounter::SearchCounter(const Objective   &objective,
                               EvaluationRecord  &record,
                               const unsigned int max_evaluations,
                               const double       target)
    : objective(objective)
    , record(record)
    , max_evaluations(max_evaluations)
    , target(target)
  {
    if (max_evaluations == 0)
      throw InputError("A search needs at least one evaluation.");
  }



  const Evaluation &
  SearchCounter::evaluate(const std::vector<double> &point)
  {
    const Evaluation &evaluation = record.evaluate(objective, point);
    if (!asked.insert(point).second)
      return evaluation;
    ++result.n_evaluations;
    if (evaluation.has_failed())
      ++result.n_failed;
    else if (result.best.empty() || evaluation.value < result.value)
      {
        result.best      = point;
        result.value     = evaluation.value;
        result.n_to_best = result.n_evaluations;
      }
    result.history.push_back(result.value);
    if (!result.best.empty() && result.value <= target)
      result.end = "the target is reached";
    else if (result.n_evaluations >= max_evaluations)
      result.end = "the evaluations are spent";
    return evaluation;
  }
} // namespace asperity
