#include <asperity/base/errors.h>
#include <asperity/surrogate/active_learning.h>
#include <asperity/surrogate/design.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../files.h"
#include "example_inputs.h"
#include "friction_like_functions.h"

using namespace asperity;

namespace
{
  FrictionLaw
  train(const friction_like::Function function, const std::vector<double> &x)
  {
    FrictionLawDescription description;
    description.inputs = example_inputs();
    return FrictionLaw::train(description,
                              x,
                              friction_like::values(function, x));
  }

  FrictionLaw
  example_law(const unsigned int n = 30)
  {
    return train(friction_like::kinked,
                 design_points(DesignKind::sobol, n, example_inputs(), 0));
  }

  /** The process of a law that has been told further points (unit cube) and
   *  believes that their values are what it predicts. */
  GaussianProcess
  told(const FrictionLaw &law, const std::vector<double> &points)
  {
    TrainingData data = law.process().data();
    for (std::size_t i = 0; i < points.size(); i += 3)
      data.y.push_back(law.process().mean(&points[i]));
    data.x.insert(data.x.end(), points.begin(), points.end());
    return {law.process().kernel(), law.process().hyperparameters(), data};
  }

  double
  distance(const double *a, const double *b)
  {
    return std::sqrt(std::pow(a[0] - b[0], 2) + std::pow(a[1] - b[1], 2) +
                     std::pow(a[2] - b[2], 2));
  }

  double
  smallest_distance(const std::vector<double> &a, const std::vector<double> &b)
  {
    double smallest = 1e300;
    for (std::size_t i = 0; i < a.size(); i += 3)
      for (std::size_t j = 0; j < b.size(); j += 3)
        if (&a != &b || i != j)
          smallest = std::min(smallest, distance(&a[i], &b[j]));
    return smallest;
  }

  double
  mean_variance(const GaussianProcess     &process,
                const std::vector<double> &points)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < points.size(); i += 3)
      sum += process.variance(&points[i]);
    return sum / (points.size() / 3);
  }

  std::vector<double>
  unit_points(const std::vector<double> &x)
  {
    return map_to_unit(example_inputs(), x);
  }

  /** Starts with Sobol points and adds batches. */
  FrictionLaw
  learn(const friction_like::Function function,
        const std::size_t             n_start,
        const std::size_t             n_batch,
        const std::size_t             n,
        const ActiveLearningOptions  &options = {})
  {
    std::vector<double> x =
      design_points(DesignKind::sobol, n_start, example_inputs(), 0);
    FrictionLaw law = train(function, x);
    while (x.size() < 3 * n)
      {
        const auto next = next_points(law, {}, n_batch, options);
        x.insert(x.end(), next.begin(), next.end());
        law = train(function, x);
      }
    return law;
  }

  /** Mean relative error at points in SI units. */
  double
  error_of(const FrictionLaw            &law,
           const friction_like::Function function,
           const std::vector<double>    &x)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < x.size(); i += 3)
      sum += std::abs(law.mean(&x[i]) / function(&x[i]) - 1.);
    return sum / (x.size() / 3);
  }

  std::vector<double>
  random_points()
  {
    return design_points(DesignKind::random, 1000, example_inputs(), 99);
  }

  /** Random points, each moved to one of the six faces of the box. */
  std::vector<double>
  points_on_faces()
  {
    std::vector<double> unit = unit_random(1002, 3, 7);
    for (std::size_t i = 0; i < 1002; ++i)
      unit[3 * i + i % 3] = i / 3 % 2;
    return map_to_box(example_inputs(), unit);
  }
} // namespace



TEST(ActiveLearning, makes_the_law_surest_on_average)
{
  const FrictionLaw     law = example_law();
  ActiveLearningOptions options;
  options.n_candidates  = 64;
  options.n_references  = 32;
  const auto points     = unit_points(next_points(law, {}, 4, options));
  const auto candidates = unit_sobol(64, 3), references = unit_sobol(32, 3);
  ASSERT_EQ(points.size(), 12u);
  for (std::size_t i = 0; i < 12; i += 3)
    {
      std::vector<double> known(points.begin(), points.begin() + i + 3);
      const double        chosen = mean_variance(told(law, known), references);
      for (std::size_t j = 0; j < candidates.size(); j += 3)
        {
          std::copy_n(&candidates[j], 3, &known[i]);
          const bool is_free =
            smallest_distance(known, known) >= options.smallest_distance &&
            smallest_distance(known, law.process().data().x) >=
              options.smallest_distance;
          if (is_free)
            {
              ASSERT_GE(mean_variance(told(law, known), references),
                        chosen * (1. - 1e-8));
            }
        }
    }
}



TEST(ActiveLearning, keeps_away_from_runs_that_are_made_pending_or_failed)
{
  const FrictionLaw law    = example_law();
  const auto        first  = next_points(law, {}, 20);
  const auto        second = next_points(law, first, 20);
  ASSERT_EQ(first.size(), 60u);
  ASSERT_EQ(second.size(), 60u);
  const auto a = unit_points(first), b = unit_points(second);
  EXPECT_GE(smallest_distance(a, law.process().data().x), 0.01);
  EXPECT_GE(smallest_distance(a, a), 0.01);
  EXPECT_GE(smallest_distance(b, b), 0.01);
  EXPECT_GE(smallest_distance(a, b), 0.01);
  EXPECT_GE(smallest_distance(b, law.process().data().x), 0.01);
  // asking again for more gives the same points
  const auto both = next_points(law, {}, 40);
  EXPECT_EQ(std::vector<double>(both.begin(), both.begin() + 60), first);
  EXPECT_EQ(std::vector<double>(both.begin() + 60, both.end()), second);
}



TEST(ActiveLearning, ends_when_no_candidate_is_left)
{
  const FrictionLaw     law = example_law();
  ActiveLearningOptions options;
  options.n_candidates      = 4;
  options.smallest_distance = 0.05;
  // 4 Sobol points are training points, 2 of them pushed to the edges, of
  // which the middle of the box stays where it is, and 8 corners
  EXPECT_EQ(next_points(law, {}, 100, options).size(), 3u * 9u);
  options.smallest_distance = 2.;
  EXPECT_TRUE(next_points(law, {}, 100, options).empty());

  options.n_references = 0;
  EXPECT_NE(message_of<InputError>([&]() {
              next_points(law, {}, 1, options);
            }).find("0 references"),
            std::string::npos);
  options.n_references = 1;
  options.n_candidates = 0;
  EXPECT_THROW(next_points(law, {}, 1, options), InputError);
}



TEST(ActiveLearning, on_a_linear_scale_small_values_count_more)
{
  // a hundredth on one side of the box, with the same absolute detail
  const auto          inputs = example_inputs();
  const auto          x      = design_points(DesignKind::sobol, 40, inputs, 0);
  const auto          z      = map_to_unit(inputs, x);
  std::vector<double> y;
  for (unsigned int i = 0; i < 40; ++i)
    y.push_back(1. + 0.9 * std::tanh(8. * (z[3 * i] - 0.5)) +
                0.01 * std::sin(9. * z[3 * i + 1]) +
                0.01 * std::sin(9. * z[3 * i + 2]));
  FrictionLawDescription description;
  description.inputs = inputs;
  std::array<int, 2> n_small;
  for (const Scale scale : {Scale::linear, Scale::logarithmic})
    {
      description.output_scale = Scale::linear;
      auto shifted             = y;
      if (scale == Scale::logarithmic) // all about the same: no preference
        for (double &value : shifted)
          value += 100.;
      const auto law  = FrictionLaw::train(description, x, shifted);
      const auto next = unit_points(next_points(law, {}, 20));
      int        n    = 0;
      for (unsigned int i = 0; i < 20; ++i)
        n += next[3 * i] < 0.5;
      n_small[scale == Scale::logarithmic] = n;
    }
  EXPECT_GE(n_small[0], 15);
  EXPECT_LT(n_small[1], 15);
}



TEST(ActiveLearning, needs_fewer_runs_than_a_grid_and_serves_the_edges_better)
{
  const unsigned int n      = 125; // a grid of 5 values an input
  const auto         inside = random_points(), faces = points_on_faces();
  for (const auto &[name, function] : friction_like::all)
    {
      const auto grid =
        train(function,
              design_points(DesignKind::grid, 5, example_inputs(), 0));
      const auto sobol =
        train(function,
              design_points(DesignKind::sobol, n, example_inputs(), 0));
      const auto   learnt = learn(function, 25, 25, n);
      const double error  = error_of(learnt, function, inside);
      EXPECT_LT(error, 0.5 * error_of(grid, function, inside)) << name;
      EXPECT_LT(error, 1.25 * error_of(sobol, function, inside)) << name;
      EXPECT_LT(error_of(learnt, function, faces),
                error_of(sobol, function, faces))
        << name;
      // the error that a campaign measures does not flatter
      EXPECT_LT(error, cross_validate(learnt).mean_relative_error) << name;
    }
}



TEST(CrossValidation, is_what_leaving_a_point_out_gives)
{
  const FrictionLaw   law  = example_law(25);
  const TrainingData &data = law.process().data();
  CrossValidation     expected;
  for (std::size_t i = 0; i < 25; ++i)
    {
      TrainingData others = data;
      others.y.erase(others.y.begin() + i);
      others.x.erase(others.x.begin() + 3 * i, others.x.begin() + 3 * i + 3);
      const GaussianProcess process(law.process().kernel(),
                                    law.process().hyperparameters(),
                                    others);
      const double          mean = process.mean(&data.x[3 * i]);
      const double          deviation =
        std::sqrt(process.variance(&data.x[3 * i]) +
                  law.process().hyperparameters().noise_variance);
      const double error =
        std::abs(std::exp(law.factor() * (mean - data.y[i])) - 1.);
      expected.mean_relative_error += error / 25.;
      expected.largest_relative_error =
        std::max(expected.largest_relative_error, error);
      expected.coverage +=
        std::abs(mean - data.y[i]) < 1.96 * deviation ? 1. / 25. : 0.;
    }
  const CrossValidation found = cross_validate(law);
  EXPECT_NEAR(found.mean_relative_error / expected.mean_relative_error,
              1.,
              1e-6);
  EXPECT_NEAR(found.largest_relative_error / expected.largest_relative_error,
              1.,
              1e-6);
  EXPECT_NEAR(found.coverage, expected.coverage, 1e-12);
  EXPECT_NEAR(found.mean_relative_error,
              law.description().leave_one_out_error,
              1e-14);
}



TEST(StoppingRule, needs_two_batches_in_a_row_under_the_target)
{
  StoppingRule rule;
  rule.target = 0.01;
  EXPECT_FALSE(rule.is_met({}));
  EXPECT_FALSE(rule.is_met({0.005}));
  EXPECT_FALSE(rule.is_met({0.005, 0.02, 0.005}));
  EXPECT_FALSE(rule.is_met({0.005, 0.005, 0.02}));
  EXPECT_TRUE(rule.is_met({0.03, 0.01, 0.009}));
  rule.safety = 1.5;
  EXPECT_FALSE(rule.is_met({0.03, 0.01, 0.009}));
  EXPECT_TRUE(rule.is_met({0.03, 0.006, 0.0066}));
  rule.n_batches = 3;
  EXPECT_FALSE(rule.is_met({0.03, 0.006, 0.006}));
  // an error that could not be measured is no success
  EXPECT_FALSE(rule.is_met({0.001, 0.001, std::nan("")}));
}
