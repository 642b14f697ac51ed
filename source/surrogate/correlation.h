#ifndef asperity_surrogate_correlation_h
#define asperity_surrogate_correlation_h

#include <asperity/surrogate/gaussian_process.h>

#include <cstddef>

namespace asperity
{
  /**
   * The inner loops of Gaussian processes, written so that the compiler turns
   * them into vector instructions, and compiled with the options for that. They
   * know neither infinities nor NaN.
   */
  namespace correlation
  {
    /**
     * r2[j] = sum over i of (points[i * stride + j] - x[i])^2, all divided by
     * the length scales already.
     */
    void
    squared_distances(const std::size_t n,
                      const std::size_t n_inputs,
                      const double     *points,
                      const std::size_t stride,
                      const double     *x,
                      double           *r2);

    /** values[j] = variance f(r_j); r2 and values may be the same. */
    void
    values(const KernelKind  kernel,
           const double      variance,
           const std::size_t n,
           const double     *r2,
           double           *values);

    /**
     * deficits[j] = variance (f(r_j) - 1), to full accuracy also where f is
     * close to 1: with long length scales the mean is a sum of huge terms that
     * nearly cancel, and without the 1 in f they are smaller by orders of
     * magnitude. r2 and deficits may be the same.
     */
    void
    deficits(const KernelKind  kernel,
             const double      variance,
             const std::size_t n,
             const double     *r2,
             double           *deficits);

    /** slopes[j] = -2 variance df/d(r^2), finite also at r = 0. */
    void
    slopes(const KernelKind  kernel,
           const double      variance,
           const std::size_t n,
           const double     *r2,
           double           *slopes);

    double
    dot(const std::size_t n, const double *a, const double *b);

    /** sum over j of weights[j] (points[j] - x)^2 */
    double
    second_moment(const std::size_t n,
                  const double     *weights,
                  const double     *points,
                  const double      x);

    /** sum over j of a[j] b[j] (points[j] - x) */
    double
    first_moment(const std::size_t n,
                 const double     *a,
                 const double     *b,
                 const double     *points,
                 const double      x);

    /** |A b|^2 of a lower triangular matrix stored row by row without gaps. */
    double
    triangular_norm_square(const std::size_t n,
                           const double     *a,
                           const double     *b);
  } // namespace correlation
} // namespace asperity

#endif
