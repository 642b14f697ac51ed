#ifndef asperity_heat_fourier_basis_h
#define asperity_heat_fourier_basis_h

#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace asperity
{
  /**
   * The real Fourier functions of a period L,
   *
   *   f_0 = 1,  f_{2k-1} = cos(kappa_k x),  f_{2k} = sin(kappa_k x),
   *   kappa_k = 2 pi k/L,  k = 1 .. n.
   *
   * The projection of a function q on them has the coefficients
   * q_m = norm(m) int q f_m dx, with norm 1/L for f_0 and 2/L for the others.
   */
  class FourierBasis
  {
  public:
    /** @param n_waves of the shortest wave in a period; 0: the mean alone */
    FourierBasis(const double period, const unsigned int n_waves);

    /** Number of functions, 1 + 2 n. */
    unsigned int
    size() const;

    /** L [m] */
    double
    period() const;

    /** kappa of a function [1/m]. */
    double
    wave_number(const unsigned int m) const;

    /** See above [1/m]. */
    double
    norm(const unsigned int m) const;

    /** f_m(x_q) as entry (q, m), at any x. */
    dealii::LAPACKFullMatrix<double>
    values(const std::vector<double> &x) const;

  private:
    double       period_;
    unsigned int n_waves;
  };
} // namespace asperity

#endif
