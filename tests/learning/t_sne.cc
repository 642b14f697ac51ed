#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learning/t_sne.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "../files.h"

using namespace asperity;

namespace
{
  /** Normal clouds around corners of a simplex in five coordinates, one after
   *  the other. */
  std::vector<double>
  clouds(const unsigned int n_clouds, const unsigned int n_each)
  {
    RandomNumbers       random(1);
    std::vector<double> result;
    for (unsigned int i = 0; i < n_clouds * n_each; ++i)
      for (unsigned int c = 0; c < 5; ++c)
        result.push_back((c == i / n_each ? 6. : 0.) + random.normal());
    return result;
  }
} // namespace



TEST(NeighbourProbabilities, of_points_at_equal_distances_are_equal)
{
  // five unit vectors; every perplexity is that of all four others
  std::vector<double> points(25, 0.);
  for (unsigned int i = 0; i < 5; ++i)
    points[6 * i] = 1.;
  const auto p = neighbour_probabilities(points, 5, 1.5);
  for (unsigned int i = 0; i < 5; ++i)
    for (unsigned int j = 0; j < 5; ++j)
      EXPECT_NEAR(p[5 * i + j], i == j ? 0. : 1. / 20., 1e-15);
}



TEST(NeighbourProbabilities, have_the_perplexity_that_is_asked_for)
{
  // on a circle all points are alike, so that p_j|i = n p_ij
  const unsigned int  n = 40;
  std::vector<double> points;
  for (unsigned int i = 0; i < n; ++i)
    for (const double x :
         {std::cos(2. * M_PI * i / n), std::sin(2. * M_PI * i / n)})
      points.push_back(x);
  const auto p       = neighbour_probabilities(points, 2, 7.);
  double     entropy = 0.;
  for (unsigned int j = 1; j < n; ++j)
    entropy -= n * p[j] * std::log(n * p[j]);
  EXPECT_NEAR(std::exp(entropy), 7., 1e-6);
  EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.), 1., 1e-12);
}



TEST(EmbeddingDivergence, has_the_gradient_of_differences)
{
  const auto          points = clouds(2, 8);
  const auto          p      = neighbour_probabilities(points, 5, 4.);
  RandomNumbers       random(2);
  std::vector<double> places(32), gradient;
  for (double &y : places)
    y = random.normal();
  embedding_divergence(p, places, &gradient);
  for (unsigned int i = 0; i < places.size(); ++i)
    {
      const double h = 1e-5, old = places[i];
      places[i]         = old + h;
      const double up   = embedding_divergence(p, places);
      places[i]         = old - h;
      const double down = embedding_divergence(p, places);
      places[i]         = old;
      EXPECT_NEAR(gradient[i], (up - down) / (2. * h), 1e-9);
    }
}



TEST(Embedding, keeps_clouds_together_and_apart)
{
  const unsigned int n_each = 40, n = 4 * n_each;
  EmbeddingOptions   options;
  options.perplexity = 15.;
  options.n_steps    = 400;
  const auto places  = embed_in_plane(clouds(4, n_each), 5, options);
  // the five nearest of each point are of its own cloud
  unsigned int n_wrong = 0;
  for (unsigned int i = 0; i < n; ++i)
    {
      std::vector<std::pair<double, unsigned int>> others;
      for (unsigned int j = 0; j < n; ++j)
        if (j != i)
          others.emplace_back(std::hypot(places[2 * i] - places[2 * j],
                                         places[2 * i + 1] - places[2 * j + 1]),
                              j);
      std::partial_sort(others.begin(), others.begin() + 5, others.end());
      for (unsigned int k = 0; k < 5; ++k)
        n_wrong += others[k].second / n_each != i / n_each;
    }
  // of 800; clouds six deviations apart touch at their rims
  EXPECT_LE(n_wrong, 8u);
}



TEST(NeighbourProbabilities, refuse_a_perplexity_of_too_many)
{
  EXPECT_EQ(message_of<InputError>([]() {
              neighbour_probabilities({1., 2., 3., 4.}, 1, 2.);
            }),
            "A picture of 4 codes needs a perplexity from 1 to less than a "
            "third of their number.");
}
