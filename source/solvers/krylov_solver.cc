#include <asperity/solvers/finite.h>

#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/trilinos_precondition.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>
#include <deal.II/lac/trilinos_vector.h>

#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>

#include <limits>
#include <string>
#include <vector>

#include "rank_solvers.h"

namespace asperity
{
  namespace
  {
    using DistributedVector = dealii::TrilinosWrappers::MPI::Vector;

    /** Residual over right-hand side: an iteration of Newton's method gains no
     *  more. */
    constexpr double tolerance = 1e-6;

    /** What is still a direction, where the iteration ends before that. */
    constexpr double largest_residual = 1e-2;

    constexpr unsigned int most_iterations = 400, most_vectors = 80;

    /**
     * GMRES preconditioned from the right by a V-cycle of smoothed aggregation
     * (ML; P. Vanek, J. Mandel, M. Brezina, Computing 56 (1996) 179-196), with
     * the rows distributed over the ranks. GMRES, and not conjugate gradients,
     * since softening and the curvature of the tool make tangents indefinite,
     * and shear makes them unsymmetric.
     */
    class KrylovSolver : public LinearSolver
    {
    public:
      explicit KrylovSolver(const SharedSystem &shared)
        : shared(shared)
        , communicator(shared.ranks.are_several() ? MPI_COMM_WORLD :
                                                    MPI_COMM_SELF)
      {}

      void
      reset() override
      {
        own_rows = dealii::IndexSet(); // clear() would keep its size
      }

      std::string
      failure() const override
      {
        return has_stalled ? "GMRES did not solve the linear equations in " +
                               std::to_string(most_iterations) +
                               " iterations (Solver/Linear solver = krylov)" :
                             LinearSolver::failure();
      }

      bool
      factorize(const dealii::SparseMatrix<double> &local) override
      {
        has_stalled = false;
        if (own_rows.size() != local.m())
          distribute(local);
        multigrid.clear();
        matrix = 0.;
        std::vector<double> values;
        bool                finite = true;
        for (const auto row : written_rows)
          {
            values.clear();
            columns.clear();
            for (auto entry = local.begin(row); entry != local.end(row);
                 ++entry)
              {
                columns.push_back(entry->column());
                values.push_back(entry->value());
              }
            finite = finite && is_finite(values);
            matrix.add(
              row, columns.size(), columns.data(), values.data(), true);
          }
        matrix.compress(dealii::VectorOperation::add);
        return shared.ranks.all(finite) && shared.ranks.all(build_multigrid());
      }

      void
      solve(dealii::Vector<double> &rhs) const override
      {
        if (rhs.all_zero())
          return;
        DistributedVector b(own_rows, communicator), x(own_rows, communicator);
        for (const auto row : own_rows)
          b(row) = rhs(row);
        b.compress(dealii::VectorOperation::insert);
        const double          size = b.l2_norm();
        dealii::SolverControl control(most_iterations, tolerance * size);
        try
          {
            using Gmres = dealii::SolverGMRES<DistributedVector>;
            Gmres(control, Gmres::AdditionalData(most_vectors, true))
              .solve(matrix, x, b, multigrid);
          }
        catch (const dealii::SolverControl::NoConvergence &)
          {}
        DistributedVector residual(b);
        matrix.vmult(residual, x);
        residual -= b;
        const bool solved =
          shared.ranks.all(residual.l2_norm() <= largest_residual * size);
        has_stalled = !solved;
        rhs         = 0.;
        for (const auto row : own_rows)
          rhs(row) =
            solved ? double(x(row)) : std::numeric_limits<double>::quiet_NaN();
        shared.ranks.sum(rhs.begin(), rhs.size());
      }

    private:
      void
      distribute(const dealii::SparseMatrix<double> &local)
      {
        const std::size_t n = local.m();
        own_rows            = dealii::IndexSet(n);
        written_rows        = dealii::IndexSet(n);
        std::vector<dealii::IndexSet::size_type> own, touched;
        for (std::size_t row = 0; row < n; ++row)
          {
            if (shared.row_owner.empty() ||
                shared.row_owner[row] == shared.ranks.rank())
              own.push_back(row);
            // Of others the row has its diagonal only.
            if (local.get_sparsity_pattern().row_length(row) > 1)
              touched.push_back(row);
          }
        own_rows.add_indices(own.begin(), own.end());
        written_rows.add_indices(touched.begin(), touched.end());
        written_rows.add_indices(own_rows);
        own_rows.compress();
        written_rows.compress();
        dealii::TrilinosWrappers::SparsityPattern pattern(own_rows,
                                                          own_rows,
                                                          written_rows,
                                                          communicator);
        for (const auto row : written_rows)
          {
            columns.clear();
            const auto &structure = local.get_sparsity_pattern();
            for (auto entry = structure.begin(row); entry != structure.end(row);
                 ++entry)
              columns.push_back(entry->column());
            pattern.add_entries(row, columns.begin(), columns.end());
          }
        pattern.compress();
        matrix.reinit(pattern);
        find_near_null_space();
      }

      /** Its vectors, of own rows, one after the other. */
      void
      find_near_null_space()
      {
        near_null_space.clear();
        if (!shared.near_null_space)
          return;
        const auto vectors = shared.near_null_space();
        n_near_null        = vectors.size();
        for (const auto &vector : vectors)
          for (const auto row : own_rows)
            near_null_space.push_back(vector(row));
      }

      bool
      build_multigrid()
      {
        Teuchos::ParameterList list;
        ML_Epetra::SetDefaults("SA", list);
        list.set("ML output", 0);
        list.set("PDE equations", static_cast<int>(shared.n_components));
        list.set("aggregation: type", "Uncoupled");
        list.set("aggregation: threshold", 0.);
        list.set("smoother: type", "Chebyshev");
        list.set("smoother: sweeps", 3);
        list.set("smoother: Chebyshev alpha", 20.);
        list.set("coarse: max size", 500);
        list.set("coarse: type", "Amesos-KLU");
        if (n_near_null > 0)
          {
            list.set("null space: type", "pre-computed");
            list.set("null space: dimension", n_near_null);
            list.set("null space: vectors", near_null_space.data());
            list.set("null space: add default vectors", false);
          }
        try
          {
            multigrid.initialize(matrix, list);
          }
        catch (const dealii::ExceptionBase &)
          {
            return false;
          }
        return true;
      }

      StartedMpi                                   mpi;
      const SharedSystem                           shared;
      const MPI_Comm                               communicator;
      dealii::IndexSet                             own_rows;
      dealii::IndexSet                             written_rows; ///< locally
      dealii::TrilinosWrappers::SparseMatrix       matrix;
      dealii::TrilinosWrappers::PreconditionAMG    multigrid;
      std::vector<double>                          near_null_space;
      int                                          n_near_null = 0;
      mutable bool                                 has_stalled = false;
      std::vector<dealii::types::global_dof_index> columns;
    };
  } // namespace



  std::unique_ptr<LinearSolver>
  make_krylov_solver(const SharedSystem &shared)
  {
    return std::make_unique<KrylovSolver>(shared);
  }
} // namespace asperity
