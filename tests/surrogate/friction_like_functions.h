#ifndef tests_surrogate_friction_like_functions_h
#define tests_surrogate_friction_like_functions_h

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

/**
 * Functions of x = (p [Pa], v [m/s], T [K]) on the box of example_inputs() with
 * the features that friction laws have.
 */
namespace friction_like
{
  /** Temperature between room and melting of steel, from 0 to 1. */
  inline double
  homologous(const double T)
  {
    return (T - 298.15) / (1510.15 - 298.15);
  }

  /** Falls with pressure and temperature, rises slowly with velocity. */
  inline double
  smooth(const double *x)
  {
    const double p = x[0] / 300e6, v = x[1], t = homologous(x[2]);
    return 0.35 * std::pow(p, -0.25) * (1. - 0.45 * std::pow(t, 1.1)) *
           (1. + 0.08 * std::log(v / 0.375)) * (1. + 0.15 * t * std::log(p));
  }

  /** From a pressure on, which falls with temperature, the oil carries load: a
   *  kink on a surface that is oblique to the axes. */
  inline double
  kinked(const double *x)
  {
    const double p = x[0] / 300e6, v = x[1], t = homologous(x[2]);
    const double excess = p - (2.6 - 1.2 * t + 0.25 * std::log(v));
    return smooth(x) / (1. + 0.5 * std::max(0., excess));
  }

  /** Slow runs have not slid far enough to leave the run-in, and cold steel
   *  hardens: boundary layers at two faces. */
  inline double
  layered(const double *x)
  {
    const double v = x[1], t = homologous(x[2]);
    return smooth(x) * (1. - 0.5 * std::exp(-(v - 0.375) / 0.15)) *
           (1. + 0.25 * std::exp(-t / 0.06));
  }

  using Function = double (*)(const double *);

  inline std::vector<double>
  values(const Function function, const std::vector<double> &x)
  {
    std::vector<double> y;
    for (std::size_t i = 0; i < x.size(); i += 3)
      y.push_back(function(&x[i]));
    return y;
  }

  inline const std::vector<std::pair<std::string, Function>> all =
    {{"smooth", smooth}, {"kinked", kinked}, {"layered", layered}};
} // namespace friction_like

#endif
