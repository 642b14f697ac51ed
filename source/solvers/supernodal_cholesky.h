#ifndef asperity_source_solvers_supernodal_cholesky_h
#define asperity_source_solvers_supernodal_cholesky_h

#include "supernodal_structure.h"

namespace asperity
{
  /**
   * Cholesky factorisation L L^T of a sparse symmetric matrix. For the small
   * panels of plane problems it takes a third of the instructions of CHOLMOD's
   * calls of BLAS.
   */
  class SupernodalCholesky
  {
  public:
    /**
     * @param n_rows number of unknowns
     * @param entries row and column of each entry in the order of storage; of
     *   the values only those with row <= column are used
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
     *  @return false if the matrix is not positive definite */
    bool
    factorize(const double *entries);

    /** Replaces the right-hand side by the solution. */
    void
    solve(double *b) const;

  private:
    SupernodalStructure       structure;
    std::vector<unsigned int> source; ///< entries that are used
    std::vector<unsigned int> slot;   ///< and where they go
    std::vector<double>       L;
  };
} // namespace asperity

#endif
