#ifndef asperity_constitutive_flow_stress_h
#define asperity_constitutive_flow_stress_h

#include <limits>

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

  // A flow stress is any class with the two members
  //
  //   double          static_value(plastic_strain, temperature) const;
  //   FlowStressValue evaluate(plastic_strain, rate, temperature) const;
  //
  // where static_value is the limit of a vanishing rate. The value must be
  // positive, continuous, and must not decrease with the rate; FiniteStrainJ2
  // takes such a class as template argument, so that the hot loop has no
  // virtual calls.

  /**
   * Linear plus saturating (Voce) isotropic hardening, without rate or
   * temperature:
   *   sigma = sigma_0 + (sigma_inf - sigma_0) (1 - exp(-delta eps)) + H eps
   * (J. C. Simo and F. Armero, Int. J. Numer. Methods Eng. 33 (1992) 1413).
   * With the defaults of sigma_inf, delta and H it is perfect plasticity.
   */
  struct SaturationHardeningParameters
  {
    double yield_stress      = 300e6; ///< sigma_0 [Pa]
    double saturation_stress = 300e6; ///< sigma_inf [Pa]
    double saturation_rate   = 0.;    ///< delta
    double linear_hardening  = 0.;    ///< H [Pa]
  };

  class SaturationHardening
  {
  public:
    /**
     * @throws InputError unless the stresses are positive and delta and H
     *   are not negative
     */
    explicit SaturationHardening(
      const SaturationHardeningParameters &parameters);

    double
    static_value(const double plastic_strain, const double temperature) const;

    FlowStressValue
    evaluate(const double plastic_strain,
             const double rate,
             const double temperature) const;

  private:
    SaturationHardeningParameters parameters;
  };

  /** The flow stress of a body that stays elastic. */
  class NeverYields
  {
  public:
    double
    static_value(const double, const double) const
    {
      return std::numeric_limits<double>::infinity();
    }

    FlowStressValue
    evaluate(const double, const double, const double) const
    {
      return {std::numeric_limits<double>::infinity(), 0., 0., 0.};
    }
  };
} // namespace asperity

#endif
