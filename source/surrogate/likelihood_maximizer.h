#ifndef asperity_surrogate_likelihood_maximizer_h
#define asperity_surrogate_likelihood_maximizer_h

#include <asperity/surrogate/gaussian_process.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity
{
  /**
   * A smooth clamp of one logarithm: the identity between the bounds but for
   * a few widths beside them, so that BFGS needs no bounds of its own.
   */
  struct SmoothClamp
  {
    double lower, upper;
    double unit; ///< of the hyperparameter, as in HyperparameterBounds

    static constexpr double width = 0.2;

    double
    value(const double u) const
    {
      return lower + width * (softplus((u - lower) / width) -
                              softplus((u - upper) / width));
    }

    double
    slope(const double u) const
    {
      return sigmoid((u - lower) / width) - sigmoid((u - upper) / width);
    }

    static double
    softplus(const double t)
    {
      return std::max(t, 0.) + std::log1p(std::exp(-std::abs(t)));
    }

    static double
    sigmoid(const double t)
    {
      return 1. / (1. + std::exp(-t));
    }
  };

  /** The order of logarithms everywhere: log s2, log l_i ..., log noise. */
  Hyperparameters
  hyperparameters_of(const std::vector<double> &logarithms);

  struct LikelihoodMaximum
  {
    std::vector<double> place; ///< before the clamps; empty: none was found
    double log_likelihood = -std::numeric_limits<double>::infinity();
  };

  /** Climbs to a maximum of the likelihood by GSL's BFGS. */
  class LikelihoodMaximizer
  {
  public:
    /** The arguments must live as long as this object. */
    LikelihoodMaximizer(const KernelKind                kernel,
                        const TrainingData             &data,
                        const std::vector<SmoothClamp> &clamps);

    /** @param start before the clamps */
    LikelihoodMaximum
    climb(const std::vector<double> &start, const unsigned int max_iterations);

    /** Of all climbs. */
    unsigned int
    n_evaluations() const;

  private:
    const KernelKind                kernel;
    const TrainingData             &data;
    const std::vector<SmoothClamp> &clamps;
    unsigned int                    n_evaluations_ = 0;
  };
} // namespace asperity

#endif
