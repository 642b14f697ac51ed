#include "posterior_covariance.h"

#include <algorithm>
#include <cmath>

#include "correlation.h"

namespace asperity
{
  PosteriorCovariance::PosteriorCovariance(
    const KernelKind           kernel,
    const Hyperparameters     &hyperparameters,
    const std::vector<double> &points)
    : kernel(kernel)
    , signal_variance(hyperparameters.signal_variance)
    , n_points(points.size() / hyperparameters.length_scales.size())
    , n_inputs(hyperparameters.length_scales.size())
    , coordinates(points.size())
    , variances(n_points, signal_variance)
  {
    for (std::size_t i = 0; i < n_inputs; ++i)
      for (std::size_t j = 0; j < n_points; ++j)
        coordinates[i * n_points + j] =
          points[j * n_inputs + i] / hyperparameters.length_scales[i];
  }



  void
  PosteriorCovariance::make_known(const std::size_t point,
                                  const double      noise_variance)
  {
    std::vector<double> row = covariances(point, 0, n_points);
    // What is left of a point that coincides with a known one is rounding.
    const double variance = variances[point] + noise_variance;
    const double factor =
      variance > 1e-12 * signal_variance ? 1. / std::sqrt(variance) : 0.;
    for (std::size_t j = 0; j < n_points; ++j)
      {
        row[j] *= factor;
        variances[j] = std::max(0., variances[j] - row[j] * row[j]);
      }
    rows.push_back(std::move(row));
  }



  double
  PosteriorCovariance::variance(const std::size_t point) const
  {
    return variances[point];
  }



  std::vector<double>
  PosteriorCovariance::covariances(const std::size_t point,
                                   const std::size_t first,
                                   const std::size_t last) const
  {
    const std::size_t   n = last - first;
    std::vector<double> x(n_inputs), result(n);
    for (std::size_t i = 0; i < n_inputs; ++i)
      x[i] = coordinates[i * n_points + point];
    correlation::squared_distances(n,
                                   n_inputs,
                                   coordinates.data() + first,
                                   n_points,
                                   x.data(),
                                   result.data());
    correlation::values(
      kernel, signal_variance, n, result.data(), result.data());
    for (const std::vector<double> &row : rows)
      {
        const double        w     = row[point];
        const double *const other = row.data() + first;
        for (std::size_t j = 0; j < n; ++j)
          result[j] -= w * other[j];
      }
    return result;
  }



  const std::vector<double> &
  PosteriorCovariance::last_row() const
  {
    return rows.back();
  }
} // namespace asperity
