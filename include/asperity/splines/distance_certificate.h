#ifndef asperity_splines_distance_certificate_h
#define asperity_splines_distance_certificate_h

#include <asperity/splines/distance_minimizer.h>

namespace asperity
{
  /**
   * Examines Bezier pieces for points that are closer than the best one known,
   * and keeps the best. After every piece that could hold a closer point was
   * examined, the best point is proved to be the closest, up to round-off.
   */
  class DistanceCertificate
  {
  public:
    DistanceCertificate(const CurvePieces               &pieces,
                        const double                     px,
                        const double                     py,
                        const DistanceMinimizer         &minimizer,
                        const DistanceMinimizer::Result &known);

    void
    examine(const unsigned int piece, const int turn);

    /** The best point so far; its method is `subdivision` if it was found
     *  here. */
    const DistanceMinimizer::Result &
    best() const
    {
      return best_point;
    }

  private:
    static constexpr unsigned int max_degree = CurvePieces::max_degree;

    /** A part of a piece: its homogeneous control points relative to the given
     *  point, and where it lies in s. */
    struct Part
    {
      double x[max_degree + 1];
      double y[max_degree + 1];
      double w[max_degree + 1];
      double low, high;
    };

    struct Forms;

    void
    search(const Part          &part,
           const CurveLocation &location,
           const unsigned int   depth);

    /** Whether a line across a way from the point has the part's hull on its
     *  far side, no nearer than the best distance: the cheapest proof. */
    bool
    is_beyond(const Part &part, const double way_x, const double way_y) const;

    void
    form_squared_distance(const Part &part, Forms &forms) const;

    void
    form_derivative(const Part &part, Forms &forms) const;

    void
    consider(CurveLocation location, const double s);

    const CurvePieces        &pieces;
    const double              px, py;
    const DistanceMinimizer  &minimizer;
    DistanceMinimizer::Result best_point;
    double                    best_squared_distance;
  };
} // namespace asperity

#endif
