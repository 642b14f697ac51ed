#ifndef asperity_solvers_low_rank_update_h
#define asperity_solvers_low_rank_update_h

#include <asperity/solvers/linear_solver.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <vector>

namespace asperity
{
  /**
   * Solves (K + sum_i d_i v_i v_i^T) x = b with a factorisation of K alone, as
   * the bordered system
   *
   *   [ K    V      ] [ x ]   [ b ]
   *   [ V^T  -D^-1  ] [ l ] = [ 0 ]
   *
   * by elimination of x: one back-substitution a vector v_i, then a dense
   * system of as many unknowns (Woodbury's formula; G. Golub, C. Van Loan,
   * Matrix Computations, sec. 2.1.4). Dense vectors v_i cost the sparse factor
   * nothing, and d_i < 0 takes back what K was raised by.
   */
  class LowRankUpdate
  {
  public:
    /** Forgets all terms. */
    void
    clear();

    /** Adds d v v^T; terms with d = 0 or v = 0 are ignored. */
    void
    add(const dealii::Vector<double> &v, const double d);

    /** To be called after the terms and after the factorisation of K.
     *  @return false if the sum is singular. */
    bool
    factorize(const LinearSolver &solver);

    /** Replaces K^-1 b, which the solver gave, by the solution of the sum. */
    void
    correct(dealii::Vector<double> &x) const;

    /** y += (sum_i d_i v_i v_i^T) x */
    void
    vmult_add(dealii::Vector<double> &y, const dealii::Vector<double> &x) const;

    /** Sets the constrained components of all v_i to zero. */
    void
    drop_rows(const dealii::AffineConstraints<double> &constraints);

    /** Multiplies all d_i. */
    void
    scale(const double factor);

    bool
    empty() const;

  private:
    std::vector<dealii::Vector<double>> vectors, solved; ///< v_i, K^-1 v_i
    std::vector<double>                 factors;         ///< d_i
    dealii::LAPACKFullMatrix<double>    capacitance;     ///< D^-1 + V^T K^-1 V
  };
} // namespace asperity

#endif
