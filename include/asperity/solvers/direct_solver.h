#ifndef asperity_solvers_direct_solver_h
#define asperity_solvers_direct_solver_h

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <string>

namespace asperity
{
  /**
   * A sparse direct solver that keeps what depends on the sparsity pattern only
   * (ordering, symbolic factorisation) from one factorisation to the next.
   * Tangents may be indefinite; with follower loads they are unsymmetric, too,
   * which all kinds but cholmod can treat.
   */
  class DirectSolver
  {
  public:
    virtual ~DirectSolver() = default;

    /** To be called when the sparsity pattern has changed. */
    virtual void
    reset() = 0;

    /** @return false if the matrix is singular or not finite. */
    virtual bool
    factorize(const dealii::SparseMatrix<double> &matrix) = 0;

    /** Replaces the right-hand side by the solution of the last factorised
     *  matrix. */
    virtual void
    solve(dealii::Vector<double> &rhs) const = 0;
  };

  enum class DirectSolverKind
  {
    cholmod,      ///< supernodal Cholesky for symmetric matrices, umfpack where
                  ///< one is indefinite
    umfpack,      ///< multifrontal with BLAS 3: the fastest below 10^5 unknowns
    klu,          ///< SuiteSparse's solver for circuits, pivot sequence reused
    mumps,        ///< Amesos_Mumps of Trilinos (deal.II's wrapper), if built in
    supernodal_lu ///< LU without pivoting for matrices whose symmetric part is
                  ///< positive definite, umfpack where it is unstable
  };

  std::unique_ptr<DirectSolver>
  make_direct_solver(const DirectSolverKind kind);
} // namespace asperity

#endif
