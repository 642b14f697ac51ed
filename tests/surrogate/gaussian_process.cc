#include <asperity/base/errors.h>
#include <asperity/surrogate/gaussian_process.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../files.h"
#include "sample_data.h"

using namespace asperity;

namespace
{
  GaussianProcess
  process_without(const GaussianProcess &process, const std::size_t left_out)
  {
    TrainingData      data = process.data();
    const std::size_t d    = data.n_inputs;
    data.x.erase(data.x.begin() + left_out * d,
                 data.x.begin() + (left_out + 1) * d);
    data.y.erase(data.y.begin() + left_out);
    if (!data.known_variance.empty())
      data.known_variance.erase(data.known_variance.begin() + left_out);
    return {process.kernel(), process.hyperparameters(), data};
  }
} // namespace



TEST(GaussianProcess, gradients_agree_with_finite_differences)
{
  for (const KernelKind kernel : all_kernels)
    for (std::size_t n_inputs = 1; n_inputs <= 6; ++n_inputs)
      {
        TrainingData data      = sample(40, n_inputs, wavy);
        data.known_variance    = std::vector<double>(40, 1e-3);
        data.known_variance[7] = 0.1;
        Hyperparameters h;
        h.noise_variance = 1e-2;
        h.length_scales  = std::vector<double>(n_inputs, 0.7);
        const GaussianProcess process(kernel, h, data);

        const double step     = 1e-5;
        const auto   gradient = process.log_likelihood_gradient();
        ASSERT_EQ(gradient.size(), n_inputs + 2);
        for (std::size_t i = 0; i < n_inputs + 2; ++i)
          {
            const auto value = [&](const double change) {
              Hyperparameters changed = h;
              (i == 0            ? changed.signal_variance :
               i == n_inputs + 1 ? changed.noise_variance :
                                   changed.length_scales[i - 1]) *=
                std::exp(change);
              return GaussianProcess(kernel, changed, data).log_likelihood();
            };
            EXPECT_NEAR(gradient[i],
                        (value(step) - value(-step)) / (2. * step),
                        1e-6 * (1. + std::abs(gradient[i])));
          }

        std::vector<double> x = evenly_spread_point(777, n_inputs);
        std::vector<double> slope(n_inputs);
        double              variance;
        const double mean = process.evaluate(x.data(), &variance, slope.data());
        EXPECT_NEAR(mean, process.mean(x.data()), 1e-13);
        EXPECT_EQ(variance, process.variance(x.data()));
        for (std::size_t i = 0; i < n_inputs; ++i)
          {
            const double middle = x[i];
            x[i]                = middle + step;
            const double right  = process.mean(x.data());
            x[i]                = middle - step;
            const double left   = process.mean(x.data());
            x[i]                = middle;
            EXPECT_NEAR(slope[i], (right - left) / (2. * step), 1e-7);
          }
      }
}



// The Matern kernels are differentiable where r = 0.
TEST(GaussianProcess, gradient_exists_at_training_points)
{
  for (const KernelKind kernel : all_kernels)
    {
      const GaussianProcess process(kernel,
                                    three_inputs,
                                    sample(25, 3, smooth));
      std::vector<double>   x(process.data().x.begin(),
                            process.data().x.begin() + 3);
      std::vector<double>   gradient(3);
      double                variance;
      process.evaluate(x.data(), &variance, gradient.data());
      for (std::size_t i = 0; i < 3; ++i)
        {
          const double step = 1e-6, middle = x[i];
          x[i]               = middle + step;
          const double right = process.mean(x.data());
          x[i]               = middle - step;
          const double left  = process.mean(x.data());
          x[i]               = middle;
          EXPECT_NEAR(gradient[i], (right - left) / (2. * step), 1e-4);
        }
    }
}



TEST(GaussianProcess, leave_one_out_is_that_of_explicit_refits)
{
  for (const KernelKind kernel : all_kernels)
    {
      TrainingData data = sample(30, 2, wavy);
      for (std::size_t j = 0; j < 30; ++j)
        data.known_variance.push_back(1e-4 * j);
      const Hyperparameters h{1.2, {0.4, 0.6}, 1e-3};
      const GaussianProcess process(kernel, h, data);
      const auto            left_out = process.leave_one_out();
      ASSERT_EQ(left_out.size(), 30u);
      for (std::size_t j = 0; j < 30; ++j)
        {
          const GaussianProcess others = process_without(process, j);
          const double *const   x      = &data.x[2 * j];
          EXPECT_NEAR(left_out[j].mean, others.mean(x), 1e-10);
          EXPECT_NEAR(left_out[j].variance,
                      others.variance(x) + 1e-3 + data.known_variance[j],
                      1e-10);
        }
    }
}



TEST(GaussianProcess, batch_of_means_is_that_of_single_means)
{
  // more points than one block of the loops
  const GaussianProcess process(KernelKind::matern_5_2,
                                {1., {0.5, 0.6, 0.7}, 1e-4},
                                sample(600, 3, smooth));
  std::vector<double>   x;
  for (std::size_t j = 700; j < 800; ++j)
    for (const double xi : evenly_spread_point(j, 3))
      x.push_back(xi);
  std::vector<double> result(100);
  process.means(100, x.data(), result.data());
  for (std::size_t j = 0; j < 100; ++j)
    {
      EXPECT_EQ(result[j], process.mean(&x[3 * j]));
      EXPECT_NEAR(result[j],
                  smooth({x[3 * j], x[3 * j + 1], x[3 * j + 2]}),
                  2e-2);
    }
}



// Without noise the process goes through its points and is sure of them; far
// away it knows nothing.
TEST(GaussianProcess, interpolates_and_forgets)
{
  for (const KernelKind kernel : all_kernels)
    {
      const GaussianProcess process(kernel,
                                    {1.7, {0.5, 0.5, 0.5}, 0.},
                                    sample(20, 3, smooth));
      for (std::size_t j = 0; j < 20; ++j)
        {
          const double *const x = &process.data().x[3 * j];
          EXPECT_NEAR(process.mean(x), process.data().y[j], 1e-9);
          EXPECT_NEAR(process.variance(x), 0., 1e-9);
          EXPECT_GE(process.variance(x), 0.);
        }
      for (const double distance : {60., 1e10, 1e300})
        {
          const std::vector<double> far = {distance, -70., 80.};
          EXPECT_NEAR(process.mean(far.data()), 0., 1e-12);
          EXPECT_NEAR(process.variance(far.data()), 1.7, 1e-12);
        }
    }
}



// Two pairs 1e-9 apart, one of them with conflicting values. A process
// without noise cannot follow the conflict, yet it must neither fail nor hide
// that it was helped.
TEST(GaussianProcess, near_duplicates_are_survived_and_reported)
{
  for (const KernelKind kernel : all_kernels)
    {
      TrainingData data = sample(40, 3, smooth);
      for (const std::size_t j : {3, 17})
        {
          for (std::size_t i = 0; i < 3; ++i)
            data.x.push_back(data.x[3 * j + i] + 1e-9);
          data.y.push_back(data.y[j] + (j == 3 ? 0.2 : 0.));
        }
      const double *const   x = &data.x[9];
      const GaussianProcess without_noise(kernel, {1., {1., 1., 1.}, 0.}, data);
      EXPECT_GT(without_noise.jitter(), 0.);
      EXPECT_LT(without_noise.jitter(), 1e-9);
      EXPECT_TRUE(std::isfinite(without_noise.mean(x)));
      EXPECT_TRUE(std::isfinite(without_noise.variance(x)));
      for (const auto &left_out : without_noise.leave_one_out())
        EXPECT_TRUE(std::isfinite(left_out.mean) && left_out.variance > 0.);
    }
}



TEST(GaussianProcess, answers_not_a_number_with_the_same)
{
  const GaussianProcess     process(KernelKind::matern_5_2,
                                three_inputs,
                                sample(20, 3, smooth));
  const std::vector<double> x = {0.1,
                                 std::numeric_limits<double>::quiet_NaN(),
                                 0.3};
  std::vector<double>       gradient(3);
  EXPECT_TRUE(std::isnan(process.mean(x.data())));
  EXPECT_TRUE(std::isnan(process.variance(x.data())));
  double variance;
  EXPECT_TRUE(
    std::isnan(process.evaluate(x.data(), &variance, gradient.data())));
  for (const double derivative : gradient)
    EXPECT_TRUE(std::isnan(derivative));
}



TEST(GaussianProcess, wrong_data_are_refused)
{
  const auto message = [](const Hyperparameters &h, const TrainingData &data) {
    return message_of<InputError>(
      [&]() { GaussianProcess(KernelKind::rbf, h, data); });
  };
  TrainingData data = sample(5, 3, smooth);
  EXPECT_EQ(message({1., {1., 1.}, 0.}, data),
            "The hyperparameters of a Gaussian process must be a positive "
            "signal variance, 3 positive length scales and a noise variance "
            "that is not negative.");
  EXPECT_EQ(message({0., {1., 1., 1.}, 0.}, data).substr(0, 19),
            "The hyperparameters");
  EXPECT_EQ(message({1., {1., 1., 1.}, -1.}, data).substr(0, 19),
            "The hyperparameters");

  data.x[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message(three_inputs, data),
            "The training data of a Gaussian process contain a number that is "
            "not finite among the coordinates.");
  data                = sample(5, 3, smooth);
  data.known_variance = {0., 0., -1., 0., 0.};
  EXPECT_EQ(message(three_inputs, data),
            "A known variance of a Gaussian process is negative; it must be "
            "zero or positive.");
  data.known_variance = {1.};
  EXPECT_EQ(message(three_inputs, data),
            "The training data of a Gaussian process have 5 values, 15 "
            "coordinates and 1 known variances; at least one value, and for "
            "each of them 3 coordinates and one known variance or none are "
            "expected.");
}



// The variances are finite, their sum is not.
TEST(GaussianProcess, hopeless_matrix_is_reported)
{
  EXPECT_EQ(message_of<ComputationError>([]() {
              GaussianProcess(KernelKind::rbf,
                              {1e308, {1., 1., 1.}, 1e308},
                              sample(5, 3, smooth));
            }),
            "The covariance matrix of the 5 training points is not positive "
            "definite, even with 1e-4 of the signal variance added to its "
            "diagonal.");
}
