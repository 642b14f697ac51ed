/* A Gaussian process that was trained on runs, as a part of tribmu.c. */

/* BEGIN kernels */
#include "kernel_formulas.h"
/* END kernels */

/* BEGIN runs */
/* Three runs over pressure and wetting. */
#define N 3      /* training runs */
#define KERNEL 3 /* 1: RBF, 3: Matern 3/2, 5: Matern 5/2 */

static const double points[N * D] = {0., 0., 1., 0.25, 2., 0.5};
static const double weights[N]    = {0.5, -0.25, 0.125};
/* inverse triangular factor of the covariance, row by row */
static const double B[N * (N + 1) / 2] = {1., -0.5, 1.25, 0.25, -0.5, 1.5};

static const double sum_of_weights  = 0.375;
static const double signal_variance = 1.;
/* END runs */

/* correlation with run j minus 1, which is accurate also for small distances,
 * and -2 times its derivative by r^2 */
static double
deficit(const double s[D], int j, double *slope)
{
  double r2 = 0., a, e;
  int    i, is_small;

  for (i = 0; i < D; ++i)
    r2 += (points[j * D + i] - s[i]) * (points[j * D + i] - s[i]);
  a = KERNEL == 1 ? RBF_ARGUMENT(r2) :
      KERNEL == 3 ? MATERN_3_2_ARGUMENT(r2) :
                    MATERN_5_2_ARGUMENT(r2);
  if (a >= KERNEL_LARGEST_ARGUMENT) /* too far away to matter */
    {
      *slope = 0.;
      return -1.;
    }
  e        = exp(-a);
  is_small = a < KERNEL_LARGE_ARGUMENT;
  if (KERNEL == 1)
    {
      *slope = RBF_SLOPE(a, e);
      return is_small ? RBF_DEFICIT(a, kernel_rest(a)) : RBF_VALUE(a, e) - 1.;
    }
  if (KERNEL == 3)
    {
      *slope = MATERN_3_2_SLOPE(a, e);
      return is_small ? MATERN_3_2_DEFICIT(a, kernel_rest(a)) :
                        MATERN_3_2_VALUE(a, e) - 1.;
    }
  *slope = MATERN_5_2_SLOPE(a, e);
  return is_small ? MATERN_5_2_DEFICIT(a, kernel_rest(a)) :
                    MATERN_5_2_VALUE(a, e) - 1.;
}

/* The fitted function, and its derivatives by s unless g is NULL. */
static double
fitted(const double s[D], double g[D])
{
  double m = sum_of_weights, slope;
  int    i, j;

  for (i = 0; g && i < D; ++i)
    g[i] = 0.;
  for (j = 0; j < N; ++j)
    {
      m += weights[j] * deficit(s, j, &slope);
      if (!g || slope <= 0.)
        continue;
      slope *= weights[j];
      for (i = 0; i < D; ++i)
        g[i] += slope * (points[j * D + i] - s[i]);
    }
  return m;
}

/* The variance of the fitted function, if it HAS_DEVIATION. */
static double
variance_of_fitted(const double s[D])
{
  double        f[N], slope, norm = 0.;
  const double *b = B;
  int           i, j;

  for (j = 0; j < N; ++j)
    f[j] = 1. + deficit(s, j, &slope);
  for (i = 0; i < N; ++i)
    {
      double product = 0.;

      for (j = 0; j <= i; ++j)
        product += *b++ * f[j];
      norm += product * product;
    }
  return norm >= 1. ? 0. : signal_variance * (1. - norm);
}
