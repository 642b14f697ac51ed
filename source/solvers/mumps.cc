#include <asperity/solvers/finite.h>

#include <dmumps_c.h>
#include <mpi.h>

#include <exception>
#include <limits>
#include <vector>

#include "rank_solvers.h"

namespace asperity
{
  namespace
  {
    // What MUMPS is asked to do.
    constexpr int begin = -1, end = -2, analyse = 1, factorise = 2, solve_ = 3;

    /** Beyond what the analysis expects [per cent]. */
    constexpr int room_to_spare = 40;

    /** Asks for a factor that needs more room than was reserved. */
    constexpr int most_attempts = 6;

    /**
     * MUMPS with the entries where the ranks have them: those of the same place
     * are added up. The analysis is kept; right-hand side and solution are
     * those of the first rank. P. R. Amestoy, I. S. Duff, J.-Y. L'Excellent,
     * J. Koster, SIAM J. Matrix Anal. Appl. 23 (2001) 15-41.
     */
    class Mumps : public LinearSolver
    {
    public:
      Mumps(const bool symmetric, const Ranks &ranks)
        : ranks(ranks)
        , symmetric(symmetric)
        , communicator(ranks.are_several() ? MPI_COMM_WORLD : MPI_COMM_SELF)
      {
        id.comm_fortran = MPI_Comm_c2f(communicator);
        id.par          = 1; // the first rank works, too
        id.sym          = symmetric ? 2 : 0;
        call(begin);
        control(1) = control(2) = control(3) = -1; // prints nothing
        control(4)                           = 0;
        control(18)                          = 3; // entries on all ranks
        control(14)                          = room_to_spare;
      }

      ~Mumps() override
      {
        // The ranks do not meet again where one of them has failed.
        if (!ranks.are_several() || std::uncaught_exceptions() == 0)
          call(end);
      }

      void
      reset() override
      {
        is_analysed = false;
      }

      bool
      factorize(const dealii::SparseMatrix<double> &matrix) override
      {
        n = matrix.m();
        if (!is_analysed)
          find_entries(matrix);
        values.clear();
        for (const auto &entry : matrix)
          if (is_wanted(entry.row(), entry.column()))
            values.push_back(entry.value());
        if (!ranks.all(is_finite(values)))
          return false;
        id.a_loc = values.data();
        if (!is_analysed)
          {
            call(analyse);
            is_analysed = id.infog[0] >= 0;
          }
        if (!is_analysed)
          return false;
        control(14) = room_to_spare;
        for (int attempt = 0; attempt < most_attempts; ++attempt)
          {
            call(factorise);
            const int status = id.infog[0];
            if (status != -8 && status != -9 && status != -20)
              return status >= 0;
            control(14) *= 2;
          }
        return false;
      }

      void
      solve(dealii::Vector<double> &rhs) const override
      {
        id.nrhs = 1;
        id.lrhs = n;
        id.rhs  = rhs.begin();
        call(solve_);
        if (id.infog[0] < 0)
          rhs = std::numeric_limits<double>::quiet_NaN(); // no direction
        MPI_Bcast(rhs.begin(), n, MPI_DOUBLE, 0, communicator);
      }

    private:
      /** Of a symmetric matrix the upper half. */
      bool
      is_wanted(const std::size_t row, const std::size_t column) const
      {
        return !symmetric || column >= row;
      }

      /** Counted from 1. */
      void
      find_entries(const dealii::SparseMatrix<double> &matrix)
      {
        rows.clear();
        columns.clear();
        for (const auto &entry : matrix)
          if (is_wanted(entry.row(), entry.column()))
            {
              rows.push_back(entry.row() + 1);
              columns.push_back(entry.column() + 1);
            }
        id.n       = n;
        id.nnz_loc = rows.size();
        id.irn_loc = rows.data();
        id.jcn_loc = columns.data();
      }

      /** An entry of ICNTL, as the manual counts. */
      int &
      control(const unsigned int number)
      {
        return id.icntl[number - 1];
      }

      void
      call(const int job) const
      {
        id.job = job;
        dmumps_c(&id);
      }

      StartedMpi             mpi;
      const Ranks            ranks;
      const bool             symmetric;
      const MPI_Comm         communicator;
      mutable DMUMPS_STRUC_C id{};
      unsigned int           n = 0;
      std::vector<MUMPS_INT> rows, columns;
      std::vector<double>    values;
      bool                   is_analysed = false;
    };
  } // namespace



  std::unique_ptr<LinearSolver>
  make_mumps(const bool symmetric, const Ranks &ranks)
  {
    return std::make_unique<Mumps>(symmetric, ranks);
  }
} // namespace asperity
