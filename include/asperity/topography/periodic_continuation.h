#ifndef asperity_topography_periodic_continuation_h
#define asperity_topography_periodic_continuation_h

#include <asperity/splines/banded_solver.h>
#include <asperity/splines/knot_vector.h>
#include <asperity/topography/profile.h>

#include <vector>

namespace asperity
{
  enum class Continuation
  {
    wrapped_spline,
    mirror,
    none
  };

  /** How the wrapped spline is fitted. */
  struct WrappedSplineOptions
  {
    /** 3 (cubic) or 5 (quintic). */
    unsigned int degree = 3;

    /** Knot spacing over sample spacing, at least 1. */
    double samples_per_knot = 1.25;

    /**
     * Length at each end over the length of the profile in which the
     * measured heights fade out of the fit: the outer half of it is bridged
     * with little bending, the inner half blends. In [0, 0.25]. With 0 all
     * samples count alike.
     */
    double blend_fraction = 0.05;
  };

  /**
   * The periodic spline with uniform knots that is fitted to equidistant
   * heights of one period, whose weights fall to zero at both ends; there
   * second differences of the coefficients (P-splines, Eilers and Marx 1996)
   * define it.
   */
  class WrappedSpline
  {
  public:
    /** @throws InputError if there are fewer samples than knots */
    WrappedSpline(const std::size_t           n_samples,
                  const WrappedSplineOptions &options);

    unsigned int
    n_knots() const;

    /** One coefficient a knot, in the order of KnotVector; sample i stands at
     *  the fraction i/n_samples of the period. */
    std::vector<double>
    coefficients(const std::vector<double> &heights) const;

    /** The spline at the samples. */
    std::vector<double>
    values(const std::vector<double> &coefficients) const;

    /** A sample that counts less than others, or not at all. */
    bool
    is_blended(const std::size_t sample) const;

  private:
    /** The functions of the basis that live at a sample, and their values. */
    struct LocalBasis
    {
      std::vector<unsigned int> functions;
      std::vector<double>       values;
    };

    KnotVector              knots;
    std::vector<double>     weights; // one a sample
    std::vector<LocalBasis> bases;   // one a sample
    BandedSolver            matrix;
  };

  /**
   * What the continuation did. The jumps compare the two sides of the seam:
   * height and slope that the last two samples of the period extrapolate to
   * its end, minus those at its start. `Before` is the profile as it comes,
   * with its trend. Heights in metres.
   */
  struct ContinuationReport
  {
    double jump_before       = 0.;
    double jump_after        = 0.;
    double slope_jump_before = 0.;
    double slope_jump_after  = 0.;

    /** Root mean square height about the mean. */
    double Rq_before = 0.;
    double Rq_after  = 0.;

    double max_slope_before = 0.;
    double max_slope_after  = 0.;

    /** Root mean square of and largest change of a sample outside the blend. */
    double fit_rms = 0.;
    double fit_max = 0.;

    /** Slope of the line that was removed first: a period has no trend. */
    double removed_trend = 0.;

    unsigned int n_knots = 0;
  };

  /**
   * Make a profile without missing points periodic.
   *
   * wrapped_spline: the least-squares line is removed, and the WrappedSpline
   * is fitted. The period is n*spacing, sampled as before.
   *
   * mirror: the profile and its mirror image; heights are exact, the period is
   * 2(n-1) spacings, and the slope has kinks at both ends.
   *
   * none: the profile is repeated as it is, with the jump that it has (for
   * profiles that are periodic already).
   *
   * @throws InputError if the profile has fewer than ten samples, or fewer than
   *   the spline has knots.
   */
  Profile
  make_periodic(const Profile              &profile,
                const Continuation          continuation,
                const WrappedSplineOptions &options,
                ContinuationReport         &report);
} // namespace asperity

#endif
