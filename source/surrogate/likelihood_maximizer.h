#ifndef asperity_surrogate_likelihood_maximizer_h
#define asperity_surrogate_likelihood_maximizer_h

#include <asperity/surrogate/gaussian_process.h>

#include <limits>
#include <vector>

#include "covariance_matrix.h"

namespace asperity
{
  /** The range of the logarithm of a hyperparameter, and that of its unit in
   *  HyperparameterBounds. */
  struct LogarithmRange
  {
    double lower, upper, unit;
  };

  /** From logarithms in the order log s2, log l_i ..., log noise. */
  Hyperparameters
  hyperparameters_of(const std::vector<double> &logarithms);

  struct LikelihoodMaximum
  {
    std::vector<double> logarithms; ///< empty: none was found
    double log_likelihood = -std::numeric_limits<double>::infinity();

    /** Estimate of the inverse of the negative second derivatives, row by row;
     *  about the covariance of the logarithms. */
    std::vector<double> inverse_hessian;
  };

  /**
   * Climbs to a maximum of the likelihood within bounds: quasi-Newton steps
   * (BFGS) projected onto the box, variables at a bound that the gradient
   * presses against held (Bertsekas 1982), Armijo's condition. Against GSL's
   * BFGS it takes one evaluation an iteration instead of two, needs no
   * transformation of the bounds, and can start with what is known of the
   * second derivatives.
   */
  class LikelihoodMaximizer
  {
  public:
    /** The arguments must live as long as this object. */
    LikelihoodMaximizer(const KernelKind                   kernel,
                        const TrainingData                &data,
                        const std::vector<LogarithmRange> &ranges);

    /** @param start of which logarithms, and inverse_hessian unless it is
     *    empty, are used */
    LikelihoodMaximum
    climb(const LikelihoodMaximum &start, const unsigned int max_iterations);

    /** Of all climbs. */
    unsigned int
    n_evaluations() const;

  private:
    /** A place with the negative log likelihood and its gradient. */
    struct Point
    {
      std::vector<double> place, gradient;
      double              value = std::numeric_limits<double>::infinity();
    };

    void
    evaluate_value(Point &point);

    /** Of the place where the value was evaluated last. */
    void
    evaluate_gradient(Point &point);

    /** -H g without the held variables. */
    std::vector<double>
    direction(const Point &point, const std::vector<double> &h) const;

    /** @return whether there is a lower point along the direction */
    bool
    search_line(const Point               &from,
                const std::vector<double> &direction,
                Point                     &to);

    const std::vector<LogarithmRange> &ranges;
    CovarianceMatrix                   covariance;
    unsigned int                       n_evaluations_ = 0;
  };
} // namespace asperity

#endif
