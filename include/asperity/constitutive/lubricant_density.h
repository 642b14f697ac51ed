#ifndef asperity_constitutive_lubricant_density_h
#define asperity_constitutive_lubricant_density_h

namespace asperity
{
  enum class DensityLaw
  {
    incompressible,
    murnaghan,        ///< rho/rho0 = (1 + K' p / K0)^(1/K')
    dowson_higginson, ///< rho/rho0 = 1 + 0.6e-9 p / (1 + 1.7e-9 p), p in Pa
    constant_modulus  ///< rho/rho0 = exp(p / K0)
  };

  /**
   * Density of a liquid over pressure, relative to that at p = 0 and a
   * reference temperature. Pressures are in Pa above ambient; all laws also
   * hold for small negative ones. F. D. Murnaghan, PNAS 30 (1944) 244-247; D.
   * Dowson, G. R. Higginson, Elasto-hydrodynamic Lubrication (1966).
   */
  struct LubricantDensity
  {
    DensityLaw law                = DensityLaw::murnaghan;
    double     bulk_modulus       = 1.6e9; ///< K0 [Pa]
    double     modulus_derivative = 10.;   ///< K' [-]

    /** rho/rho0 at p = 0, which is not 1 at other temperatures than that of
     *  rho0; a factor on all laws. */
    double ambient_ratio = 1.;

    /** rho/rho0 at a pressure [Pa]. */
    double
    ratio(const double pressure) const;

    /** d(rho/rho0)/dp [1/Pa] */
    double
    derivative(const double pressure) const;

    /** Inverse of ratio(), [Pa]; infinite where no pressure gives this
     *  density (Dowson-Higginson ends at 1 + 0.6/1.7). Not for the
     *  incompressible law. */
    double
    pressure(const double ratio) const;
  };
} // namespace asperity

#endif
