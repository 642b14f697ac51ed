#ifndef asperity_surrogate_gaussian_process_h
#define asperity_surrogate_gaussian_process_h

#include <asperity/surrogate/regression.h>

#include <cstddef>
#include <string>
#include <vector>

namespace asperity
{
  /** Covariance k(x, x') = s2 f(r), r^2 = sum over i of ((x_i - x'_i)/l_i)^2.
   */
  enum class KernelKind
  {
    rbf,        ///< f = exp(-r^2/2)
    matern_3_2, ///< f = (1 + sqrt(3) r) exp(-sqrt(3) r)
    matern_5_2  ///< f = (1 + sqrt(5) r + 5/3 r^2) exp(-sqrt(5) r)
  };

  /** "rbf", "matern_3_2" or "matern_5_2", as in the model file. */
  std::string
  to_string(const KernelKind kernel);

  struct Hyperparameters
  {
    double              signal_variance = 1.; ///< s2
    std::vector<double> length_scales;        ///< l_i, one an input
    double              noise_variance = 1e-6;
  };

  /** n points of d inputs with one value each; no units, no scaling. */
  struct TrainingData
  {
    std::size_t         n_inputs = 0;
    std::vector<double> x; ///< n x d, one point after the other
    std::vector<double> y; ///< n

    /** Variance of each value that is known beforehand, e.g. of a mean over
     *  several profiles, beside the noise variance; empty: none. */
    std::vector<double> known_variance;
  };

  /**
   * Exact Gaussian process regression with zero prior mean (Rasmussen and
   * Williams 2006, algorithm 2.1): K = k(X, X) + noise, L L^T = K,
   * alpha = K^-1 y. Immutable, so that threads may share it. A
   * coordinate that is NaN makes the answer NaN.
   */
  class GaussianProcess : public Regression
  {
  public:
    /** @throws ComputationError if K is not positive definite even with the
     *  largest jitter; see jitter() */
    GaussianProcess(const KernelKind       kernel,
                    const Hyperparameters &hyperparameters,
                    const TrainingData    &data);

    /** @param x d inputs */
    double
    mean(const double *x) const;

    /** @param x n x d inputs, one point after the other @param result n means
     */
    void
    means(const std::size_t n, const double *x, double *result) const override;

    /** Variance of the latent function, without noise; not negative. */
    double
    variance(const double *x) const;

    /** Mean, variance and gradient of the mean at once, for little more than
     *  the price of the variance. @param gradient d numbers, or nullptr
     *  @return the mean */
    double
    evaluate(const double *x,
             double       *variance,
             double       *gradient) const override;

    /** That of the hyperparameters. */
    double
    noise_variance() const override;

    /** log p(y | X) = -y^T alpha / 2 - sum log L_ii - n/2 log(2 pi). */
    double
    log_likelihood() const;

    /** Its derivatives with respect to log s2, log l_i, log noise. */
    std::vector<double>
    log_likelihood_gradient() const;

    /** Prediction at a training point by the other ones (closed form). */
    struct LeftOut
    {
      double mean, variance; ///< variance with noise
    };

    std::vector<LeftOut>
    leave_one_out() const;

    /** What had to be added to the diagonal so that K could be factorised. */
    double
    jitter() const;

    KernelKind
    kernel() const;

    const Hyperparameters &
    hyperparameters() const;

    const TrainingData &
    data() const;

    const std::vector<double> &
    alpha() const;

    /**
     * s2 sum over j of alpha_j. The mean is computed as this plus the sum of
     * alpha_j s2 (f(r_j) - 1): with long length scales the terms alpha_j s2
     * nearly cancel, and apart from each other they cost less accuracy.
     */
    double
    sum_of_weights() const;

    /** The lower triangle of L^-1, row by row without gaps. */
    const std::vector<double> &
    inverse_factor() const;

  private:
    /** scaled_i = x_i / l_i @return whether there is no NaN among them */
    bool
    scale(const double *x, double *scaled) const;

    void
    gradient_from_distances(const double *scaled,
                            double       *r2,
                            double       *gradient) const;

    KernelKind          kernel_;
    Hyperparameters     hyperparameters_;
    TrainingData        data_;
    std::vector<double> alpha_;
    std::vector<double> coordinates; ///< x / l, one row an input

    /** The lower triangle of L^-1 row by row: |L^-1 k|^2 then reads n^2/2
     *  numbers once, in order, and without the dependence of one row on all
     *  before it that a triangular solve has. */
    std::vector<double> inverse_factor_;
    double              log_likelihood_ = 0.;
    double              sum_of_weights_ = 0.;
    double              jitter_         = 0.;
  };
} // namespace asperity

#endif
