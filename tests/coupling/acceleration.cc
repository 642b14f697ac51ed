#include <asperity/base/archive.h>
#include <asperity/base/errors.h>
#include <asperity/coupling/quasi_newton.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace asperity;
using Vector = dealii::Vector<double>;

namespace
{
  /** H(x) = x* + A (x - x*), A dense with a spectral radius far above one. */
  struct LinearMap
  {
    explicit LinearMap(const unsigned int n)
      : A(n * n)
      , solution(n)
    {
      std::mt19937                           generator(5);
      std::uniform_real_distribution<double> uniform(-1., 1.);
      for (double &a : A)
        a = uniform(generator);
      for (unsigned int i = 0; i < n; ++i)
        {
          A[i * n + i] -= 2.;
          solution(i) = uniform(generator);
        }
    }

    Vector
    operator()(const Vector &x) const
    {
      const unsigned int n      = x.size();
      Vector             result = solution;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          result(i) += A[i * n + j] * (x(j) - solution(j));
      return result;
    }

    std::vector<double> A;
    Vector              solution;
  };

  double
  distance(const Vector &a, const Vector &b)
  {
    Vector difference = a;
    difference -= b;
    return difference.l2_norm();
  }

  std::vector<std::unique_ptr<Acceleration>>
  all_methods()
  {
    std::vector<std::unique_ptr<Acceleration>> methods;
    AccelerationParameters                     parameters;
    parameters.relaxation = 0.5;
    for (const auto kind : {AccelerationKind::relaxation,
                            AccelerationKind::aitken,
                            AccelerationKind::iqn_ils})
      {
        parameters.kind = kind;
        methods.push_back(make_acceleration(parameters));
      }
    return methods;
  }
} // namespace



TEST(Acceleration, relaxation_contracts_by_its_factor)
{
  // H(x) = 2 - 3 (x - 2): x_new - 2 = (1 - 4 omega) (x - 2).
  ConstantRelaxation relaxation(0.2);
  relaxation.start_step();
  Vector x(1), Hx(1);
  for (unsigned int k = 1; k < 10; ++k)
    {
      Hx(0) = 2. - 3. * (x(0) - 2.);
      x     = relaxation.next(x, Hx);
      EXPECT_NEAR(x(0) - 2., -2. * std::pow(0.2, k), 1e-14);
    }
}



TEST(Acceleration, aitken_solves_a_scalar_linear_problem_in_two_iterations)
{
  AitkenRelaxation aitken(0.1);
  for (unsigned int step = 0; step < 2; ++step)
    {
      aitken.start_step();
      Vector x(1), Hx(1);
      for (unsigned int k = 0; k < 2; ++k)
        {
          Hx(0) = 2. - 7. * (x(0) - 2.);
          x     = aitken.next(x, Hx);
        }
      EXPECT_NEAR(x(0), 2., 1e-13);
    }
}



TEST(Acceleration,
     quasi_newton_solves_a_linear_problem_in_one_iteration_more_than_unknowns)
{
  for (const unsigned int n : {1u, 2u, 5u, 12u})
    {
      const LinearMap H(n);
      QuasiNewton     method(0.3, 0, 1e-6);
      method.start_step();
      Vector x(n);
      for (unsigned int k = 0; k < n + 1; ++k)
        {
          EXPECT_GT(distance(H(x), x), 1e-6) << n << " unknowns, " << k;
          x = method.next(x, H(x));
        }
      EXPECT_LT(distance(x, H.solution), 1e-8) << n << " unknowns";
    }
}



TEST(Acceleration, quasi_newton_profits_from_the_columns_of_earlier_steps)
{
  const unsigned int n = 6;
  LinearMap          H(n);
  QuasiNewton        method(0.3, 1, 1e-6);
  Vector             x(n);
  method.start_step();
  for (unsigned int k = 0; k < n + 1; ++k)
    x = method.next(x, H(x));
  method.finish_step(true);
  EXPECT_EQ(method.n_columns(), n);
  // Another solution, the same Jacobian.
  H.solution(2) += 3.;
  method.start_step();
  x = method.next(x, H(x));
  EXPECT_LT(distance(x, H.solution), 1e-7);
  method.finish_step(true);

  // Two steps later the columns are gone, and after a failure at once.
  method.start_step();
  method.finish_step(false);
  EXPECT_EQ(method.n_columns(), 0u);
}



TEST(Acceleration, quasi_newton_drops_dependent_columns)
{
  // r changes along one direction only, so that one column is all there is.
  QuasiNewton method(0.5, 3, 1e-3);
  Vector      x(3), Hx(3);
  for (unsigned int step = 0; step < 3; ++step)
    {
      method.start_step();
      for (unsigned int k = 0; k < 4; ++k)
        {
          Hx = x;
          Hx(0) += std::pow(0.5, k);
          x = method.next(x, Hx);
          EXPECT_LE(method.n_columns(), 1u);
          EXPECT_TRUE(std::isfinite(x.l2_norm()));
        }
      method.finish_step(true);
    }
}



TEST(Acceleration, zero_residual_returns_the_fixed_point)
{
  for (auto &method : all_methods())
    for (unsigned int step = 0; step < 3; ++step)
      {
        method->start_step();
        Vector x(4);
        x(1) = 3.;
        for (unsigned int k = 0; k < 3; ++k)
          {
            const Vector next = method->next(x, x);
            EXPECT_EQ(distance(next, x), 0.);
          }
        method->finish_step(true);
      }
}



TEST(Acceleration, constant_input_and_output_give_finite_steps)
{
  // The coupled sides do not react: identical columns of zero.
  for (auto &method : all_methods())
    for (unsigned int step = 0; step < 3; ++step)
      {
        method->start_step();
        Vector x(2), Hx(2);
        x(0) = Hx(1) = 1.;
        for (unsigned int k = 0; k < 4; ++k)
          {
            const Vector next = method->next(x, Hx);
            EXPECT_NEAR(next(0), 0.5, 1e-15);
            EXPECT_NEAR(next(1), 0.5, 1e-15);
          }
        method->finish_step(true);
      }
}



TEST(Acceleration, a_rest_between_steps_changes_nothing)
{
  // Columns of a step that moves serve after steps at rest.
  const unsigned int n = 3;
  const LinearMap    H(n);
  QuasiNewton        method(0.3, 2, 1e-6);
  method.start_step();
  Vector x(n);
  for (unsigned int k = 0; k < n + 1; ++k)
    x = method.next(x, H(x));
  method.finish_step(true);
  for (unsigned int step = 0; step < 10; ++step)
    {
      method.start_step();
      method.next(x, x);
      method.finish_step(true);
    }
  EXPECT_EQ(method.n_columns(), n);
}



TEST(Acceleration, quasi_newton_goes_on_from_what_it_saved)
{
  // Also after a step that has ended at once and left no residual behind.
  const unsigned int n = 3;
  LinearMap          H(n);
  QuasiNewton        method(0.3, 2, 1e-6);
  method.start_step();
  Vector x(n);
  for (unsigned int k = 0; k < n + 1; ++k)
    x = method.next(x, H(x));
  method.finish_step(true);
  method.start_step();
  method.finish_step(true);

  QuasiNewton       other(0.3, 2, 1e-6);
  const std::string bytes =
    to_bytes([&](OutputArchive &archive) { method.save(archive); });
  EXPECT_THROW(from_bytes(bytes,
                          "what was learnt",
                          [&](InputArchive &archive) {
                            other.load(archive, n + 1);
                          }),
               InputError);
  from_bytes(bytes, "what was learnt", [&](InputArchive &archive) {
    other.load(archive, n);
  });
  EXPECT_EQ(other.n_columns(), n);
  H.solution(1) -= 2.;
  method.start_step();
  other.start_step();
  EXPECT_EQ(distance(method.next(x, H(x)), other.next(x, H(x))), 0.);
}



TEST(Acceleration, rejects_a_factor_without_meaning)
{
  AccelerationParameters parameters;
  for (const double factor : {0., -1., 3., double(NAN)})
    {
      parameters.relaxation = factor;
      EXPECT_THROW(make_acceleration(parameters), InputError);
    }
}
