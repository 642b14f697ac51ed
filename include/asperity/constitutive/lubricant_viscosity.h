#ifndef asperity_constitutive_lubricant_viscosity_h
#define asperity_constitutive_lubricant_viscosity_h

namespace asperity
{
  enum class ShearLaw
  {
    newtonian, ///< eta_0
    carreau ///< eta_inf + (eta_0 - eta_inf)(1 + (lambda gamma)^2)^((n - 1)/2)
  };

  enum class PressureLaw
  {
    none,
    barus,   ///< exp(alpha p)
    roelands ///< exp((ln(eta_0/eta_R))((1 + p/p_R)^Z - 1))
  };

  enum class StressLimit
  {
    none,
    circular ///< 1/sqrt(1 + (eta gamma/tau_L)^2), tau_L = tau_0 + zeta p
  };

  /**
   * The constants of the viscosity. The default is the oil of Lee (2025),
   * section 2.3, table 2: 0.032 Pa s, whatever
   * the rate and the pressure. The other constants are those of a mineral oil
   * and count only if their law is chosen.
   */
  struct ViscosityParameters
  {
    double viscosity = 0.032; ///< eta_0, at rest and at p = 0 [Pa s]

    ShearLaw shear_law                = ShearLaw::newtonian;
    double   infinite_shear_viscosity = 0.003; ///< eta_inf at p = 0 [Pa s]
    double   time_constant            = 1e-7;  ///< lambda [s]
    double   power_index              = 0.6;   ///< n [-]

    PressureLaw pressure_law         = PressureLaw::none;
    double      pressure_coefficient = 19e-9; ///< alpha of Barus [1/Pa]
    double      roelands_exponent    = 0.6;   ///< Z [-]

    StressLimit stress_limit          = StressLimit::none;
    double      limiting_stress       = 5e6;  ///< tau_0, at p = 0 [Pa]
    double      limiting_stress_slope = 0.05; ///< zeta [-]
  };

  /** The viscosity at a point and its partial derivatives. */
  struct ViscosityValue
  {
    double value;      ///< [Pa s]
    double d_rate;     ///< by the shear rate [Pa s^2]
    double d_pressure; ///< by the pressure [s]

    /** The law gives more than LubricantViscosity::glass_viscosity, which is
     *  returned instead: the lubricant is a solid there. */
    bool solid;
  };

  /**
   * Dynamic viscosity of a lubricant over shear rate gamma = sqrt(2 D : D)
   * [1/s] (du/dy in a film) and pressure p [Pa, above ambient]:
   *
   *   eta_N = eta_C(gamma) F(p),     eta = eta_N/sqrt(1 + (eta_N
   * gamma/tau_L)^2)
   *
   * with eta_C constant or after P. J. Carreau (Trans. Soc. Rheol. 16 (1972)
   * 99), F after C. Barus (Am. J. Sci. 45 (1893) 87) or C. J. A. Roelands
   * (thesis, Delft 1966; eta_R = 6.31e-5 Pa s, p_R = 196.2 MPa), and the
   * circular law of the limiting stress tau_L (R.-T. Lee, B. J. Hamrock, J.
   * Tribol. 112 (1990) 486): the shear stress eta gamma never exceeds tau_L.
   *
   * A liquid under tension keeps the viscosity and the limit of p = 0: such
   * pressures occur on the way to a cavitated solution only.
   */
  class LubricantViscosity
  {
  public:
    /** The viscosity by which the glass transition is commonly defined [Pa s].
     *  No law is followed beyond it, so that nothing overflows. */
    static constexpr double glass_viscosity = 1e12;

    /** eta_R of Roelands [Pa s]; the viscosity at rest must lie above it. */
    static constexpr double roelands_viscosity = 6.31e-5;

    /** @throws InputError if a constant of the chosen laws has no physical
     *  meaning */
    explicit LubricantViscosity(const ViscosityParameters &parameters);

    /** @param rate not negative [1/s] */
    ViscosityValue
    evaluate(const double rate, const double pressure) const;

    /** tau_L [Pa]; infinite without a limit. */
    double
    limiting_stress(const double pressure) const;

    /** Whether eta is a number that depends on nothing. */
    bool
    is_constant() const;

    const ViscosityParameters &
    parameters() const;

  private:
    ViscosityParameters parameters_;
  };
} // namespace asperity

#endif
