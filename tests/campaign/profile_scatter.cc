#include <asperity/campaign/profile_scatter.h>
#include <asperity/surrogate/friction_law.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace asperity;

// y_ik = y_i (1 + b_k + e_ik), where e_ik = c_i d_k has zero means over i and
// k.
TEST(ProfileScatter, tells_factors_from_the_rest)
{
  const double   b[] = {-0.3, 0.1, 0.2}, d[] = {1., -2., 1.};
  const double   c[] = {0.01, -0.03, 0.02, 0.};
  ProfileScatter scatter(3);
  for (unsigned int i = 0; i < 4; ++i)
    {
      std::vector<double> values;
      for (unsigned int k = 0; k < 3; ++k)
        values.push_back((1. + i) * (1. + b[k] + c[i] * d[k]));
      scatter.add(values);
    }
  scatter.add({1., 0., -1.}); // no mean, no relative deviation
  for (unsigned int k = 0; k < 3; ++k)
    EXPECT_NEAR(scatter.factor(k), 1. + b[k], 1e-14);
  // sum of c^2 times sum of d^2 over (4 - 1) (3 - 1)
  EXPECT_NEAR(scatter.beyond_factor(), std::sqrt(14e-4 * 6. / 6.), 1e-14);
  // sum of b^2 over 3 - 1, and the rest over 4 (3 - 1)
  EXPECT_NEAR(scatter.total(), std::sqrt(0.14 / 2. + 14e-4 * 6. / 8.), 1e-14);
}



TEST(ProfileScatter, one_profile_has_no_scatter)
{
  ProfileScatter scatter(1);
  scatter.add({0.1});
  EXPECT_EQ(scatter.total(), 0.);
  EXPECT_EQ(scatter.beyond_factor(), 0.);
  EXPECT_EQ(scatter.mean({0.2})->mean, 0.2);
  EXPECT_FALSE(scatter.mean({{}}));
}



TEST(ProfileScatter, needs_a_whole_point_to_fill_gaps)
{
  ProfileScatter scatter(2);
  EXPECT_FALSE(scatter.mean({0.1, {}}));
  EXPECT_EQ(scatter.mean({0.1, 0.3})->mean, 0.2);
  EXPECT_EQ(scatter.mean({0.1, 0.3})->deviation, 0.);
  scatter.add({1., 3.});
  EXPECT_DOUBLE_EQ(scatter.mean({0.1, {}})->mean, 0.2);
  EXPECT_DOUBLE_EQ(scatter.mean({{}, 0.3})->mean, 0.2);
}



// The errors of means with gaps are as large as their deviations say.
TEST(ProfileScatter, knows_the_error_of_a_mean_with_gaps)
{
  constexpr unsigned int     n_profiles = 5, n_points = 2000;
  std::mt19937               generator(1);
  std::normal_distribution<> random(0., 1.);
  const double               b[]    = {-0.2, -0.1, 0., 0.1, 0.2};
  const auto                 values = [&]() {
    std::vector<double> result;
    for (const double b_k : b)
      result.push_back(0.1 * (1. + b_k + 0.05 * random(generator)));
    return result;
  };
  ProfileScatter scatter(n_profiles);
  for (unsigned int i = 0; i < n_points; ++i)
    scatter.add(values());

  for (const unsigned int n : {1, 2, 4})
    {
      double square = 0.;
      for (unsigned int i = 0; i < n_points; ++i)
        {
          const std::vector<double>          all = values();
          std::vector<std::optional<double>> some(n_profiles);
          double                             mean = 0.;
          for (const double value : all)
            mean += value / n_profiles;
          for (unsigned int k = 0; k < n; ++k)
            some[(k + i) % n_profiles] = all[(k + i) % n_profiles];
          const ProfileMean found = *scatter.mean(some);
          square += std::pow((found.mean - mean) / found.deviation, 2);
        }
      EXPECT_NEAR(std::sqrt(square / n_points), 1., 0.05) << n;
    }
}



// Student's 97.5 % quantile for two degrees of freedom is 4.302652729696142
// (tables); on a logarithmic scale intervals are factors.
TEST(ProfileScatter, widens_the_interval_of_the_whole_surface)
{
  std::vector<double> x, y;
  for (unsigned int i = 0; i < 8; ++i)
    {
      x.push_back(i / 7.);
      y.push_back(0.2 + 0.1 * std::sin(3. * x.back()));
    }
  for (const Scale scale : {Scale::logarithmic, Scale::linear})
    {
      FrictionLawDescription description;
      description.inputs        = {{"Load/Pressure", "p", "Pa", 0., 1.}};
      description.output_scale  = scale;
      const double        place = 0.4;
      const LawPrediction of_one =
        FrictionLaw::train(description, x, y).predict(&place);
      EXPECT_EQ(of_one.surface_lower, of_one.lower);
      EXPECT_EQ(of_one.surface_upper, of_one.upper);

      description.n_profiles         = 3;
      description.topography_scatter = 0.03;
      const FrictionLaw   law        = FrictionLaw::train(description, x, y);
      const LawPrediction at         = law.predict(&place);
      const double        error      = 4.302652729696142 * 0.03 / std::sqrt(3.);
      EXPECT_NEAR(law.description().topography_error, error, 1e-9);
      EXPECT_EQ(at.lower, of_one.lower);
      EXPECT_EQ(at.upper, of_one.upper);
      const auto half = [&](const double end) {
        return scale == Scale::logarithmic ? std::abs(std::log(end / at.mean)) :
                                             std::abs(end / at.mean - 1.);
      };
      EXPECT_NEAR(half(at.surface_upper),
                  std::hypot(half(at.upper), error),
                  1e-8);
      EXPECT_NEAR(half(at.surface_lower),
                  std::hypot(half(at.lower), error),
                  1e-8);
    }
}
