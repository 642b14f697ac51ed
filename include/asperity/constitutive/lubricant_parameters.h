#ifndef asperity_constitutive_lubricant_parameters_h
#define asperity_constitutive_lubricant_parameters_h

#include <asperity/constitutive/lubricant_density.h>
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
    double              density = 800.; ///< rho_0, at p = 0 [kg/m^3]
    LubricantDensity    compressibility;
    ViscosityParameters viscosity;

    /** Declares the subsection "Lubricant". */
    void
    declare(ParameterDeclarator &parameters);

    /** @throws InputError if a constant of the chosen laws has no physical
     *  meaning */
    void
    check() const;

    /** The same; relations between entries are refused with their place. */
    void
    check(const ParameterDeclarator &parameters) const;
  };
} // namespace asperity

#endif
