#ifndef asperity_splines_spline_fit_h
#define asperity_splines_spline_fit_h

#include <asperity/splines/parametrization.h>
#include <asperity/splines/spline_curve.h>

#include <functional>
#include <vector>

namespace asperity
{
  /** How far a fitted curve is from its data. */
  struct FitReport
  {
    double       max_error        = 0.; ///< largest residual [m]
    double       rms_error        = 0.; ///< root mean square of residuals [m]
    unsigned int n_control_points = 0;

    /** Distance from each datum to the curve at the datum's parameter [m]. */
    std::vector<double> residuals;
  };



  struct FitOptions
  {
    /** One a datum, positive; empty for equal weights. They multiply squared
     *  residuals. */
    std::vector<double> weights;

    /** Factor of the bending term, the integral of |C''(t)|^2 dt, which is
     * added to the weighted mean of the squared residuals; the unit is that of
     * t^3. */
    double bending = 0.;

    /** Open curves: pass exactly through the first and last datum (Piegl and
     *  Tiller, section 9.4.1). The data must be sorted by parameter. */
    bool interpolate_ends = false;

    /** Periodic curves: what the data move by in one turn [m]. */
    dealii::Tensor<1, 2> period;
  };



  struct SplineFit
  {
    SplineCurve curve;
    FitReport   report;
  };

  /**
   * Global interpolation: as many data as functions, on open or periodic knots.
   * @throws InputError where the data do not determine the curve
   * (Schoenberg-Whitney conditions).
   */
  SplineFit
  interpolate(const KnotVector                    &knot_vector,
              const std::vector<dealii::Point<2>> &points,
              const std::vector<double>           &parameters,
              const dealii::Tensor<1, 2>          &period = {});

  /** Global interpolation on chord-length parameters and averaged knots.
   *  @throws InputError as chord_parameters() and averaged_knots() */
  SplineFit
  interpolate(const std::vector<dealii::Point<2>> &points,
              const unsigned int                   degree);

  /**
   * Weighted least squares with an optional bending term. Periodic knots:
   * parameters may lie in any turn.
   * @throws InputError if a span has too few data and there is no bending term,
   *   or if a weight is not positive
   */
  SplineFit
  fit_least_squares(const KnotVector                    &knot_vector,
                    const std::vector<dealii::Point<2>> &points,
                    const std::vector<double>           &parameters,
                    const FitOptions                    &options = {});

  /**
   * The L-periodic graph y(x), x in [x_0, x_0 + L], that fits the samples on
   * n_spans equal spans (wrapped fit).
   * @param x positions [m], in any order and turn; x_0 is the smallest one
   * @param y heights [m]
   * @throws InputError as fit_least_squares(), if the period is not positive or
   *   if there are not as many heights as positions
   */
  SplineFit
  fit_periodic_graph(const std::vector<double> &x,
                     const std::vector<double> &y,
                     const double               period,
                     const unsigned int         n_spans,
                     const unsigned int         degree,
                     const FitOptions          &options = {});

  /**
   * Global interpolation (Piegl and Tiller, algorithm A9.1) of equidistant
   * heights [m] of one period, the first at x = 0, by the periodic graph whose
   * knots are the data. The parameters are the positions, as a graph has them.
   * @throws InputError if the degree is even, for which these knots do not
   *   determine the spline, or if the data are fewer than 2 degree + 2
   */
  SplineFit
  interpolate_periodic_graph(const std::vector<double> &heights,
                             const double               period,
                             const unsigned int         degree);

  /** The periodic graph that meets a periodic function at the Greville points
   * of n_spans equal spans that begin at x_begin. */
  SplineCurve
  interpolate_periodic_function(const std::function<double(double)> &function,
                                const double                         x_begin,
                                const double                         period,
                                const unsigned int                   n_spans,
                                const unsigned int                   degree);
} // namespace asperity

#endif
