#ifndef asperity_source_solvers_supernodal_structure_h
#define asperity_source_solvers_supernodal_structure_h

#include <utility>
#include <vector>

#include "supernodal_panels.h"

namespace asperity
{
  /**
   * What of a sparse factorisation depends on the places of the entries only.
   * CHOLMOD orders the unknowns of the pattern of A + A^T and finds the
   * supernodes: columns of the factor with the same rows below their triangle,
   * stored as one dense panel. What of a panel goes into which other one, and
   * where, is listed once; the numbers are then left to loops over vector
   * registers.
   */
  class SupernodalStructure
  {
  public:
    /**
     * @param n_rows number of unknowns
     * @param entries row and column of each entry
     * @param dissect_too whether the better of minimum degree and nested
     *   dissection is taken, which takes three times as long to find
     * @return false if CHOLMOD found no ordering
     */
    bool
    analyze(const unsigned int                      n_rows,
            const std::vector<std::pair<int, int>> &entries,
            const bool                              dissect_too = false);

    /** Whether analyze() succeeded, and clear() was not called since. */
    bool
    is_analyzed() const
    {
      return !panels.empty();
    }

    void
    clear();

    /** Row and column of the factor for each unknown. */
    std::vector<unsigned int>
    places() const;

    /** Where an entry of the factor stands in the values of the panels. */
    std::size_t
    slot(const unsigned int column, const unsigned int row) const;

    /** Numbers that a factor has: all panels, and what tiles read behind. */
    std::size_t
    n_values() const;

    /** Makes L of A = L L^T.
     *  @param L lower triangle of A at its slots
     *  @return false if A is not positive definite */
    bool
    factorize(double *L) const;

    /** Makes the factors of A = L U, U with a diagonal of ones, without a
     *  search for pivots.
     *  @param L, U_transposed lower triangles of A and A^T at their slots
     *  @return the largest |L_ij U_jk|, infinite where a pivot is zero */
    double
    factorize(double *L, double *U_transposed) const;

    /** Replaces b by the solution of L U x = b. */
    void
    solve(const double *L, const double *U_transposed, double *b) const;

  private:
    void
    build_panels(const void *symbolic_factor);

    void
    sort_panels();

    void
    list_updates();

    std::vector<unsigned int>       order; ///< row of the factor -> unknown
    std::vector<supernodal::Panel>  panels;
    std::vector<unsigned int>       panel_of; ///< column -> panel
    std::vector<unsigned int>       rows;     ///< of all panels
    std::vector<supernodal::Update> updates;
    std::vector<unsigned int>       relative; ///< row in the panel updated
    std::size_t                     size = 0; ///< of all panels

    mutable std::vector<double> ordered, work;
  };
} // namespace asperity

#endif
