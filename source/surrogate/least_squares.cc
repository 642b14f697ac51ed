#include "least_squares.h"

#include <algorithm>

#include "lapack.h"

namespace asperity
{
  LeastSquares::LeastSquares(const std::vector<double> &a,
                             const std::vector<double> &y)
    : a(a)
    , y(y)
    , m(a.size() / y.size())
    , factor(m * m, 0.)
    , coefficients_(m, 0.)
  {
    for (std::size_t row = 0; row < y.size(); ++row)
      for (std::size_t i = 0; i < m; ++i)
        {
          coefficients_[i] += a[row * m + i] * y[row];
          for (std::size_t j = 0; j < m; ++j)
            factor[i * m + j] += a[row * m + i] * a[row * m + j];
        }
    const int size = static_cast<int>(m);
    int       info = 0;
    dpotrf_("L", &size, factor.data(), &size, &info);
    determined = info == 0;
    for (std::size_t i = 0; i < m && determined; ++i)
      determined = factor[i * m + i] > 1e-7 * factor[0];
    if (determined)
      solve(coefficients_);
  }



  bool
  LeastSquares::is_determined() const
  {
    return determined;
  }



  const std::vector<double> &
  LeastSquares::coefficients() const
  {
    return coefficients_;
  }



  double
  LeastSquares::residual(const std::size_t row) const
  {
    double result = y[row];
    for (std::size_t i = 0; i < m; ++i)
      result -= coefficients_[i] * a[row * m + i];
    return result;
  }



  double
  LeastSquares::left_out_residual(const std::size_t row) const
  {
    std::vector<double> b(a.begin() + row * m, a.begin() + (row + 1) * m);
    solve(b);
    double h = 0.;
    for (std::size_t i = 0; i < m; ++i)
      h += a[row * m + i] * b[i];
    return residual(row) / std::max(1. - h, 1e-12);
  }



  double
  LeastSquares::sum_of_squares() const
  {
    double result = 0.;
    for (std::size_t row = 0; row < y.size(); ++row)
      result += residual(row) * residual(row);
    return result;
  }



  std::vector<double>
  LeastSquares::inverse() const
  {
    std::vector<double> result;
    for (std::size_t i = 0; i < m; ++i)
      {
        std::vector<double> unit(m, 0.);
        unit[i] = 1.;
        solve(unit);
        result.insert(result.end(), unit.begin(), unit.end());
      }
    return result;
  }



  void
  LeastSquares::solve(std::vector<double> &b) const
  {
    const int size = static_cast<int>(m), one = 1;
    int       info = 0;
    dpotrs_("L", &size, &one, factor.data(), &size, b.data(), &size, &info);
  }
} // namespace asperity
