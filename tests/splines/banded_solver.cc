#include <asperity/splines/banded_solver.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace asperity;

// The right-hand side is made from a known solution.
TEST(BandedSolver, solves_a_cyclic_system)
{
  const unsigned int  n = 12;
  BandedSolver        matrix(n, 1, true);
  std::vector<double> solution(n), rhs(n);
  for (unsigned int i = 0; i < n; ++i)
    solution[i] = std::cos(i * i);
  for (unsigned int i = 0; i < n; ++i)
    {
      matrix.add(i, i, 2.5);
      matrix.add(i, (i + 1) % n, -1.);
      matrix.add((i + 1) % n, i, -1.);
      rhs[i] =
        2.5 * solution[i] - solution[(i + 1) % n] - solution[(i + n - 1) % n];
    }
  ASSERT_TRUE(matrix.factorize());
  matrix.solve(rhs);
  for (unsigned int i = 0; i < n; ++i)
    EXPECT_NEAR(rhs[i], solution[i], 1e-14);
}

TEST(BandedSolver, solves_a_full_system)
{
  const unsigned int  n = 5;
  BandedSolver        matrix(n, n - 1, false);
  std::vector<double> solution(n), rhs(n, 0.);
  for (unsigned int i = 0; i < n; ++i)
    solution[i] = 1. + i;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      {
        const double entry = 1. / (1. + i + j) + (i == j ? 1. : 0.);
        matrix.add(i, j, entry);
        rhs[i] += entry * solution[j];
      }
  ASSERT_TRUE(matrix.factorize());
  matrix.solve(rhs);
  for (unsigned int i = 0; i < n; ++i)
    EXPECT_NEAR(rhs[i], solution[i], 1e-13);
}

TEST(BandedSolver, finds_a_singular_matrix)
{
  BandedSolver matrix(2, 1, false);
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      matrix.add(i, j, 1.);
  EXPECT_FALSE(matrix.factorize());
}
