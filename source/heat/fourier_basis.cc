#include <asperity/heat/fourier_basis.h>

#include <deal.II/base/numbers.h>

#include <complex>

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
    dealii::LAPACKFullMatrix<double> f(x.size(), size());
    for (unsigned int q = 0; q < x.size(); ++q)
      {
        const auto turn = std::polar(1., wave_number(1) * x[q]);
        // Powers of a number of modulus one lose a digit in a thousand waves.
        std::complex<double> wave = 1.;
        f(q, 0)                   = 1.;
        for (unsigned int k = 1; k <= n_waves; ++k)
          {
            wave *= turn;
            f(q, 2 * k - 1) = wave.real();
            f(q, 2 * k)     = wave.imag();
          }
      }
    return f;
  }
} // namespace asperity
