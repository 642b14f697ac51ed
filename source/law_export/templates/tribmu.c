#include "tribmu.h"

#include <math.h>
#include <stddef.h>

/* BEGIN data */
/* A law over pressure and wetting. */
#define D 2             /* inputs of the law */
#define LOGARITHMIC 1   /* whether ln(mu) is fitted */
#define HAS_DEVIATION 1 /* whether the variance of the fit is known */
#define HAS_LIMIT 1     /* whether k is known */
#define SOFTENS 1       /* whether k depends on T */

/* which input of p, v, T and the further ones each is */
static const int place[D] = {0, 3};
/* how the fit sees it: (g(x) - origin)/span/length, g = log or identity */
static const int    sees_logarithm[D] = {0, 0};
static const double origin[D]         = {3e8, 0.};
static const double span[D]           = {1e9, 1.};
static const double length[D]         = {0.5, 2.};
/* its range, and what still counts as inside of that */
static const double lower[D]      = {3e8, 0.};
static const double upper[D]      = {1.3e9, 1.};
static const double low_edge[D]   = {3e8, 0.};
static const double high_edge[D]  = {1.3e9, 1.};
/* values at which tribmu() holds the further inputs, and a zero behind them */
static const double stated[TRIBMU_FURTHER + 1] = {0.5, 0.};

static const double offset                    = -2.;
static const double factor                    = 0.25;
static const double largest_trusted_deviation = 0.05;

static const double k_0          = 6e8;
static const double k_exponent   = 1.;
static const double k_transition = 293.15;
static const double k_range      = 1480.; /* to the melting temperature */

/* whether the fit sees p/k instead of p, and which inputs p, T and the strain
 * are, D for none */
#define OVER_STRENGTH 0
#define P_INPUT 0
#define T_INPUT D
#define STRAIN_INPUT D
/* k at a strain e over k_0: (1 + ratio min(e + added, limit)^exponent)/hard_0 */
static const double hard_ratio    = 0.;
static const double hard_exponent = 1.;
static const double hard_added    = 0.08;
static const double hard_limit    = 1.;
static const double hard_0        = 1.;
/* END data */

/* BEGIN model */
#include "gaussian_process.c"
/* END model */

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

/* An input within its range. */
static double
clamped(const double x[D], int i)
{
  return x[i] < lower[i] ? lower[i] : x[i] > upper[i] ? upper[i] : x[i];
}

/* Whether it lies strictly inside of that. */
static int
moves(const double x[D], int i)
{
  return x[i] > lower[i] && x[i] < upper[i];
}

/* The strength that the fit sees the pressure over, and its derivatives over
 * itself. */
static double
strength(const double x[D], double by[D])
{
  double k = k_0, dk, e, h, power;
  int    i;

  for (i = 0; i < D; ++i)
    by[i] = 0.;
  for (i = 0; i < D; ++i)
    if (i == T_INPUT)
      {
        k = tribmu_k(clamped(x, i), &dk);
        if (moves(x, i))
          by[i] = dk / k;
      }
  for (i = 0; i < D; ++i)
    if (i == STRAIN_INPUT)
      {
        e     = clamped(x, i) + hard_added;
        power = hard_ratio *
                pow(e < hard_limit ? e : hard_limit, hard_exponent);
        h     = (1. + power) / hard_0;
        if (moves(x, i) && e < hard_limit)
          by[i] = hard_exponent * power / (e * hard_0 * h);
        k *= h;
      }
  return k;
}

/* What the fit sees of the inputs, and the derivatives by them; across: those
 * of the pressure's by the others. Tiny numbers have no inverse. */
static void
scale(const double x[D], double s[D], double ds[D], double across[D])
{
  double q[D], k = 1.;
  int    i;

  for (i = 0; i < D; ++i)
    {
      q[i]      = sees_logarithm[i] && x[i] <= 0. ? lower[i] : x[i];
      across[i] = 0.;
    }
  if (OVER_STRENGTH)
    {
      k = strength(x, across);
      q[P_INPUT] /= k;
    }
  for (i = 0; i < D; ++i)
    if (sees_logarithm[i])
      {
        ds[i] = x[i] > 1e-300 ? 1. / (x[i] * span[i] * length[i]) : 0.;
        s[i]  = (log(q[i]) - origin[i]) / span[i] / length[i];
      }
    else
      {
        ds[i] = 1. / (span[i] * length[i]);
        s[i]  = (q[i] - origin[i]) / span[i] / length[i];
      }
  if (OVER_STRENGTH && !sees_logarithm[P_INPUT])
    ds[P_INPUT] /= k;
  for (i = 0; OVER_STRENGTH && i < D; ++i)
    across[i] *= -(sees_logarithm[P_INPUT] ? 1. : q[P_INPUT]) /
                 (span[P_INPUT] * length[P_INPUT]);
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
  double x[D], s[D], ds[D], across[D], g[D] = {0.}, mu;
  int    i;

  gather(p, v, T, further, x);
  scale(x, s, ds, across);
  mu = offset + factor * fitted(s, dmu == NULL ? NULL : g);
  if (LOGARITHMIC)
    mu = exp(mu);
  if (dmu)
    {
      for (i = 0; i < 3 + TRIBMU_FURTHER; ++i)
        dmu[i] = 0.;
      for (i = 0; i < D; ++i)
        {
          dmu[place[i]] = (LOGARITHMIC ? mu : 1.) * factor * g[i] * ds[i];
          if (g[P_INPUT] != 0.) /* the pressure may be infinite elsewhere */
            dmu[place[i]] +=
              (LOGARITHMIC ? mu : 1.) * factor * g[P_INPUT] * across[i];
        }
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
  double x[D], s[D], ds[D], across[D], mu, sigma;

  gather(p, v, T, further, x);
  if (!HAS_DEVIATION)
    {
      if (trusted)
        *trusted = is_inside(x);
      return -1.;
    }
  scale(x, s, ds, across);
  sigma = factor * sqrt(variance_of_fitted(s));
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
