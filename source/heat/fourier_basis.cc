#include <asperity/heat/fourier_basis.h>

#include <deal.II/base/numbers.h>

#include <cmath>

namespace asperity
{
  FourierBasis::FourierBasis(const double period, const unsigned int n_waves)
    : period_(period)
    , n_waves(n_waves)
  {}



  unsigned int
  FourierBasis::size() const
  {
    return 1 + 2 * n_waves;
  }



  double
  FourierBasis::period() const
  {
    return period_;
  }



  double
  FourierBasis::wave_number(const unsigned int m) const
  {
    return 2. * dealii::numbers::PI * ((m + 1) / 2) / period_;
  }



  double
  FourierBasis::norm(const unsigned int m) const
  {
    return (m == 0 ? 1. : 2.) / period_;
  }



  dealii::LAPACKFullMatrix<double>
  FourierBasis::values(const std::vector<double> &x) const
  {
    const unsigned int               n = x.size();
    dealii::LAPACKFullMatrix<double> f(n, size());
    for (unsigned int q = 0; q < n; ++q)
      f(q, 0) = 1.;
    if (n_waves == 0 || n == 0)
      return f;
    for (unsigned int q = 0; q < n; ++q)
      {
        f(q, 1) = std::cos(wave_number(1) * x[q]);
        f(q, 2) = std::sin(wave_number(1) * x[q]);
      }
    // Down the columns, in which the matrix is stored. Each wave turns by the
    // first: powers of a number of modulus one lose a digit in a thousand.
    const double *const cosine = &f(0, 1), *const sine = &f(0, 2);
    for (unsigned int k = 2; k <= n_waves; ++k)
      {
        const double *const c = &f(0, 2 * k - 3), *const s = &f(0, 2 * k - 2);
        double *const next_c = &f(0, 2 * k - 1), *const next_s = &f(0, 2 * k);
        for (unsigned int q = 0; q < n; ++q)
          {
            next_c[q] = c[q] * cosine[q] - s[q] * sine[q];
            next_s[q] = s[q] * cosine[q] + c[q] * sine[q];
          }
      }
    return f;
  }
} // namespace asperity
