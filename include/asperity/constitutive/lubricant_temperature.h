#ifndef asperity_constitutive_lubricant_temperature_h
#define asperity_constitutive_lubricant_temperature_h

namespace asperity
{
  class ParameterDeclarator;

  enum class TemperatureLaw
  {
    none,     ///< the oil is the same at every temperature
    roelands, ///< ln(eta/eta_R) ~ (T - 138 K)^(-S_0)
    vogel     ///< ln(eta) ~ B/(T - T_V)
  };

  /**
   * What the temperature T [K] makes of a liquid whose constants are known at
   * T_0, all at p = 0:
   *
   *   eta/eta_0 = exp(B/(T - T_V) - B/(T_0 - T_V))                    (Vogel),
   *   eta/eta_R = (eta_0/eta_R)^(((T - 138 K)/(T_0 - 138 K))^(-S_0))
   * (Roelands), rho/rho_0 = exp(-beta (T - T_0)), K/K_0     = exp(-beta_K (T -
   * T_0)).
   *
   * With Roelands' law of the pressure this is his law of both (thesis, Delft
   * 1966). H. Vogel, Phys. Z. 22 (1921) 645; the constants are those of an oil
   * SAE 30 after A. Seireg and S. Dandage, J. Lubr. Technol. 104 (1982) 135.
   * beta after D. Dowson and G. R. Higginson, Elasto-hydrodynamic Lubrication
   * (1966); beta_K after S. Bair, High-Pressure Rheology for Quantitative
   * Elastohydrodynamics (2007).
   */
  struct LubricantTemperature
  {
    TemperatureLaw law               = TemperatureLaw::none;
    double         reference         = 298.15; ///< T_0 [K]
    double         roelands_slope    = 1.1;    ///< S_0 [-]
    double         vogel_constant    = 755.6;  ///< B [K]
    double         vogel_temperature = 202.6;  ///< T_V [K]
    double         expansion         = 6.5e-4; ///< beta [1/K]
    double         modulus_decay     = 6.5e-3; ///< beta_K [1/K]

    /** Declares entries in the subsection that is open. */
    void
    declare(ParameterDeclarator &parameters);

    /** The temperature above which the law of the viscosity holds [K]. */
    double
    lowest() const;

    /** The temperature at which the liquid is a glass,
     *  LubricantViscosity::glass_viscosity [K].
     *  @param viscosity eta_0 [Pa s] */
    double
    glass_temperature(const double viscosity) const;

    /** eta at p = 0 [Pa s]; infinite at and below lowest().
     *  @param viscosity eta_0 [Pa s] */
    double
    viscosity(const double viscosity, const double temperature) const;

    /** rho/rho_0 at p = 0 */
    double
    density_ratio(const double temperature) const;

    /** K/K_0 */
    double
    modulus_ratio(const double temperature) const;
  };
} // namespace asperity

#endif
