#include <asperity/learning/adam.h>
#include <asperity/learning/loss.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace asperity;



TEST(Adam, takes_the_steps_of_its_formulas)
{
  // gradients 3, then -1: m_1 = 0.3, v_1 = 0.009, m_2 = 0.17, v_2 = 0.009991;
  // divided by 1 - beta^t they are 3, 9 and 0.17/0.19, 0.009991/0.001999
  Adam<double>        adam(1);
  std::vector<double> x = {2.};
  adam.step({3.}, 0.5, x);
  EXPECT_NEAR(x[0], 2. - 0.5 * 3. / (3. + 1e-8), 1e-14);
  const double after_one = x[0];
  adam.step({-1.}, 0.25, x);
  EXPECT_NEAR(x[0],
              after_one -
                0.25 * (0.17 / 0.19) / (std::sqrt(0.009991 / 0.001999) + 1e-8),
              1e-13);
}



TEST(Adam, finds_the_bottom_of_a_narrow_valley)
{
  // (x - 3)^2 + 1e4 (y + 2)^2: steps are as long in both directions
  Adam<float>        adam(2);
  std::vector<float> x = {0.f, 0.f};
  for (unsigned int i = 0; i < 3000; ++i)
    adam.step({2.f * (x[0] - 3.f), 2e4f * (x[1] + 2.f)},
              0.05 * std::pow(0.5, i / 300),
              x);
  EXPECT_NEAR(x[0], 3., 1e-3);
  EXPECT_NEAR(x[1], -2., 1e-3);
}



TEST(LearningRate, is_halved_at_intervals)
{
  const LearningRate rate{8e-4, 0.5, 500};
  EXPECT_EQ(rate.at(0), 8e-4);
  EXPECT_EQ(rate.at(499), 8e-4);
  EXPECT_EQ(rate.at(500), 4e-4);
  EXPECT_EQ(rate.at(1999), 1e-4);
}



TEST(Loss, of_distances_is_clamped)
{
  const Loss               loss; // clamped at 0.1
  const std::vector<float> f = {0.05f, 0.5f, -0.3f, 0.02f, 0.2f};
  const std::vector<float> y = {0.02f, 0.3f, -0.05f, 0.7f, 0.04f};
  std::vector<float>       gradient(5);
  // |0.05 - 0.02| + 0 + |-0.3 + 0.05| + |0.02 - 0.1| + |0.2 - 0.04|
  EXPECT_NEAR(loss.evaluate(5, f.data(), y.data(), 2.f, gradient.data()),
              0.03 + 0. + 0.25 + 0.08 + 0.16,
              1e-7);
  // an output on the right side of the clamp is as good as any other there
  EXPECT_EQ(gradient, std::vector<float>({2.f, 0.f, -2.f, -2.f, 2.f}));
  const float below = -0.7f, above = 0.3f, inside = -0.2f;
  EXPECT_EQ(loss.evaluate(1, &below, &inside, 1.f, gradient.data()), 0.);
  EXPECT_EQ(gradient[0], 0.f);
  EXPECT_NEAR(loss.evaluate(1, &above, &inside, 1.f, gradient.data()),
              0.4,
              1e-7);
  EXPECT_EQ(gradient[0], 1.f);
}



TEST(Loss, of_fields_is_the_squared_error)
{
  Loss loss;
  loss.kind                  = Loss::Kind::squared;
  const std::vector<float> f = {1.f, -2.f}, y = {0.5f, 1.f};
  std::vector<float>       gradient(2);
  EXPECT_NEAR(loss.evaluate(2, f.data(), y.data(), 0.5f, gradient.data()),
              0.25 + 9.,
              1e-6);
  EXPECT_EQ(gradient, std::vector<float>({0.5f, -3.f}));
}
