#include <asperity/base/errors.h>
#include <asperity/solvers/linear_solver.h>

#include <suitesparse/klu.h>
#include <suitesparse/umfpack.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "compressed_rows.h"
#include "rank_solvers.h"
#include "supernodal_cholesky.h"
#include "supernodal_lu.h"

namespace asperity
{
  namespace
  {
    class Umfpack : public LinearSolver
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
     * SupernodalCholesky or SupernodalLu, with a factorisation by Umfpack
     * wherever the matrix is not positive definite: softening material and the
     * curvature of the contact surface make tangents indefinite now and then.
     */
    template <class Factor>
    class Supernodal : public LinearSolver
    {
    public:
      void
      reset() override
      {
        factor.clear();
        fallback.reset();
      }

      bool
      factorize(const dealii::SparseMatrix<double> &matrix) override
      {
        if (!factor.is_analyzed() && !analyze(matrix))
          return false;
        // The diagonal comes first in each row of a square matrix: that of the
        // first row is where its values start, which are only read.
        is_factorised = factor.factorize(
          &const_cast<dealii::SparseMatrix<double> &>(matrix).diag_element(0));
        return is_factorised || fallback.factorize(matrix);
      }

      void
      solve(dealii::Vector<double> &rhs) const override
      {
        if (is_factorised)
          factor.solve(rhs.begin());
        else
          fallback.solve(rhs);
      }

    private:
      bool
      analyze(const dealii::SparseMatrix<double> &matrix)
      {
        std::vector<std::pair<int, int>> entries;
        for (const auto &entry : matrix)
          entries.emplace_back(entry.row(), entry.column());
        return factor.analyze(matrix.m(), entries);
      }

      Factor  factor;
      Umfpack fallback;
      bool    is_factorised = false;
    };

    class Klu : public LinearSolver
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
  } // namespace



  std::unique_ptr<LinearSolver>
  make_linear_solver(const LinearSolverKind kind, const SharedSystem &shared)
  {
    switch (kind)
      {
        case LinearSolverKind::mumps:
        case LinearSolverKind::mumps_symmetric:
          return make_mumps(is_for_symmetric(kind), shared.ranks);
        case LinearSolverKind::krylov:
          return make_krylov_solver(shared);
        default:
          if (shared.ranks.are_several())
            throw ComputationError("A direct solver for one rank was asked to "
                                   "work on several.");
      }
    switch (kind)
      {
        case LinearSolverKind::cholmod:
          return std::make_unique<Supernodal<SupernodalCholesky>>();
        case LinearSolverKind::supernodal_lu:
          return std::make_unique<Supernodal<SupernodalLu>>();
        case LinearSolverKind::klu:
          return std::make_unique<Klu>();
        case LinearSolverKind::umfpack:
          return std::make_unique<Umfpack>();
        default:
          throw ComputationError("A linear solver was asked for that nobody "
                                 "has chosen.");
      }
  }
} // namespace asperity
