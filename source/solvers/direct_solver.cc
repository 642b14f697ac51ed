#include <asperity/base/errors.h>
#include <asperity/solvers/direct_solver.h>

#include <deal.II/lac/trilinos_solver.h>
#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <suitesparse/klu.h>
#include <suitesparse/umfpack.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity
{
  namespace
  {
    /**
     * A deal.II matrix as compressed rows with sorted columns, which
     * SuiteSparse reads as the compressed columns of the transpose. deal.II
     * stores the diagonal first, so the slots are found once a pattern.
     */
    class CompressedRows
    {
    public:
      void
      reset()
      {
        row_start.clear();
      }

      /** @return true if the pattern was built anew. */
      bool
      update(const dealii::SparseMatrix<double> &matrix)
      {
        const bool is_new = row_start.empty();
        if (is_new)
          build_pattern(matrix);
        std::size_t k = 0;
        for (const auto &entry : matrix)
          values[slot[k++]] = entry.value();
        return is_new;
      }

      int
      n() const
      {
        return static_cast<int>(row_start.size()) - 1;
      }

      std::vector<int>    row_start, column;
      std::vector<double> values;

    private:
      void
      build_pattern(const dealii::SparseMatrix<double> &matrix)
      {
        row_start.assign(1, 0);
        column.clear();
        slot.clear();
        std::vector<std::pair<int, int>> row; // column, position in the row
        for (unsigned int r = 0; r < matrix.m(); ++r)
          {
            row.clear();
            for (auto entry = matrix.begin(r); entry != matrix.end(r); ++entry)
              row.emplace_back(entry->column(), row.size());
            std::sort(row.begin(), row.end());
            slot.resize(slot.size() + row.size());
            for (unsigned int i = 0; i < row.size(); ++i)
              {
                slot[row_start.back() + row[i].second] = row_start.back() + i;
                column.push_back(row[i].first);
              }
            row_start.push_back(column.size());
          }
        values.resize(column.size());
      }

      std::vector<int> slot; ///< deal.II's k-th entry -> index into values
    };

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
              return false;
          }
        free_numeric();
        return umfpack_di_numeric(rows.row_start.data(),
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
        if (symbolic == nullptr)
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
        : solver(control,
                 dealii::TrilinosWrappers::SolverDirect::AdditionalData(
                   false,
                   "Amesos_Mumps"))
      {}

      void
      reset() override
      {}

      bool
      factorize(const dealii::SparseMatrix<double> &matrix) override
      {
        try
          {
            trilinos_matrix.reinit(matrix);
            solver.initialize(trilinos_matrix);
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
        solver.solve(x, b);
        std::copy(x.begin(), x.end(), rhs.begin());
      }

    private:
      dealii::SolverControl                          control;
      dealii::TrilinosWrappers::SparseMatrix         trilinos_matrix;
      mutable dealii::TrilinosWrappers::SolverDirect solver;
    };
  } // namespace



  std::unique_ptr<DirectSolver>
  make_direct_solver(const DirectSolverKind kind)
  {
    switch (kind)
      {
        case DirectSolverKind::klu:
          return std::make_unique<Klu>();
        case DirectSolverKind::mumps:
          return std::make_unique<Mumps>();
        default:
          return std::make_unique<Umfpack>();
      }
  }
} // namespace asperity
