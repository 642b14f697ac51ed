#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/surrogate/design.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "../files.h"
#include "example_inputs.h"

using namespace asperity;

namespace
{
  /** Square of the L2 star discrepancy (Warnock 1972). */
  double
  star_discrepancy(const std::vector<double> &x, const unsigned int d)
  {
    const std::size_t n     = x.size() / d;
    double            first = 0., second = 0.;
    for (std::size_t i = 0; i < n; ++i)
      {
        double product = 1.;
        for (unsigned int k = 0; k < d; ++k)
          product *= 1. - x[i * d + k] * x[i * d + k];
        first += product;
        for (std::size_t j = 0; j < n; ++j)
          {
            product = 1.;
            for (unsigned int k = 0; k < d; ++k)
              product *= 1. - std::max(x[i * d + k], x[j * d + k]);
            second += product;
          }
      }
    return std::pow(3., -static_cast<double>(d)) -
           std::pow(2., 1. - static_cast<double>(d)) / n * first +
           second / n / n;
  }
} // namespace



TEST(Design, sobol_points_are_those_of_the_published_sequence)
{
  // Direction numbers v_j = m_j / 2^j of Bratley and Fox (1988), with
  // m_j = 2 m_{j-1} ^ m_{j-1} for x + 1 and
  // m_j = 2 m_{j-1} ^ 4 m_{j-2} ^ m_{j-2} for x^2 + x + 1; 1, 1, 7 in the last.
  // The first input is van der Corput's sequence, m_j = 1.
  // Antonov and Saleev: point i is point i - 1 with v_c added bit by bit, c the
  // lowest zero bit of i - 1.
  const std::vector<std::vector<unsigned int>> eighths = {{4, 2, 1},
                                                          {4, 6, 5},
                                                          {4, 2, 7}};
  std::vector<double>                          expected;
  std::vector<unsigned int>                    point(3, 0);
  for (const unsigned int c : {0, 1, 0, 2, 0, 1, 0})
    for (unsigned int k = 0; k < 3; ++k)
      {
        point[k] ^= eighths[k][c];
        expected.push_back(point[k] / 8.);
      }
  EXPECT_EQ(unit_sobol(7, 3), expected);
  EXPECT_EQ(unit_sobol(2, 3, 6),
            std::vector<double>(expected.begin() + 15, expected.end()));
}



TEST(Design, sobol_points_fill_the_cube_better_than_random_ones)
{
  const unsigned int n = 128, d = 3;
  double             random = 0.;
  for (unsigned int seed = 0; seed < 20; ++seed)
    random += star_discrepancy(unit_random(n, d, seed), d) / 20.;
  // The expectation for random points is (2^-d - 3^-d) / n.
  const double expectation = (1. / 8. - 1. / 27.) / n;
  EXPECT_NEAR(random, expectation, 0.5 * expectation);
  EXPECT_LT(star_discrepancy(unit_sobol(n, d), d), 0.1 * expectation);
}



TEST(Design, a_latin_hypercube_has_one_point_in_each_slice)
{
  const unsigned int n = 37, d = 4;
  const auto         x = unit_latin_hypercube(n, d, 5);
  ASSERT_EQ(x.size(), n * d);
  for (unsigned int k = 0; k < d; ++k)
    {
      std::set<int> slices;
      for (unsigned int i = 0; i < n; ++i)
        slices.insert(static_cast<int>(std::floor(x[i * d + k] * n)));
      EXPECT_EQ(slices.size(), n);
      EXPECT_EQ(*slices.begin(), 0);
      EXPECT_EQ(*slices.rbegin(), static_cast<int>(n) - 1);
    }
}



TEST(Design, the_seed_decides_the_random_designs)
{
  const auto inputs = example_inputs();
  for (const auto kind : {DesignKind::latin_hypercube, DesignKind::random})
    {
      const auto x = design_points(kind, 20, inputs, 42);
      EXPECT_EQ(x, design_points(kind, 20, inputs, 42));
      EXPECT_NE(x, design_points(kind, 20, inputs, 43));
    }
  for (const auto kind : {DesignKind::sobol, DesignKind::grid})
    EXPECT_EQ(design_points(kind, 4, inputs, 42),
              design_points(kind, 4, inputs, 43));
}



TEST(Design, a_grid_has_the_corners_of_the_box)
{
  const auto inputs = example_inputs();
  const auto x      = grid_points({10, 9, 10}, inputs);
  ASSERT_EQ(x.size(), 900u * 3u); // as the 900 runs of Lee (2025)
  std::set<std::vector<double>> points;
  for (unsigned int i = 0; i < 900; ++i)
    points.insert({x[3 * i], x[3 * i + 1], x[3 * i + 2]});
  EXPECT_EQ(points.size(), 900u);
  for (const double p : {inputs[0].lower, inputs[0].upper})
    for (const double v : {inputs[1].lower, inputs[1].upper})
      for (const double T : {inputs[2].lower, inputs[2].upper})
        EXPECT_EQ(points.count({p, v, T}), 1u);
  // the last input varies fastest; the second value of ten
  EXPECT_EQ(x[0], inputs[0].lower);
  EXPECT_NEAR(x[5], 298.15 + 875. / 9., 1e-10);
  EXPECT_EQ(unit_grid({1, 2}), (std::vector<double>{0.5, 0., 0.5, 1.}));
}



TEST(Design, a_logarithmic_scale_has_equal_ratios)
{
  const auto   inputs = example_inputs();
  const auto   x      = grid_points({1, 4, 1}, inputs);
  const double ratio  = std::cbrt(200. / 22.5);
  for (unsigned int i = 0; i + 1 < 4; ++i)
    EXPECT_NEAR(x[3 * (i + 1) + 1] / x[3 * i + 1], ratio, 1e-14 * ratio);
  EXPECT_NEAR(x[0], 800e6, 1e-6);

  const auto unit = unit_sobol(50, 3);
  const auto back = map_to_unit(inputs, map_to_box(inputs, unit));
  for (unsigned int i = 0; i < unit.size(); ++i)
    EXPECT_NEAR(back[i], unit[i], 1e-14);
  EXPECT_NEAR(unit_coordinate(inputs[1],
                              std::sqrt(inputs[1].lower * inputs[1].upper)),
              0.5,
              1e-15);
}



TEST(Design, wrong_boxes_and_numbers_are_refused_by_name)
{
  auto inputs     = example_inputs();
  inputs[1].lower = -1.;
  auto message    = message_of<InputError>(
    [&]() { design_points(DesignKind::sobol, 4, inputs, 0); });
  EXPECT_NE(message.find("Load/Velocity"), std::string::npos);
  EXPECT_NE(message.find("logarithmic"), std::string::npos);
  inputs[1].lower = inputs[1].upper;
  message         = message_of<InputError>(
    [&]() { design_points(DesignKind::random, 4, inputs, 0); });
  EXPECT_NE(message.find("Load/Velocity"), std::string::npos);
  EXPECT_NE(message.find("not empty"), std::string::npos);

  EXPECT_THROW(unit_sobol(4, 41), InputError);
  EXPECT_THROW(unit_grid({2, 0}), InputError);
  EXPECT_THROW(unit_grid({1000, 1000, 2}), InputError);
  EXPECT_THROW(grid_points({2, 2}, example_inputs()), InputError);
  EXPECT_THROW(design_points(DesignKind::sobol, 4, {}, 0), InputError);
}
