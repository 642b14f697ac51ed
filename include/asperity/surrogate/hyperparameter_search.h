#ifndef asperity_surrogate_hyperparameter_search_h
#define asperity_surrogate_hyperparameter_search_h

#include <asperity/surrogate/gaussian_process.h>

#include <string>
#include <vector>

namespace asperity
{
  /**
   * Where hyperparameters are looked for. Length scales are relative to the
   * extent of the training points along their input, variances to the mean
   * square of the values, so that nothing depends on units.
   */
  struct HyperparameterBounds
  {
    double smallest_length_scale = 0.02, largest_length_scale = 50.;
    double smallest_signal = 1e-3, largest_signal = 1e4;

    /** The lower bound is well above the rounding error of the covariance
     *  matrix, and stands for "no noise". */
    double smallest_noise = 1e-10, largest_noise = 1.;
  };

  struct HyperparameterSearchOptions
  {
    HyperparameterBounds bounds;

    /** Starts at pseudo-random points (always the same ones) beside the start
     *  at middling length scales and little noise. */
    unsigned int n_restarts = 8;

    /** With more training points the starts are made on a subset of this size,
     *  and all points only improve on the best of them. */
    std::size_t subset_size = 250;

    unsigned int max_iterations = 100; ///< of one start
  };

  struct HyperparameterSearchResult
  {
    Hyperparameters hyperparameters;
    double          log_likelihood = 0.;
    unsigned int    n_evaluations  = 0; ///< of the likelihood of all points

    /** One sentence for each length scale at its bound, for the signal variance
     *  at its bound and for noise at its upper bound. */
    std::vector<std::string> warnings;
  };

  /**
   * The hyperparameters with the largest likelihood (Rasmussen and Williams
   * 2006, equations 5.8 and 5.9): BFGS on their logarithms with analytic
   * gradients, within bounds, from several starts. Deterministic.
   *
   * @throws ComputationError if no start finds a likelihood
   */
  HyperparameterSearchResult
  find_hyperparameters(const KernelKind                   kernel,
                       const TrainingData                &data,
                       const HyperparameterSearchOptions &options = {});
} // namespace asperity

#endif
