#include <asperity/solvers/linear_solver.h>
#include <asperity/solvers/unsymmetric_part.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace asperity;
  using Vector = dealii::Vector<double>;
  using Matrix = dealii::SparseMatrix<double>;

  constexpr unsigned int n = 40;

  /** A chain of springs to ground, and a part U of a few unknowns. */
  class UnsymmetricSystem : public testing::Test
  {
  protected:
    UnsymmetricSystem()
      : exact(n)
      , rhs(n)
    {
      dealii::DynamicSparsityPattern couplings(n), few(n);
      for (unsigned int i = 0; i < n; ++i)
        for (const unsigned int j : {i, (i + 1) % n, (i + n - 1) % n})
          couplings.add(i, j);
      for (unsigned int i = 10; i < 15; ++i)
        for (unsigned int j = 9; j < 16; ++j)
          {
            couplings.add(i, j);
            few.add(i, j);
          }
      pattern.copy_from(couplings);
      few_couplings.copy_from(few);
      K.reinit(pattern);
      U.reinit(few_couplings);
      for (unsigned int i = 0; i < n; ++i)
        {
          K.set(i, i, 3.);
          K.set(i, (i + 1) % n, -1.);
          K.set(i, (i + n - 1) % n, -1.);
          exact(i) = std::cos(i);
        }
      for (unsigned int i = 10; i < 15; ++i)
        for (unsigned int j = 9; j < 16; ++j)
          U.set(i, j, std::sin(1. + i + 5. * j));
      part.add(U);
      part.scale(0.5);
      K.vmult(rhs, exact);
      part.vmult_add(rhs, exact);
    }

    bool
    solve(Vector &b)
    {
      const auto solver = make_linear_solver(LinearSolverKind::cholmod);
      EXPECT_TRUE(solver->factorize(K));
      return part.solve([&](Vector &x) { solver->solve(x); },
                        dealii::AffineConstraints<double>(),
                        1e-10,
                        b);
    }

    dealii::SparsityPattern pattern, few_couplings;
    Matrix                  K, U;
    UnsymmetricPart         part;
    Vector                  exact, rhs;
  };

  TEST_F(UnsymmetricSystem, is_solved_with_the_factors_of_its_symmetric_part)
  {
    ASSERT_TRUE(solve(rhs));
    rhs -= exact;
    EXPECT_LT(rhs.linfty_norm(), 1e-8);
  }

  TEST_F(UnsymmetricSystem, becomes_one_matrix_but_for_constrained_components)
  {
    dealii::AffineConstraints<double> constraints;
    constraints.add_line(12);
    constraints.close();
    Matrix sum(pattern);
    sum.copy_from(K);
    part.add_to(sum, constraints);
    for (unsigned int i = 10; i < 15; ++i)
      for (unsigned int j = 9; j < 16; ++j)
        EXPECT_DOUBLE_EQ(sum.el(i, j),
                         K.el(i, j) +
                           (i == 12 || j == 12 ? 0. : 0.5 * U.el(i, j)));
  }

  TEST_F(UnsymmetricSystem, leaves_the_right_hand_side_where_it_fails)
  {
    // K + U is singular: row 12 of it is zero.
    for (unsigned int j = 9; j < 16; ++j)
      U.set(12, j, -2. * K.el(12, j));
    part.clear();
    part.add(U);
    part.scale(0.5);
    const Vector before = rhs;
    EXPECT_FALSE(solve(rhs));
    EXPECT_EQ(rhs, before);
  }
} // namespace
