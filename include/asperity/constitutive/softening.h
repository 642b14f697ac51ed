#ifndef asperity_constitutive_softening_h
#define asperity_constitutive_softening_h

#include <asperity/base/lanes.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  /** A function of one variable at a point, with its derivative there. */
  template <class Number>
  struct BasicValueAndSlope
  {
    Number value;
    Number slope;
  };

  using ValueAndSlope = BasicValueAndSlope<double>;

  /** How plastic strain hardens a flow stress: by the factor 1 + ratio
   *  min(eps, limit)^exponent, B/A and n of Johnson and Cook (1983). */
  struct PowerHardening
  {
    double ratio    = 0.;
    double exponent = 1.;
    double limit    = 1.; ///< strain from which on the factor is constant

    /** The factor and its slope at an equivalent plastic strain above 0. */
    ValueAndSlope
    factor(const double strain) const
    {
      const double power = ratio * std::pow(std::min(strain, limit), exponent);
      return {1. + power, strain < limit ? exponent * power / strain : 0.};
    }
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
    template <class Number>
    BasicValueAndSlope<Number>
    factor(const Number &temperature) const
    {
      const double range = melting_temperature - transition_temperature;
      const Number T     = (temperature - transition_temperature) / range;
      const Number one   = lanes::broadcast<Number>(1.);
      const auto   warm  = T > 0.;
      if (!lanes::any(warm))
        return {one, Number()};
      const Number power =
        lanes::pow(lanes::select(warm & (T < 1.), T, one), exponent);
      const auto soft = warm & (T < 1.) & (1. - power > floor);
      return {lanes::select(soft,
                            1. - power,
                            lanes::select(warm, Number() + floor, one)),
              lanes::select(soft, -exponent * power / (T * range), Number())};
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
