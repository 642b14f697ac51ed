#ifndef asperity_constitutive_softening_h
#define asperity_constitutive_softening_h

#include <cmath>

namespace asperity
{
  /** A function of one variable at a point, with its derivative there. */
  struct ValueAndSlope
  {
    double value;
    double slope;
  };

  /**
   * How the temperature softens a flow stress: by the factor
   *   max(floor, 1 - T*^m), T* = (T - T_t)/(T_m - T_t), 1 below T_t
   * of Johnson and Cook (1983). The floor is not theirs: it leaves a molten
   * point a positive flow stress and a regular tangent.
   */
  struct Softening
  {
    /** The smallest factor. */
    static constexpr double floor = 1e-3;

    double exponent;               ///< m
    double transition_temperature; ///< T_t [K]
    double melting_temperature;    ///< T_m [K]

    /** The factor and its slope [1/K] at a temperature [K]. */
    ValueAndSlope
    factor(const double temperature) const
    {
      const double range = melting_temperature - transition_temperature;
      const double T     = (temperature - transition_temperature) / range;
      if (T <= 0.)
        return {1., 0.};
      if (T >= 1.)
        return {floor, 0.};
      const double power = std::pow(T, exponent);
      if (1. - power <= floor)
        return {floor, 0.};
      return {1. - power, -exponent * power / (T * range)};
    }

    /** The temperature at which the factor is `strength` [K]. */
    double
    temperature_at(const double strength) const
    {
      return transition_temperature +
             (melting_temperature - transition_temperature) *
               std::pow(1. - strength, 1. / exponent);
    }
  };
} // namespace asperity

#endif
