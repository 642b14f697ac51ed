#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learning/orthogonal_decomposition.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../files.h"

using namespace asperity;

namespace
{
  std::vector<double>
  normal_vector(const std::size_t n, RandomNumbers &random)
  {
    std::vector<double> result(n);
    for (double &x : result)
      x = random.normal();
    return result;
  }

  std::vector<double>
  snapshot(const std::vector<double> &snapshots,
           const std::size_t          size,
           const std::size_t          i)
  {
    return {snapshots.begin() + i * size, snapshots.begin() + (i + 1) * size};
  }

  /** Sum over the snapshots of the squared errors with n modes, one by one. */
  double
  squared_error(const OrthogonalDecomposition &pod,
                const std::vector<double>     &snapshots,
                const std::vector<double>     &weights,
                const std::size_t              n)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < snapshots.size() / pod.size(); ++i)
      {
        const auto s = snapshot(snapshots, pod.size(), i);
        const auto r = pod.reconstruct(pod.project(s, n));
        for (std::size_t k = 0; k < s.size(); ++k)
          sum += weights[k] * (s[k] - r[k]) * (s[k] - r[k]);
      }
    return sum;
  }
} // namespace



TEST(OrthogonalDecomposition, is_exact_for_data_of_low_rank)
{
  // combinations of two fields
  const std::size_t   size = 30, n = 12;
  RandomNumbers       random(3);
  const auto          a = normal_vector(size, random);
  const auto          b = normal_vector(size, random);
  std::vector<double> snapshots;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < size; ++k)
      snapshots.push_back(4. + std::cos(i) * a[k] + std::sin(i) * b[k]);
  const OrthogonalDecomposition pod(snapshots, n);
  ASSERT_EQ(pod.n_modes(), n);
  EXPECT_GT(pod.singular_values()[1], 1.);
  EXPECT_LT(pod.singular_values()[2], 1e-13 * pod.singular_values()[0]);
  EXPECT_LT(pod.truncation_error(2), 1e-12 * pod.singular_values()[0]);
  EXPECT_LT(std::sqrt(
              squared_error(pod, snapshots, std::vector<double>(size, 1.), 2)),
            1e-12);
}



TEST(OrthogonalDecomposition, has_the_error_of_eckart_and_young)
{
  const std::size_t   size = 40, n = 15;
  RandomNumbers       random(8);
  const auto          snapshots = normal_vector(size * n, random);
  std::vector<double> weights(size);
  for (double &w : weights)
    w = 0.1 + random.uniform();
  const OrthogonalDecomposition pod(snapshots, n, weights);

  // all modes together have the squares of all deviations
  double              total = 0.;
  std::vector<double> mean(size, 0.);
  for (std::size_t i = 0; i < size * n; ++i)
    mean[i % size] += snapshots[i] / n;
  for (std::size_t i = 0; i < size * n; ++i)
    total += weights[i % size] * std::pow(snapshots[i] - mean[i % size], 2);
  EXPECT_NEAR(std::pow(pod.truncation_error(0), 2), total, 1e-10 * total);

  for (const std::size_t n_modes : {0, 1, 4, 9})
    EXPECT_NEAR(squared_error(pod, snapshots, weights, n_modes),
                std::pow(pod.truncation_error(n_modes), 2),
                1e-10 * total);

  // modes are orthonormal in the inner product
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < 5; ++j)
      {
        double product = 0.;
        for (std::size_t k = 0; k < size; ++k)
          product += weights[k] * pod.mode(i)[k] * pod.mode(j)[k];
        EXPECT_NEAR(product, i == j, 1e-12);
      }
}



TEST(OrthogonalDecomposition, has_the_singular_values_of_a_matrix_by_hand)
{
  // deviations (3, 0), (-3, 0), (0, 2), (0, -2) from the mean (1, 5)
  const OrthogonalDecomposition pod({4., 5., -2., 5., 1., 7., 1., 3.}, 4);
  ASSERT_EQ(pod.n_modes(), 2u);
  EXPECT_NEAR(pod.mean()[0], 1., 1e-14);
  EXPECT_NEAR(pod.mean()[1], 5., 1e-14);
  EXPECT_NEAR(pod.singular_values()[0], std::sqrt(18.), 1e-13);
  EXPECT_NEAR(pod.singular_values()[1], std::sqrt(8.), 1e-13);
  EXPECT_NEAR(std::abs(pod.mode(0)[0]), 1., 1e-14);
}



TEST(OrthogonalDecomposition, refuses_what_is_no_snapshots)
{
  EXPECT_EQ(message_of<InputError>([]() {
              OrthogonalDecomposition({1., 2., 3.}, 2);
            }),
            "3 numbers are not 2 snapshots of one length.");
  EXPECT_EQ(message_of<InputError>([]() {
              OrthogonalDecomposition({1., NAN}, 2);
            }),
            "A snapshot has a value that is no number.");
  EXPECT_EQ(message_of<InputError>([]() {
              OrthogonalDecomposition({1., 2.}, 1, {1., 0.});
            }),
            "Snapshots need a positive weight for each of their values.");
  const OrthogonalDecomposition pod({1., 2., 3., 4.}, 2);
  EXPECT_EQ(message_of<InputError>([&]() { pod.project({1.}, 1); }),
            "A field of 1 values cannot be projected on 1 of 2 modes of 2.");
}
