#ifndef asperity_solvers_direct_solver_h
#define asperity_solvers_direct_solver_h

#include <asperity/base/ranks.h>

#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <functional>
#include <memory>
#include <vector>

namespace asperity
{
  /**
   * A sparse direct solver that keeps what depends on the sparsity pattern only
   * (ordering, symbolic factorisation) from one factorisation to the next.
   * Tangents may be indefinite; with follower loads they are unsymmetric, too,
   * which all kinds but those for symmetric matrices can treat.
   *
   * On several ranks the matrix is the sum of what each of them has, vectors
   * are the same on all, and the members are collective.
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
  is_for_symmetric(const DirectSolverKind kind)
  {
    return kind == DirectSolverKind::cholmod ||
           kind == DirectSolverKind::mumps_symmetric;
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
  std::unique_ptr<DirectSolver>
  make_direct_solver(const DirectSolverKind kind,
                     const SharedSystem    &shared = SharedSystem());
} // namespace asperity

#endif
