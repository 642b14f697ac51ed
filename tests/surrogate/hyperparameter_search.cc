#include <asperity/surrogate/hyperparameter_search.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sample_data.h"

using namespace asperity;

namespace
{
  double
  kinked(const std::vector<double> &x)
  {
    return std::abs(x[0] - 0.4) + 0.2 * x[1];
  }

  double
  without_third_input(const std::vector<double> &x)
  {
    return std::sin(4. * x[0]) + std::cos(3. * x[1]);
  }
} // namespace



// At the maximum every derivative vanishes that is not held by a bound.
TEST(HyperparameterSearch, ends_where_the_gradient_vanishes)
{
  std::mt19937               generator(1);
  std::normal_distribution<> noise(0., 0.05);
  TrainingData               data = sample(80, 2, kinked);
  for (double &y : data.y)
    y += noise(generator);
  for (const KernelKind kernel : all_kernels)
    {
      const auto            found = find_hyperparameters(kernel, data);
      const GaussianProcess process(kernel, found.hyperparameters, data);
      EXPECT_NEAR(found.log_likelihood, process.log_likelihood(), 1e-6);
      for (const double derivative : process.log_likelihood_gradient())
        EXPECT_NEAR(derivative, 0., 0.02);
      // the scatter of the values
      EXPECT_NEAR(std::sqrt(found.hyperparameters.noise_variance), 0.05, 0.01);
    }
}



TEST(HyperparameterSearch, is_deterministic)
{
  const TrainingData data  = sample(40, 3, without_third_input);
  const auto         first = find_hyperparameters(KernelKind::rbf, data),
             second        = find_hyperparameters(KernelKind::rbf, data);
  EXPECT_EQ(first.log_likelihood, second.log_likelihood);
  EXPECT_EQ(first.hyperparameters.length_scales,
            second.hyperparameters.length_scales);
}



TEST(HyperparameterSearch, input_without_influence_is_told)
{
  const auto found = find_hyperparameters(KernelKind::matern_5_2,
                                          sample(60, 3, without_third_input));
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_EQ(found.warnings[0],
            "The length scale of input 3 is at its upper bound: the values "
            "hardly depend on this input, or in a straight line.");
}



TEST(HyperparameterSearch, pure_noise_is_told)
{
  std::mt19937               generator(1);
  std::normal_distribution<> noise(0., 1.);
  const auto                 found =
    find_hyperparameters(KernelKind::rbf,
                         sample(200, 1, [&](const std::vector<double> &) {
                           return noise(generator);
                         }));
  // either all is noise, or a length scale below the spacing of the points is
  // the same thing
  EXPECT_FALSE(found.warnings.empty());
}



// More restarts never find less, and the coarse start on a subset ends at the
// same place as the search on all points.
TEST(HyperparameterSearch, subset_leads_to_the_same_maximum)
{
  const TrainingData          data = sample(300, 2, kinked);
  HyperparameterSearchOptions all, few;
  all.subset_size     = 1000;
  all.n_restarts      = 2;
  few.subset_size     = 100;
  const auto with_all = find_hyperparameters(KernelKind::matern_3_2, data, all),
             with_few = find_hyperparameters(KernelKind::matern_3_2, data, few);
  EXPECT_NEAR(with_few.log_likelihood, with_all.log_likelihood, 0.1);
  EXPECT_LT(with_few.n_evaluations, with_all.n_evaluations / 2);
}



// A pair of points 1e-9 apart with conflicting values makes noise likely,
// not the process wild.
TEST(HyperparameterSearch, conflicting_pair_is_taken_for_noise)
{
  TrainingData data = sample(60, 3, without_third_input);
  for (std::size_t i = 0; i < 3; ++i)
    data.x.push_back(data.x[9 + i] + 1e-9);
  data.y.push_back(data.y[3] + 0.2);
  for (const KernelKind kernel : all_kernels)
    {
      const auto            found = find_hyperparameters(kernel, data);
      const GaussianProcess process(kernel, found.hyperparameters, data);
      EXPECT_EQ(process.jitter(), 0.);
      const double deviation = std::sqrt(found.hyperparameters.noise_variance);
      EXPECT_GT(deviation, 0.01);
      EXPECT_LT(deviation, 0.1);
      EXPECT_NEAR(process.mean(&data.x[9]), data.y[3] + 0.1, 0.1);
      for (std::size_t j = 100; j < 200; ++j)
        {
          const std::vector<double> x = evenly_spread_point(j, 3);
          EXPECT_NEAR(process.mean(x.data()), without_third_input(x), 0.2);
        }
    }
}



TEST(HyperparameterSearch, constant_and_single_input_data)
{
  const auto zero =
    find_hyperparameters(KernelKind::matern_5_2,
                         sample(10, 2, [](const auto &) { return 0.; }));
  EXPECT_TRUE(std::isfinite(zero.log_likelihood));

  // all points share their second coordinate
  TrainingData data = sample(20, 2, kinked);
  for (std::size_t j = 0; j < 20; ++j)
    data.x[2 * j + 1] = 0.5;
  const auto found = find_hyperparameters(KernelKind::matern_5_2, data);
  EXPECT_TRUE(std::isfinite(found.log_likelihood));
}
