#include <asperity/base/errors.h>
#include <asperity/splines/spline_fit.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace asperity;

namespace
{
  std::vector<double>
  random_heights(const unsigned int n)
  {
    std::mt19937                           generator(3);
    std::uniform_real_distribution<double> uniform(-1e-6, 1e-6);
    std::vector<double>                    heights(n);
    for (double &height : heights)
      height = uniform(generator);
    return heights;
  }
} // namespace

TEST(PeriodicInterpolation, passes_through_its_points)
{
  const double L = 12e-6;
  for (const unsigned int degree : {3u, 5u})
    for (const unsigned int n : {12u, 41u})
      {
        const auto      heights = random_heights(n);
        const SplineFit fit = interpolate_periodic_graph(heights, L, degree);
        for (unsigned int i = 0; i < n; ++i)
          for (const double turn : {-L, 0., L})
            EXPECT_NEAR(fit.curve.value(L * i / n + turn)[1],
                        heights[i],
                        1e-20);
        EXPECT_LT(fit.report.max_error, 1e-20);
        EXPECT_EQ(fit.report.n_control_points, n);
      }
}

TEST(PeriodicInterpolation, reproduces_a_periodic_cubic_spline)
{
  const unsigned int  n = 20;
  std::vector<double> breakpoints(n + 1);
  for (unsigned int i = 0; i <= n; ++i)
    breakpoints[i] = 0.5 * i;
  const SplineCurve given =
    SplineCurve::graph(KnotVector(3, breakpoints, true), random_heights(n));
  std::vector<double> heights;
  for (unsigned int i = 0; i < n; ++i)
    heights.push_back(given.value(0.5 * i)[1]);
  const SplineCurve curve = interpolate_periodic_graph(heights, 10., 3).curve;
  for (unsigned int i = 0; i < 10 * n; ++i)
    EXPECT_NEAR(curve.value(0.05 * i)[1], given.value(0.05 * i)[1], 1e-19);
}

TEST(PeriodicInterpolation, misses_a_cosine_by_its_fourth_order)
{
  for (const unsigned int n : {16u, 32u})
    {
      std::vector<double> heights;
      for (unsigned int i = 0; i < n; ++i)
        heights.push_back(std::cos(2. * M_PI * i / n));
      const SplineCurve curve =
        interpolate_periodic_graph(heights, 1., 3).curve;
      double error = 0.;
      for (unsigned int i = 0; i < 20 * n; ++i)
        error = std::max(error,
                         std::abs(curve.value(i / 20. / n)[1] -
                                  std::cos(2. * M_PI * i / 20. / n)));
      const double expected = std::pow(2. * M_PI / n, 4) / 384.;
      EXPECT_NEAR(error, expected, 0.1 * expected) << n;
    }
}

TEST(PeriodicInterpolation, refuses_what_does_not_determine_it)
{
  for (const auto &[degree, n] :
       {std::pair<unsigned int, unsigned int>(4, 20), {3, 7}})
    EXPECT_THROW(interpolate_periodic_graph(random_heights(n), 1., degree),
                 InputError)
      << degree;
}
