#ifndef asperity_splines_sheet_fit_h
#define asperity_splines_sheet_fit_h

#include <asperity/splines/spline_fit.h>
#include <asperity/splines/spline_sheet.h>

#include <array>
#include <vector>

namespace asperity
{
  /** Heights of one period of a surface on a regular grid: sample (i, j) stands
   *  at x = i period[0]/n[0], y = j period[1]/n[1]. */
  struct PeriodicHeights
  {
    std::array<unsigned int, 2> n      = {{0, 0}};
    std::array<double, 2>       period = {{0., 0.}}; ///< [m]
    std::vector<double>         heights; ///< [m], n[0] n[1], along x fastest
  };



  struct SheetFit
  {
    SplineSheet sheet;
    FitReport   report;
  };

  /**
   * Wrapped least squares on equal spans. Since the data are a grid, the normal
   * equations are the Kronecker product of those of the two directions, and are
   * solved along x first, then along y.
   *
   * @param bending [m^3] factor of the bending term of each direction, as in
   *   FitOptions. The penalised normal equations of both directions are
   *   multiplied, too (sandwich smoother; L. Xiao, Y. Li, D. Ruppert, J. R.
   *   Stat. Soc. B 75 (2013) 577-599): with zero this is the least-squares
   *   sheet, with data constant along y the fit of the profile.
   * @throws InputError if the numbers do not agree, if a height is not finite,
   *   or if a direction has too few data for its spans and no bending term
   */
  SheetFit
  fit_periodic_sheet(const PeriodicHeights             &data,
                     const std::array<unsigned int, 2> &n_spans,
                     const unsigned int                 degree,
                     const double                       bending = 0.);

  /**
   * The sheet through the data, whose knots they are.
   * @throws InputError if the degree is even, for which these knots do not
   *   determine the spline, or if a direction has fewer than 2 degree + 2 data
   */
  SheetFit
  interpolate_periodic_sheet(const PeriodicHeights &data,
                             const unsigned int     degree);
} // namespace asperity

#endif
