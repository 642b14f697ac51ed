#ifndef asperity_learned_shapes_spline_shape_h
#define asperity_learned_shapes_spline_shape_h

#include <asperity/learned_shapes/shape.h>
#include <asperity/splines/closest_point.h>

#include <memory>
#include <vector>

namespace asperity
{
  /** The plane region inside of a closed B-spline or NURBS curve. */
  class SplineShape : public Shape<2>
  {
  public:
    /** @throws InputError if the curve is not closed or has more than
     *   ClosestPoint's degree */
    explicit SplineShape(const SplineCurve &curve);

    double
    signed_distance(const dealii::Point<2> &point) const override;

    dealii::Point<2>
    surface_point(RandomNumbers &random) const override;

  private:
    std::unique_ptr<const ClosestPoint> closest_point;
    std::vector<double> parameters, lengths; ///< of short pieces
  };

  /** The circle of nine control points, which is exact (Piegl and Tiller 1997,
   *  example 7.3), counterclockwise. */
  SplineCurve
  circle(const dealii::Point<2> &centre, const double radius);
} // namespace asperity

#endif
