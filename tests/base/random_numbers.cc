#include <asperity/base/random_numbers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

using namespace asperity;

TEST(RandomNumbers, follow_the_generator_of_the_standard)
{
  // [rand.predef]: the 10000th number of a default-constructed mt19937_64
  std::mt19937_64 reference;
  reference.discard(9999);
  EXPECT_EQ(reference(), 9981545732273789042ull);
  // and ours are its leading 53 bits
  RandomNumbers random(std::mt19937_64::default_seed);
  for (unsigned int i = 0; i < 9999; ++i)
    random.uniform();
  EXPECT_EQ(random.uniform(), (9981545732273789042ull >> 11) * 0x1p-53);
}



TEST(RandomNumbers, permutations_are_uniform)
{
  RandomNumbers         random(3);
  std::vector<unsigned> count(4 * 4, 0);
  const unsigned int    n_draws = 20000;
  for (unsigned int draw = 0; draw < n_draws; ++draw)
    {
      const auto order = random.permutation(4);
      ASSERT_EQ(std::set<std::size_t>(order.begin(), order.end()).size(), 4u);
      for (unsigned int i = 0; i < 4; ++i)
        ++count[4 * i + order[i]];
    }
  // five standard deviations of a binomial distribution
  const double tolerance = 5. * std::sqrt(n_draws * 0.25 * 0.75);
  for (const unsigned int c : count)
    EXPECT_NEAR(c, n_draws / 4., tolerance);
}



TEST(RandomNumbers, normal_ones_have_the_moments_of_their_distribution)
{
  RandomNumbers      random(4);
  const unsigned int n     = 40000;
  double             first = 0., second = 0., fourth = 0.;
  for (unsigned int i = 0; i < n; ++i)
    {
      const double x = random.normal();
      first += x / n;
      second += x * x / n;
      fourth += x * x * x * x / n;
    }
  // x, x^2 and x^4 have the variances 1, 2 and 96; five standard deviations
  EXPECT_NEAR(first, 0., 5. * std::sqrt(1. / n));
  EXPECT_NEAR(second, 1., 5. * std::sqrt(2. / n));
  EXPECT_NEAR(fourth, 3., 5. * std::sqrt(96. / n));
}
