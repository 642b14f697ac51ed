#include <asperity/base/errors.h>
#include <asperity/surrogate/design.h>
#include <asperity/surrogate/sensitivity.h>

#include <cmath>

#include "../files.h"
#include "example_inputs.h"

using namespace asperity;

namespace
{
  constexpr double pi = 3.14159265358979323846;

  template <typename Function>
  FunctionOfPoints
  row_by_row(const unsigned int n_inputs, const Function &function)
  {
    return [=](const std::size_t n, const double *unit, double *values) {
      for (std::size_t i = 0; i < n; ++i)
        values[i] = function(unit + i * n_inputs);
    };
  }

  /** Ishigami and Homma (1990) on (-pi, pi)^3, a = 7, b = 0.1. */
  const double a = 7., b = 0.1;

  const FunctionOfPoints ishigami = row_by_row(3, [](const double *z) {
    const double x1 = pi * (2. * z[0] - 1.), x2 = pi * (2. * z[1] - 1.),
                 x3 = pi * (2. * z[2] - 1.);
    return std::sin(x1) + a * std::sin(x2) * std::sin(x2) +
           b * std::pow(x3, 4) * std::sin(x1);
  });

  struct IshigamiIndices
  {
    double first[3], total[3];
  };

  IshigamiIndices
  analytic_indices()
  {
    const double V1  = 0.5 * std::pow(1. + b * std::pow(pi, 4) / 5., 2);
    const double V2  = a * a / 8.;
    const double V13 = b * b * std::pow(pi, 8) * 8. / 225.;
    const double V   = V1 + V2 + V13;
    return {{V1 / V, V2 / V, 0.}, {(V1 + V13) / V, V2 / V, V13 / V}};
  }
} // namespace



TEST(Sensitivity, ishigami_function_within_the_confidence_stated)
{
  const IshigamiIndices exact   = analytic_indices();
  const auto            indices = sensitivity_indices(3, ishigami);
  ASSERT_EQ(indices.size(), 3u);
  for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(indices[i].S1, exact.first[i], indices[i].S1_conf);
      EXPECT_NEAR(indices[i].ST, exact.total[i], indices[i].ST_conf);
      EXPECT_NEAR(indices[i].S1, exact.first[i], 0.01);
      EXPECT_NEAR(indices[i].ST, exact.total[i], 0.01);
      EXPECT_LT(indices[i].S1_conf, 0.06);
      EXPECT_LT(indices[i].ST_conf, 0.06);
    }
}



TEST(Sensitivity, the_interval_narrows_with_the_root_of_the_points)
{
  SensitivityOptions few, many;
  few.n_points     = 1024;
  many.n_points    = 16384;
  many.n_resamples = few.n_resamples = 400;
  const auto wide                    = sensitivity_indices(3, ishigami, few);
  const auto narrow                  = sensitivity_indices(3, ishigami, many);
  // the standard deviation of 400 resamples is known to 4 %
  EXPECT_NEAR(wide[0].S1_conf / narrow[0].S1_conf, 4., 0.8);
  EXPECT_NEAR(wide[1].ST_conf / narrow[1].ST_conf, 4., 0.8);
}



TEST(Sensitivity, a_linear_function_has_no_interactions)
{
  // variances are those of the coefficients
  const double c[] = {1., 2., 0., -4.};
  const auto   indices =
    sensitivity_indices(4, row_by_row(4, [&](const double *z) {
                          return 1e3 + c[0] * z[0] + c[1] * z[1] + c[2] * z[2] +
                                 c[3] * z[3];
                        }));
  for (unsigned int i = 0; i < 4; ++i)
    {
      EXPECT_NEAR(indices[i].S1, c[i] * c[i] / 21., 2e-3);
      EXPECT_NEAR(indices[i].ST, c[i] * c[i] / 21., 2e-3);
    }
  EXPECT_EQ(indices[2].ST, 0.);
}



TEST(Sensitivity, a_constant_function_and_wrong_numbers)
{
  const auto constant = row_by_row(2, [](const double *) { return 0.1; });
  for (const auto &index : sensitivity_indices(2, constant))
    {
      EXPECT_EQ(index.S1, 0.);
      EXPECT_EQ(index.ST_conf, 0.);
    }
  SensitivityOptions options;
  options.n_points   = 1;
  const auto message = message_of<InputError>(
    [&]() { sensitivity_indices(2, constant, options); });
  EXPECT_NE(message.find("1 points"), std::string::npos);
  EXPECT_THROW(sensitivity_indices(21, constant), InputError);
}



TEST(Sensitivity, of_a_law_in_its_box)
{
  // ln mu = -0.3 z_p + 0.1 z_v, z_v on the logarithmic scale: with two inputs
  // that act as factors the indices are known in closed form.
  const auto          inputs = example_inputs();
  const auto          x      = design_points(DesignKind::sobol, 60, inputs, 0);
  const auto          z      = map_to_unit(inputs, x);
  std::vector<double> y;
  for (unsigned int i = 0; i < 60; ++i)
    y.push_back(std::exp(-0.3 * z[3 * i] + 0.1 * z[3 * i + 1]));
  FrictionLawDescription description;
  description.inputs = inputs;
  const auto law     = FrictionLaw::train(description, x, y);
  const auto indices = sensitivity_indices(law);

  // E exp(c z) = (e^c - 1) / c
  const auto moment = [](const double c) { return std::expm1(c) / c; };
  // relative variances of both factors: V = (1 + r_p) (1 + r_v) - 1
  const double r_p = moment(-0.6) / std::pow(moment(-0.3), 2) - 1.;
  const double r_v = moment(0.2) / std::pow(moment(0.1), 2) - 1.;
  const double V   = (1. + r_p) * (1. + r_v) - 1.;
  EXPECT_NEAR(indices[0].S1, r_p / V, 2e-3);
  EXPECT_NEAR(indices[1].S1, r_v / V, 2e-3);
  EXPECT_NEAR(indices[2].S1, 0., 2e-3);
  EXPECT_NEAR(indices[0].ST, r_p * (1. + r_v) / V, 2e-3);
  EXPECT_NEAR(indices[1].ST, r_v * (1. + r_p) / V, 2e-3);
  EXPECT_NEAR(indices[2].ST, 0., 2e-3);

  const std::string path = test_folder() + "/sensitivity.csv";
  write_sensitivity(path, description, {{0.5, 0.25, 0.75, 0.125}, {}, {}});
  EXPECT_EQ(content(path),
            "# Sobol sensitivity indices of mu; conf is the half width of the "
            "95 % interval\n"
            "# p is uniformly distributed from 300 MPa to 1300 MPa\n"
            "# v is uniformly distributed on a logarithmic scale from 22.5 "
            "m/min to 200 m/min\n"
            "# T is uniformly distributed from 25 degC to 900 degC\n"
            "input,symbol,S1,S1_conf,ST,ST_conf\n"
            "Load/Pressure,p,0.5,0.25,0.75,0.125\n"
            "Load/Velocity,v,0,0,0,0\n"
            "Load/Temperature,T,0,0,0,0\n");
}
