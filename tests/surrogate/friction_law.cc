#include <asperity/base/errors.h>
#include <asperity/surrogate/friction_law.h>
#include <asperity/surrogate/hyperparameter_search.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "../files.h"
#include "sample_data.h"

using namespace asperity;

namespace
{
  const std::vector<LawInput> inputs = {
    {"Load/Pressure", "p", "MPa", 3e8, 1.3e9, Scale::linear},
    {"Load/Velocity", "v", "m/min", 0.375, 10. / 3., Scale::logarithmic},
    {"Load/Temperature", "T", "degC", 298.15, 1173.15, Scale::linear}};

  /** Falls with pressure, velocity and temperature, as in Lee (2025). */
  double
  mu(const double *x)
  {
    const double heat = (x[2] - 298.15) / 1000.;
    return 0.1 * std::pow(x[0] / 3e8, -0.2) * std::pow(x[1], -0.05) *
           (1. - 0.5 * heat * heat);
  }

  std::vector<double>
  point(const std::size_t index)
  {
    std::vector<double> x = evenly_spread_point(index, 3);
    for (std::size_t i = 0; i < 3; ++i)
      x[i] = inputs[i].lower + x[i] * (inputs[i].upper - inputs[i].lower);
    return x;
  }

  struct Samples
  {
    explicit Samples(const std::size_t n)
    {
      for (std::size_t j = 0; j < n; ++j)
        {
          const std::vector<double> one = point(j);
          x.insert(x.end(), one.begin(), one.end());
          y.push_back(mu(one.data()));
        }
    }

    std::vector<double> x, y;
  };

  FrictionLawDescription
  description_of_mu()
  {
    FrictionLawDescription description;
    description.inputs                = inputs;
    description.topography_scatter    = 0.03;
    description.shear_limit           = {6.3e8, 1.03, 298.15, 1793.15, 1., 1e4};
    description.provenance["version"] = "a test's";
    return description;
  }

  FrictionLaw
  trained_law(const FrictionLawDescription &description = description_of_mu())
  {
    const Samples samples(40);
    return FrictionLaw::train(description, samples.x, samples.y);
  }
} // namespace



TEST(FrictionLaw, predicts_a_smooth_function)
{
  for (const Scale scale : {Scale::linear, Scale::logarithmic})
    for (const KernelKind kernel : all_kernels)
      {
        FrictionLawDescription description = description_of_mu();
        description.output_scale           = scale;
        description.kernel                 = kernel;
        const FrictionLaw law              = trained_law(description);
        EXPECT_LT(law.description().leave_one_out_error, 0.01);
        for (std::size_t j = 100; j < 200; ++j)
          {
            const std::vector<double> x          = point(j);
            const LawPrediction       prediction = law.predict(x.data());
            const double              exact      = mu(x.data());
            EXPECT_NEAR(prediction.mean, exact, 0.02 * exact);
            EXPECT_NEAR(prediction.mean, law.mean(x.data()), 1e-14);
            EXPECT_TRUE(prediction.trusted);
          }
      }
}



// The law is the process behind its scales.
TEST(FrictionLaw, prediction_is_that_of_the_process_behind_its_scales)
{
  const FrictionLaw         law = trained_law();
  const std::vector<double> x   = {6e8, 1.1, 700.};
  const std::vector<double> z   = {0.3,
                                   std::log(1.1 / 0.375) /
                                     std::log(10. / 3. / 0.375),
                                   (700. - 298.15) / 875.};
  const double m = law.offset() + law.factor() * law.process().mean(z.data()),
               s = law.factor() * std::sqrt(law.process().variance(z.data()));
  const LawPrediction found = law.predict(x.data());
  EXPECT_NEAR(found.mean, std::exp(m), 1e-11);
  EXPECT_NEAR(found.deviation, std::exp(m) * s, 1e-10);
  const double noise  = law.process().hyperparameters().noise_variance;
  const double of_run = std::sqrt(s * s + law.factor() * law.factor() * noise);
  EXPECT_NEAR(found.lower, std::exp(m - 1.96 * of_run), 1e-10);
  EXPECT_NEAR(found.upper, std::exp(m + 1.96 * of_run), 1e-10);

  // the values are centred and of unit variance
  double sum = 0., square = 0.;
  for (const double y : law.process().data().y)
    {
      sum += y / 40.;
      square += y * y / 40.;
    }
  EXPECT_NEAR(sum, 0., 1e-12);
  EXPECT_NEAR(square, 1., 1e-12);
}



// Of 40 points, each predicted by the others, the interval holds 39, the next
// whole number to 95 % of 41; the mean is that of the likeliest process.
TEST(FrictionLaw, deviation_is_calibrated_by_cross_validation)
{
  for (const KernelKind kernel : all_kernels)
    {
      FrictionLawDescription description = description_of_mu();
      description.kernel                 = kernel;
      const FrictionLaw      law         = trained_law(description);
      const GaussianProcess &process     = law.process();
      const double           factor      = law.description().calibration;
      ASSERT_GT(factor, 0.5) << to_string(kernel);
      ASSERT_LT(factor, 2.) << to_string(kernel);
      const auto   left_out = process.leave_one_out();
      unsigned int n_inside = 0;
      for (std::size_t j = 0; j < left_out.size(); ++j)
        n_inside += std::abs(left_out[j].mean - process.data().y[j]) <=
                    1.96 * std::sqrt(left_out[j].variance);
      EXPECT_EQ(n_inside, 39U);

      Hyperparameters plain_values = process.hyperparameters();
      plain_values.signal_variance /= factor * factor;
      plain_values.noise_variance /= factor * factor;
      const GaussianProcess plain(kernel, plain_values, process.data());
      EXPECT_NEAR(plain.log_likelihood(),
                  find_hyperparameters(kernel, process.data()).log_likelihood,
                  1e-5);
      const std::vector<double> z = {0.3, 0.4, 0.5};
      EXPECT_NEAR(process.mean(z.data()), plain.mean(z.data()), 1e-9);
      EXPECT_NEAR(process.variance(z.data()) / plain.variance(z.data()),
                  factor * factor,
                  1e-5);
    }
}



// Few points tell no 95 %, and known deviations are not to be scaled: the
// points that have one are left out.
TEST(FrictionLaw, deviation_is_left_alone_without_a_measure)
{
  const Samples few(19), many(40);
  EXPECT_EQ(FrictionLaw::train(description_of_mu(), few.x, few.y)
              .description()
              .calibration,
            1.);
  EXPECT_EQ(FrictionLaw::train(description_of_mu(),
                               many.x,
                               many.y,
                               std::vector<double>(40, 1e-4))
              .description()
              .calibration,
            1.);
  std::vector<double> some(40, 0.);
  some[3] = 1e-4;
  EXPECT_NE(FrictionLaw::train(description_of_mu(), many.x, many.y, some)
              .description()
              .calibration,
            1.);
}



TEST(FrictionLaw, gradient_agrees_with_finite_differences)
{
  for (const Scale scale : {Scale::linear, Scale::logarithmic})
    {
      FrictionLawDescription description = description_of_mu();
      description.output_scale           = scale;
      const FrictionLaw   law            = trained_law(description);
      std::vector<double> x              = point(77);
      const auto          gradient       = law.predict(x.data()).gradient;
      for (std::size_t i = 0; i < 3; ++i)
        {
          const double step   = 1e-5 * (inputs[i].upper - inputs[i].lower);
          const double middle = x[i];
          x[i]                = middle + step;
          const double right  = law.mean(x.data());
          x[i]                = middle - step;
          const double left   = law.mean(x.data());
          x[i]                = middle;
          EXPECT_NEAR(gradient[i] * step, (right - left) / 2., 1e-11);
        }
    }
}



TEST(FrictionLaw, trusts_nothing_outside_or_unsure)
{
  FrictionLawDescription description = description_of_mu();
  const FrictionLaw      law         = trained_law(description);
  std::vector<double>    x           = {6e8, 1.1, 700.};
  EXPECT_TRUE(law.predict(x.data()).trusted);
  for (std::size_t i = 0; i < 3; ++i)
    for (const double sign : {-1., 1.})
      {
        std::vector<double> outside = x;
        const double        range   = inputs[i].upper - inputs[i].lower;
        outside[i] = (sign < 0. ? inputs[i].lower : inputs[i].upper);
        EXPECT_TRUE(law.is_inside(outside.data()));
        outside[i] += sign * 1e-6 * range;
        EXPECT_FALSE(law.is_inside(outside.data()));
        EXPECT_FALSE(law.predict(outside.data()).trusted);
        EXPECT_TRUE(std::isfinite(law.predict(outside.data()).mean));
      }
  x[1]                        = -1.; // no logarithm: clamped
  const LawPrediction clamped = law.predict(x.data());
  x[1]                        = 0.375;
  EXPECT_EQ(clamped.mean, law.predict(x.data()).mean);
  EXPECT_EQ(clamped.gradient[1], 0.);
  EXPECT_FALSE(clamped.trusted);
  x[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(law.predict(x.data()).trusted);
  EXPECT_TRUE(std::isnan(law.mean(x.data())));

  description.largest_trusted_deviation = 1e-9;
  x[1]                                  = 1.1;
  EXPECT_FALSE(trained_law(description).predict(x.data()).trusted);
}



// Known scatter of the values is not taken for signal.
TEST(FrictionLaw, known_deviation_widens_the_band)
{
  Samples samples(40);
  for (std::size_t j = 0; j < 40; ++j)
    samples.y[j] *= j % 2 == 0 ? 1.02 : 0.98;
  const FrictionLaw with =
    FrictionLaw::train(description_of_mu(),
                       samples.x,
                       samples.y,
                       std::vector<double>(40, 0.02 * 0.1));
  const std::vector<double> x = point(300);
  EXPECT_NEAR(with.predict(x.data()).mean, mu(x.data()), 0.02 * mu(x.data()));
  const double           y        = samples.y[5];
  const double           expected = 0.002 / y / with.factor();
  const GaussianProcess &process  = with.process();
  EXPECT_NEAR(process.data().known_variance[5],
              expected * expected,
              1e-12 * expected * expected);
}



TEST(FrictionLaw, constant_data_give_a_constant_law)
{
  Samples samples(20);
  for (double &y : samples.y)
    y = 0.1;
  const FrictionLaw law =
    FrictionLaw::train(description_of_mu(), samples.x, samples.y);
  const LawPrediction found = law.predict(point(50).data());
  EXPECT_NEAR(found.mean, 0.1, 1e-12);
  EXPECT_LT(found.deviation, 1e-10);
  EXPECT_TRUE(found.trusted);
}



TEST(FrictionLaw, takes_one_to_six_inputs)
{
  for (std::size_t d = 1; d <= 6; ++d)
    {
      FrictionLawDescription description;
      for (std::size_t i = 0; i < d; ++i)
        description.inputs.push_back({"Group/Entry " + std::to_string(i + 1),
                                      "x" + std::to_string(i + 1),
                                      "1",
                                      0.,
                                      1.});
      const TrainingData data = sample(60, d, [](const auto &x) {
        return std::exp(x.front() + 0.5 * x.back());
      });
      const FrictionLaw  law  = FrictionLaw::train(description, data.x, data.y);
      const std::vector<double> x = evenly_spread_point(90, d);
      EXPECT_NEAR(law.mean(x.data()) / std::exp(x.front() + 0.5 * x.back()),
                  1.,
                  1e-3);
    }
}



TEST(FrictionLaw, wrong_data_are_refused)
{
  const auto message = [](const FrictionLawDescription &description,
                          const Samples                &samples,
                          const std::vector<double>    &known = {}) {
    return message_of<InputError>(
      [&]() { FrictionLaw::train(description, samples.x, samples.y, known); });
  };
  const FrictionLawDescription good = description_of_mu();
  const std::string            by   = "Training of the friction law: ";

  EXPECT_EQ(message(good, Samples(4)),
            by + "There are 4 training points; at least 5 are expected for 3 "
                 "inputs.");
  Samples samples(10);
  samples.y[3] = -0.1;
  EXPECT_EQ(message(good, samples),
            by + "Value number 4 of 'mu' is -0.1; on a logarithmic scale all "
                 "must be positive.");
  samples.y[3] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message(good, samples),
            by + "Value number 4 of 'mu' is not finite.");
  samples      = Samples(10);
  samples.x[3] = 300.; // MPa where Pa are expected
  EXPECT_EQ(message(good, samples),
            by +
              "The input 'Load/Pressure' of point number 2 is 300; its range "
              "is 3e+08 to 1.3e+09 (SI units).");
  samples.x.pop_back();
  EXPECT_EQ(message(good, samples),
            by + "The training data have 10 values, 29 coordinates and 0 known "
                 "deviations; for each value 3 coordinates, and one known "
                 "deviation or none, are expected.");
  std::vector<double> known(10, 0.);
  known[9] = -1.;
  EXPECT_EQ(message(good, Samples(10), known),
            by + "The known deviation of value number 10 of 'mu' is negative "
                 "or not finite.");

  FrictionLawDescription bad = good;
  bad.inputs[0].upper        = bad.inputs[0].lower;
  EXPECT_EQ(message(bad, Samples(10)),
            by + "The input 'Load/Pressure' ranges from 3e+08 to 3e+08; "
                 "a finite range that increases is expected.");
  bad                 = good;
  bad.inputs[1].lower = 0.;
  EXPECT_EQ(message(bad, Samples(10)),
            by + "The input 'Load/Velocity' has a logarithmic scale and starts "
                 "at 0; a positive lower end is expected.");
  bad                  = good;
  bad.inputs[2].symbol = "";
  EXPECT_EQ(message(bad, Samples(10)),
            by + "An input of the law has no name or no symbol; each needs "
                 "both.");
  bad.inputs.clear();
  EXPECT_EQ(message(bad, Samples(10)),
            by + "The law has no input; at least one is expected.");
}



TEST(ShearLimit, follows_the_temperature)
{
  const ShearLimit limit{600e6, 2., 300., 1700., 1., 1e4};
  EXPECT_EQ(limit(200.), 600e6);
  EXPECT_NEAR(limit(1000.), 600e6 * 0.75, 1e-3);
  EXPECT_EQ(limit(1700.), 0.);
  EXPECT_EQ(limit(2000.), 0.);
  EXPECT_EQ(ShearLimit()(500.), 0.);
}
