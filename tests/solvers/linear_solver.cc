#include <asperity/solvers/finite.h>
#include <asperity/solvers/linear_solver.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace asperity;
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::SparseMatrix<double>;

  const LinearSolverKind kinds[] = {LinearSolverKind::umfpack,
                                    LinearSolverKind::klu,
                                    LinearSolverKind::mumps,
                                    LinearSolverKind::supernodal_lu};

  constexpr unsigned int n = 60;

  /** Couplings of a chain with some far ones, one of them one-sided. */
  dealii::SparsityPattern
  pattern()
  {
    dealii::DynamicSparsityPattern couplings(n);
    for (unsigned int i = 0; i < n; ++i)
      for (const unsigned int j :
           {i, (i + 1) % n, (i + n - 1) % n, (i + 7) % n})
        couplings.add(i, j);
    dealii::SparsityPattern result;
    result.copy_from(couplings);
    return result;
  }

  /** An indefinite and unsymmetric matrix. */
  void
  fill(Matrix &matrix, const double phase)
  {
    for (unsigned int i = 0; i < n; ++i)
      for (auto entry = matrix.begin(i); entry != matrix.end(i); ++entry)
        entry->value() = (entry->column() == i ? (i % 3 == 0 ? -6. : 5.) : 0.) +
                         std::sin(phase + i + 3. * entry->column());
  }

  double
  error_of_solution(const LinearSolver &solver, const Matrix &matrix)
  {
    Vector exact(n), rhs(n);
    for (unsigned int i = 0; i < n; ++i)
      exact(i) = std::cos(i);
    matrix.vmult(rhs, exact);
    solver.solve(rhs);
    rhs -= exact;
    return rhs.linfty_norm();
  }
} // namespace



TEST(LinearSolver, solves_unsymmetric_indefinite_systems_and_refactorizes)
{
  const auto sparsity = pattern();
  Matrix     matrix(sparsity);
  for (const LinearSolverKind kind : kinds)
    {
      const auto solver = make_linear_solver(kind);
      for (const double phase : {0., 1., 2.5})
        {
          fill(matrix, phase);
          ASSERT_TRUE(solver->factorize(matrix));
          EXPECT_LT(error_of_solution(*solver, matrix), 1e-11);
        }
    }
}



TEST(LinearSolver, singular_matrices_are_reported_and_do_no_lasting_harm)
{
  const auto sparsity = pattern();
  Matrix     matrix(sparsity);
  for (const LinearSolverKind kind : kinds)
    {
      const auto solver = make_linear_solver(kind);
      fill(matrix, 0.);
      for (auto entry = matrix.begin(9); entry != matrix.end(9); ++entry)
        entry->value() = 0.;
      EXPECT_FALSE(solver->factorize(matrix));
      fill(matrix, 0.);
      ASSERT_TRUE(solver->factorize(matrix));
      EXPECT_LT(error_of_solution(*solver, matrix), 1e-11);
    }
}



TEST(LinearSolver, matrices_that_are_not_finite_are_reported)
{
  const auto sparsity = pattern();
  Matrix     matrix(sparsity);
  for (const LinearSolverKind kind : kinds)
    {
      const auto solver = make_linear_solver(kind);
      fill(matrix, 0.);
      matrix.begin(4)->value() = std::nan("");
      EXPECT_FALSE(solver->factorize(matrix));
    }
}



TEST(LinearSolver, follows_a_new_sparsity_pattern_after_reset)
{
  const auto sparsity = pattern();
  Matrix     matrix(sparsity);
  for (const LinearSolverKind kind : kinds)
    {
      const auto solver = make_linear_solver(kind);
      fill(matrix, 0.);
      ASSERT_TRUE(solver->factorize(matrix));
      dealii::DynamicSparsityPattern couplings(n);
      for (unsigned int i = 0; i < n; ++i)
        couplings.add(i, i);
      dealii::SparsityPattern diagonal_sparsity;
      diagonal_sparsity.copy_from(couplings);
      Matrix diagonal(diagonal_sparsity);
      for (unsigned int i = 0; i < n; ++i)
        diagonal.set(i, i, 2. + i);
      solver->reset();
      ASSERT_TRUE(solver->factorize(diagonal));
      EXPECT_LT(error_of_solution(*solver, diagonal), 1e-13);
    }
}



// Laplace's equation by five points on a square: symmetric and definite.
TEST(LinearSolver,
     large_symmetric_systems_are_solved_by_factor_and_by_multigrid)
{
  constexpr unsigned int         m = 40;
  dealii::DynamicSparsityPattern couplings(m * m);
  const auto for_each_neighbour = [](const unsigned int i, const auto &action) {
    if (i % m > 0)
      action(i - 1);
    if (i % m + 1 < m)
      action(i + 1);
    if (i >= m)
      action(i - m);
    if (i + m < m * m)
      action(i + m);
  };
  for (unsigned int i = 0; i < m * m; ++i)
    {
      couplings.add(i, i);
      for_each_neighbour(i, [&](const unsigned int j) { couplings.add(i, j); });
    }
  dealii::SparsityPattern sparsity;
  sparsity.copy_from(couplings);
  Matrix matrix(sparsity);
  for (unsigned int i = 0; i < m * m; ++i)
    {
      matrix.set(i, i, 4.);
      for_each_neighbour(i,
                         [&](const unsigned int j) { matrix.set(i, j, -1.); });
    }
  SharedSystem shared;
  shared.near_null_space = []() {
    Vector one(m * m);
    one = 1.;
    return std::vector<Vector>{one};
  };
  for (const auto &[kind, tolerance] :
       {std::pair(LinearSolverKind::mumps_symmetric, 1e-12),
        std::pair(LinearSolverKind::krylov, 1.01e-6)})
    {
      const auto solver = make_linear_solver(kind, shared);
      ASSERT_TRUE(solver->factorize(matrix));
      Vector b(m * m);
      for (unsigned int i = 0; i < m * m; ++i)
        b(i) = std::cos(0.1 * i);
      Vector x(b), residual(b);
      solver->solve(x);
      matrix.vmult(residual, x);
      residual -= b;
      EXPECT_LE(residual.l2_norm(), tolerance * b.l2_norm());
    }
}



// A shift along a ring moves all of a residual on to the next unknown: GMRES
// gains nothing until it has seen them all.
TEST(LinearSolver, krylov_says_that_it_has_not_converged)
{
  constexpr unsigned int         m = 2000;
  dealii::DynamicSparsityPattern couplings(m);
  for (unsigned int i = 0; i < m; ++i)
    for (const unsigned int j : {i, (i + 1) % m})
      couplings.add(i, j);
  dealii::SparsityPattern sparsity;
  sparsity.copy_from(couplings);
  Matrix matrix(sparsity);
  for (unsigned int i = 0; i < m; ++i)
    {
      matrix.set(i, i, 1e-3);
      matrix.set(i, (i + 1) % m, 1.);
    }
  const auto solver = make_linear_solver(LinearSolverKind::krylov);
  ASSERT_TRUE(solver->factorize(matrix));
  Vector x(m);
  x(0) = 1.;
  solver->solve(x);
  EXPECT_FALSE(is_finite(x));
  EXPECT_EQ(solver->failure(),
            "GMRES did not solve the linear equations in 400 iterations "
            "(Solver/Linear solver = krylov)");
}
