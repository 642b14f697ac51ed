#ifndef asperity_source_solvers_rank_solvers_h
#define asperity_source_solvers_rank_solvers_h

#include <asperity/base/mpi_session.h>
#include <asperity/solvers/linear_solver.h>

namespace asperity
{
  /** MPI, started before the members that follow this one. */
  struct StartedMpi
  {
    StartedMpi()
    {
      MpiSession::start();
    }
  };

  /** MUMPS, L D L^T for symmetric matrices and else LU. */
  std::unique_ptr<LinearSolver>
  make_mumps(const bool symmetric, const Ranks &ranks);

  /** GMRES with smoothed aggregation by ML. */
  std::unique_ptr<LinearSolver>
  make_krylov_solver(const SharedSystem &shared);
} // namespace asperity

#endif
