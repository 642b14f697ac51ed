#ifndef asperity_constitutive_flow_stress_h
#define asperity_constitutive_flow_stress_h

#include <asperity/constitutive/softening.h>

#include <cmath>
#include <optional>

namespace asperity
{
  /** The flow stress [Pa] at a point and its partial derivatives. */
  template <class Number>
  struct BasicFlowStressValue
  {
    Number value;
    Number d_strain;      ///< by equivalent plastic strain [Pa]
    Number d_rate;        ///< by equivalent plastic strain rate [Pa s]
    Number d_temperature; ///< by temperature [Pa/K]
  };

  using FlowStressValue = BasicFlowStressValue<double>;

  /**
   * Base of all flow stresses sigma(eps, epsdot, T). A flow stress is a class
   * `Law : public FlowStress<Law>` with the two members
   *
   *   Number                       static_value(plastic_strain, temperature);
   *   BasicFlowStressValue<Number> evaluate(plastic_strain, rate, temperature);
   *
   * in 1, 1/s and K, both const and templates of Number, a double or a
   * lanes::Pack of several points, where static_value is the limit of a
   * vanishing rate. The value must be positive, continuous, and must not
   * decrease with the rate. Temperature counts by the factor of softening()
   * alone, which a law that softens hides by its own: messages about melting
   * and the shear limit of exported laws are made from it. FiniteStrainJ2 takes
   * such a class as template argument, so that the hot loop has no virtual
   * calls.
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

    /** Empty if the flow stress does not harden by a power of the strain. */
    std::optional<PowerHardening>
    hardening_law() const
    {
      return {};
    }

    /** Empty if the flow stress does not depend on the temperature. */
    std::optional<Softening>
    softening() const
    {
      return {};
    }
  };
} // namespace asperity

#endif
