#ifndef asperity_contact_zone_friction_result_h
#define asperity_contact_zone_friction_result_h

#include <asperity/postprocess/friction_table.h>

#include <optional>
#include <vector>

namespace asperity
{
  /**
   * Force against the motion over the load, from the force (T_x, T_y) on the
   * chip [N/m]. Equation 17 of Lee (2025, section 2.3) takes absolute values;
   * here a tool that pushes the chip along its way gives a negative
   * coefficient. Zero as long as nothing is loaded.
   * @param direction of the chip's motion along x, of which only the sign
   * counts
   */
  double
  friction_coefficient(const double T_x,
                       const double T_y,
                       const double direction);

  /**
   * The friction coefficient of a run: numerator and denominator are averaged
   * over a window of time first, mu = int T_x dt / int T_y dt with the sign of
   * friction_coefficient(), by the trapezoidal rule, which halves the
   * first-order error of the time steps.
   */
  struct FrictionResult
  {
    double mu     = 0.;
    double mu_end = 0.; ///< at the last step

    /** Standard deviation of mu(t) over the window. */
    double spread = 0.;

    double window_begin = 0., window_end = 0.; ///< [s]
    double T_x = 0., T_y = 0.;                 ///< means [N/m]
    double contact_fraction = 0.;              ///< mean

    /** Mean force across Load/Sliding direction over the load; positive to its
     *  left. */
    double transverse = 0.;

    /** Means of the oil's part: vertical pressure [Pa], lateral forces by
     *  pressure and by shear [N/m]. */
    double oil_pressure = 0.;
    double oil_T_x      = 0.;
    double shear_T_x    = 0.;

    double interface_T_x = 0.; ///< mean lateral force by shear of the contact
    double interface_T_y = 0.; ///< mean vertical force by it [N/m]

    /** Parts of mu: by pressures on slopes, by shear of the contact and of the
     *  oil. */
    double ploughing = 0., interface_shear = 0., oil_shear = 0.;
  };

  /** Rows must be in order of time; values at the ends of the window are
   *  interpolated.
   *  @throws ComputationError if no row lies after `begin`, or the window is
   *  empty */
  FrictionResult
  average_friction(const std::vector<FrictionRow> &rows,
                   const double                    begin,
                   const double                    end);

  /** Heat that goes into the tool in a window of time over the frictional heat
   *  in it; plastic heat that flows into the tool is in the first, too. Empty
   *  without frictional heat. */
  std::optional<double>
  share_of_tool(const std::vector<FrictionRow> &rows,
                const double                    begin,
                const double                    end);

  /** mu over [from, to] in sliding distance. */
  struct DistanceMean
  {
    double from, to; ///< [m]
    double mu;
  };

  /** Means over windows of equal sliding distance, the first at zero; a last
   *  incomplete one is left out. */
  std::vector<DistanceMean>
  means_over_distance(const std::vector<FrictionRow> &rows,
                      const double                    window);
} // namespace asperity

#endif
