#ifndef asperity_source_solvers_supernodal_cholesky_h
#define asperity_source_solvers_supernodal_cholesky_h

#include <utility>
#include <vector>

#include "supernodal_panels.h"

namespace asperity
{
  /**
   * Cholesky factorisation L L^T of a sparse symmetric matrix. CHOLMOD orders
   * the unknowns and finds the supernodes: columns of L with the same rows
   * below their triangle, stored as one dense panel. What of a panel goes into
   * which other one, and where, is listed once; the numbers are then left to
   * loops over vector registers. For the small panels of plane problems that
   * takes a third of the instructions of CHOLMOD's calls of BLAS.
   */
  class SupernodalCholesky
  {
  public:
    /**
     * @param n_rows number of unknowns
     * @param entries row and column of each entry in the order of storage; only
     *   those with row <= column are used
     * @return false if CHOLMOD found no ordering
     */
    bool
    analyze(const unsigned int                      n_rows,
            const std::vector<std::pair<int, int>> &entries);

    /** Whether analyze() succeeded, and clear() was not called since. */
    bool
    is_analyzed() const
    {
      return !panels.empty();
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
    void
    build_panels(const void *symbolic_factor);

    void
    list_updates();

    void
    find_slots(const std::vector<std::pair<int, int>> &entries);

    std::vector<unsigned int>       order; ///< row of L -> unknown
    std::vector<supernodal::Panel>  panels;
    std::vector<unsigned int>       panel_of; ///< column -> panel
    std::vector<unsigned int>       rows;     ///< of all panels
    std::vector<supernodal::Update> updates;
    std::vector<unsigned int>       relative; ///< row in the panel updated
    std::vector<unsigned int>       source;   ///< entries that are used
    std::vector<unsigned int>       slot;     ///< and where they go
    std::vector<double>             values;   ///< L, panel by panel
    mutable std::vector<double>     ordered, work;
  };
} // namespace asperity

#endif
