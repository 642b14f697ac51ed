#ifndef asperity_contact_curve_obstacle_h
#define asperity_contact_curve_obstacle_h

#include <asperity/contact/rigid_obstacle.h>
#include <asperity/splines/closest_point.h>

namespace asperity
{
  /** A rigid spline curve, periodic or not. */
  class CurveObstacle : public RigidObstacle
  {
  public:
    /** The side of the curve, seen along its parameter, where the body is. */
    enum class FreeSide
    {
      left,
      right
    };

    CurveObstacle(const SplineCurve &curve, const FreeSide side);

    GapPoint
    gap(const dealii::Point<2> &x, double &hint) const override;

  private:
    ClosestPoint search;
  };
} // namespace asperity

#endif
