#include <asperity/flow/flow_solver.h>
#include <asperity/flow/fluid_space.h>

#include <deal.II/dofs/dof_tools.h>

namespace asperity
{
  namespace
  {
    class DirectFlowSolver : public FlowSolver
    {
    public:
      explicit DirectFlowSolver(const LinearSolverKind kind)
        : solver(make_linear_solver(kind))
      {}

      bool
      prepare(const Matrix &matrix,
              const std::function<const SchurEstimate &()> &) override
      {
        return solver->factorize(matrix);
      }

      ConvergenceReport
      solve(Vector &rhs) const override
      {
        solver->solve(rhs);
        ConvergenceReport report;
        report.converged = true;
        return report;
      }

    private:
      std::unique_ptr<LinearSolver> solver;
    };



    class KrylovFlowSolver : public FlowSolver
    {
    public:
      KrylovFlowSolver(const FluidSpace &space, const KrylovOptions &options)
        : solver(velocity_components(space), options)
      {}

      bool
      prepare(const Matrix                                 &matrix,
              const std::function<const SchurEstimate &()> &estimate) override
      {
        return solver.prepare(matrix, estimate());
      }

      ConvergenceReport
      solve(Vector &rhs) const override
      {
        return solver.solve(rhs);
      }

    private:
      static std::vector<std::vector<bool>>
      velocity_components(const FluidSpace &space)
      {
        std::vector<std::vector<bool>> components(
          2, std::vector<bool>(space.n_velocity_dofs()));
        for (unsigned int c = 0; c < components.size(); ++c)
          {
            dealii::ComponentMask mask(3, false);
            mask.set(c, true);
            for (const auto i :
                 dealii::DoFTools::extract_dofs(space.dofs(), mask))
              components[c][i] = true;
          }
        return components;
      }

      SaddlePointKrylov solver;
    };
  } // namespace



  std::unique_ptr<FlowSolver>
  make_flow_solver(const FluidSpace      &space,
                   const FlowSolverKind   kind,
                   const LinearSolverKind direct,
                   const KrylovOptions   &krylov)
  {
    if (kind == FlowSolverKind::direct)
      return std::make_unique<DirectFlowSolver>(direct);
    return std::make_unique<KrylovFlowSolver>(space, krylov);
  }
} // namespace asperity
