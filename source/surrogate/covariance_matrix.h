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
   * is made of, and what the search for hyperparameters makes many times in the
   * same memory.
   */
  class CovarianceMatrix
  {
  public:
    /** @param data must live as long as this object */
    CovarianceMatrix(const KernelKind kernel, const TrainingData &data);

    /**
     * K = L L^T, with as little jitter on the diagonal as that takes, and
     * alpha. Everything below is about the last matrix that was factorised.
     * @return whether K is positive definite with the largest jitter
     */
    bool
    factorize(const Hyperparameters &hyperparameters);

    double
    jitter() const;

    /** K^-1 y */
    const std::vector<double> &
    alpha() const;

    double
    log_likelihood() const;

    /** In the order of GaussianProcess::log_likelihood_gradient(). */
    std::vector<double>
    log_likelihood_gradient();

    /** L^-1, the lower triangle row by row. */
    std::vector<double>
    packed_inverse_factor();

  private:
    void
    fill();

    bool
    factorize_with(const double jitter);

    double
    noise(const std::size_t point) const;

    /** Adds the derivatives with respect to log l_i, W = alpha alpha^T - K^-1:
     *  tr(W dK/dlog l_i) / 2, a pair of points at a time. */
    void
    add_length_scale_derivatives(std::vector<double> &gradient) const;

    const KernelKind    kernel;
    const TrainingData &data;
    const std::size_t   n;
    Hyperparameters     hyperparameters;
    std::vector<double> coordinates; ///< of scaled_coordinates()
    std::vector<double> alpha_;
    double              jitter_ = 0.;

    /** L, and K^-1 or L^-1 when they are asked for: lower triangles by columns;
     *  the upper ones hold nothing. */
    std::vector<double> factor, inverse;
  };
} // namespace asperity

#endif
