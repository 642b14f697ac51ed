#include <asperity/base/errors.h>
#include <asperity/learning/orthogonal_decomposition.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "blas.h"

namespace asperity
{
  namespace
  {
    void
    check(const std::vector<double> &snapshots,
          const std::size_t          n_snapshots,
          const std::vector<double> &weights)
    {
      const auto is_finite = [](const double x) { return std::isfinite(x); };
      if (n_snapshots == 0 || snapshots.empty() ||
          snapshots.size() % n_snapshots != 0)
        throw InputError(std::to_string(snapshots.size()) +
                         " numbers are not " + std::to_string(n_snapshots) +
                         " snapshots of one length.");
      if (!std::all_of(snapshots.begin(), snapshots.end(), is_finite))
        throw InputError("A snapshot has a value that is no number.");
      if (!weights.empty() &&
          (weights.size() != snapshots.size() / n_snapshots ||
           !std::all_of(weights.begin(), weights.end(), [](const double w) {
             return w > 0. && std::isfinite(w);
           })))
        throw InputError("Snapshots need a positive weight for each of their "
                         "values.");
    }



    /** Left singular vectors and singular values of a matrix by columns, which
     *  is overwritten. */
    void
    decompose(const int            m,
              const int            n,
              std::vector<double> &a,
              std::vector<double> &u,
              std::vector<double> &s)
    {
      const int           k = std::min(m, n);
      std::vector<double> vt(std::size_t(k) * n), work(1);
      std::vector<int>    integers(8 * std::size_t(k));
      int                 length = -1, info = 0;
      u.resize(std::size_t(m) * k);
      s.resize(k);
      const auto call = [&]() {
        dgesdd_("S",
                &m,
                &n,
                a.data(),
                &m,
                s.data(),
                u.data(),
                &m,
                vt.data(),
                &k,
                work.data(),
                &length,
                integers.data(),
                &info);
      };
      call(); // asks for the length of the work space
      length = static_cast<int>(work[0]);
      work.resize(length);
      call();
      if (info != 0)
        throw ComputationError("The singular values of the snapshots did not "
                               "converge.");
    }
  } // namespace



  OrthogonalDecomposition::OrthogonalDecomposition(
    const std::vector<double> &snapshots,
    const std::size_t          n_snapshots,
    const std::vector<double> &weights)
    : weights(weights)
  {
    check(snapshots, n_snapshots, weights);
    const std::size_t n = snapshots.size() / n_snapshots;
    if (weights.empty())
      this->weights.assign(n, 1.);
    mean_.assign(n, 0.);
    for (std::size_t i = 0; i < snapshots.size(); ++i)
      mean_[i % n] += snapshots[i] / n_snapshots;
    std::vector<double> deviations(snapshots.size());
    for (std::size_t i = 0; i < snapshots.size(); ++i)
      deviations[i] =
        std::sqrt(this->weights[i % n]) * (snapshots[i] - mean_[i % n]);
    decompose(n, n_snapshots, deviations, modes, singular_values_);
    for (std::size_t i = 0; i < modes.size(); ++i)
      modes[i] /= std::sqrt(this->weights[i % n]);
  }



  std::vector<double>
  OrthogonalDecomposition::project(const std::vector<double> &field,
                                   const std::size_t          n) const
  {
    if (field.size() != size() || n > n_modes())
      throw InputError("A field of " + std::to_string(field.size()) +
                       " values cannot be projected on " + std::to_string(n) +
                       " of " + std::to_string(n_modes()) + " modes of " +
                       std::to_string(size()) + ".");
    std::vector<double> result(n, 0.);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < size(); ++k)
        result[i] += weights[k] * mode(i)[k] * (field[k] - mean_[k]);
    return result;
  }



  std::vector<double>
  OrthogonalDecomposition::reconstruct(
    const std::vector<double> &coefficients) const
  {
    if (coefficients.size() > n_modes())
      throw InputError(std::to_string(coefficients.size()) +
                       " coefficients are more than the " +
                       std::to_string(n_modes()) + " modes.");
    std::vector<double> result = mean_;
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      for (std::size_t k = 0; k < size(); ++k)
        result[k] += coefficients[i] * mode(i)[k];
    return result;
  }



  double
  OrthogonalDecomposition::truncation_error(const std::size_t n) const
  {
    double sum = 0.;
    for (std::size_t i = n_modes(); i-- > n;)
      sum += singular_values_[i] * singular_values_[i];
    return std::sqrt(sum);
  }
} // namespace asperity
