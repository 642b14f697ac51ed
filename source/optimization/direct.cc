#include <asperity/base/errors.h>
#include <asperity/optimization/direct.h>

#include <nlopt.h>

#include <exception>
#include <limits>
#include <memory>
#include <string>

#include "search_counter.h"

namespace asperity
{
  namespace
  {
    struct Context
    {
      SearchCounter     *counter;
      nlopt_opt          search;
      std::exception_ptr error;
    };

    /** For NLopt, which is C: no exception may leave it. */
    double
    evaluate(unsigned n, const double *x, double *gradient, void *data)
    {
      Context &context = *static_cast<Context *>(data);
      try
        {
          if (!context.counter->has_ended())
            {
              const Evaluation &evaluation =
                context.counter->evaluate({x, x + n});
              if (context.counter->has_ended())
                nlopt_force_stop(context.search);
              if (!evaluation.has_failed())
                return evaluation.value;
            }
        }
      catch (...)
        {
          context.error = std::current_exception();
          nlopt_force_stop(context.search);
        }
      // what NLopt takes for an infeasible point
      return std::numeric_limits<double>::infinity();
    }
  } // namespace



  SearchResult
  search_by_direct(const Objective     &objective,
                   EvaluationRecord    &record,
                   const DirectOptions &options)
  {
    SearchCounter    counter(objective,
                          record,
                          options.max_evaluations,
                          options.target);
    const SearchBox &box = record.box();

    const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> search(
      nlopt_create(options.locally_biased ? NLOPT_GN_ORIG_DIRECT_L :
                                            NLOPT_GN_ORIG_DIRECT,
                   box.size()),
      nlopt_destroy);
    Context context{&counter, search.get(), nullptr};
    // NLopt counts evaluations in its own way: the counter ends the search
    const bool is_set =
      search != nullptr &&
      nlopt_set_lower_bounds(search.get(), box.lower.data()) > 0 &&
      nlopt_set_upper_bounds(search.get(), box.upper.data()) > 0 &&
      nlopt_set_min_objective(search.get(), evaluate, &context) > 0 &&
      nlopt_set_maxeval(search.get(), 2 * options.max_evaluations + 100) > 0;
    if (!is_set)
      throw ComputationError("NLopt does not take the box of a search.");
    std::vector<double> x = box.lower;
    double              value;
    const nlopt_result  status = nlopt_optimize(search.get(), x.data(), &value);
    if (context.error)
      std::rethrow_exception(context.error);
    if (!counter.has_ended())
      {
        if (status < 0)
          throw ComputationError(
            std::string("The search by DIRECT has failed in NLopt (") +
            nlopt_result_to_string(status) + ").");
        counter.result.end = "its rectangles cannot be divided further";
      }
    return counter.result;
  }
} // namespace asperity
