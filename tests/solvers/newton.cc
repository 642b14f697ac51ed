#include <asperity/solvers/newton.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
  using namespace asperity;
  using Vector = dealii::Vector<double>;

  /** One equation in one unknown. */
  class Scalar : public NonlinearSystem
  {
  public:
    using Function = std::function<double(double)>;

    Scalar(const Function &f,
           const Function &slope,
           const double    domain_end = INFINITY)
      : f(f)
      , slope(slope)
      , domain_end(domain_end)
    {}

    bool
    residual(const Vector &u, Vector &R) override
    {
      R(0) = f(u(0));
      return u(0) < domain_end;
    }

    bool
    linearize(const Vector &u, Vector &R) override
    {
      tangent = slope(u(0));
      iterates.push_back(u(0));
      return residual(u, R);
    }

    bool
    direction(const Vector &R, Vector &d) override
    {
      d(0) = -R(0) / tangent;
      return tangent != 0.;
    }

    std::vector<double> iterates;

  private:
    Function f, slope;
    double   domain_end, tangent = 0.;
  };

  ConvergenceReport
  solve(Scalar &system, Vector &u, const double tolerance = 1e-13)
  {
    NewtonOptions    options;
    NewtonStatistics statistics;
    options.tolerance = tolerance;
    return newton(system, u, options, statistics);
  }

  Vector
  start(const double value)
  {
    Vector u(1);
    u(0) = value;
    return u;
  }
} // namespace



TEST(Newton, converges_quadratically_near_a_root)
{
  Scalar     system([](const double x) { return std::exp(x) - 2.; },
                [](const double x) { return std::exp(x); });
  Vector     u      = start(1.);
  const auto report = solve(system, u);
  ASSERT_TRUE(report.converged);
  EXPECT_NEAR(u(0), std::log(2.), 1e-14);
  // e_{k+1} -> e_k^2 f''/(2 f') = e_k^2 / 2
  ASSERT_GE(system.iterates.size(), 4u);
  const double e2 = system.iterates[2] - std::log(2.),
               e3 = system.iterates[3] - std::log(2.);
  EXPECT_NEAR(e3 / (e2 * e2), 0.5, 0.02);
}



TEST(Newton, solves_a_linear_equation_in_one_iteration)
{
  Scalar     system([](const double x) { return 3. * x - 6.; },
                [](const double) { return 3.; });
  Vector     u      = start(-50.);
  const auto report = solve(system, u);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.iterations, 1u);
  EXPECT_NEAR(u(0), 2., 1e-14);
}



TEST(Newton, line_search_saves_what_full_steps_overshoot)
{
  // Full steps diverge for |x| > 1.392.
  Scalar     system([](const double x) { return std::atan(x); },
                [](const double x) { return 1. / (1. + x * x); });
  Vector     u      = start(10.);
  const auto report = solve(system, u);
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR(u(0), 0., 1e-13);
}



TEST(Newton, steps_back_from_where_no_residual_exists)
{
  // The first step leads beyond the end of the domain at 1.
  Scalar     system([](const double x) { return 1. / (1. - x) - 20.; },
                [](const double x) { return 1. / ((1. - x) * (1. - x)); },
                1.);
  Vector     u      = start(0.);
  const auto report = solve(system, u, 1e-11);
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR(u(0), 0.95, 1e-12);
}



TEST(Newton, start_without_residual_is_reported)
{
  Scalar     system([](const double x) { return x; },
                [](const double) { return 1.; },
                1.);
  Vector     u      = start(2.);
  const auto report = solve(system, u);
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.reason.empty());
}



TEST(Newton, singular_tangent_is_reported)
{
  Scalar     system([](const double x) { return x * x - 1.; },
                [](const double x) { return 2. * x; });
  Vector     u      = start(0.);
  const auto report = solve(system, u);
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.reason.empty());
}



TEST(Newton, equation_without_root_ends_with_a_reason)
{
  Scalar     system([](const double x) { return x * x + 1.; },
                [](const double x) { return 2. * x; });
  Vector     u      = start(3.);
  const auto report = solve(system, u);
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(report.reason.empty());
}



TEST(Newton, keeps_a_tangent_as_long_as_it_is_good)
{
  // The chord of slope f'(1) contracts by 1 - f'(x)/f'(1), which is 0.26 at
  // ln 2; a new tangent is needed once, where 0.2 is asked for.
  for (const auto &[contraction, n_tangents] :
       {std::pair<double, unsigned int>{0.5, 1}, {0.2, 2}})
    {
      Scalar        system([](const double x) { return std::exp(x) - 2.; },
                    [](const double x) { return std::exp(x); });
      Vector        u = start(1.);
      NewtonOptions options;
      options.tolerance                = 1e-13;
      options.kept_tangent_contraction = contraction;
      NewtonStatistics statistics;
      ASSERT_TRUE(newton(system, u, options, statistics).converged);
      EXPECT_NEAR(u(0), std::log(2.), 1e-13);
      EXPECT_EQ(statistics.linearizations, n_tangents);
    }
}



TEST(Newton, leaves_a_kept_tangent_that_leads_away)
{
  Scalar        system([](const double x) { return std::atan(x); },
                [](const double x) { return 1. / (1. + x * x); });
  Vector        u = start(10.);
  NewtonOptions options;
  options.tolerance                = 1e-13;
  options.kept_tangent_contraction = 0.5;
  NewtonStatistics statistics;
  EXPECT_TRUE(newton(system, u, options, statistics).converged);
  EXPECT_NEAR(u(0), 0., 1e-13);
}
