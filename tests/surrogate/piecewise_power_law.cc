#include <asperity/base/errors.h>
#include <asperity/surrogate/friction_law.h>
#include <asperity/surrogate/piecewise_power_law.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../../source/surrogate/law_checksum.h"
#include "../files.h"

using namespace asperity;

namespace
{
  constexpr double v_0 = 46. / 60.; // Lee (2025), section 2.1

  /** Velocities of 5 to 180 m/min, evenly spread in the logarithm. */
  std::vector<double>
  velocities(const unsigned int n)
  {
    std::vector<double> v;
    for (unsigned int i = 0; i < n; ++i)
      v.push_back(5. / 60. * std::pow(36., i / (n - 1.)));
    return v;
  }

  /** Dry there: constant, then falling. @param noise relative */
  std::vector<double>
  dry(const std::vector<double> &v,
      const double               noise  = 0.,
      const unsigned int         number = 1)
  {
    std::mt19937               random(number);
    std::normal_distribution<> normal;
    std::vector<double>        mu;
    for (const double velocity : v)
      mu.push_back(0.54 * std::pow(std::max(velocity, v_0) / v_0, -0.35) *
                   std::exp(noise * normal(random)));
    return mu;
  }

  PiecewisePowerOptions
  with(const ConstantPart part, const double velocity = 0.)
  {
    PiecewisePowerOptions result;
    result.constant_part = part;
    result.v_0           = velocity;
    return result;
  }

  FrictionLawDescription
  description()
  {
    FrictionLawDescription result;
    result.inputs     = {{"Load/Velocity", "v", "m/min"}};
    result.mechanisms = {"measurements"};
    return result;
  }
} // namespace

TEST(PiecewisePowerLaw, finds_the_law_that_made_the_measurements)
{
  const std::vector<double> v = velocities(16);
  for (const auto part : {ConstantPart::automatic, ConstantPart::fitted})
    {
      const PiecewisePowerFit fit =
        fit_piecewise_power_law(v, dry(v), {}, with(part));
      EXPECT_TRUE(fit.law.has_constant_part);
      EXPECT_NEAR(fit.law.mu_0, 0.54, 1e-8);
      EXPECT_NEAR(fit.law.v_0, v_0, 1e-6);
      EXPECT_NEAR(fit.law.exponent, -0.35, 1e-6);
      EXPECT_EQ(fit.degrees_of_freedom, 13u);
      EXPECT_LT(fit.leave_one_out_error, 1e-5);
      EXPECT_NEAR(fit.law(0.1), 0.54, 1e-8);
      EXPECT_NEAR(fit.law(2. * v_0), 0.54 * std::pow(2., -0.35), 1e-6);
    }
}

// Wet there: a power over all velocities.
TEST(PiecewisePowerLaw, leaves_the_constant_part_out_if_it_does_not_help)
{
  const std::vector<double> v = velocities(16);
  std::vector<double>       mu;
  for (std::size_t i = 0; i < v.size(); ++i)
    mu.push_back(0.2 * std::pow(v[i], 0.12) * (1. + 0.02 * std::sin(9. * i)));
  const PiecewisePowerFit fit = fit_piecewise_power_law(v, mu, {});
  EXPECT_FALSE(fit.law.has_constant_part);
  EXPECT_DOUBLE_EQ(fit.law.v_0, v[0]);
  EXPECT_EQ(fit.law.standard_errors()[1], 0.);
  EXPECT_NEAR(fit.law.exponent, 0.12, 0.01);
}

// Textbook: slope S_xy/S_xx, its error s/sqrt(S_xx), s^2 = SSE/(n - 2).
TEST(PiecewisePowerLaw, errors_of_a_power_are_those_of_a_straight_line)
{
  const std::vector<double> v = velocities(9), mu = dry(v, 0.05);
  double x_mean = 0., y_mean = 0., xx = 0., xy = 0., sse = 0.;
  for (std::size_t i = 0; i < 9; ++i)
    {
      x_mean += std::log(v[i]) / 9.;
      y_mean += std::log(mu[i]) / 9.;
    }
  for (std::size_t i = 0; i < 9; ++i)
    {
      const double x = std::log(v[i]) - x_mean, y = std::log(mu[i]) - y_mean;
      xx += x * x;
      xy += x * y;
    }
  for (std::size_t i = 0; i < 9; ++i)
    sse +=
      std::pow(std::log(mu[i]) - y_mean - xy / xx * (std::log(v[i]) - x_mean),
               2);
  const double            s = std::sqrt(sse / 7.);
  const PiecewisePowerFit fit =
    fit_piecewise_power_law(v, mu, {}, with(ConstantPart::none));
  EXPECT_NEAR(fit.law.exponent, xy / xx, 1e-12);
  EXPECT_NEAR(fit.law.standard_errors()[2], s / std::sqrt(xx), 1e-12);
  EXPECT_NEAR(fit.law.scatter, s, 1e-12);
  // of ln(mu) at v_0, which is the smallest velocity
  EXPECT_NEAR(fit.law.standard_errors()[0] / fit.law.mu_0,
              s *
                std::sqrt(1. / 9. + std::pow(std::log(v[0]) - x_mean, 2) / xx),
              1e-12);
}

// The same measurements again and again, with other errors of 2 %.
TEST(PiecewisePowerLaw, errors_are_the_scatter_of_repeated_fits)
{
  const std::vector<double> v       = velocities(24);
  constexpr unsigned int    n       = 300;
  double                    mean[3] = {}, square[3] = {}, stated[3] = {};
  for (unsigned int number = 1; number <= n; ++number)
    {
      const PiecewisePowerFit fit = fit_piecewise_power_law(
        v, dry(v, 0.02, number), {}, with(ConstantPart::fitted));
      const double constants[3] = {fit.law.mu_0, fit.law.v_0, fit.law.exponent};
      for (unsigned int i = 0; i < 3; ++i)
        {
          mean[i] += constants[i] / n;
          square[i] += constants[i] * constants[i] / n;
          stated[i] += fit.law.standard_errors()[i] / n;
        }
    }
  for (unsigned int i = 0; i < 3; ++i)
    {
      const double scatter = std::sqrt(square[i] - mean[i] * mean[i]);
      EXPECT_NEAR(stated[i], scatter, 0.15 * scatter) << i;
    }
}

TEST(PiecewisePowerLaw, weighs_by_the_deviations)
{
  const std::vector<double> v  = velocities(16);
  std::vector<double>       mu = dry(v), deviation;
  for (const double value : mu)
    deviation.push_back(0.01 * value);
  mu[3] *= 1.5;
  deviation[3] *= 1e4;
  const PiecewisePowerFit fit = fit_piecewise_power_law(v, mu, deviation);
  EXPECT_NEAR(fit.law.mu_0, 0.54, 1e-5);
  // what agrees better than its deviations says nothing against them
  EXPECT_GT(fit.law.standard_errors()[0], 0.54 * 0.01 / std::sqrt(16.));
}

TEST(PiecewisePowerLaw, says_what_it_cannot_find)
{
  const std::vector<double> v       = velocities(8);
  const auto                message = [&](const std::vector<double>   &mu,
                           const PiecewisePowerOptions &options) {
    return message_of<InputError>(
      [&] { fit_piecewise_power_law(v, mu, {}, options); });
  };
  EXPECT_NE(message(std::vector<double>(8, 0.5), with(ConstantPart::fitted))
              .find("do not determine the constants"),
            std::string::npos);
  EXPECT_NE(message(dry(v), with(ConstantPart::given, 10.))
              .find("do not determine the constants"),
            std::string::npos);
  std::vector<double> negative = dry(v);
  negative[2]                  = -0.1;
  EXPECT_EQ(message(negative, {}),
            "A power law needs positive velocities and friction coefficients; "
            "-0.1 is among them.");
  EXPECT_EQ(message_of<InputError>([] {
              fit_piecewise_power_law({0.1, 0.2}, {0.5, 0.4}, {});
            }),
            "There are 2 measurements for 2 constants; at least one more than "
            "constants is expected, so that errors can be told.");
}

TEST(PiecewisePowerLaw, predicts_with_derivative_and_interval)
{
  const std::vector<double> v = velocities(16);
  const FrictionLaw         law =
    FrictionLaw::fit_to_measurements(description(), v, dry(v, 0.03), {});
  const PiecewisePowerLaw &fitted = law.fitted()->law();
  for (const double velocity : {0.1, 0.5, 1.1, 2.7})
    {
      const LawPrediction at = law.predict(&velocity);
      EXPECT_NEAR(at.mean, fitted(velocity), 1e-12);
      const double h = 1e-6, plus = velocity + h, minus = velocity - h;
      EXPECT_NEAR(at.gradient[0],
                  (law.mean(&plus) - law.mean(&minus)) / (2. * h),
                  1e-7);
      EXPECT_GT(at.upper, at.mean * (1. + 1.96 * fitted.scatter));
      EXPECT_TRUE(at.trusted);
    }
  // at the smallest velocity the deviation is that of mu_0, enlarged by
  // Student's quantile for 13 degrees of freedom, 2.1604
  EXPECT_NEAR(law.predict(&v[0]).deviation,
              fitted.standard_errors()[0] * 2.1604 / 1.96,
              1e-5);
  const double fast = 4.;
  EXPECT_FALSE(law.predict(&fast).trusted);
  EXPECT_EQ(message_of<InputError>([&] { law.process(); }),
            "The friction law was fitted to measurements; one that was trained "
            "on runs is expected.");
}

TEST(PiecewisePowerLaw, is_saved_as_a_law)
{
  const std::vector<double> v = velocities(12);
  const FrictionLaw         law =
    FrictionLaw::fit_to_measurements(description(), v, dry(v, 0.03), {});
  const std::string path = test_folder() + "/law.json";
  law.save(path);
  const FrictionLaw same = FrictionLaw::load(path);
  for (const double velocity : {0.05, 0.5, 2., 80.})
    {
      const LawPrediction a = law.predict(&velocity),
                          b = same.predict(&velocity);
      EXPECT_EQ(a.mean, b.mean);
      EXPECT_EQ(a.deviation, b.deviation);
      EXPECT_EQ(a.upper, b.upper);
    }
  EXPECT_EQ(same.description().mechanisms, law.description().mechanisms);

  const auto message = [&](const std::string            &pointer,
                           const nlohmann::ordered_json &value) {
    nlohmann::ordered_json document                         = law.to_json();
    document[nlohmann::ordered_json::json_pointer(pointer)] = value;
    document["checksum"] = law_checksum(document);
    return message_of<InputError>(
      [&] { FrictionLaw::from_json(document, "law.json"); });
  };
  EXPECT_EQ(message("/model", "oracle"),
            "law.json: The entry 'model' of the friction law is \"oracle\"; "
            "'Gaussian process' or 'piecewise power law' is expected.");
  EXPECT_EQ(message("/constants/mu_0", -1),
            "law.json: The entry 'constants/mu_0' of the friction law is -1; a "
            "positive number is expected.");
  EXPECT_NE(message("/constants/covariance", {1., 2.})
              .find("a list of 9 numbers is expected"),
            std::string::npos);
  nlohmann::ordered_json changed = law.to_json();
  changed["constants"]["mu_0"]   = 0.4;
  EXPECT_NE(message_of<InputError>([&] {
              FrictionLaw::from_json(changed, "law.json");
            }).find("was changed after it was written"),
            std::string::npos);
}
