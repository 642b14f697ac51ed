#ifndef asperity_splines_distance_minimizer_h
#define asperity_splines_distance_minimizer_h

#include <asperity/splines/curve_pieces.h>
#include <asperity/splines/projection.h>

namespace asperity
{
  /**
   * A local minimum of the distance from a point to a curve: Newton's method,
   * then sequential quadratic programming (here: the bounds of the pieces as
   * constraints, the Hessian made positive, Armijo line search), then
   * Levenberg-Marquardt. Each starts where the one before gave up.
   */
  class DistanceMinimizer
  {
  public:
    struct Result
    {
      CurveLocation      location;
      DistanceJet        jet;
      Projection::Method method     = Projection::Method::none;
      unsigned int       iterations = 0;
    };

    DistanceMinimizer(const CurvePieces &pieces,
                      const double       px,
                      const double       py);

    Result
    minimize(const CurveLocation &start) const;

    /** The only minimum between two parameters of one piece at which the
     *  derivative of the distance is negative and positive. */
    Result
    minimize_between(CurveLocation location, double low, double high) const;

    /** What a user wants to know of it. */
    Projection
    describe(const Result &result, const CurveSide free_side) const;

    /** Round-off of a position [m]. */
    double
    position_noise() const
    {
      return noise;
    }

  private:
    /** Moves by ds, over the ends of pieces if the distance goes on falling
     *  there. @return true if the way ends at a kink or end of the curve */
    bool
    move(CurveLocation &location, const double ds) const;

    bool
    newton(Result &result) const;

    bool
    sequential_quadratic_programming(Result &result) const;

    bool
    levenberg_marquardt(Result &result) const;

    /** At the end of a piece the curve may have a kink, or stop. */
    void
    describe_piece_end(const Result &result,
                       const double  side,
                       Projection   &projection) const;

    /** The distance is stationary to round-off. */
    bool
    stationary(const DistanceJet &jet) const;

    /** Round-off of the squared distance. */
    double
    round_off(const DistanceJet &jet) const;

    /** After a step ds from here nothing will change any more. */
    bool
    settled(const DistanceJet &jet, const double ds) const;

    DistanceJet
    jet(const CurveLocation &location) const
    {
      return pieces.jet(location, px, py);
    }

    const CurvePieces &pieces;
    const double       px, py;
    const double       noise;
  };
} // namespace asperity

#endif
