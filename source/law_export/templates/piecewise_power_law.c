/* ln(mu) over the logarithm of the velocity, a part of tribmu.c: constant up to
 * a knee, a line beyond it, and constant again from the end on. */

/* BEGIN constants */
/* mu = 0.5 up to 1 m/s, and 0.5 v^-0.4 beyond. */
static const double level = -0.6931471805599453, knee = 0., slope = -0.4;
static const double end = 9.;
/* of level, knee and slope, row by row */
static const double covariance[9] = {0.01, 0., 0., 0., 0.04, 0., 0., 0., 0.01};
/* END constants */

/* How far s lies beyond the knee; what is no number stays none. */
static double
beyond_knee(const double s[D])
{
  return s[0] <= knee ? 0. : (s[0] > end ? end : s[0]) - knee;
}

/* The fitted function, and its derivatives by s unless g is NULL. */
static double
fitted(const double s[D], double g[D])
{
  if (g)
    g[0] = s[0] <= knee || s[0] > end ? 0. : slope;
  return level + slope * beyond_knee(s);
}

/* The variance of the fitted function. */
static double
variance_of_fitted(const double s[D])
{
  double by[3], variance = 0.;
  int    i, j;

  by[0] = 1.;
  by[1] = s[0] <= knee ? 0. : -slope;
  by[2] = beyond_knee(s);
  for (i = 0; i < 3; ++i)
    for (j = 0; j < 3; ++j)
      variance += by[i] * covariance[3 * i + j] * by[j];
  return variance < 0. ? 0. : variance;
}
