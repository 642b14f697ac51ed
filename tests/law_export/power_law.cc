#include <asperity/base/errors.h>
#include <asperity/surrogate/power_law.h>

#include "../files.h"
#include "exported_law.h"

using namespace asperity;
using namespace asperity_test;

namespace
{
  /** Trained on a function of p, v, T at 40 points. */
  template <typename Function>
  FrictionLaw
  trained_on(const Function &function, const LawKind &kind = {})
  {
    const FrictionLawDescription law = description(kind);
    std::vector<double>          x, y;
    for (std::size_t j = 0; j < 40; ++j)
      {
        const std::vector<double> unit = evenly_spread_point(j, 3);
        for (std::size_t i = 0; i < 3; ++i)
          x.push_back(law.inputs[i].lower +
                      unit[i] * (law.inputs[i].upper - law.inputs[i].lower));
        y.push_back(function(x[3 * j], x[3 * j + 1], x[3 * j + 2]));
      }
    return FrictionLaw::train(law, x, y);
  }
} // namespace

TEST(PowerLaw, finds_the_law_that_made_the_runs)
{
  const auto function = [](const double p, const double v, const double T) {
    return 2.5 * std::pow(p, -0.12) * std::pow(v, -0.07) * std::pow(T, -0.15);
  };
  for (const LawKind &kind : law_kinds)
    {
      const PowerLaw law = fit_power_law(trained_on(function, kind));
      EXPECT_NEAR(law.coefficient, 2.5, 1e-9);
      EXPECT_NEAR(law.exponents[0], -0.12, 1e-10);
      EXPECT_NEAR(law.exponents[1], -0.07, 1e-10);
      EXPECT_NEAR(law.exponents[2], -0.15, 1e-10);
      EXPECT_NEAR(law.mean_relative_error, 0., 1e-10);
      EXPECT_NEAR(law.leave_one_out_error, 0., 1e-10);
      const std::vector<double> x = {5e8, 1.2, 700.}, zero = {0., 0., 0.};
      EXPECT_NEAR(law(x.data()), function(5e8, 1.2, 700.), 1e-10);
      // finite where p and v vanish
      EXPECT_NEAR(law(zero.data()), function(3e8, 0.375, 298.15), 1e-10);
      EXPECT_EQ(to_string(law, description(kind).inputs),
                "mu = 2.5 p^-0.12 v^-0.07 T^-0.15 (SI), p >= 3e+08, v >= "
                "0.375, T >= 298.1");
    }
}

TEST(PowerLaw, leaves_out_runs_as_fitting_without_them_does)
{
  const auto function = [](const double p, const double v, const double T) {
    return formula(p, v, T, 0.);
  };
  const FrictionLaw law   = trained_on(function);
  const PowerLaw    fit   = fit_power_law(law);
  double            error = 0.;
  const std::size_t n     = law.data().y.size();
  for (std::size_t left_out = 0; left_out < n; ++left_out)
    {
      std::vector<double> x = law.data().x, y = law.data().y;
      x.erase(x.begin() + 3 * left_out, x.begin() + 3 * left_out + 3);
      y.erase(y.begin() + left_out);
      const PowerLaw without =
        fit_power_law(FrictionLaw::train(law.description(), x, y));
      error +=
        std::abs(without(&law.data().x[3 * left_out]) / law.data().y[left_out] -
                 1.) /
        static_cast<double>(n);
    }
  EXPECT_NEAR(fit.leave_one_out_error, error, 1e-9);
  EXPECT_GT(fit.leave_one_out_error, fit.mean_relative_error);
  // a law that the runs do not follow is worse than the Gaussian process
  EXPECT_GT(fit.leave_one_out_error,
            3. * law.description().leave_one_out_error);
}

TEST(VelocityLaw, finds_where_the_constant_part_ends)
{
  // dry, in Lee (2025), section 2.1: constant up to 46 m/min
  const double v_0 = 46. / 60.;
  const auto   dry = [&](double, const double v, double) {
    return 0.6 * std::pow(std::max(v, v_0) / v_0, -0.4);
  };
  const auto wet = [](double, const double v, double) {
    return 0.2 * std::pow(v, 0.3);
  };
  const PowerLaw dry_law = fit_velocity_law(trained_on(dry));
  EXPECT_NEAR(dry_law.floors[1], v_0, 0.012 * v_0); // a step of the search
  EXPECT_NEAR(dry_law.exponents[1], -0.4, 0.005);
  EXPECT_EQ(dry_law.exponents[0], 0.);
  EXPECT_LT(dry_law.mean_relative_error, 2e-3);
  const std::vector<double> slow = {5e8, 0.1, 300.};
  EXPECT_NEAR(dry_law(slow.data()), 0.6, 2e-3);

  // a few fast runs do not make a law of their own
  const auto outlier = [](double, const double v, double) {
    return v > 3.15 ? 0.3 : 0.2;
  };
  EXPECT_LT(fit_velocity_law(trained_on(outlier)).floors[1], 2.7);

  const PowerLaw wet_law = fit_velocity_law(trained_on(wet));
  EXPECT_DOUBLE_EQ(wet_law.floors[1], 0.375);
  EXPECT_NEAR(wet_law.exponents[1], 0.3, 1e-9);
  EXPECT_NEAR(wet_law.coefficient, 0.2, 1e-9);
}

TEST(PowerLaw, says_why_it_cannot_be_fitted)
{
  const FrictionLaw      full = train(law_kinds[2]);
  FrictionLawDescription law  = full.description();

  // pressure and velocity that rise together
  std::vector<double> x;
  for (std::size_t j = 0; j < 40; ++j)
    {
      const double u = (j + 0.5) / 40.;
      x.insert(x.end(),
               {3e8 * std::pow(13. / 3., u),
                0.375 * std::pow(80. / 9., u),
                298.15 + 875. * evenly_spread_point(j, 1)[0]});
    }
  std::vector<double> y(40);
  for (std::size_t j = 0; j < 40; ++j)
    y[j] = formula(x[3 * j], x[3 * j + 1], x[3 * j + 2], 0.);
  EXPECT_EQ(message_of<InputError>(
              [&] { fit_power_law(FrictionLaw::train(law, x, y)); }),
            "The runs of the friction law do not determine the exponents of a "
            "power law: its inputs do not vary independently of each other.");

  law.output_scale = Scale::linear;
  y[3]             = -0.1;
  EXPECT_EQ(message_of<InputError>(
              [&] { fit_power_law(FrictionLaw::train(law, x, y)); }),
            "A power law needs positive values of mu; -0.1 is among them.");

  law.inputs[1].symbol = "w";
  EXPECT_EQ(message_of<InputError>(
              [&] { fit_velocity_law(FrictionLaw::train(law, x, y)); }),
            "The friction law does not depend on a velocity v, so no power law "
            "over the velocity can be fitted to it.");
}
