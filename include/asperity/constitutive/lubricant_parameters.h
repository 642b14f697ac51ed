#ifndef asperity_constitutive_lubricant_parameters_h
#define asperity_constitutive_lubricant_parameters_h

#include <asperity/constitutive/lubricant_density.h>
#include <asperity/constitutive/lubricant_temperature.h>
#include <asperity/constitutive/lubricant_viscosity.h>

namespace asperity
{
  class ParameterDeclarator;

  /**
   * A lubricant as a parameter file describes it. The defaults of density and
   * viscosity are those of Lee (2025), section 2.3, table 2. The oil is
   * incompressible there, which a pocket without outlet cannot be: hence the
   * default of the density law.
   */
  struct LubricantParameters
  {
    double               density = 800.; ///< rho_0, at p = 0 [kg/m^3]
    LubricantDensity     compressibility;
    ViscosityParameters  viscosity;
    LubricantTemperature temperature;

    /** Declares the subsection "Lubricant". */
    void
    declare(ParameterDeclarator &parameters);

    /**
     * The oil at a temperature [K] as constants of the same laws. The ratio of
     * densities counts from a temperature at which volumes of oil are given.
     * Rate and viscosity of Carreau's law shift with the viscosity at rest
     * (R. B. Bird, R. C. Armstrong, O. Hassager, Dynamics of Polymeric Liquids,
     * vol. 1 (1987), section 3.6).
     */
    LubricantParameters
    at(const double temperature, const double temperature_of_volume) const;

    /** @throws InputError if a constant of the chosen laws has no physical
     *  meaning */
    void
    check() const;

    /** The same; relations between entries are refused with their place. */
    void
    check(const ParameterDeclarator &parameters) const;

    /** @param temperature of the oil at the start, the entry
     *  "Load/Temperature" [K]
     *  @throws InputError if the law of the temperature does not go there, or
     *  not with the other laws */
    void
    check_temperature(const ParameterDeclarator &parameters,
                      const double               temperature) const;
  };
} // namespace asperity

#endif
