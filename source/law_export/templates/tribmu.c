#include "tribmu.h"

#include <math.h>
#include <stddef.h>

/* BEGIN kernels */
#include "kernel_formulas.h"
/* END kernels */

/* BEGIN data */
/* Three runs over pressure and wetting. */
#define D 2             /* inputs of the law */
#define N 3             /* training runs */
#define KERNEL 3        /* 1: RBF, 3: Matern 3/2, 5: Matern 5/2 */
#define LOGARITHMIC 1   /* whether the process is ln(mu) */
#define HAS_DEVIATION 1 /* whether B is there */
#define HAS_LIMIT 1     /* whether k is known */
#define SOFTENS 1       /* whether k depends on T */

/* which input of p, v, T and the further ones each is */
static const int place[D] = {0, 3};
/* how the kernel sees it: (g(x) - origin)/span/length, g = log or identity */
static const int    sees_logarithm[D] = {0, 0};
static const double origin[D]         = {3e8, 0.};
static const double span[D]           = {1e9, 1.};
static const double length[D]         = {0.5, 2.};
/* its range, and what still counts as inside of that */
static const double lower[D]      = {3e8, 0.};
static const double low_edge[D]   = {3e8, 0.};
static const double high_edge[D]  = {1.3e9, 1.};
/* values at which tribmu() holds the further inputs, and a zero behind them */
static const double stated[TRIBMU_FURTHER + 1] = {0.5, 0.};

static const double points[N * D] = {0., 0., 1., 0.25, 2., 0.5};
static const double weights[N]   = {0.5, -0.25, 0.125};
/* inverse triangular factor of the covariance, row by row */
static const double B[N * (N + 1) / 2] = {1., -0.5, 1.25, 0.25, -0.5, 1.5};

static const double sum_of_weights            = 0.375;
static const double signal_variance           = 1.;
static const double offset                    = -2.;
static const double factor                    = 0.25;
static const double largest_trusted_deviation = 0.05;

static const double k_0          = 6e8;
static const double k_exponent   = 1.;
static const double k_transition = 293.15;
static const double k_range      = 1480.; /* to the melting temperature */
/* END data */

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

/* The inputs of the law among the arguments. */
static void
gather(double p, double v, double T, const double further[], double x[D])
{
  int i;

  for (i = 0; i < D; ++i)
    x[i] = place[i] == 0 ? p :
           place[i] == 1 ? v :
           place[i] == 2 ? T :
                           further[place[i] - 3];
}

/* What the kernel sees of the inputs, and the derivatives by them. Tiny numbers
 * have no inverse. */
static void
scale(const double x[D], double s[D], double ds[D])
{
  int i;

  for (i = 0; i < D; ++i)
    if (sees_logarithm[i])
      {
        ds[i] = x[i] > 1e-300 ? 1. / (x[i] * span[i] * length[i]) : 0.;
        s[i]  = (log(x[i] <= 0. ? lower[i] : x[i]) - origin[i]) / span[i] /
               length[i];
      }
    else
      {
        ds[i] = 1. / (span[i] * length[i]);
        s[i]  = (x[i] - origin[i]) / span[i] / length[i];
      }
}

/* in the box of the training data; false if not a number */
static int
is_inside(const double x[D])
{
  int i, result = 1;

  for (i = 0; i < D; ++i)
    result = result && x[i] >= low_edge[i] && x[i] <= high_edge[i];
  return result;
}

double
tribmu_at(double       p,
          double       v,
          double       T,
          const double further[],
          double       dmu[],
          int         *inside)
{
  double x[D], s[D], ds[D], g[D] = {0.}, mu, slope, m = sum_of_weights;
  int    i, j;

  gather(p, v, T, further, x);
  scale(x, s, ds);
  for (j = 0; j < N; ++j)
    {
      m += weights[j] * deficit(s, j, &slope);
      if (slope <= 0.)
        continue;
      slope *= weights[j];
      for (i = 0; i < D; ++i)
        g[i] += slope * (points[j * D + i] - s[i]);
    }
  mu = offset + factor * m;
  if (LOGARITHMIC)
    mu = exp(mu);
  if (dmu)
    {
      for (i = 0; i < 3 + TRIBMU_FURTHER; ++i)
        dmu[i] = 0.;
      for (i = 0; i < D; ++i)
        dmu[place[i]] = (LOGARITHMIC ? mu : 1.) * factor * g[i] * ds[i];
    }
  if (inside)
    *inside = is_inside(x);
  return mu;
}

double
tribmu_sigma_at(double       p,
                double       v,
                double       T,
                const double further[],
                int         *trusted)
{
  double        x[D], s[D], ds[D], f[N], slope, norm = 0., mu, sigma;
  const double *b = B;
  int           i, j;

  gather(p, v, T, further, x);
  if (!HAS_DEVIATION)
    {
      if (trusted)
        *trusted = is_inside(x);
      return -1.;
    }
  scale(x, s, ds);
  for (j = 0; j < N; ++j)
    f[j] = 1. + deficit(s, j, &slope);
  for (i = 0; i < N; ++i)
    {
      double product = 0.;

      for (j = 0; j <= i; ++j)
        product += *b++ * f[j];
      norm += product * product;
    }
  sigma = norm >= 1. ? 0. : factor * sqrt(signal_variance * (1. - norm));
  mu    = tribmu_at(p, v, T, further, NULL, NULL);
  if (LOGARITHMIC)
    sigma *= mu;
  if (trusted)
    *trusted = is_inside(x) && sigma <= largest_trusted_deviation * fabs(mu);
  return sigma;
}

double
tribmu_k(double T, double *dk)
{
  const double t = SOFTENS ? (T - k_transition) / k_range : 0.;

  if (dk)
    *dk = HAS_LIMIT && t > 0. && t < 1. ?
            -k_0 * k_exponent * pow(t, k_exponent - 1.) / k_range :
            0.;
  if (!HAS_LIMIT)
    return HUGE_VAL;
  if (t <= 0.)
    return k_0;
  return t >= 1. ? 0. : k_0 * (1. - pow(t, k_exponent));
}

double
tribmu_tau_at(double p, double v, double T, const double further[])
{
  const double coulomb = tribmu_at(p, v, T, further, NULL, NULL) * p;
  const double k       = tribmu_k(T, NULL);

  return coulomb < k ? coulomb : k;
}

double
tribmu(double p, double v, double T, double dmu[3], int *inside)
{
  double       all[3 + TRIBMU_FURTHER];
  const double mu =
    tribmu_at(p, v, T, stated, dmu == NULL ? NULL : all, inside);
  int i;

  if (dmu)
    for (i = 0; i < 3; ++i)
      dmu[i] = all[i];
  return mu;
}

double
tribmu_sigma(double p, double v, double T, int *trusted)
{
  return tribmu_sigma_at(p, v, T, stated, trusted);
}

double
tribmu_tau(double p, double v, double T)
{
  return tribmu_tau_at(p, v, T, stated);
}
