#include <asperity/base/errors.h>
#include <asperity/surrogate/gaussian_process.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "correlation.h"
#include "covariance_matrix.h"

namespace asperity
{
  namespace
  {
    /** Points whose covariances are on the stack at once. */
    constexpr std::size_t block_size = 256;

    void
    require_finite(const std::vector<double> &values, const std::string &what)
    {
      for (const double value : values)
        if (!std::isfinite(value))
          throw InputError("The training data of a Gaussian process contain a "
                           "number that is not finite among the " +
                           what + ".");
    }

    void
    require_consistent(const Hyperparameters &hyperparameters,
                       const TrainingData    &data)
    {
      const std::size_t n = data.y.size();
      if (n == 0 || data.n_inputs == 0 || data.x.size() != n * data.n_inputs ||
          (!data.known_variance.empty() && data.known_variance.size() != n))
        throw InputError(
          "The training data of a Gaussian process have " + std::to_string(n) +
          " values, " + std::to_string(data.x.size()) + " coordinates and " +
          std::to_string(data.known_variance.size()) +
          " known variances; at least one value, and for each of them " +
          std::to_string(data.n_inputs) +
          " coordinates and one known variance or none are expected.");
      require_finite(data.x, "coordinates");
      require_finite(data.y, "values");
      require_finite(data.known_variance, "known variances");
      for (const double variance : data.known_variance)
        if (variance < 0.)
          throw InputError(
            "A known variance of a Gaussian process is negative; "
            "it must be zero or positive.");

      const auto positive = [](const double value) {
        return std::isfinite(value) && value > 0.;
      };
      const std::vector<double> &l = hyperparameters.length_scales;
      if (l.size() != data.n_inputs ||
          !std::all_of(l.begin(), l.end(), positive) ||
          !positive(hyperparameters.signal_variance) ||
          !std::isfinite(hyperparameters.noise_variance) ||
          hyperparameters.noise_variance < 0.)
        throw InputError(
          "The hyperparameters of a Gaussian process must be a positive signal "
          "variance, " +
          std::to_string(data.n_inputs) +
          " positive length scales and a noise variance that is not negative.");
    }

    /** s2 sum over j of alpha_j; these terms nearly cancel. */
    double
    sum_of_terms(const std::vector<double> &alpha, const double signal_variance)
    {
      long double sum = 0.;
      for (const double a : alpha)
        sum += a;
      return static_cast<double>(sum * signal_variance);
    }
  } // namespace



  std::string
  to_string(const KernelKind kernel)
  {
    return kernel == KernelKind::rbf        ? "rbf" :
           kernel == KernelKind::matern_3_2 ? "matern_3_2" :
                                              "matern_5_2";
  }



  GaussianProcess::GaussianProcess(const KernelKind       kernel,
                                   const Hyperparameters &hyperparameters,
                                   const TrainingData    &data)
    : kernel_(kernel)
    , hyperparameters_(hyperparameters)
    , data_(data)
  {
    require_consistent(hyperparameters, data);
    CovarianceMatrix covariance(kernel, data);
    if (!covariance.factorize(hyperparameters))
      throw ComputationError(
        "The covariance matrix of the " + std::to_string(data.y.size()) +
        " training points is not positive definite, even with 1e-4 of the "
        "signal variance added to its diagonal.");
    alpha_          = covariance.alpha();
    sum_of_weights_ = sum_of_terms(alpha_, hyperparameters.signal_variance);
    jitter_         = covariance.jitter();
    inverse_factor_ = covariance.packed_inverse_factor();
    coordinates     = scaled_coordinates(data, hyperparameters.length_scales);
    log_likelihood_ = covariance.log_likelihood();
  }



  bool
  GaussianProcess::scale(const double *x, double *scaled) const
  {
    bool is_number = true;
    for (std::size_t i = 0; i < data_.n_inputs; ++i)
      {
        scaled[i] = x[i] / hyperparameters_.length_scales[i];
        is_number = is_number && !std::isnan(scaled[i]);
      }
    return is_number;
  }



  double
  GaussianProcess::mean(const double *x) const
  {
    double result;
    means(1, x, &result);
    return result;
  }



  void
  GaussianProcess::means(const std::size_t n_points,
                         const double     *x,
                         double           *result) const
  {
    const std::size_t              n = alpha_.size(), d = data_.n_inputs;
    std::vector<double>            scaled(d);
    std::array<double, block_size> k;
    for (std::size_t point = 0; point < n_points; ++point)
      {
        double sum = sum_of_weights_;
        if (!scale(x + point * d, scaled.data()))
          sum = std::numeric_limits<double>::quiet_NaN();
        for (std::size_t begin = 0; begin < n; begin += block_size)
          {
            const std::size_t size = std::min(block_size, n - begin);
            correlation::squared_distances(
              size, d, coordinates.data() + begin, n, scaled.data(), k.data());
            correlation::deficits(kernel_,
                                  hyperparameters_.signal_variance,
                                  size,
                                  k.data(),
                                  k.data());
            sum += correlation::dot(size, k.data(), alpha_.data() + begin);
          }
        result[point] = sum;
      }
  }



  void
  GaussianProcess::gradient_from_distances(const double *scaled,
                                           double       *r2,
                                           double       *gradient) const
  {
    const std::size_t n = alpha_.size();
    correlation::slopes(kernel_, hyperparameters_.signal_variance, n, r2, r2);
    for (std::size_t i = 0; i < data_.n_inputs; ++i)
      gradient[i] = correlation::first_moment(n,
                                              r2,
                                              alpha_.data(),
                                              coordinates.data() + i * n,
                                              scaled[i]) /
                    hyperparameters_.length_scales[i];
  }



  double
  GaussianProcess::variance(const double *x) const
  {
    double result;
    evaluate(x, &result, nullptr);
    return result;
  }



  double
  GaussianProcess::evaluate(const double *x,
                            double       *variance,
                            double       *gradient) const
  {
    const std::size_t   n = alpha_.size(), d = data_.n_inputs;
    std::vector<double> work(d + 2 * n);
    double *const k = work.data() + d, *const r2 = k + n;
    if (!scale(x, work.data()))
      {
        if (gradient != nullptr)
          std::fill(gradient,
                    gradient + d,
                    std::numeric_limits<double>::quiet_NaN());
        return *variance = std::numeric_limits<double>::quiet_NaN();
      }
    correlation::squared_distances(
      n, d, coordinates.data(), n, work.data(), r2);
    correlation::deficits(kernel_, hyperparameters_.signal_variance, n, r2, k);
    const double mean = sum_of_weights_ + correlation::dot(n, k, alpha_.data());
    for (std::size_t j = 0; j < n; ++j)
      k[j] += hyperparameters_.signal_variance;
    if (gradient != nullptr)
      gradient_from_distances(work.data(), r2, gradient);
    *variance = std::max(
      0.,
      hyperparameters_.signal_variance -
        correlation::triangular_norm_square(n, inverse_factor_.data(), k));
    return mean;
  }



  double
  GaussianProcess::noise_variance() const
  {
    return hyperparameters_.noise_variance;
  }



  double
  GaussianProcess::log_likelihood() const
  {
    return log_likelihood_;
  }



  std::vector<double>
  GaussianProcess::log_likelihood_gradient() const
  {
    CovarianceMatrix covariance(kernel_, data_);
    covariance.factorize(hyperparameters_);
    return covariance.log_likelihood_gradient();
  }



  // Rasmussen and Williams, equations 5.10 to 5.12:
  // mean_i = y_i - alpha_i / K^-1_ii, variance_i = 1 / K^-1_ii,
  // and K^-1 = L^-T L^-1, so K^-1_ii is the square of column i of L^-1.
  std::vector<GaussianProcess::LeftOut>
  GaussianProcess::leave_one_out() const
  {
    const std::size_t   n = alpha_.size();
    std::vector<double> diagonal(n, 0.);
    const double       *entry = inverse_factor_.data();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j, ++entry)
        diagonal[j] += *entry * *entry;

    std::vector<LeftOut> result(n);
    for (std::size_t i = 0; i < n; ++i)
      result[i] = {data_.y[i] - alpha_[i] / diagonal[i], 1. / diagonal[i]};
    return result;
  }



  double
  GaussianProcess::jitter() const
  {
    return jitter_;
  }



  KernelKind
  GaussianProcess::kernel() const
  {
    return kernel_;
  }



  const Hyperparameters &
  GaussianProcess::hyperparameters() const
  {
    return hyperparameters_;
  }



  const TrainingData &
  GaussianProcess::data() const
  {
    return data_;
  }



  const std::vector<double> &
  GaussianProcess::alpha() const
  {
    return alpha_;
  }



  double
  GaussianProcess::sum_of_weights() const
  {
    return sum_of_weights_;
  }



  const std::vector<double> &
  GaussianProcess::inverse_factor() const
  {
    return inverse_factor_;
  }
} // namespace asperity
