#ifndef asperity_experiment_moving_source_h
#define asperity_experiment_moving_source_h

namespace asperity
{
  /** What a body does with heat; SI. */
  struct HeatProperties
  {
    double conductivity  = 0.; ///< [W/(m K)]
    double density       = 0.; ///< [kg/m3]
    double heat_capacity = 0.; ///< [J/(kg K)]

    /** k/(rho c) [m2/s] */
    double
    diffusivity() const;
  };

  /**
   * Mean rise of the surface under a uniform band of heat that moves over a
   * half-space, at any Peclet number, over its flux q (J. C. Jaeger, J. Proc.
   * R. Soc. N.S.W. 76 (1942) 203): with X = v x/(2 kappa) and L = v l/(4 kappa)
   *   theta(X)/q = 2 kappa/(pi k v) int from X - L to X + L of e^-u K_0(|u|).
   * For fast bands it tends to 4/3 sqrt(l/(pi k rho c v)).
   * @param length l along the motion [m] @param velocity [m/s]
   * @return [K m2/W]
   * @throws ComputationError if the integral does not converge
   */
  double
  moving_band(const HeatProperties &body,
              const double          length,
              const double          velocity);

  /**
   * Mean rise of the surface under a uniform rectangle of heat at rest on a
   * half-space, over its flux (H. S. Carslaw and J. C. Jaeger 1959; E. G.
   * Loewen and M. C. Shaw, Trans. ASME 76 (1954) 217): with l and m half its
   * sides and r = m/l
   *   2 l/(pi k) (asinh r + r asinh(1/r) + (r^2 + 1/r - (r + 1/r)
   *   sqrt(1 + r^2))/3).
   * @return [K m2/W]
   */
  double
  resting_rectangle(const double conductivity,
                    const double half_length,
                    const double half_width);

  /**
   * The same under a uniform circle that moves or, with the velocity 0, rests
   * (X. Tian and F. E. Kennedy, J. Tribol. 116 (1994) 167): a fit that is exact
   * at rest and for fast circles, 1.22 a/(k sqrt(pi (0.6575 + v a/(2 kappa)))).
   * @return [K m2/W]
   */
  double
  moving_circle(const HeatProperties &body,
                const double          radius,
                const double          velocity);
} // namespace asperity

#endif
