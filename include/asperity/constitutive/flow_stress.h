#ifndef asperity_constitutive_flow_stress_h
#define asperity_constitutive_flow_stress_h

#include <cmath>
#include <optional>

namespace asperity
{
  /** A function of one variable at a point, with its derivative there. */
  struct ValueAndSlope
  {
    double value;
    double slope;
  };

  /** The flow stress [Pa] at a point and its partial derivatives. */
  struct FlowStressValue
  {
    double value;
    double d_strain;      ///< by equivalent plastic strain [Pa]
    double d_rate;        ///< by equivalent plastic strain rate [Pa s]
    double d_temperature; ///< by temperature [Pa/K]
  };

  /**
   * Base of all flow stresses sigma(eps, epsdot, T). A flow stress is a class
   * `Law : public FlowStress<Law>` with the two members
   *
   *   double          static_value(plastic_strain, temperature) const;
   *   FlowStressValue evaluate(plastic_strain, rate, temperature) const;
   *
   * in 1, 1/s and K, where static_value is the limit of a vanishing rate. The
   * value must be positive, continuous, and must not decrease with the rate.
   * FiniteStrainJ2 takes such a class as template argument, so that the hot
   * loop has no virtual calls.
   */
  template <class Law>
  class FlowStress
  {
  public:
    /** Shear stress at which the point flows, k = sigma/sqrt(3) [Pa] after von
     *  Mises, at an equivalent plastic strain, its rate [1/s] and a temperature
     *  [K]. */
    double
    shear_limit(const double plastic_strain,
                const double rate,
                const double temperature) const
    {
      const Law &law = static_cast<const Law &>(*this);
      return law.evaluate(plastic_strain, rate, temperature).value /
             std::sqrt(3.);
    }

    /** The temperature at which only this part of the strength is left [K];
     *  empty unless the law hides this member, as one that melts does. */
    std::optional<double>
    softest_temperature(const double strength) const
    {
      return {};
    }
  };
} // namespace asperity

#endif
