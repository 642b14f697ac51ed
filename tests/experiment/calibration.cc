#include <asperity/base/errors.h>
#include <asperity/experiment/calibration.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../files.h"
#include "../surrogate/sample_data.h"

using namespace asperity;

namespace
{
  /** Ploughing, and a shear strength m k on the contact: mu of p [Pa] and m. */
  double
  formula(const double p, const double m)
  {
    return 0.08 + 0.45 * m * std::pow(p / 3e8, -0.1);
  }

  /** A law of 60 runs, as good as exact. */
  const FrictionLaw &
  law()
  {
    static const FrictionLaw result = [] {
      FrictionLawDescription description;
      description.inputs = {
        {"Load/Pressure", "p", "MPa", 3e8, 1.3e9, Scale::logarithmic},
        {"Interface/Shear factor", "ShearFactor", "1", 0., 1.}};
      std::vector<double> x, y;
      for (std::size_t j = 0; j < 60; ++j)
        {
          const std::vector<double> u = evenly_spread_point(j, 2);
          x.insert(x.end(), {3e8 + 1e9 * u[0], u[1]});
          y.push_back(formula(x[2 * j], u[1]));
        }
      return FrictionLaw::train(description, x, y);
    }();
    return result;
  }

  /** At n pressures with m = 0.7. @param noise relative */
  CalibrationData
  measurements(const unsigned int n,
               const double       noise  = 0.,
               const unsigned int number = 1)
  {
    std::mt19937               random(number);
    std::normal_distribution<> normal;
    CalibrationData            data;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double p = 4e8 + 8e8 * (i + 0.5) / n;
        data.x.push_back({p, 0.});
        data.mu.push_back(formula(p, 0.7) * (1. + noise * normal(random)));
      }
    return data;
  }
} // namespace

TEST(Calibration, finds_the_shear_factor_of_a_synthetic_law)
{
  for (const unsigned int n : {1, 5})
    {
      const Calibration found = calibrate(law(), 1, measurements(n));
      EXPECT_NEAR(found.value, 0.7, 2e-3) << n;
      EXPECT_EQ(found.standard_error.has_value(), n > 1);
      EXPECT_EQ(found.computed.size(), n);
      EXPECT_NEAR(found.computed[0].mean, measurements(n).mu[0], 1e-3);
    }
}

// d mu/d m = 0.45 (p/300 MPa)^-0.1, so that one measurement of 0.02 gives
// 0.02/(d mu/d m), and n of them by the root of n less.
TEST(Calibration, has_the_error_of_its_measurements)
{
  CalibrationData one = measurements(1);
  one.deviation       = {0.02};
  const double slope  = 0.45 * std::pow(8. / 3., -0.1);
  EXPECT_NEAR(*calibrate(law(), 1, one).standard_error,
              0.02 / slope,
              0.02 * 0.02 / slope);
  CalibrationData four = one;
  for (unsigned int i = 0; i < 3; ++i)
    {
      four.x.push_back(one.x[0]);
      four.mu.push_back(one.mu[0]);
      four.deviation.push_back(0.02);
    }
  EXPECT_NEAR(*calibrate(law(), 1, four).standard_error,
              *calibrate(law(), 1, one).standard_error / 2.,
              1e-9);
}

TEST(Calibration, has_the_error_of_repeated_calibrations)
{
  constexpr unsigned int n    = 200;
  double                 mean = 0., square = 0., stated = 0.;
  for (unsigned int number = 1; number <= n; ++number)
    {
      const Calibration found =
        calibrate(law(), 1, measurements(8, 0.04, number));
      mean += found.value / n;
      square += found.value * found.value / n;
      stated += *found.standard_error / n;
    }
  EXPECT_NEAR(mean, 0.7, 0.01);
  const double scatter = std::sqrt(square - mean * mean);
  EXPECT_NEAR(stated, scatter, 0.15 * scatter);
}

TEST(Calibration, says_what_is_not_determined)
{
  CalibrationData high = measurements(3);
  for (double &mu : high.mu)
    mu *= 2.;
  EXPECT_NE(message_of<InputError>([&] { calibrate(law(), 1, high); })
              .find("do not determine 'Interface/Shear factor': the best value "
                    "is the end of its range, 1, where the mean of mu is "),
            std::string::npos);
  CalibrationData poor = measurements(2);
  poor.deviation       = {2., 2.};
  EXPECT_NE(message_of<InputError>([&] {
              calibrate(law(), 1, poor);
            }).find(": its standard error would be "),
            std::string::npos);
}
