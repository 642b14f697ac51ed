#ifndef asperity_topography_make_window_h
#define asperity_topography_make_window_h

#include <asperity/splines/spline_sheet.h>
#include <asperity/topography/make_profile.h>

#include <array>
#include <optional>

namespace asperity
{
  /** The part of a treated map that is to become one period of a surface. */
  struct WindowChoice
  {
    /** Along x and y [m], before scaling. */
    std::array<double, 2> extent = {{0., 0.}};

    /** Its corner with the smallest x and y in the map that the crop leaves
     *  [m], moved to the nearest sample; in the middle of it if empty. */
    std::optional<std::array<double, 2>> origin;
  };

  /**
   * What making a window periodic changed; index 0 along x, 1 along y. Lengths
   * in metres, before scaling. The seam of a direction is where its periods
   * meet: the jumps there are what neighbouring samples extrapolated from both
   * sides differ by.
   */
  struct WindowReport
  {
    Window                window; ///< samples of the treated map
    std::array<double, 2> extent = {{0., 0.}};

    /** The tilt that is removed since it would leave a mean jump. */
    std::array<double, 2> removed_tilt = {{0., 0.}};

    /** Across the seams of the filled window, without tilt. */
    std::array<double, 2> largest_jump = {{0., 0.}};
    std::array<double, 2> rms_jump     = {{0., 0.}};

    /** Whether heights near a seam had to be bridged: where steps across it are
     *  larger than those between other neighbours. */
    std::array<bool, 2> bridged = {{false, false}};

    /** Sq [m] and Sdq of the window without tilt, and of the sheet at the same
     *  places. */
    double Sq_before = 0., Sq_after = 0.;
    double Sdq_before = 0., Sdq_after = 0.;

    /** Root mean square of and largest change of a sample that is not bridged.
     */
    double fit_rms = 0.;
    double fit_max = 0.;

    std::size_t                 n_filled = 0;
    std::array<unsigned int, 2> n_knots  = {{0, 0}};
  };

  /**
   * Treat the map as for a profile, cut the window out, fill its gaps by
   * straight lines along x, make it periodic in both directions and scale it
   * (`scale_x` both lengths).
   *
   * The wrapped least-squares spline is that of make_periodic() along x, then
   * along y: its normal equations are the Kronecker product of those of the two
   * directions. A direction in which the window repeats already (no larger
   * steps across its seam than elsewhere), is not bridged: all its samples
   * count. So do they if the continuation is `none`, with which no tilt is
   * removed either.
   *
   * @param report filled as by make_profile() as far as the map, its steps and
   *   warnings completed by those of the window
   * @return heights [m] about the mean of the window, one period from (0, 0) on
   * @throws InputError if the file, one of the choices or the window is not
   *   usable
   */
  SplineSheet
  make_window(const TopographyParameters &parameters,
              const WindowChoice         &choice,
              TopographyReport           &report,
              WindowReport               &window_report);
} // namespace asperity

#endif
