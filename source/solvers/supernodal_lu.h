#ifndef asperity_source_solvers_supernodal_lu_h
#define asperity_source_solvers_supernodal_lu_h

#include "supernodal_structure.h"

namespace asperity
{
  /**
   * Factorisation L U of a sparse matrix without a search for pivots, at twice
   * the operations of SupernodalCholesky. It exists, and is stable, where the
   * symmetric part of A is positive definite and not much smaller than the rest
   * (G. Golub, C. Van Loan, Matrix Computations, sec. 4.2.2), as it is for a
   * chip with a film of oil on it: the film's pressure acts on the chip as the
   * chip's displacement on the film's volume, with the opposite sign. Unknowns
   * that have the same couplings are eliminated in their rising order.
   */
  class SupernodalLu
  {
  public:
    /**
     * @param n_rows number of unknowns
     * @param entries row and column of each entry in the order of storage
     * @return false if no ordering was found
     */
    bool
    analyze(const unsigned int                      n_rows,
            const std::vector<std::pair<int, int>> &entries);

    /** Whether analyze() succeeded, and clear() was not called since. */
    bool
    is_analyzed() const
    {
      return structure.is_analyzed();
    }

    void
    clear();

    /** @param entries as told to analyze()
     *  @return false if the factors are not to be trusted: a pivot vanishes, or
     *   numbers much larger than those of the matrix have come up */
    bool
    factorize(const double *entries);

    /** Replaces the right-hand side by the solution. */
    void
    solve(double *b) const;

  private:
    SupernodalStructure       structure;
    std::vector<unsigned int> slot;    ///< of each entry in the factors
    std::vector<double>       factors; ///< L, then U^T
  };
} // namespace asperity

#endif
