#ifndef asperity_surrogate_kernel_formulas_h
#define asperity_surrogate_kernel_formulas_h

/*
 * The correlation f of two points at a squared distance r2, all inputs divided
 * by their length scales, in terms of an argument a(r2), of e = exp(-a) and of
 *
 *   R(a) = (exp(-a) - 1 + a) / a^2.
 *
 * f - 1 is wanted to full accuracy also where f is close to 1: for small a
 *
 *   exp(-a) - 1                 = a (a R - 1),
 *   (1 + a) exp(-a) - 1         = a^2 ((1 + a) R - 1),
 *   (1 + a + a^2/3) exp(-a) - 1 = a^2 ((1 + a + a^2/3) R - 2/3 - a/3),
 *
 * and for large a the left sides. The slope is -2 df/d(r2), finite at r2 = 0.
 *
 * This file is C99 and C++ at once: Asperity computes with it, and it becomes
 * part of the C source of an exported law.
 */

/* Where exp(-a) is zero for all purposes. */
#define KERNEL_LARGEST_ARGUMENT 700.

/* From here on f - 1 is computed for large a. */
#define KERNEL_LARGE_ARGUMENT 0.5

/* R(a) for a below that, where 14 terms of its Taylor series are exact to
 * rounding. */
static inline double
kernel_rest(const double a)
{
  double sum = 1. / 1307674368000.; /* 1/15! */

  sum = 1. / 87178291200. - a * sum;
  sum = 1. / 6227020800. - a * sum;
  sum = 1. / 479001600. - a * sum;
  sum = 1. / 39916800. - a * sum;
  sum = 1. / 3628800. - a * sum;
  sum = 1. / 362880. - a * sum;
  sum = 1. / 40320. - a * sum;
  sum = 1. / 5040. - a * sum;
  sum = 1. / 720. - a * sum;
  sum = 1. / 120. - a * sum;
  sum = 1. / 24. - a * sum;
  sum = 1. / 6. - a * sum;
  return 0.5 - a * sum;
}

/* Squared exponential (RBF): a = r2/2, f = exp(-a). */
#define RBF_ARGUMENT(r2) (0.5 * (r2))
#define RBF_VALUE(a, e) (e)
#define RBF_DEFICIT(a, R) ((a) * ((a) * (R)-1.))
#define RBF_SLOPE(a, e) (e)

/* Matern 3/2: a = sqrt(3 r2), f = (1 + a) exp(-a). */
#define MATERN_3_2_ARGUMENT(r2) sqrt(3. * (r2))
#define MATERN_3_2_VALUE(a, e) ((1. + (a)) * (e))
#define MATERN_3_2_DEFICIT(a, R) ((a) * (a) * ((1. + (a)) * (R)-1.))
#define MATERN_3_2_SLOPE(a, e) (3. * (e))

/* Matern 5/2: a = sqrt(5 r2), f = (1 + a + a^2/3) exp(-a). */
#define MATERN_5_2_ARGUMENT(r2) sqrt(5. * (r2))
#define MATERN_5_2_VALUE(a, e) ((1. + (a) + (a) * (a) / 3.) * (e))
#define MATERN_5_2_DEFICIT(a, R) \
  ((a) * (a) * ((1. + (a) + (a) * (a) / 3.) * (R) - (2. + (a)) / 3.))
#define MATERN_5_2_SLOPE(a, e) (5. / 3. * (1. + (a)) * (e))

#endif
