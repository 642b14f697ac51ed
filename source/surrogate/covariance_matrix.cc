#include "covariance_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "correlation.h"
#include "lapack.h"

namespace asperity
{
  std::vector<double>
  scaled_coordinates(const TrainingData        &data,
                     const std::vector<double> &length_scales)
  {
    const std::size_t   n = data.y.size(), d = data.n_inputs;
    std::vector<double> result(n * d);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < d; ++i)
        result[i * n + j] = data.x[j * d + i] / length_scales[i];
    return result;
  }



  CovarianceMatrix::CovarianceMatrix(const KernelKind    kernel,
                                     const TrainingData &data)
    : kernel(kernel)
    , data(data)
    , n(data.y.size())
    , factor(n * n)
  {}



  bool
  CovarianceMatrix::factorize(const Hyperparameters &new_hyperparameters)
  {
    hyperparameters = new_hyperparameters;
    coordinates     = scaled_coordinates(data, hyperparameters.length_scales);
    // Rounding in K is a few parts of 1e-16 of its diagonal: the first jitter
    // is just above it, the last one a visible change of the model.
    bool success = factorize_with(0.);
    for (double share = 1e-14; !success && share < 2e-4; share *= 10.)
      success = factorize_with(share * hyperparameters.signal_variance);
    if (!success)
      return false;

    alpha_        = data.y;
    const int n_  = static_cast<int>(n);
    const int one = 1;
    int       info;
    dpotrs_("L", &n_, &one, factor.data(), &n_, alpha_.data(), &n_, &info);
    return true;
  }



  double
  CovarianceMatrix::noise(const std::size_t point) const
  {
    return hyperparameters.noise_variance + jitter_ +
           (data.known_variance.empty() ? 0. : data.known_variance[point]);
  }



  void
  CovarianceMatrix::fill()
  {
    std::vector<double> x(data.n_inputs);
    for (std::size_t j = 0; j < n; ++j)
      {
        for (std::size_t i = 0; i < data.n_inputs; ++i)
          x[i] = coordinates[i * n + j];
        double *const column = factor.data() + j * n + j;
        correlation::squared_distances(
          n - j, data.n_inputs, coordinates.data() + j, n, x.data(), column);
        correlation::values(
          kernel, hyperparameters.signal_variance, n - j, column, column);
        column[0] = hyperparameters.signal_variance + noise(j);
      }
  }



  bool
  CovarianceMatrix::factorize_with(const double jitter)
  {
    jitter_ = jitter;
    fill();
    double largest = 0.;
    for (std::size_t j = 0; j < n; ++j)
      largest = std::max(largest, factor[j * n + j]);

    const int n_ = static_cast<int>(n);
    int       info;
    dpotrf_("L", &n_, factor.data(), &n_, &info);
    if (info != 0)
      return false;
    // A pivot of the size of the rounding error is positive by chance only.
    const double rounding =
      largest * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
    for (std::size_t j = 0; j < n; ++j)
      if (!(factor[j * n + j] * factor[j * n + j] > rounding))
        return false;
    return true;
  }



  double
  CovarianceMatrix::jitter() const
  {
    return jitter_;
  }



  const std::vector<double> &
  CovarianceMatrix::alpha() const
  {
    return alpha_;
  }



  double
  CovarianceMatrix::log_likelihood() const
  {
    double result = -0.5 * static_cast<double>(n) * std::log(2. * M_PI);
    for (std::size_t j = 0; j < n; ++j)
      result -= 0.5 * data.y[j] * alpha_[j] + std::log(factor[j * n + j]);
    return result;
  }



  std::vector<double>
  CovarianceMatrix::log_likelihood_gradient()
  {
    inverse      = factor;
    const int n_ = static_cast<int>(n);
    int       info;
    dpotri_("L", &n_, inverse.data(), &n_, &info);

    // tr(W K) = y^T alpha - n, and K less its noise is the signal's derivative.
    std::vector<double> gradient(data.n_inputs + 2, 0.);
    double             &signal = gradient.front(), &noise = gradient.back();
    signal = -0.5 * static_cast<double>(n);
    for (std::size_t j = 0; j < n; ++j)
      {
        const double w = alpha_[j] * alpha_[j] - inverse[j * n + j];
        signal += 0.5 * (data.y[j] * alpha_[j] - w * this->noise(j));
        noise += 0.5 * w * hyperparameters.noise_variance;
      }
    add_length_scale_derivatives(gradient);
    return gradient;
  }



  void
  CovarianceMatrix::add_length_scale_derivatives(
    std::vector<double> &gradient) const
  {
    std::vector<double> x(data.n_inputs), r2(n), slopes(n);
    for (std::size_t j = 0; j + 1 < n; ++j)
      {
        const std::size_t first = j + 1, size = n - first;
        for (std::size_t i = 0; i < data.n_inputs; ++i)
          x[i] = coordinates[i * n + j];
        correlation::squared_distances(size,
                                       data.n_inputs,
                                       coordinates.data() + first,
                                       n,
                                       x.data(),
                                       r2.data());
        correlation::slopes(kernel,
                            hyperparameters.signal_variance,
                            size,
                            r2.data(),
                            slopes.data());
        const double *const column = inverse.data() + j * n + first;
        for (std::size_t i = 0; i < size; ++i)
          slopes[i] *= alpha_[j] * alpha_[first + i] - column[i];
        // each pair stands for two entries of the symmetric matrices
        for (std::size_t i = 0; i < data.n_inputs; ++i)
          gradient[1 + i] += correlation::second_moment(
            size, slopes.data(), coordinates.data() + i * n + first, x[i]);
      }
  }



  std::vector<double>
  CovarianceMatrix::packed_inverse_factor()
  {
    inverse      = factor;
    const int n_ = static_cast<int>(n);
    int       info;
    dtrtri_("L", "N", &n_, inverse.data(), &n_, &info);

    std::vector<double> packed(n * (n + 1) / 2);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = j; i < n; ++i)
        packed[i * (i + 1) / 2 + j] = inverse[j * n + i];
    return packed;
  }
} // namespace asperity
