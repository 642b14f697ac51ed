#ifndef asperity_splines_banded_solver_h
#define asperity_splines_banded_solver_h

#include <vector>

namespace asperity
{
  /**
   * LU factorisation (LAPACK dgbtrf) of a banded matrix whose band may wrap
   * around the corners, as periodic splines give it. Wrapping is undone by
   * folding: in the order 0, n-1, 1, n-2, ... a cyclic band of width w is an
   * ordinary one of width 2 w.
   */
  class BandedSolver
  {
  public:
    /** Entries (i, j) with |i - j| <= bandwidth, modulo n if cyclic, may be
     *  nonzero. */
    BandedSolver(const unsigned int n,
                 const unsigned int bandwidth,
                 const bool         cyclic);

    void
    add(const unsigned int i, const unsigned int j, const double value);

    /** The row of the identity instead of row i. */
    void
    set_identity_row(const unsigned int i);

    /** False if the matrix is singular to working precision. */
    bool
    factorize();

    /** In place. */
    void
    solve(std::vector<double> &right_hand_side) const;

  private:
    unsigned int
    folded(const unsigned int i) const;

    double &
    entry(const unsigned int row, const unsigned int column);

    int                 n;
    int                 bandwidth; ///< after folding
    bool                cyclic;
    std::vector<double> band; ///< LAPACK's layout, columns contiguous
    std::vector<int>    pivots;
  };
} // namespace asperity

#endif
