#include <asperity/base/errors.h>
#include <asperity/surrogate/active_learning.h>
#include <asperity/surrogate/friction_law.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sample_data.h"

using namespace asperity;

namespace
{
  std::vector<LawInput>
  inputs(const Scale of_pressure)
  {
    return {{"Load/Temperature", "T", "degC", 298.15, 1173.15},
            {"Load/Pressure", "p", "MPa", 3e8, 1.3e9, of_pressure},
            {"Load/Plastic strain", "Plasticstrain", "1", 0., 2.}};
  }

  /** The steel of Lee (2025), section 2.3, table 1, at a rate of 1e6/s. */
  ShearLimit
  steel()
  {
    ShearLimit k;
    k.k_0 =
      (288e6 + 695e6) * (1. + 0.034 * std::log(1e6 / 0.004)) / std::sqrt(3.);
    k.exponent               = 1.3558;
    k.transition_temperature = 293.15;
    k.melting_temperature    = 1773.15;
    k.strain                 = 1.;
    k.rate                   = 1e6;
    k.hardening_ratio        = 695. / 288.;
    k.hardening_exponent     = 0.2835;
    k.strain_limit           = 1.8;
    return k;
  }

  /** Its flow stress over sqrt(3) after Johnson and Cook, written down again;
   *  the strain includes that of an indentation. */
  double
  k_of_steel(const double T, const double strain)
  {
    const double A = 288e6, B = 695e6;
    const double eps = std::min(strain + 0.08, 1.8);
    return (A + B * std::pow(eps, 0.2835)) *
           (1. + 0.034 * std::log(1e6 / 0.004)) *
           (1. - std::pow((T - 293.15) / 1480., 1.3558)) / std::sqrt(3.);
  }

  /** Rises steeply where half of the chip's strength is reached. */
  double
  mu(const double *x)
  {
    const double q = x[1] / k_of_steel(x[0], x[2]);
    return 0.3 + 0.15 * std::tanh(4. * (q - 1.));
  }

  std::vector<double>
  points(const std::size_t n, const std::size_t first)
  {
    const std::vector<LawInput> box = inputs(Scale::linear);
    std::vector<double>         x;
    for (std::size_t j = 0; j < n; ++j)
      {
        const std::vector<double> u = evenly_spread_point(first + j, 3);
        for (std::size_t i = 0; i < 3; ++i)
          x.push_back(box[i].lower + u[i] * (box[i].upper - box[i].lower));
      }
    return x;
  }

  FrictionLaw
  trained(const bool over_strength, const Scale of_pressure = Scale::linear)
  {
    FrictionLawDescription description;
    description.inputs                 = inputs(of_pressure);
    description.shear_limit            = steel();
    description.pressure_over_strength = over_strength;
    const std::vector<double> x        = points(60, 0);
    std::vector<double>       y;
    for (std::size_t j = 0; j < x.size(); j += 3)
      y.push_back(mu(&x[j]));
    return FrictionLaw::train(description, x, y);
  }

  double
  mean_error(const FrictionLaw &law)
  {
    const std::vector<double> x     = points(200, 1000);
    double                    error = 0.;
    for (std::size_t j = 0; j < x.size(); j += 3)
      error += std::abs(law.mean(&x[j]) / mu(&x[j]) - 1.) / 200.;
    return error;
  }

  std::string
  message(const std::vector<LawInput> &box, const ShearLimit &k)
  {
    try
      {
        LawCoordinates(box, k, true, "law.json");
      }
    catch (const InputError &error)
      {
        return error.what();
      }
    return "";
  }
} // namespace



TEST(LawCoordinates, are_the_pressure_over_the_strength_of_the_chip)
{
  const LawCoordinates seen(inputs(Scale::linear), steel(), true, "a test");
  const double         least = 3e8 / k_of_steel(298.15, 2.),
               most          = 1.3e9 / k_of_steel(1173.15, 0.);
  for (const double T : {298.15, 700., 1173.15})
    for (const double p : {3e8, 1.3e9})
      for (const double strain : {0., 0.7, 1.75, 2.})
        {
          const double x[3] = {T, p, strain};
          double       z[3];
          seen.transform(x, z);
          EXPECT_NEAR(z[0], (T - 298.15) / 875., 1e-14);
          EXPECT_NEAR(z[1],
                      (p / k_of_steel(T, strain) - least) / (most - least),
                      1e-13);
          EXPECT_NEAR(z[2], strain / 2., 1e-14);
        }
}



// A law over p, T and the strain has to find out how they work together.
TEST(LawCoordinates, save_runs_where_the_strength_decides)
{
  const double plain = mean_error(trained(false)),
               over  = mean_error(trained(true));
  EXPECT_GT(plain, 0.01);
  EXPECT_LT(over, 0.2 * plain);
}



TEST(LawCoordinates, give_derivatives_by_the_inputs_themselves)
{
  for (const Scale scale : {Scale::linear, Scale::logarithmic})
    {
      const FrictionLaw law      = trained(true, scale);
      const double      h[3]     = {1e-3, 1e3, 1e-6};
      const double      at[4][3] = {{500., 6e8, 0.3},
                                    {1100., 4e8, 1.9}, // hardening has ended
                                    {1300., 1e9, 0.5}, // hotter than the box
                                    {250., 1.4e9, 2.5}};
      for (const auto &x : at)
        {
          const std::vector<double> gradient = law.predict(x).gradient;
          for (unsigned int i = 0; i < 3; ++i)
            {
              double below[3], above[3];
              std::copy(x, x + 3, below);
              std::copy(x, x + 3, above);
              below[i] -= h[i];
              above[i] += h[i];
              const double difference =
                (law.mean(above) - law.mean(below)) / (2. * h[i]);
              EXPECT_NEAR(gradient[i], difference, 1e-6 / (1e3 * h[i]))
                << x[0] << ' ' << i;
            }
        }
    }
}



TEST(LawCoordinates, stay_finite_beyond_melting)
{
  const FrictionLaw law = trained(true);
  for (const double T : {1773.15, 3000., 0.})
    {
      const double        x[3] = {T, 5e8, -1.};
      const LawPrediction at   = law.predict(x);
      EXPECT_TRUE(std::isfinite(at.mean));
      EXPECT_FALSE(at.trusted);
      for (const double slope : at.gradient)
        EXPECT_TRUE(std::isfinite(slope));
    }
  const double nan[3] = {std::numeric_limits<double>::quiet_NaN(), 5e8, 1.};
  EXPECT_TRUE(std::isnan(law.mean(nan)));
}



TEST(LawCoordinates, are_kept_in_the_file)
{
  const FrictionLaw law   = trained(true);
  const FrictionLaw again = FrictionLaw::from_json(law.to_json(), "law.json");
  const std::vector<double> x = points(20, 300);
  EXPECT_TRUE(again.description().pressure_over_strength);
  for (std::size_t j = 0; j < x.size(); j += 3)
    EXPECT_NEAR(again.mean(&x[j]), law.mean(&x[j]), 1e-12);
}



TEST(LawCoordinates, let_active_learning_choose_in_the_box)
{
  const FrictionLaw         law   = trained(true);
  const std::vector<double> first = next_points(law, {}, 4);
  ASSERT_EQ(first.size(), 12u);
  for (std::size_t j = 0; j < first.size(); j += 3)
    EXPECT_TRUE(law.is_inside(&first[j]));
  // What is pending is not chosen again.
  const std::vector<double> next = next_points(law, first, 4);
  for (std::size_t i = 0; i < first.size(); i += 3)
    for (std::size_t j = 0; j < next.size(); j += 3)
      EXPECT_FALSE(std::equal(&first[i], &first[i] + 3, &next[j]));
}



TEST(LawCoordinates, say_what_they_lack)
{
  EXPECT_EQ(message({{"Load/Velocity", "v", "m/min"}}, steel()),
            "law.json: The law is to see the pressure over the shear strength "
            "of the chip, but Load/Pressure is none of its inputs.");
  EXPECT_EQ(message(inputs(Scale::linear), ShearLimit()),
            "law.json: The law is to see the pressure over the shear strength "
            "of the chip, but that is not known, since the chip stays "
            "elastic.");
  std::vector<LawInput> molten = inputs(Scale::linear);
  molten[0].upper              = 1800.;
  EXPECT_EQ(message(molten, steel()),
            "law.json: The law is to see the pressure over the shear strength "
            "of the chip, which has none at the upper end of the temperature; "
            "a range that ends below melting is expected.");
}
