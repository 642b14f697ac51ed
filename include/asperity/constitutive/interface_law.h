#ifndef asperity_constitutive_interface_law_h
#define asperity_constitutive_interface_law_h

#include <optional>

namespace asperity
{
  class ParameterDeclarator;

  /** What limits the shear of two surfaces that touch. */
  enum class InterfaceShear
  {
    none,            ///< frictionless, as Lee (2025)
    coulomb,         ///< mu_0 p
    shear_factor,    ///< m k of what touches
    limited_coulomb, ///< the smaller of both
    wanheim_bay      ///< from the one to the other, smoothly
  };

  /** The subsection "Interface". */
  struct InterfaceParameters
  {
    InterfaceShear law = InterfaceShear::none;

    double friction_coefficient = 0.5; ///< mu_0
    double shear_factor         = 0.8; ///< m where it is dry

    /** m where oil covers a spot; automatic: that of the dry one. */
    std::optional<double> wet_shear_factor;

    /** Thickness of the layer of the chip that shears [m]. */
    double shear_layer = 1e-6;

    /** epsilon_t over the penalty epsilon of the pressure. Stiffer than this,
     *  Newton's method chatters between slip in either direction. */
    double stick_penalty = 0.03;

    /** Gap over which the shear of a spot ends, over the length of an element.
     */
    double transition = 0.003;

    /** Declares the subsection. */
    void
    declare(ParameterDeclarator &parameters);

    /** Whether the law rests on the shear strength k of the chip. */
    bool
    uses_shear_strength() const;
  };

  /** A part of the contact edge, as a law of its shear sees it. */
  struct InterfaceState
  {
    double pressure = 0.; ///< p, not negative [Pa]
    double k        = 0.; ///< shear strength, counted as the pressure is [Pa]
    double touching = 1.; ///< part of it that touches, 0 to 1
    double wet      = 0.; ///< part of it that oil covers, 0 to 1
  };

  /** The largest shear stress and its partial derivatives. */
  struct ShearStrength
  {
    double value       = 0.; ///< [Pa]
    double by_pressure = 0.; ///< [-]
    double by_touching = 0.; ///< [Pa]
  };

  /**
   * The largest shear stress that a part of the interface bears, with
   * m = (1 - wet) m_dry + wet m_wet:
   *
   *   Coulomb:         tau = mu_0 p
   *   shear factor:    tau = m k touching
   *   limited Coulomb: tau = min(mu_0 p, m k touching)
   *   Wanheim-Bay:     tau = f alpha(p) k with f = m,
   *     f alpha = (f alpha)' p/p' up to p', then
   *     f alpha = (f alpha)' + (f - (f alpha)') (1 - exp(-(f alpha)'
   *               (p - p')/(p' (f - (f alpha)')))),
   *     (f alpha)' = 1 - sqrt(1 - f),
   *     p' = sqrt(3) k (1 + pi/2 + acos f + sqrt(1 - f^2)) /
   *          (sqrt(3) (1 + sqrt(1 - f))).
   *
   * Coulomb's law counts on what presses; asperities too small for the spline
   * touch in a part alpha of the area under Wanheim and Bay, whose law does
   * not count `touching`. T. Wanheim, N. Bay, Ann. CIRP 27 (1978) 189-194; the
   * form in formulas is that of N. Bay, J. Mech. Work. Technol. 14 (1987)
   * 203-223.
   */
  class InterfaceLaw
  {
  public:
    explicit InterfaceLaw(const InterfaceParameters &parameters);

    /** See above. */
    ShearStrength
    strength(const InterfaceState &state) const;

  private:
    ShearStrength
    wanheim_bay(const double pressure, const double k, const double f) const;

    InterfaceShear law;
    double         friction_coefficient, dry_shear_factor, wet_shear_factor;
  };
} // namespace asperity

#endif
