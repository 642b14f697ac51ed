#ifndef asperity_solvers_saddle_point_krylov_h
#define asperity_solvers_saddle_point_krylov_h

#include <asperity/base/convergence_report.h>

#include <deal.II/lac/sparse_ilu.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/vector.h>

#include <memory>
#include <vector>

namespace asperity
{
  struct KrylovOptions
  {
    /** Of the residual, relative to the right-hand side. */
    double       tolerance          = 1e-8;
    unsigned int maximum_iterations = 400;
    unsigned int restart            = 80; ///< vectors of the basis, times two
  };

  /** What the Schur complement S = B A^-1 B^T of a saddle point is estimated
   *  from; unknowns of the second block are numbered from 0. */
  struct SchurEstimate
  {
    /** int q r/eta: the complement where viscosity rules. Not initialised: the
     *  first block has no viscosity. */
    dealii::SparsityPattern      mass_pattern;
    dealii::SparseMatrix<double> mass;

    /** Diagonal of what A has besides viscosity, time derivative and Robin
     *  terms, by unknowns of the first block; zero: nothing. */
    dealii::Vector<double> inertia;

    /** Sets of unknowns of the second block that are determined but for their
     *  level and of which the first is held at zero. */
    std::vector<std::vector<unsigned int>> levels;

    /** Convection dominates in A: the least-squares commutator is the better
     *  estimate, and nothing of the above is used. */
    bool is_convective = false;
  };

  /**
   * FGMRES for the saddle point
   *
   *   K = [ A  G  ]     P = [ A~  G  ]
   *       [ B  -C ],        [ 0  -S~ ]
   *
   * with P as preconditioner from the right (H. Elman, D. Silvester, A. Wathen,
   * Finite Elements and Fast Iterative Solvers, ch. 4 and 9). A~ is a V-cycle
   * of smoothed aggregation with incomplete factorisations as smoother (ML of
   * Trilinos). The Schur complement is that of J. Cahouet and J.-P. Chabard
   * (Int. J. Num. Meth. Fluids 8 (1988) 869),
   *
   *   S~^-1 = M^-1 + (G^T D^-1 G + C)^-1,
   *
   * M the mass matrix over the viscosity, D the diagonal of inertia: the first
   * is right for slow, the second for fast changes. Since the Laplacian comes
   * from G it knows the boundary conditions. Where convection dominates M is
   * no estimate, and the least-squares commutator takes its place (H. Elman, V.
   * Howle, J. Shadid, R. Shuttleworth, R. Tuminaro, SIAM J. Sci. Comput. 27
   * (2006) 1651) with D = diag A,
   *
   *   S~^-1 = L^-1 (G^T D^-1 A D^-1 G) L^-1,  L = G^T D^-1 G + C,
   *
   * whose iterations grow slowly with refinement and Reynolds number.
   */
  class SaddlePointKrylov
  {
  public:
    using Vector = dealii::Vector<double>;
    using Matrix = dealii::SparseMatrix<double>;

    /** @param components of the first block: each marks its unknowns */
    SaddlePointKrylov(const std::vector<std::vector<bool>> &components,
                      const KrylovOptions                  &options);

    /**
     * Builds the preconditioner. The matrix must live until the last solve(),
     * its pattern must be that of the first call; constrained unknowns have a
     * row and column with a diagonal entry only.
     * @return false if the matrix is not finite or has no preconditioner
     */
    bool
    prepare(const Matrix &matrix, const SchurEstimate &schur);

    /**
     * Replaces the right-hand side by the solution. In the norm of the residual
     * the second block is weighted by |A|/|G|, since the blocks differ in unit.
     */
    ConvergenceReport
    solve(Vector &rhs) const;

  private:
    class ScaledMatrix;
    class BlockTriangular;

    void
    build_patterns();

    void
    copy_blocks();

    void
    build_laplacian();

    /** x = S~^-1 b */
    void
    apply_schur(Vector &x, const Vector &b) const;

    /** The same, by the commutator. */
    void
    apply_commutator(Vector &x, const Vector &b) const;

    /** Trilinos needs MPI from the construction of its preconditioners on. */
    struct StartedMpi
    {
      StartedMpi();
    };

    const StartedMpi                     mpi;
    const KrylovOptions                  options;
    const std::vector<std::vector<bool>> modes; ///< component -> its unknowns
    const unsigned int                   n_first;
    const Matrix                        *matrix = nullptr;
    const SchurEstimate                 *schur  = nullptr;

    dealii::SparsityPattern velocity_pattern, gradient_pattern;
    dealii::SparsityPattern laplacian_pattern;
    Matrix                  velocity, gradient, laplacian; ///< A, G
    dealii::TrilinosWrappers::PreconditionAMG velocity_inverse;
    dealii::TrilinosWrappers::PreconditionAMG laplacian_inverse;
    dealii::SparseILU<double>                 mass_inverse;
    Vector                                    inverse_scale; ///< D^-1
    double row_weight    = 1.; ///< of the second block
    bool   is_convective = false, has_laplacian = false, has_mass = false;
  };
} // namespace asperity

#endif
