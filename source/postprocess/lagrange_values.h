#ifndef asperity_postprocess_lagrange_values_h
#define asperity_postprocess_lagrange_values_h

#include <deal.II/base/quadrature_lib.h>

#include <vector>

namespace asperity
{
  namespace internal
  {
    /** Lagrange polynomials through the Gauss points at equidistant points,
     *  [picture point * n_gauss_points + Gauss point]. */
    inline std::vector<double>
    lagrange_values(const unsigned int n_subdivisions,
                    const unsigned int n_gauss_points)
    {
      const dealii::QGauss<1> gauss(n_gauss_points);
      std::vector<double>     values;
      for (unsigned int i = 0; i <= n_subdivisions; ++i)
        for (unsigned int g = 0; g < n_gauss_points; ++g)
          {
            const double x     = static_cast<double>(i) / n_subdivisions;
            double       value = 1.;
            for (unsigned int h = 0; h < n_gauss_points; ++h)
              if (h != g)
                value *= (x - gauss.point(h)[0]) /
                         (gauss.point(g)[0] - gauss.point(h)[0]);
            values.push_back(value);
          }
      return values;
    }
  } // namespace internal
} // namespace asperity

#endif
