#ifndef asperity_source_surrogate_posterior_covariance_h
#define asperity_source_surrogate_posterior_covariance_h

#include <asperity/surrogate/gaussian_process.h>

#include <cstddef>
#include <vector>

namespace asperity
{
  /**
   * Covariances of the latent function at a set of points, of which one after
   * the other becomes known. Whether a value is known is all that matters, not
   * which (Rasmussen and Williams 2006, equation 2.24); so points may be
   * counted as known whose runs have not been made.
   *
   * With w_l(x) = cov(x, q_l) / sqrt(var(q_l) + noise_l), both as they were
   * before q_l became known: cov(x, y) = k(x, y) - sum over l of w_l(x) w_l(y).
   * The w_l are the rows of the Cholesky factor, and a further point costs one
   * of them.
   */
  class PosteriorCovariance
  {
  public:
    /** @param points n x d, of which none is known yet */
    PosteriorCovariance(const KernelKind           kernel,
                        const Hyperparameters     &hyperparameters,
                        const std::vector<double> &points);

    /** The point becomes known up to noise of this variance. */
    void
    make_known(const std::size_t point, const double noise_variance);

    double
    variance(const std::size_t point) const;

    /** With the points first, ..., last - 1. */
    std::vector<double>
    covariances(const std::size_t point,
                const std::size_t first,
                const std::size_t last) const;

    /** w of the point that became known last, of all points; zero if it told
     *  nothing new. */
    const std::vector<double> &
    last_row() const;

  private:
    KernelKind                       kernel;
    double                           signal_variance;
    std::size_t                      n_points, n_inputs;
    std::vector<double>              coordinates; ///< x / l, a row an input
    std::vector<double>              variances;
    std::vector<std::vector<double>> rows; ///< w_l
  };
} // namespace asperity

#endif
