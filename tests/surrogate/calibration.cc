#include <asperity/surrogate/design.h>
#include <asperity/surrogate/friction_law.h>
#include <asperity/surrogate/random_numbers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace asperity;

namespace
{
  const std::vector<LawInput> inputs = {
    {"Load/Pressure", "p", "MPa", 3e8, 1.3e9, Scale::logarithmic},
    {"Load/Velocity", "v", "m/min", 0.375, 10. / 3., Scale::logarithmic},
    {"Load/Temperature", "T", "degC", 298.15, 1173.15, Scale::linear}};

  using Truth = std::function<double(const double *)>;

  /** Softening (Johnson and Cook) and a slow transition from ploughing of
   * single asperities to contact all over. */
  double
  dry(const double *x)
  {
    const double softened =
      1. - std::pow(std::max(0., (x[2] - 298.15) / 1495.), 1.03);
    return 0.12 * std::pow(x[0] / 3e8, -0.15) *
           (1. + 0.02 * std::log(x[1] / 0.375)) * (0.6 + 0.4 * softened) *
           (1. + 0.1 * std::tanh((x[0] / 3e8 - 2.3) * softened));
  }

  /** Oil carries everything up to a pressure that depends on velocity and
   *  temperature; above it solid contact starts with a kink. */
  double
  lubricated(const double *x)
  {
    const double viscosity = std::exp(-(x[2] - 298.15) / 440.);
    const double carried   = 2e8 * (1. + 0.5 * x[1] * viscosity);
    return 0.03 + 0.005 * viscosity * x[1] +
           0.1 * std::max(0., 1. - carried / x[0]) *
             (1. - 0.3 * (x[2] - 298.15) / 875.);
  }

  double
  normal(RandomNumbers &random)
  {
    const double radius = std::sqrt(-2. * std::log(1. - random.uniform()));
    return radius * std::cos(2. * M_PI * random.uniform());
  }

  struct Quality
  {
    double coverage, error; ///< both shares
  };

  /** Training on corners and Sobol points that @p keep wants, judged by random
   *  points that it does not want, or by points anywhere if it wants all. */
  Quality
  judge(const Truth                               &truth,
        const double                               noise,
        const std::size_t                          n,
        const std::function<bool(const double *)> &is_trained)
  {
    RandomNumbers       random(11);
    std::vector<double> unit  = unit_corners(3);
    const auto          sobol = unit_sobol(n - 8, 3);
    unit.insert(unit.end(), sobol.begin(), sobol.end());
    FrictionLawDescription description;
    description.inputs = inputs;
    std::vector<double> x, y;
    const auto          run = [&](const double *z) {
      const std::vector<double> point = map_to_box(inputs, {z, z + 3});
      x.insert(x.end(), point.begin(), point.end());
      y.push_back(truth(point.data()) * (1. + noise * normal(random)));
    };
    for (std::size_t j = 0; j < n; ++j)
      if (is_trained(&unit[3 * j]))
        run(&unit[3 * j]);
    const FrictionLaw law = FrictionLaw::train(description, x, y);

    bool all = true;
    for (std::size_t j = 0; j < n; ++j)
      all = all && is_trained(&unit[3 * j]);
    x.clear();
    y.clear();
    while (y.size() < 1000)
      {
        const double z[3] = {random.uniform(),
                             random.uniform(),
                             random.uniform()};
        if (all || !is_trained(z))
          run(z);
      }
    Quality quality{0., 0.};
    for (std::size_t j = 0; j < y.size(); ++j)
      {
        const LawPrediction found = law.predict(&x[3 * j]);
        quality.coverage += (y[j] >= found.lower && y[j] <= found.upper) / 1e3;
        quality.error += std::abs(found.mean - y[j]) / y[j] / 1e3;
      }
    return quality;
  }

  bool
  everything(const double *)
  {
    return true;
  }
} // namespace



// 95 % are promised; the scatter of a thousand points is 0.7 %, that of the law
// itself more.
TEST(Calibration, band_holds_other_runs)
{
  for (const auto &truth : {dry, lubricated})
    for (const double noise : {0., 0.01})
      {
        const Quality quality = judge(truth, noise, 110, everything);
        EXPECT_GT(quality.coverage, 0.9);
        EXPECT_LT(quality.coverage, 0.98);
        // an unbiased law would be wrong by the mean of |noise|, 0.8 noise
        EXPECT_LT(quality.error, 0.01 + noise);
      }
}



// A slab at one face of the box without a run: the error stays small, and the
// band knows of most of it, but not of a change of behaviour that it has not
// seen. So a law is trusted inside of its box only.
TEST(Calibration, edge_blocks_left_out)
{
  for (const auto &truth : {dry, lubricated})
    {
      double mean_coverage = 0.;
      for (unsigned int face = 0; face < 6; ++face)
        {
          const auto is_trained = [face](const double *z) {
            return face % 2 == 0 ? z[face / 2] > 0.15 : z[face / 2] < 0.85;
          };
          const Quality quality = judge(truth, 0.002, 110, is_trained);
          EXPECT_GT(quality.coverage, 0.6) << face;
          EXPECT_LT(quality.error, 0.04) << face;
          mean_coverage += quality.coverage / 6.;
        }
      EXPECT_GT(mean_coverage, 0.85);
    }
}
