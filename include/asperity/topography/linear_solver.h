#ifndef asperity_topography_linear_solver_h
#define asperity_topography_linear_solver_h

#include <vector>

namespace asperity
{
  /**
   * A symmetric positive definite matrix in skyline storage: of row i the
   * entries from column first(i) to the diagonal. Banded, cyclic and dense
   * normal equations all fit.
   */
  class SkylineMatrix
  {
  public:
    /** Zero matrix; @p first[i] <= i is the first nonzero column of row i. */
    explicit SkylineMatrix(const std::vector<unsigned int> &first);

    /** Add to the entry (i, j) and, by symmetry, (j, i). */
    void
    add(const unsigned int i, const unsigned int j, const double value);

    /**
     * Cholesky factorisation in place, and the solution of A x = b.
     *
     * @throw ComputationError if the matrix is not positive definite.
     */
    std::vector<double>
    factorize_and_solve(std::vector<double> b);

  private:
    std::vector<unsigned int>        first;
    std::vector<std::vector<double>> rows;
  };
} // namespace asperity

#endif
