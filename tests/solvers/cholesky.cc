#include <asperity/solvers/direct_solver.h>

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

  /** Symmetric; by Gershgorin's circles definite for a large diagonal. */
  void
  fill(Matrix &matrix, const double diagonal)
  {
    for (auto entry = matrix.begin(); entry != matrix.end(); ++entry)
      {
        const unsigned int i = entry->row(), j = entry->column();
        entry->value() = std::sin(3. * std::min(i, j) + 7. * std::max(i, j)) +
                         (i == j ? diagonal : 0.);
      }
  }

  double
  error_of_solution(const DirectSolver &solver, const Matrix &matrix)
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



TEST(Cholesky, solves_definite_systems_of_all_shapes_again_and_again)
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
      const auto solver = make_direct_solver(DirectSolverKind::cholmod);
      for (const double diagonal : {60., 55., 80.})
        {
          fill(matrix, diagonal);
          ASSERT_TRUE(solver->factorize(matrix));
          EXPECT_LT(error_of_solution(*solver, matrix), 1e-13)
            << columns << " x " << rows;
        }
    }
}



TEST(Cholesky, leaves_what_is_not_definite_to_another_factorisation)
{
  const auto sparsity = strip(17, 4);
  Matrix     matrix(sparsity);
  const auto solver = make_direct_solver(DirectSolverKind::cholmod);
  for (const double change : {-200., 0., -150.})
    {
      fill(matrix, 60.);
      matrix.diag_element(41) += change;
      ASSERT_TRUE(solver->factorize(matrix));
      EXPECT_LT(error_of_solution(*solver, matrix), 1e-12);
    }
}



TEST(Cholesky, reports_matrices_that_are_singular_or_not_finite)
{
  const auto sparsity = strip(9, 3);
  Matrix     matrix(sparsity);
  const auto solver = make_direct_solver(DirectSolverKind::cholmod);
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
