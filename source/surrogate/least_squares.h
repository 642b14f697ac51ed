#ifndef asperity_source_surrogate_least_squares_h
#define asperity_source_surrogate_least_squares_h

#include <cstddef>
#include <vector>

namespace asperity
{
  /** y = sum over i of c_i a_i, by the normal equations: the columns are of the
   *  size of 1, so that these are well conditioned. */
  class LeastSquares
  {
  public:
    /** @param a n rows of m columns, as y times the square roots of weights */
    LeastSquares(const std::vector<double> &a, const std::vector<double> &y);

    /** Whether the columns are independent; if not, nothing else is known. */
    bool
    is_determined() const;

    const std::vector<double> &
    coefficients() const;

    double
    residual(const std::size_t row) const;

    /** The residual without this row in the fit: r / (1 - h), h the diagonal of
     *  the hat matrix A (A^T A)^-1 A^T. */
    double
    left_out_residual(const std::size_t row) const;

    double
    sum_of_squares() const;

    /** (A^T A)^-1, row by row. */
    std::vector<double>
    inverse() const;

  private:
    void
    solve(std::vector<double> &b) const;

    const std::vector<double> a, y;
    const std::size_t         m;
    std::vector<double>       factor, coefficients_;
    bool                      determined;
  };
} // namespace asperity

#endif
