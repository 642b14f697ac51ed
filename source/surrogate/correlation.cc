#include "correlation.h"

#include <asperity/base/vector_widths.h>

#include <algorithm>
#include <cmath>

#include "kernel_formulas.h"

namespace asperity
{
  namespace correlation
  {
    /** Before vectorised versions of exp fall back to slow ones and before
     *  infinities can come up. */
    constexpr double largest = KERNEL_LARGEST_ARGUMENT;

    ASPERITY_ALL_VECTOR_WIDTHS
    void
    squared_distances(const std::size_t n,
                      const std::size_t n_inputs,
                      const double     *points,
                      const std::size_t stride,
                      const double     *x,
                      double           *r2)
    {
      for (std::size_t j = 0; j < n; ++j)
        r2[j] = 0.;
      for (std::size_t i = 0; i < n_inputs; ++i)
        {
          const double *const p  = points + i * stride;
          const double        xi = x[i];
          for (std::size_t j = 0; j < n; ++j)
            r2[j] += (p[j] - xi) * (p[j] - xi);
        }
    }



    ASPERITY_ALL_VECTOR_WIDTHS
    void
    values(const KernelKind  kernel,
           const double      variance,
           const std::size_t n,
           const double     *r2,
           double           *values)
    {
      if (kernel == KernelKind::rbf)
        for (std::size_t j = 0; j < n; ++j)
          {
            const double a = std::min(RBF_ARGUMENT(r2[j]), largest);
            values[j]      = variance * RBF_VALUE(a, std::exp(-a));
          }
      else if (kernel == KernelKind::matern_3_2)
        for (std::size_t j = 0; j < n; ++j)
          {
            const double a = std::min(MATERN_3_2_ARGUMENT(r2[j]), largest);
            values[j]      = variance * MATERN_3_2_VALUE(a, std::exp(-a));
          }
      else
        for (std::size_t j = 0; j < n; ++j)
          {
            const double a = std::min(MATERN_5_2_ARGUMENT(r2[j]), largest);
            values[j]      = variance * MATERN_5_2_VALUE(a, std::exp(-a));
          }
    }



    // Both branches are computed, so that there is no jump in the loop.
    ASPERITY_ALL_VECTOR_WIDTHS
    void
    deficits(const KernelKind  kernel,
             const double      variance,
             const std::size_t n,
             const double     *r2,
             double           *deficits)
    {
      if (kernel == KernelKind::rbf)
        for (std::size_t j = 0; j < n; ++j)
          {
            const double a     = std::min(RBF_ARGUMENT(r2[j]), largest);
            const double small = RBF_DEFICIT(a, kernel_rest(a));
            const double large = RBF_VALUE(a, std::exp(-a)) - 1.;
            deficits[j] =
              variance * (a < KERNEL_LARGE_ARGUMENT ? small : large);
          }
      else if (kernel == KernelKind::matern_3_2)
        for (std::size_t j = 0; j < n; ++j)
          {
            const double a     = std::min(MATERN_3_2_ARGUMENT(r2[j]), largest);
            const double small = MATERN_3_2_DEFICIT(a, kernel_rest(a));
            const double large = MATERN_3_2_VALUE(a, std::exp(-a)) - 1.;
            deficits[j] =
              variance * (a < KERNEL_LARGE_ARGUMENT ? small : large);
          }
      else
        for (std::size_t j = 0; j < n; ++j)
          {
            const double a     = std::min(MATERN_5_2_ARGUMENT(r2[j]), largest);
            const double small = MATERN_5_2_DEFICIT(a, kernel_rest(a));
            const double large = MATERN_5_2_VALUE(a, std::exp(-a)) - 1.;
            deficits[j] =
              variance * (a < KERNEL_LARGE_ARGUMENT ? small : large);
          }
    }



    ASPERITY_ALL_VECTOR_WIDTHS
    void
    slopes(const KernelKind  kernel,
           const double      variance,
           const std::size_t n,
           const double     *r2,
           double           *slopes)
    {
      if (kernel == KernelKind::rbf)
        for (std::size_t j = 0; j < n; ++j)
          {
            const double a = std::min(RBF_ARGUMENT(r2[j]), largest);
            slopes[j]      = variance * RBF_SLOPE(a, std::exp(-a));
          }
      else if (kernel == KernelKind::matern_3_2)
        for (std::size_t j = 0; j < n; ++j)
          {
            const double a = std::min(MATERN_3_2_ARGUMENT(r2[j]), largest);
            slopes[j]      = variance * MATERN_3_2_SLOPE(a, std::exp(-a));
          }
      else
        for (std::size_t j = 0; j < n; ++j)
          {
            const double a = std::min(MATERN_5_2_ARGUMENT(r2[j]), largest);
            slopes[j]      = variance * MATERN_5_2_SLOPE(a, std::exp(-a));
          }
    }



    ASPERITY_ALL_VECTOR_WIDTHS
    double
    dot(const std::size_t n, const double *a, const double *b)
    {
      double sum = 0.;
      for (std::size_t j = 0; j < n; ++j)
        sum += a[j] * b[j];
      return sum;
    }



    ASPERITY_ALL_VECTOR_WIDTHS
    double
    second_moment(const std::size_t n,
                  const double     *weights,
                  const double     *points,
                  const double      x)
    {
      double sum = 0.;
      for (std::size_t j = 0; j < n; ++j)
        sum += weights[j] * (points[j] - x) * (points[j] - x);
      return sum;
    }



    ASPERITY_ALL_VECTOR_WIDTHS
    double
    first_moment(const std::size_t n,
                 const double     *a,
                 const double     *b,
                 const double     *points,
                 const double      x)
    {
      double sum = 0.;
      for (std::size_t j = 0; j < n; ++j)
        sum += a[j] * b[j] * (points[j] - x);
      return sum;
    }



    ASPERITY_ALL_VECTOR_WIDTHS
    double
    triangular_norm_square(const std::size_t n,
                           const double     *a,
                           const double     *b)
    {
      // Four rows at a time keep four sums in flight and read b a quarter as
      // often; what they have beyond the first one's end follows apart.
      double      sum = 0.;
      std::size_t i   = 0;
      for (; i + 4 <= n; i += 4)
        {
          const double *const a1 = a + i + 1, *const a2 = a1 + i + 2,
                              *const a3 = a2 + i + 3;
          double                     s0 = 0., s1 = 0., s2 = 0., s3 = 0.;
          for (std::size_t j = 0; j <= i; ++j)
            {
              s0 += a[j] * b[j];
              s1 += a1[j] * b[j];
              s2 += a2[j] * b[j];
              s3 += a3[j] * b[j];
            }
          s1 += a1[i + 1] * b[i + 1];
          s2 += a2[i + 1] * b[i + 1] + a2[i + 2] * b[i + 2];
          s3 +=
            a3[i + 1] * b[i + 1] + a3[i + 2] * b[i + 2] + a3[i + 3] * b[i + 3];
          sum += s0 * s0 + s1 * s1 + s2 * s2 + s3 * s3;
          a = a3 + i + 4;
        }
      for (; i < n; ++i)
        {
          const double product = dot(i + 1, a, b);
          sum += product * product;
          a += i + 1;
        }
      return sum;
    }
  } // namespace correlation
} // namespace asperity
