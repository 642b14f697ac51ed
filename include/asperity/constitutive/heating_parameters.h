#ifndef asperity_constitutive_heating_parameters_h
#define asperity_constitutive_heating_parameters_h

namespace asperity
{
  class ParameterDeclarator;

  /** How plastic work heats the point. */
  struct HeatingParameters
  {
    bool   adiabatic     = true; ///< false: the temperature stays
    double heat_capacity = 450.; ///< c_p [J/(kg K)]
    double heat_fraction = 0.9;  ///< chi, share of the plastic work that heats

    /** Declares the entries in the present subsection. */
    void
    declare(ParameterDeclarator &parameters);

    /**
     * Temperature rise per plastic work, chi/(rho c_p) [K/Pa]; 0 if the
     * temperature stays.
     * @param density rho [kg/m^3]; work and density count per reference volume
     * @throws InputError if a constant has no physical meaning
     */
    double
    temperature_per_work(const double density) const;
  };
} // namespace asperity

#endif
