#ifndef asperity_experiment_orthogonal_cut_h
#define asperity_experiment_orthogonal_cut_h

#include <asperity/experiment/moving_source.h>
#include <asperity/experiment/rake_contact.h>

#include <limits>
#include <optional>

namespace asperity
{
  /** What an orthogonal cut gives; SI. */
  struct OrthogonalCut
  {
    double cutting_force = 0.; ///< along the cutting velocity [N]
    double passive_force = 0.; ///< normal to it and to the edge [N]

    /** What the edge itself takes of both forces, which does not act on the
     *  rake face [N]. */
    double edge_cutting_force = 0., edge_passive_force = 0.;

    double width                = 0.;
    double uncut_chip_thickness = 0.; ///< h
    double velocity             = 0.; ///< of the cut
    double rake                 = 0.; ///< gamma [rad]

    double chip_thickness = 0.; ///< h_c

    /** Of chip and rake face; empty: from the balance of moments. */
    std::optional<double> contact_length;

    double zorev_exponent = 2.;

    /** k of the chip at the rake face [Pa]; infinite: no sticking. */
    double shear_limit = std::numeric_limits<double>::infinity();

    HeatProperties chip        = {45., 7850., 500.};  ///< steel
    HeatProperties tool        = {88., 15250., 292.}; ///< cemented carbide
    double         temperature = 293.15;              ///< far away [K]
  };

  /** What follows for the contact of chip and rake face; SI. */
  struct CutConditions
  {
    double shear_angle   = 0.; ///< phi [rad]
    double chip_velocity = 0.; ///< along the rake face

    double friction_force = 0., normal_force = 0.; ///< of the rake face [N]
    double contact_length = 0.;
    RakeContact contact;

    double shear_stress   = 0.; ///< on the shear plane [Pa]
    double plastic_strain = 0.; ///< of the chip, equivalent

    double shear_plane_temperature = 0.; ///< of the chip behind it [K]
    double interface_temperature   = 0.; ///< mean over the contact [K]
    double heat_to_chip            = 0.; ///< part of the frictional heat
  };

  /**
   * The rake contact of a cut with one shear plane.
   *
   * Forces on the rake face and mu after M. E. Merchant (J. Appl. Phys. 16
   * (1945) 267): F = F_c sin(gamma) + F_p cos(gamma), N = F_c cos(gamma) - F_p
   * sin(gamma); tan(phi) = r cos(gamma)/(1 - r sin(gamma)) and the velocity v_c
   * r with r = h/h_c; shear strain cos(gamma)/(sin(phi) cos(phi - gamma)), over
   * sqrt(3). Contact length from the balance of moments on the chip (A. Moufki,
   * A. Molinari, D. Dudzinski, J. Mech. Phys. Solids 46 (1998) 2103), l = h
   * (xi + 2)/2 sin(phi + lambda - gamma)/(sin(phi) cos(lambda)), tan(lambda) =
   * F/N.
   *
   * Temperature of the chip behind the shear plane: its work F_c v_c - F v less
   * the part that flows into the workpiece, from the data of G. Boothroyd
   * (Proc. Inst. Mech. Eng. 177 (1963) 789) as P. L. B. Oxley (The Mechanics of
   * Machining, 1989) has them. Interface after E. G. Loewen and M. C. Shaw
   * (Trans. ASME 76 (1954) 217): the frictional heat is split so that the mean
   * temperatures of the chip under a moving band (moving_band()) and of the
   * tool, a quarter-space under a band that rests at its edge
   * (resting_rectangle()), are equal; steady state.
   *
   * @throws InputError if the chip is pulled off the rake face, if the shear
   *   angle or shear work is not positive, or as RakeContact
   */
  CutConditions
  conditions_of(const OrthogonalCut &cut);
} // namespace asperity

#endif
