#include <asperity/lubricant/pocket_extent.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{
  using namespace asperity;

  constexpr double S = 10.;
} // namespace



TEST(FindPockets, crossings_are_those_of_the_piecewise_linear_gap)
{
  const auto pockets =
    find_pockets({0., 2., 3., 5., 6., 8.}, {0., 2., -1., 4., .5, 1.}, S, 1.);
  // Seals: around 8 .. 10 .. 0 (smallest at 0), at 3, and at 6 to 8.
  ASSERT_EQ(pockets.size(), 2u);
  EXPECT_DOUBLE_EQ(pockets[0].open.begin, 1.);
  EXPECT_DOUBLE_EQ(pockets[0].open.end, 2. + 1. / 3.);
  EXPECT_DOUBLE_EQ(pockets[0].domain.begin, 0.);
  EXPECT_DOUBLE_EQ(pockets[0].domain.end, 3.);
  EXPECT_DOUBLE_EQ(pockets[1].open.begin, 3. + 2. * 2. / 5.);
  EXPECT_DOUBLE_EQ(pockets[1].open.end, 5. + 3. / 3.5);
  EXPECT_DOUBLE_EQ(pockets[1].domain.begin, 3.);
  EXPECT_DOUBLE_EQ(pockets[1].domain.end, 10.);
}



TEST(FindPockets, a_pocket_may_wrap_around_the_period)
{
  const auto pockets =
    find_pockets({1., 3., 5., 7., 9.}, {2., 0., 0., 0., 2.}, S, 1.);
  ASSERT_EQ(pockets.size(), 1u);
  EXPECT_DOUBLE_EQ(pockets[0].open.begin, 8.);
  EXPECT_DOUBLE_EQ(pockets[0].open.end, 12.);
  // the smallest gap is that of three samples: the middle one
  EXPECT_DOUBLE_EQ(pockets[0].domain.begin, 5.);
  EXPECT_DOUBLE_EQ(pockets[0].domain.end, 15.);
}



TEST(FindPockets, without_seal_the_pocket_is_the_period)
{
  const auto pockets = find_pockets({1., 3., 5.}, {2., 1.5, 3.}, S, 1.);
  ASSERT_EQ(pockets.size(), 1u);
  EXPECT_EQ(pockets[0].open.begin, 0.);
  EXPECT_EQ(pockets[0].open.end, S);
  EXPECT_EQ(pockets[0].domain.length(), S);
  EXPECT_TRUE(find_pockets({1., 3., 5.}, {1., .5, -3.}, S, 1.).empty());
}



TEST(FindPockets, domains_partition_the_edge)
{
  std::mt19937                           random(3);
  std::uniform_real_distribution<double> uniform(0., 1.);
  for (unsigned int trial = 0; trial < 200; ++trial)
    {
      std::vector<double> s, gaps;
      for (unsigned int i = 0; i < 40; ++i)
        {
          s.push_back(S * (i + .9 * uniform(random)) / 40.);
          gaps.push_back(uniform(random));
        }
      const auto pockets = find_pockets(s, gaps, S, .2 + .6 * uniform(random));
      double     sum     = 0.;
      for (unsigned int i = 0; i < pockets.size(); ++i)
        {
          const PocketExtent &pocket = pockets[i];
          const PocketExtent &next   = pockets[(i + 1) % pockets.size()];
          sum += pocket.domain.length();
          EXPECT_NEAR(std::remainder(next.domain.begin - pocket.domain.end, S),
                      0.,
                      1e-14);
          EXPECT_NEAR(overlap(pocket.open, pocket.domain, S),
                      pocket.open.length(),
                      1e-14);
          EXPECT_EQ(pocket_at(pockets, pocket.domain.begin, S), i);
          EXPECT_EQ(pocket_at(pockets,
                              pocket.open.begin + .5 * pocket.open.length(),
                              S),
                    i);
        }
      EXPECT_NEAR(sum, pockets.empty() ? 0. : S, 1e-13);
    }
}
