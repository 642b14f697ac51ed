#ifndef asperity_lubricant_sheet_integral_h
#define asperity_lubricant_sheet_integral_h

#include <asperity/splines/spline_sheet.h>

#include <deal.II/base/point.h>

#include <vector>

namespace asperity
{
  /**
   * The integral of a sheet along x,
   *
   *   P(x, y) = int_0^x s(x', y) dx',
   *
   * so that the volume below the sheet over a region is the integral of P dy
   * along its boundary. It is exact, and grows by P(L, y) with each period; 0
   * is where the knots of the sheet begin.
   */
  class SheetIntegral
  {
  public:
    /** At a place, with derivatives by y. */
    struct Values
    {
      double P    = 0.; ///< [m^2]
      double P_y  = 0.; ///< [m]
      double P_yy = 0.; ///< [-]
    };

    explicit SheetIntegral(const SplineSheet &sheet);

    Values
    at(const dealii::Point<2> &place) const;

    /** P(x + L, y) - P(x, y), which does not depend on x. */
    Values
    over_period(const double y) const;

  private:
    /** sum_b r_b B_b(y) of the rows of coefficients at y. */
    template <typename Row>
    Values
    across(const double y, const Row &integral_of_row) const;

    SplineSheet sheet;

    /** Of each row of coefficients, up to each of the n breakpoints and the end
     *  [m^2]. */
    std::vector<std::vector<double>> cumulative;
  };
} // namespace asperity

#endif
