#ifndef asperity_tests_surrogate_sample_data_h
#define asperity_tests_surrogate_sample_data_h

#include <asperity/surrogate/gaussian_process.h>

#include <cmath>
#include <functional>
#include <vector>

namespace asperity
{
  /** Point number @p index of an additive recurrence that fills the unit cube
   *  evenly (R_d sequence: powers of the root of x^(d+1) = x + 1). */
  inline std::vector<double>
  evenly_spread_point(const std::size_t index, const std::size_t n_inputs)
  {
    double root = 1.5;
    for (unsigned int i = 0; i < 100; ++i)
      root = std::pow(1. + root, 1. / (static_cast<double>(n_inputs) + 1.));
    std::vector<double> x(n_inputs);
    double              power = 1.;
    for (double &xi : x)
      {
        power /= root;
        xi = std::fmod((static_cast<double>(index) + 1.) * power, 1.);
      }
    return x;
  }

  inline TrainingData
  sample(const std::size_t                                         n,
         const std::size_t                                         n_inputs,
         const std::function<double(const std::vector<double> &)> &function)
  {
    TrainingData data;
    data.n_inputs = n_inputs;
    for (std::size_t j = 0; j < n; ++j)
      {
        const std::vector<double> x = evenly_spread_point(j, n_inputs);
        data.x.insert(data.x.end(), x.begin(), x.end());
        data.y.push_back(function(x));
      }
    return data;
  }

  /** Of three inputs. */
  inline double
  smooth(const std::vector<double> &x)
  {
    return std::sin(3. * x[0]) + 0.5 * std::cos(5. * x[1] * x[2]);
  }

  /** Defined for any number of inputs. */
  inline double
  wavy(const std::vector<double> &x)
  {
    double sum = 0.3;
    for (std::size_t i = 0; i < x.size(); ++i)
      sum += std::sin((3. + i) * x[i]) * (1. + x[(i + 1) % x.size()]);
    return sum;
  }

  inline const Hyperparameters three_inputs{1.7, {0.6, 0.9, 1.3}, 1e-3};

  inline const std::vector<KernelKind> all_kernels = {KernelKind::rbf,
                                                      KernelKind::matern_3_2,
                                                      KernelKind::matern_5_2};
} // namespace asperity

#endif
