#ifndef asperity_flow_flow_solver_h
#define asperity_flow_flow_solver_h

#include <asperity/solvers/linear_solver.h>
#include <asperity/solvers/saddle_point_krylov.h>

#include <functional>
#include <memory>

namespace asperity
{
  class FluidSpace;

  enum class FlowSolverKind
  {
    direct, ///< a factorisation: the faster one where convection matters
    krylov  ///< SaddlePointKrylov: for large creeping flows, half the memory
  };

  /** Solves with the tangent of a flow, velocity first, then pressure. */
  class FlowSolver
  {
  public:
    using Vector = dealii::Vector<double>;
    using Matrix = dealii::SparseMatrix<double>;

    virtual ~FlowSolver() = default;

    /**
     * Makes ready for solve().
     * @param matrix must not change until the last solve()
     * @param estimate is called if the Schur complement's estimate is needed;
     *   what it returns must stay like the matrix
     * @return false if the matrix is singular or not finite
     */
    virtual bool
    prepare(const Matrix                                 &matrix,
            const std::function<const SchurEstimate &()> &estimate) = 0;

    /** Replaces the right-hand side by the solution. */
    virtual ConvergenceReport
    solve(Vector &rhs) const = 0;
  };

  std::unique_ptr<FlowSolver>
  make_flow_solver(const FluidSpace      &space,
                   const FlowSolverKind   kind,
                   const LinearSolverKind direct,
                   const KrylovOptions   &krylov);
} // namespace asperity

#endif
