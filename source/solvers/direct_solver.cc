#include <asperity/base/errors.h>
#include <asperity/base/mpi_session.h>
#include <asperity/solvers/direct_solver.h>

#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <suitesparse/cholmod.h>
#include <suitesparse/klu.h>
#include <suitesparse/umfpack.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "compressed_rows.h"

namespace asperity
{
  namespace
  {
    class Umfpack : public DirectSolver
    {
    public:
      Umfpack()
      {
        umfpack_di_defaults(control);
        // Tangents are symmetric in structure and nearly so in value.
        control[UMFPACK_STRATEGY]            = UMFPACK_STRATEGY_SYMMETRIC;
        control[UMFPACK_IRSTEP]              = 0;
        control[UMFPACK_SYM_PIVOT_TOLERANCE] = 1e-3;
      }

      ~Umfpack() override
      {
        free_numeric();
        free_symbolic();
      }

      void
      reset() override
      {
        rows.reset();
      }

      bool
      factorize(const dealii::SparseMatrix<double> &matrix) override
      {
        if (rows.update(matrix))
          {
            free_symbolic();
            if (umfpack_di_symbolic(rows.n(),
                                    rows.n(),
                                    rows.row_start.data(),
                                    rows.column.data(),
                                    rows.values.data(),
                                    &symbolic,
                                    control,
                                    nullptr) != UMFPACK_OK)
              {
                rows.reset();
                return false;
              }
          }
        free_numeric();
        return rows.is_finite && umfpack_di_numeric(rows.row_start.data(),
                                                    rows.column.data(),
                                                    rows.values.data(),
                                                    symbolic,
                                                    &numeric,
                                                    control,
                                                    nullptr) == UMFPACK_OK;
      }

      void
      solve(dealii::Vector<double> &rhs) const override
      {
        dealii::Vector<double> x(rhs.size());
        umfpack_di_solve(UMFPACK_At,
                         rows.row_start.data(),
                         rows.column.data(),
                         rows.values.data(),
                         x.begin(),
                         rhs.begin(),
                         numeric,
                         control,
                         nullptr);
        rhs.swap(x);
      }

    private:
      void
      free_numeric()
      {
        if (numeric != nullptr)
          umfpack_di_free_numeric(&numeric);
        numeric = nullptr;
      }

      void
      free_symbolic()
      {
        if (symbolic != nullptr)
          umfpack_di_free_symbolic(&symbolic);
        symbolic = nullptr;
      }

      CompressedRows rows;
      double         control[UMFPACK_CONTROL];
      void          *symbolic = nullptr;
      void          *numeric  = nullptr;
    };

    /**
     * Supernodal Cholesky, with a factorisation by Umfpack wherever the matrix
     * is not positive definite: softening material and the curvature of the
     * contact surface make tangents indefinite now and then.
     */
    class Cholmod : public DirectSolver
    {
    public:
      Cholmod()
      {
        cholmod_start(&common);
        common.supernodal    = CHOLMOD_SUPERNODAL;
        common.print         = 0;
        common.error_handler = nullptr;
      }

      ~Cholmod() override
      {
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
      }

      void
      reset() override
      {
        rows.reset();
        fallback.reset();
      }

      bool
      factorize(const dealii::SparseMatrix<double> &matrix) override
      {
        const bool     is_new = rows.update(matrix);
        cholmod_sparse view   = lower_triangle();
        if (is_new)
          {
            cholmod_free_factor(&factor, &common);
            factor = cholmod_analyze(&view, &common);
          }
        if (factor == nullptr || !rows.is_finite)
          return false;
        cholmod_factorize(&view, factor, &common);
        is_definite = common.status == CHOLMOD_OK && factor->minor == factor->n;
        return is_definite || fallback.factorize(matrix);
      }

      void
      solve(dealii::Vector<double> &rhs) const override
      {
        if (!is_definite)
          {
            fallback.solve(rhs);
            return;
          }
        cholmod_dense b{};
        b.nrow = b.nzmax = b.d = rhs.size();
        b.ncol                 = 1;
        b.x                    = rhs.begin();
        b.xtype                = CHOLMOD_REAL;
        b.dtype                = CHOLMOD_DOUBLE;
        cholmod_dense *x       = cholmod_solve(CHOLMOD_A, factor, &b, &common);
        std::copy_n(static_cast<double *>(x->x), rhs.size(), rhs.begin());
        cholmod_free_dense(&x, &common);
      }

    private:
      /** The rows, read as columns of the symmetric matrix; CHOLMOD ignores
       *  what lies above the diagonal. */
      cholmod_sparse
      lower_triangle()
      {
        cholmod_sparse view{};
        view.nrow = view.ncol = rows.n();
        view.nzmax            = rows.values.size();
        view.p                = rows.row_start.data();
        view.i                = rows.column.data();
        view.x                = rows.values.data();
        view.stype            = -1;
        view.itype            = CHOLMOD_INT;
        view.xtype            = CHOLMOD_REAL;
        view.dtype            = CHOLMOD_DOUBLE;
        view.sorted           = 1;
        view.packed           = 1;
        return view;
      }

      CompressedRows         rows;
      Umfpack                fallback;
      bool                   is_definite = false;
      mutable cholmod_common common;
      cholmod_factor        *factor = nullptr;
    };

    class Klu : public DirectSolver
    {
    public:
      Klu()
      {
        klu_defaults(&common);
      }

      ~Klu() override
      {
        free_all();
      }

      void
      reset() override
      {
        rows.reset();
      }

      bool
      factorize(const dealii::SparseMatrix<double> &matrix) override
      {
        if (rows.update(matrix))
          {
            free_all();
            symbolic = klu_analyze(rows.n(),
                                   rows.row_start.data(),
                                   rows.column.data(),
                                   &common);
          }
        if (symbolic == nullptr || !rows.is_finite)
          return false;
        if (numeric != nullptr)
          {
            // The old pivot sequence serves as long as pivots do not decay.
            if (klu_refactor(rows.row_start.data(),
                             rows.column.data(),
                             rows.values.data(),
                             symbolic,
                             numeric,
                             &common) &&
                klu_rcond(symbolic, numeric, &common) && common.rcond > 1e-13)
              return true;
            klu_free_numeric(&numeric, &common);
          }
        numeric = klu_factor(rows.row_start.data(),
                             rows.column.data(),
                             rows.values.data(),
                             symbolic,
                             &common);
        return numeric != nullptr;
      }

      void
      solve(dealii::Vector<double> &rhs) const override
      {
        klu_tsolve(symbolic, numeric, rows.n(), 1, rhs.begin(), &common);
      }

    private:
      void
      free_all()
      {
        if (numeric != nullptr)
          klu_free_numeric(&numeric, &common);
        if (symbolic != nullptr)
          klu_free_symbolic(&symbolic, &common);
      }

      CompressedRows     rows;
      mutable klu_common common;
      klu_symbolic      *symbolic = nullptr;
      klu_numeric       *numeric  = nullptr;
    };

    /** MUMPS through Amesos; the wrapper repeats the analysis every time. */
    class Mumps : public DirectSolver
    {
    public:
      Mumps()
      {
        MpiSession::start();
      }

      void
      reset() override
      {}

      bool
      factorize(const dealii::SparseMatrix<double> &matrix) override
      {
        try
          {
            // Amesos keeps pointers into the matrix: the old solver goes first.
            solver.reset();
            trilinos_matrix.reinit(matrix);
            solver = std::make_unique<dealii::TrilinosWrappers::SolverDirect>(
              control,
              dealii::TrilinosWrappers::SolverDirect::AdditionalData(
                false, "Amesos_Mumps"));
            solver->initialize(trilinos_matrix);
          }
        catch (const dealii::ExceptionBase &)
          {
            return false;
          }
        return true;
      }

      void
      solve(dealii::Vector<double> &rhs) const override
      {
        const dealii::IndexSet all = dealii::complete_index_set(rhs.size());
        dealii::TrilinosWrappers::MPI::Vector b(all, MPI_COMM_SELF),
          x(all, MPI_COMM_SELF);
        std::copy(rhs.begin(), rhs.end(), b.begin());
        solver->solve(x, b);
        std::copy(x.begin(), x.end(), rhs.begin());
      }

    private:
      dealii::SolverControl                                   control;
      dealii::TrilinosWrappers::SparseMatrix                  trilinos_matrix;
      std::unique_ptr<dealii::TrilinosWrappers::SolverDirect> solver;
    };
  } // namespace



  std::unique_ptr<DirectSolver>
  make_direct_solver(const DirectSolverKind kind)
  {
    switch (kind)
      {
        case DirectSolverKind::cholmod:
          return std::make_unique<Cholmod>();
        case DirectSolverKind::klu:
          return std::make_unique<Klu>();
        case DirectSolverKind::mumps:
          return std::make_unique<Mumps>();
        default:
          return std::make_unique<Umfpack>();
      }
  }
} // namespace asperity
