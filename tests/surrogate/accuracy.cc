#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sample_data.h"

using namespace asperity;

// Long length scales make the mean a sum of huge terms that nearly cancel. It
// is compared with the same sum in extended precision, and has to be as exact
// as a sum of alpha_j s2 (f(r_j) - 1) can be.

namespace
{
  long double
  correlation(const KernelKind kernel, const long double r2)
  {
    if (kernel == KernelKind::rbf)
      return std::exp(-r2 / 2);
    const long double a =
      std::sqrt((kernel == KernelKind::matern_3_2 ? 3 : 5) * r2);
    return (kernel == KernelKind::matern_3_2 ? 1 + a : 1 + a + a * a / 3) *
           std::exp(-a);
  }
} // namespace

TEST(GaussianProcess, keeps_its_accuracy_with_long_length_scales)
{
  if (sizeof(long double) == sizeof(double))
    GTEST_SKIP() << "there is no extended precision";
  const TrainingData data = sample(60, 3, [](const std::vector<double> &x) {
    return std::exp(-x[0]) - std::pow(x[1] + 0.1, 0.3) + 0.2 * x[2] * x[2];
  });
  for (const KernelKind kernel : all_kernels)
    for (const double length : {0.5, 3., 8.})
      {
        const Hyperparameters hyperparameters = {100. * length,
                                                 {length, 2. * length, length},
                                                 1e-4};
        const GaussianProcess process(kernel, hyperparameters, data);
        for (std::size_t point = 500; point < 520; ++point)
          {
            const std::vector<double> x     = evenly_spread_point(point, 3);
            long double               exact = 0., size = 1.;
            for (std::size_t j = 0; j < data.y.size(); ++j)
              {
                long double r2 = 0;
                for (std::size_t i = 0; i < 3; ++i)
                  {
                    // the scaled coordinates are those of the process
                    const double      l = hyperparameters.length_scales[i];
                    const long double a = data.x[3 * j + i] / l, b = x[i] / l;
                    const long double d = a - b;
                    r2 += d * d;
                  }
                const long double alpha = process.alpha()[j];
                const long double f     = correlation(kernel, r2);
                exact += hyperparameters.signal_variance * alpha * f;
                size +=
                  std::abs(hyperparameters.signal_variance * alpha * (f - 1));
              }
            const double expected  = static_cast<double>(exact);
            const double tolerance = static_cast<double>(
              6. * std::numeric_limits<double>::epsilon() * size);
            double variance;
            EXPECT_NEAR(process.mean(x.data()), expected, tolerance);
            EXPECT_NEAR(process.evaluate(x.data(), &variance, nullptr),
                        expected,
                        tolerance);
            EXPECT_LT(tolerance, 5e-11);
          }
      }
}
