#ifndef asperity_solvers_linear_solver_h
#define asperity_solvers_linear_solver_h

#include <asperity/base/ranks.h>

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * A sparse solver that keeps what depends on the sparsity pattern only (for a
   * direct one the ordering and the symbolic factorisation, for `krylov` who
   * has which rows) from one matrix to the next. Tangents may be indefinite;
   * with follower loads they are unsymmetric, too, which all kinds but those
   * for symmetric matrices can treat.
   *
   * On several ranks the matrix is the sum of what each of them has, vectors
   * are the same on all, and the members are collective.
   */
  class LinearSolver
  {
  public:
    virtual ~LinearSolver() = default;

    /** To be called when the sparsity pattern has changed. */
    virtual void
    reset() = 0;

    /** @return false if the matrix is singular or not finite. */
    virtual bool
    factorize(const dealii::SparseMatrix<double> &matrix) = 0;

    /** Replaces the right-hand side by the solution of the last factorised
     *  matrix; numbers that are not finite if there is none. */
    virtual void
    solve(dealii::Vector<double> &rhs) const = 0;

    /** Why factorize() failed, or what solve() found is not finite. */
    virtual std::string
    failure() const
    {
      return "the tangent is singular";
    }
  };

  enum class LinearSolverKind
  {
    cholmod, ///< supernodal Cholesky for symmetric matrices, umfpack where
             ///< one is indefinite
    umfpack, ///< multifrontal with BLAS 3: the fastest below 10^5 unknowns
    klu,     ///< SuiteSparse's solver for circuits, pivot sequence reused
    mumps,   ///< multifrontal, on one rank or several
    mumps_symmetric, ///< the same, L D L^T
    krylov, ///< no direct one: GMRES with algebraic multigrid, on one rank
            ///< or several
    supernodal_lu, ///< LU without pivoting for matrices whose symmetric part is
                   ///< positive definite, umfpack where it is unstable
    automatic      ///< left to those who know the size; none for itself
  };

  /** Whether it takes symmetric matrices only. */
  constexpr bool
  is_for_symmetric(const LinearSolverKind kind)
  {
    return kind == LinearSolverKind::cholmod ||
           kind == LinearSolverKind::mumps_symmetric;
  }

  /** What a solver is told of unknowns that several ranks share, or of which
   *  there are many; the default is a process alone. */
  struct SharedSystem
  {
    Ranks ranks;

    /** Rank of each unknown's row, for krylov; empty: one has all. */
    std::vector<unsigned int> row_owner;

    /** Vectors that the undisturbed operator all but annihilates, for krylov:
     *  the rigid motions of a body. There are `n_components` unknowns a point,
     *  one after the other. */
    std::function<std::vector<dealii::Vector<double>>()> near_null_space;
    unsigned int                                         n_components = 1;
  };

  /** @throws ComputationError if a kind that runs on one rank only is wanted on
   *    several */
  std::unique_ptr<LinearSolver>
  make_linear_solver(const LinearSolverKind kind,
                     const SharedSystem    &shared = SharedSystem());
} // namespace asperity

#endif
