// How the coupling iteration fares on the piston of the tests, where impedances
// are known. Writes coupling_map.csv into the directory given as the first
// argument (default: the current one); tools/charts draws it.

#include <asperity/base/errors.h>

#include <coupling/piston.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace
{
  using namespace piston;

  struct Outcome
  {
    bool         converged   = false;
    double       iterations  = 0.; ///< mean over the steps
    unsigned int maximum     = 0;
    double       contraction = 0.; ///< of the residual, first pair
  };



  /** A solid that tells its tangent at rest only: from the second step on its
   *  impedance is known by secants. */
  class SilentPiston : public Piston
  {
  public:
    bool
    compliance(const Vector &force, Vector &displacement) override
    {
      return time == 0. && Piston::compliance(force, displacement);
    }
  };



  /** Twenty steps of a driven piston with Z_s = 1. */
  template <typename Solid = Piston>
  Outcome
  run(const CouplingParameters &parameters, const double Z_f)
  {
    Solid   solid;
    Chamber fluid;
    solid.mass   = 0.5;
    solid.spring = 0.5;
    solid.drive  = [](const double t) { return std::sin(0.4 * t); };
    fluid.leak   = 1. / Z_f;
    Outcome outcome;
    try
      {
        PartitionedStep    step(solid, fluid, parameters);
        const unsigned int n_steps = 20;
        for (unsigned int i = 0; i < n_steps; ++i)
          {
            const ConvergenceReport report = step.advance(1.);
            if (i == 0 && fluid.outputs.size() > 1)
              outcome.contraction =
                std::abs(fluid.outputs[1] - fluid.inputs[1]) /
                std::abs(fluid.outputs[0] - fluid.inputs[0]);
            if (!report.converged)
              return outcome;
            outcome.iterations += double(report.iterations) / n_steps;
            outcome.maximum = std::max(outcome.maximum, report.iterations);
          }
        outcome.converged = true;
      }
    catch (const InputError &)
      {
        // Dirichlet-Neumann on a sealed pocket.
      }
    return outcome;
  }



  void
  write_map(const std::string &directory)
  {
    const std::vector<std::pair<std::string, AccelerationKind>> methods = {
      {"plain", AccelerationKind::relaxation},
      {"Aitken", AccelerationKind::aitken},
      {"IQN-ILS", AccelerationKind::iqn_ils}};
    std::ofstream table(directory + "/coupling_map.csv");
    table << "method,condition,alpha,Z_f,converged,iterations,maximum,"
             "contraction,formula\n";
    for (const auto &[name, kind] : methods)
      for (const double Z_f : {0.1, 0.3, 1., 3., 10., 1e2, 1e3, 1e4, infinity})
        {
          CouplingParameters parameters;
          parameters.acceleration.kind  = kind;
          parameters.tolerance          = 1e-6;
          parameters.maximum_iterations = 100;
          const auto write              = [&](const std::string &condition,
                                 const double       alpha,
                                 const Outcome     &o) {
            const double q =
              std::isfinite(alpha) && std::isfinite(Z_f) ?
                             Z_f * std::abs(1. - alpha) / (Z_f + alpha) :
                             (std::isfinite(alpha) ? std::abs(1. - alpha) : Z_f);
            table << name << ',' << condition << ',' << alpha << ',' << Z_f
                  << ',' << o.converged << ',' << o.iterations << ','
                  << o.maximum << ',' << o.contraction << ',' << q << '\n';
          };
          for (int k = -12; k <= 12; ++k)
            {
              parameters.robin_coefficient = std::pow(10., k / 4.);
              write("robin",
                    *parameters.robin_coefficient,
                    run(parameters, Z_f));
            }
          parameters.robin_coefficient.reset();
          write("automatic", 1., run(parameters, Z_f));
          write("secant", 1., run<SilentPiston>(parameters, Z_f));
          parameters.scheme = CouplingScheme::dirichlet_neumann;
          write("dirichlet", infinity, run(parameters, Z_f));
        }
  }
} // namespace



int
main(int argc, char **argv)
{
  try
    {
      write_map(argc > 1 ? argv[1] : ".");
    }
  catch (const std::exception &exception)
    {
      std::cerr << exception.what() << '\n';
      return 1;
    }
  return 0;
}
