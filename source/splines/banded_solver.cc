#include <asperity/splines/banded_solver.h>

#include <deal.II/base/config.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

extern "C"
{
  void DEAL_II_FORTRAN_MANGLE(dgbtrf, DGBTRF)(const int *m,
                                              const int *n,
                                              const int *kl,
                                              const int *ku,
                                              double    *ab,
                                              const int *ldab,
                                              int       *ipiv,
                                              int       *info);

  void DEAL_II_FORTRAN_MANGLE(dgbtrs, DGBTRS)(const char   *trans,
                                              const int    *n,
                                              const int    *kl,
                                              const int    *ku,
                                              const int    *nrhs,
                                              const double *ab,
                                              const int    *ldab,
                                              const int    *ipiv,
                                              double       *b,
                                              const int    *ldb,
                                              int          *info);
}

namespace asperity
{
  BandedSolver::BandedSolver(const unsigned int n,
                             const unsigned int bandwidth,
                             const bool         cyclic)
    : n(n)
    , bandwidth(std::min(cyclic ? 2 * bandwidth : bandwidth, n - 1))
    , cyclic(cyclic)
    , band(std::size_t(3 * this->bandwidth + 1) * n)
    , pivots(n)
  {}



  unsigned int
  BandedSolver::folded(const unsigned int i) const
  {
    if (!cyclic)
      return i;
    return 2 * i < unsigned(n) ? 2 * i : 2 * (n - 1 - i) + 1;
  }



  double &
  BandedSolver::entry(const unsigned int row, const unsigned int column)
  {
    return band[std::size_t(column) * (3 * bandwidth + 1) + 2 * bandwidth +
                row - column];
  }



  void
  BandedSolver::add(const unsigned int i,
                    const unsigned int j,
                    const double       value)
  {
    entry(folded(i), folded(j)) += value;
  }



  void
  BandedSolver::set_identity_row(const unsigned int i)
  {
    const int row = folded(i);
    for (int column = std::max(0, row - bandwidth);
         column <= std::min(n - 1, row + bandwidth);
         ++column)
      entry(row, column) = (row == column ? 1. : 0.);
  }



  bool
  BandedSolver::factorize()
  {
    const int ld   = 3 * bandwidth + 1;
    int       info = 0;
    DEAL_II_FORTRAN_MANGLE(dgbtrf, DGBTRF)
    (&n, &n, &bandwidth, &bandwidth, band.data(), &ld, pivots.data(), &info);

    double largest = 0., smallest = HUGE_VAL;
    for (int i = 0; i < n; ++i)
      {
        const double pivot = std::abs(entry(i, i));
        largest            = std::max(largest, pivot);
        smallest           = std::min(smallest, pivot);
      }
    // A span without data leaves pivots of round-off size.
    return info == 0 && smallest > 1e-14 * largest;
  }



  void
  BandedSolver::solve(std::vector<double> &right_hand_side) const
  {
    std::vector<double> x(n);
    for (int i = 0; i < n; ++i)
      x[folded(i)] = right_hand_side[i];
    const int  ld = 3 * bandwidth + 1, one = 1;
    int        info  = 0;
    const char trans = 'N';
    DEAL_II_FORTRAN_MANGLE(dgbtrs, DGBTRS)
    (&trans,
     &n,
     &bandwidth,
     &bandwidth,
     &one,
     band.data(),
     &ld,
     pivots.data(),
     x.data(),
     &n,
     &info);
    for (int i = 0; i < n; ++i)
      right_hand_side[i] = x[folded(i)];
  }
} // namespace asperity
