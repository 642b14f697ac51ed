#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/surrogate/hyperparameter_search.h>

#include <algorithm>
#include <cmath>

#include "likelihood_maximizer.h"

namespace asperity
{
  namespace
  {
    /** log s2, log l_i ..., log noise, in this order everywhere. */
    std::vector<LogarithmRange>
    ranges_of(const TrainingData &data, const HyperparameterBounds &bounds)
    {
      const std::size_t n = data.y.size(), d = data.n_inputs;
      double            square = 0.;
      for (const double y : data.y)
        square += y * y / static_cast<double>(n);
      if (square == 0.)
        square = 1.; // constant data: any scale does

      const auto range =
        [](const double scale, const double a, const double b) {
          return LogarithmRange{std::log(scale * a),
                                std::log(scale * b),
                                std::log(scale)};
        };
      std::vector<LogarithmRange> result;
      result.push_back(
        range(square, bounds.smallest_signal, bounds.largest_signal));
      for (std::size_t i = 0; i < d; ++i)
        {
          double lowest = data.x[i], highest = data.x[i];
          for (std::size_t j = 0; j < n; ++j)
            {
              lowest  = std::min(lowest, data.x[j * d + i]);
              highest = std::max(highest, data.x[j * d + i]);
            }
          const double extent = highest > lowest ? highest - lowest : 1.;
          result.push_back(range(extent,
                                 bounds.smallest_length_scale,
                                 bounds.largest_length_scale));
        }
      result.push_back(
        range(square, bounds.smallest_noise, bounds.largest_noise));
      return result;
    }

    /** The first one has middling length scales and little noise; the others
     *  are spread evenly over the likelier part of the box. */
    std::vector<std::vector<double>>
    starting_points(const std::vector<LogarithmRange> &ranges,
                    const unsigned int                 n_restarts)
    {
      RandomNumbers                    random(1);
      std::vector<std::vector<double>> result;
      for (unsigned int start = 0; start <= n_restarts; ++start)
        {
          std::vector<double> u(ranges.size());
          for (std::size_t i = 0; i < u.size(); ++i)
            {
              const bool   is_signal = i == 0, is_noise = i + 1 == u.size();
              const double low   = is_signal ? 0.3 :
                                   is_noise  ? 1e-8 :
                                               0.1,
                           high  = is_signal ? 30. :
                                   is_noise  ? 1e-1 :
                                               10.,
                           first = is_signal ? 1. :
                                   is_noise  ? 1e-4 :
                                               0.5;
              const double share = random.uniform();
              u[i] =
                ranges[i].unit +
                (start == 0 ? std::log(first) :
                              std::log(low) + share * std::log(high / low));
              u[i] = std::clamp(u[i], ranges[i].lower, ranges[i].upper);
            }
          result.push_back(u);
        }
      return result;
    }

    /** Some of the points, the same ones every time. */
    TrainingData
    subset(const TrainingData &data, const std::size_t size)
    {
      const std::vector<std::size_t> order =
        RandomNumbers(1).permutation(data.y.size());
      TrainingData result;
      result.n_inputs = data.n_inputs;
      for (std::size_t i = 0; i < size; ++i)
        {
          const double *const x = &data.x[order[i] * data.n_inputs];
          result.x.insert(result.x.end(), x, x + data.n_inputs);
          result.y.push_back(data.y[order[i]]);
          if (!data.known_variance.empty())
            result.known_variance.push_back(data.known_variance[order[i]]);
        }
      return result;
    }

    std::vector<std::string>
    warnings_of(const std::vector<double>         &logarithms,
                const std::vector<LogarithmRange> &ranges)
    {
      const auto at_lower = [&](const std::size_t i) {
        return logarithms[i] < ranges[i].lower + 0.02;
      };
      const auto at_upper = [&](const std::size_t i) {
        return logarithms[i] > ranges[i].upper - 0.02;
      };
      std::vector<std::string> result;
      if (at_lower(0) || at_upper(0))
        result.push_back("The signal variance is at its " +
                         std::string(at_lower(0) ? "lower" : "upper") +
                         " bound.");
      const std::size_t last = ranges.size() - 1;
      for (std::size_t i = 1; i < last; ++i)
        if (at_lower(i))
          result.push_back(
            "The length scale of input " + std::to_string(i) +
            " is at its lower bound: the values change more between "
            "neighbouring training points than these can resolve.");
        else if (at_upper(i))
          result.push_back("The length scale of input " + std::to_string(i) +
                           " is at its upper bound: the values hardly depend "
                           "on this input, or in a straight line.");
      if (at_upper(last))
        result.push_back("The noise variance is at its upper bound: the inputs "
                         "explain nothing of the values.");
      return result;
    }
  } // namespace



  HyperparameterSearchResult
  find_hyperparameters(const KernelKind                   kernel,
                       const TrainingData                &data,
                       const HyperparameterSearchOptions &options)
  {
    const std::vector<LogarithmRange> ranges = ranges_of(data, options.bounds);
    const bool         coarse = data.y.size() > options.subset_size;
    const TrainingData few =
      coarse ? subset(data, options.subset_size) : TrainingData();

    LikelihoodMaximizer on_few(kernel, coarse ? few : data, ranges);
    LikelihoodMaximum   best;
    for (const std::vector<double> &start :
         starting_points(ranges, options.n_restarts))
      {
        LikelihoodMaximum found =
          on_few.climb({start, 0., {}}, options.max_iterations);
        if (found.log_likelihood > best.log_likelihood)
          best = std::move(found);
      }
    unsigned int n_evaluations = coarse ? 0 : on_few.n_evaluations();
    if (coarse && !best.logarithms.empty())
      {
        // the likelihood of more points has a maximum as much sharper
        for (double &entry : best.inverse_hessian)
          entry *= static_cast<double>(few.y.size()) /
                   static_cast<double>(data.y.size());
        LikelihoodMaximizer on_all(kernel, data, ranges);
        best          = on_all.climb(best, options.max_iterations);
        n_evaluations = on_all.n_evaluations();
      }
    if (best.logarithms.empty())
      throw ComputationError(
        "No hyperparameters were found: the covariance matrix of the " +
        std::to_string(data.y.size()) +
        " training points is not positive definite at any starting point.");

    return {hyperparameters_of(best.logarithms),
            best.log_likelihood,
            n_evaluations,
            warnings_of(best.logarithms, ranges)};
  }
} // namespace asperity
