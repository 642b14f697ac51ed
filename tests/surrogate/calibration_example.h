#ifndef asperity_tests_calibration_example_h
#define asperity_tests_calibration_example_h

#include <asperity/base/random_numbers.h>
#include <asperity/surrogate/design.h>
#include <asperity/surrogate/friction_law.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

/** Laws of functions that are known everywhere, so that their band can be
 *  judged by as many other runs as one likes. */
namespace calibration_example
{
  using namespace asperity;

  inline const std::vector<LawInput> inputs = {
    {"Load/Pressure", "p", "MPa", 3e8, 1.3e9, Scale::logarithmic},
    {"Load/Velocity", "v", "m/min", 0.375, 10. / 3., Scale::logarithmic},
    {"Load/Temperature", "T", "degC", 298.15, 1173.15, Scale::linear}};

  using Truth = std::function<double(const double *)>;

  /** Softening (Johnson and Cook) and a slow transition from ploughing of
   * single asperities to contact all over. */
  inline double
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
  inline double
  lubricated(const double *x)
  {
    const double viscosity = std::exp(-(x[2] - 298.15) / 440.);
    const double carried   = 2e8 * (1. + 0.5 * x[1] * viscosity);
    return 0.03 + 0.005 * viscosity * x[1] +
           0.1 * std::max(0., 1. - carried / x[0]) *
             (1. - 0.3 * (x[2] - 298.15) / 875.);
  }

  struct Quality
  {
    double coverage, error; ///< both shares

    std::vector<std::string> warnings; ///< of the law
  };

  /** Training on corners and Sobol points that @p keep wants, judged by random
   *  points that it does not want, or by points anywhere if it wants all. */
  inline Quality
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
      y.push_back(truth(point.data()) * (1. + noise * random.normal()));
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
    Quality quality{0., 0., law.description().warnings};
    for (std::size_t j = 0; j < y.size(); ++j)
      {
        const LawPrediction found = law.predict(&x[3 * j]);
        quality.coverage += (y[j] >= found.lower && y[j] <= found.upper) / 1e3;
        quality.error += std::abs(found.mean - y[j]) / y[j] / 1e3;
      }
    return quality;
  }

  inline bool
  everything(const double *)
  {
    return true;
  }

  /** Whether a point of the unit cube lies off the slab of 15 % at a face. */
  inline bool
  is_off_face(const unsigned int face, const double *z)
  {
    return face % 2 == 0 ? z[face / 2] > 0.15 : z[face / 2] < 0.85;
  }
} // namespace calibration_example

#endif
