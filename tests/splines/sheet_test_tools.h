#ifndef asperity_tests_splines_sheet_test_tools_h
#define asperity_tests_splines_sheet_test_tools_h

#include <asperity/splines/sheet_fit.h>

#include <array>
#include <functional>
#include <random>
#include <vector>

namespace asperity_test
{
  /** Spans of 0.6 to 1.4. */
  inline asperity::KnotVector
  uneven_knots(const unsigned int  degree,
               const unsigned int  n_spans,
               const double        begin,
               const unsigned long seed)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> uniform(0.6, 1.4);
    std::vector<double>                    breakpoints = {begin};
    for (unsigned int i = 0; i < n_spans; ++i)
      breakpoints.push_back(breakpoints.back() + uniform(generator));
    return asperity::KnotVector(degree, breakpoints, true);
  }

  /** In [-1, 1]. */
  inline std::vector<double>
  random_numbers(const std::size_t n, const unsigned long seed = 11)
  {
    std::mt19937                           generator(seed);
    std::uniform_real_distribution<double> uniform(-1., 1.);
    std::vector<double>                    numbers(n);
    for (double &number : numbers)
      number = uniform(generator);
    return numbers;
  }

  inline asperity::PeriodicHeights
  sampled(const std::function<double(double, double)> &function,
          const std::array<unsigned int, 2>           &n,
          const std::array<double, 2>                 &period)
  {
    asperity::PeriodicHeights data;
    data.n      = n;
    data.period = period;
    for (unsigned int j = 0; j < n[1]; ++j)
      for (unsigned int i = 0; i < n[0]; ++i)
        data.heights.push_back(
          function(i * period[0] / n[0], j * period[1] / n[1]));
    return data;
  }
} // namespace asperity_test

#endif
