#ifndef asperity_experiment_pin_contact_h
#define asperity_experiment_pin_contact_h

#include <asperity/experiment/moving_source.h>

namespace asperity
{
  /** The end of the pin. */
  enum class PinEnd
  {
    ball, ///< a sphere
    flat  ///< a circle
  };

  /** What a tribometer gives, whose pin slides on a disc, bar or cylinder of
   *  chip material; SI. */
  struct PinContact
  {
    PinEnd end          = PinEnd::ball;
    double normal_force = 0.; ///< [N]
    double radius       = 0.; ///< of the ball or of the flat end
    double velocity     = 0.;
    double mu           = 0.; ///< measured

    /** Young's moduli [Pa] and Poisson's ratios. */
    double chip_modulus = 210e9, chip_poisson = 0.3;
    double tool_modulus = 600e9, tool_poisson = 0.22;

    /** Of the chip: the largest mean pressure that it carries [Pa]. */
    double hardness = 2e9;

    /** Whether the pin always meets new material, as in an open tribometer: a
     *  groove that stays carries its front half alone (F. P. Bowden and D.
     *  Tabor, The Friction and Lubrication of Solids, 1950). */
    bool is_open = true;

    HeatProperties chip        = {45., 7850., 500.};  ///< steel
    HeatProperties tool        = {88., 15250., 292.}; ///< cemented carbide
    double         temperature = 293.15;              ///< far away [K]
  };

  struct PinConditions
  {
    bool   is_plastic    = false;
    double radius        = 0.; ///< of the contact
    double mean_pressure = 0.; ///< [Pa]
    double temperature   = 0.; ///< mean over the contact [K]
    double heat_to_chip  = 0.; ///< part of the frictional heat
  };

  /**
   * Pressure after H. Hertz (K. L. Johnson 1985, equation 4.22), a = (3 F R/(4
   * E*))^(1/3), unless its mean exceeds the hardness; then that is the pressure
   * and a^2 = F/(pi H), or twice that in a groove. Temperature after H. Blok
   * (Proc. Gen. Disc. Lubrication, Inst. Mech. Eng. 2 (1937) 222): the heat mu
   * p v is split so that the mean temperatures of the resting pin and of the
   * moving chip are equal (moving_circle()); steady state.
   */
  PinConditions
  conditions_of(const PinContact &pin);
} // namespace asperity

#endif
