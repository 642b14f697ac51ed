#include <asperity/solvers/linear_solver.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
  using namespace asperity;
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::SparseMatrix<double>;

  /** Couplings of quadratic splines on a strip, periodic along it, of two
   *  components a function. */
  dealii::SparsityPattern
  strip(const int columns, const int rows)
  {
    dealii::DynamicSparsityPattern couplings(2 * columns * rows);
    for (int i = 0; i < columns * rows; ++i)
      for (int x = -2; x <= 2; ++x)
        for (int y = std::max(0, i % rows - 2);
             y < std::min(rows, i % rows + 3);
             ++y)
          {
            const int column = (i / rows + x + 2 * columns) % columns;
            for (unsigned int c = 0; c < 4; ++c)
              couplings.add(2 * i + c / 2, 2 * (column * rows + y) + c % 2);
          }
    dealii::SparsityPattern result;
    result.copy_from(couplings);
    return result;
  }

  /** A symmetric part that by Gershgorin's circles is definite for a large
   *  diagonal, and a part that changes its sign with rows for columns. */
  void
  fill(Matrix &matrix, const double diagonal, const double skew = 0.)
  {
    for (auto entry = matrix.begin(); entry != matrix.end(); ++entry)
      {
        const unsigned int i = entry->row(), j = entry->column();
        const double       low = std::min(i, j), high = std::max(i, j);
        entry->value() =
          std::sin(3. * low + 7. * high) +
          (i == j ? diagonal :
                    (i < j ? skew : -skew) * std::cos(5. * low + 2. * high));
      }
  }

  double
  error_of_solution(const LinearSolver &solver, const Matrix &matrix)
  {
    Vector exact(matrix.m()), rhs(matrix.m());
    for (unsigned int i = 0; i < exact.size(); ++i)
      exact(i) = std::cos(i);
    matrix.vmult(rhs, exact);
    solver.solve(rhs);
    rhs -= exact;
    return rhs.linfty_norm();
  }
} // namespace



TEST(Supernodal, solves_definite_systems_of_all_shapes_again_and_again)
{
  for (const auto &[columns, rows] : {std::pair(1, 1),
                                      std::pair(1, 7),
                                      std::pair(3, 1),
                                      std::pair(6, 2),
                                      std::pair(23, 5),
                                      std::pair(40, 12)})
    {
      const auto sparsity = strip(columns, rows);
      Matrix     matrix(sparsity);
      for (const bool symmetric : {true, false})
        {
          const auto solver =
            make_linear_solver(symmetric ? LinearSolverKind::cholmod :
                                           LinearSolverKind::supernodal_lu);
          for (const double diagonal : {60., 55., 80.})
            {
              fill(matrix, diagonal, symmetric ? 0. : 20.);
              ASSERT_TRUE(solver->factorize(matrix));
              EXPECT_LT(error_of_solution(*solver, matrix), 1e-13)
                << columns << " x " << rows;
            }
        }
    }
}



TEST(Cholesky, leaves_what_is_not_definite_to_another_factorisation)
{
  const auto sparsity = strip(17, 4);
  Matrix     matrix(sparsity);
  const auto solver = make_linear_solver(LinearSolverKind::cholmod);
  for (const double change : {-200., 0., -150.})
    {
      fill(matrix, 60.);
      matrix.diag_element(41) += change;
      ASSERT_TRUE(solver->factorize(matrix));
      EXPECT_LT(error_of_solution(*solver, matrix), 1e-12);
    }
}



TEST(SupernodalLu, leaves_what_it_cannot_eliminate_to_another_factorisation)
{
  const auto sparsity = strip(1, 1);
  Matrix     matrix(sparsity);
  const auto solver = make_linear_solver(LinearSolverKind::supernodal_lu);
  for (const double pivot : {0., 1e-11, -1e-14})
    {
      matrix.set(0, 0, pivot);
      matrix.set(0, 1, 1.);
      matrix.set(1, 0, 2.);
      matrix.set(1, 1, pivot);
      ASSERT_TRUE(solver->factorize(matrix));
      EXPECT_LT(error_of_solution(*solver, matrix), 1e-14) << pivot;
    }
}



TEST(Supernodal, reports_matrices_that_are_singular_or_not_finite)
{
  const auto sparsity = strip(9, 3);
  Matrix     matrix(sparsity);
  for (const LinearSolverKind kind :
       {LinearSolverKind::cholmod, LinearSolverKind::supernodal_lu})
    {
      const auto solver = make_linear_solver(kind);
      for (const double value : {std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::infinity()})
        {
          fill(matrix, 60.);
          matrix.diag_element(20) = value;
          EXPECT_FALSE(solver->factorize(matrix));
        }
      matrix = 0.;
      EXPECT_FALSE(solver->factorize(matrix));
      fill(matrix, 60.);
      ASSERT_TRUE(solver->factorize(matrix));
      EXPECT_LT(error_of_solution(*solver, matrix), 1e-13);
    }
}
