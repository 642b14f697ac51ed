#ifndef asperity_tests_mesh_motion_example_surfaces_h
#define asperity_tests_mesh_motion_example_surfaces_h

#include <asperity/splines/spline_curve.h>
#include <asperity/splines/spline_fit.h>

#include <cmath>
#include <functional>
#include <vector>

namespace asperity
{
  /** The surfaces of the reference scene R0, in m: a flat chip below a tool of
   *  six harmonics, with a smallest gap of 0.02 um. */
  namespace example
  {
    constexpr double um     = 1e-6;
    constexpr double period = 10. * um;

    /** Of the tool, without offset, and its derivative [m, -]. */
    inline double
    harmonics(const double x, const unsigned int derivative = 0)
    {
      const double a[]   = {0.16, 0.12, 0.09, 0.06, 0.04, 0.02};
      const double phi[] = {0.3, 1.9, 4.1, 5.2, 0.9, 2.6};
      double       sum   = 0.;
      for (unsigned int k = 1; k <= 6; ++k)
        {
          const double wave_number = 2. * M_PI * k / period;
          const double phase       = wave_number * x + phi[k - 1];
          sum += a[k - 1] * um *
                 (derivative == 0 ? std::cos(phase) :
                                    -wave_number * std::sin(phase));
        }
      return sum;
    }

    /** Height of the tool above the flat chip at y = 0 [m]. */
    inline double
    tool_height(const double x)
    {
      static const double lowest = [] {
        double smallest = 0.;
        for (unsigned int i = 0; i < 100000; ++i)
          smallest = std::min(smallest, harmonics(1e-5 * i * period));
        return smallest;
      }();
      return 0.02 * um + harmonics(x) - lowest;
    }

    /** A quadratic spline through the function on equal spans. */
    inline SplineCurve
    surface(const std::function<double(double)> &height,
            const unsigned int                   n_spans = 160,
            const unsigned int                   degree  = 2)
    {
      return interpolate_periodic_function(height, 0., period, n_spans, degree);
    }

    inline SplineCurve
    flat(const double y, const unsigned int n_spans = 80)
    {
      return surface([y](const double) { return y; }, n_spans);
    }
  } // namespace example
} // namespace asperity

#endif
