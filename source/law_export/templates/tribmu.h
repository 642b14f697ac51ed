#ifndef TRIBMU_H
#define TRIBMU_H

#ifdef __cplusplus
extern "C"
{
#endif

/* Inputs of the law beside pressure, velocity and temperature. */
/* BEGIN further */
/* Lubrication/Wetting [1] = 0.5 */
#define TRIBMU_FURTHER 1
  /* END further */

  /* The friction coefficient.
   * p: pressure [Pa], v: sliding velocity [m/s], T: temperature [K]
   * dmu: the derivatives by p, v and T, or NULL
   * inside: whether the point is in the box of the training data, or NULL
   *
   * Further inputs are held at the values that stand above.
   *
   * Outside of the box the law is still answered, with finite numbers: far away
   * it tends to a constant. A pressure, velocity or temperature
   * that is not positive is replaced by the lower end of its range if the law
   * sees its logarithm (see the ranges above); the derivative by it is 0 then.
   */
  double
  tribmu(double p, double v, double T, double dmu[3], int *inside);

  /* The same with the further inputs as arguments.
   * further: TRIBMU_FURTHER values in SI, in the order that stands above
   * dmu: 3 + TRIBMU_FURTHER derivatives: by p, v, T and the further inputs */
  double
  tribmu_at(double       p,
            double       v,
            double       T,
            const double further[],
            double       dmu[],
            int         *inside);

  /* The standard deviation of mu, which takes longer than mu itself; and
   * whether mu is to be trusted: in the box, and with a deviation that is
   * small. See tribmu.c if this file was written with the deviation: -1 means
   * without. */
  double
  tribmu_sigma(double p, double v, double T, int *trusted);

  double
  tribmu_sigma_at(double       p,
                  double       v,
                  double       T,
                  const double further[],
                  int         *trusted);

  /* The shear limit k [Pa], HUGE_VAL if unknown; dk: its derivative, or NULL.
   */
  double
  tribmu_k(double T, double *dk);

  /* The shear stress min(mu p, k) [Pa]. */
  double
  tribmu_tau(double p, double v, double T);

  double
  tribmu_tau_at(double p, double v, double T, const double further[]);

#ifdef __cplusplus
}
#endif

#endif
