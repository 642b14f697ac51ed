#ifndef asperity_surrogate_covariance_matrix_h
#define asperity_surrogate_covariance_matrix_h

#include <asperity/surrogate/gaussian_process.h>

#include <vector>

namespace asperity
{
  /**
   * The coordinates of training points divided by the length scales, one row an
   * input, as the vectorised loops read them.
   */
  std::vector<double>
  scaled_coordinates(const TrainingData        &data,
                     const std::vector<double> &length_scales);

  /**
   * K = k(X, X) + noise of training points, factorised: what a Gaussian process
   * is made of, and what the search for hyperparameters makes many times.
   */
  class CovarianceMatrix
  {
  public:
    /**
     * @param data must live as long as this object
     * @throws ComputationError as GaussianProcess::GaussianProcess
     */
    CovarianceMatrix(const KernelKind       kernel,
                     const Hyperparameters &hyperparameters,
                     const TrainingData    &data);

    double
    jitter() const;

    /** K^-1 y */
    const std::vector<double> &
    alpha() const;

    double
    log_likelihood() const;

    /** In the order of GaussianProcess::log_likelihood_gradient(). */
    std::vector<double>
    log_likelihood_gradient() const;

    /** L^-1, the lower triangle row by row. */
    std::vector<double>
    packed_inverse_factor() const;

  private:
    void
    fill(std::vector<double> &matrix) const;

    bool
    factorize(const double jitter);

    double
    noise(const std::size_t point) const;

    /** Adds the derivatives with respect to log l_i, W = alpha alpha^T - K^-1:
     *  tr(W dK/dlog l_i) / 2, a pair of points at a time. */
    void
    add_length_scale_derivatives(const std::vector<double> &inverse,
                                 std::vector<double>       &gradient) const;

    const KernelKind      kernel;
    const Hyperparameters hyperparameters;
    const TrainingData   &data;
    std::size_t           n;
    std::vector<double>   coordinates; ///< of scaled_coordinates()
    std::vector<double>   factor;      ///< L in the lower triangle, by columns
    std::vector<double>   alpha_;
    double                jitter_ = 0.;
  };
} // namespace asperity

#endif
