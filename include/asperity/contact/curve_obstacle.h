#ifndef asperity_contact_curve_obstacle_h
#define asperity_contact_curve_obstacle_h

#include <asperity/contact/rigid_obstacle.h>
#include <asperity/splines/closest_point.h>

namespace asperity
{
  /** A rigid spline curve, periodic or not, with certified projection. */
  class CurveObstacle : public RigidObstacle<2>
  {
  public:
    /** @param free_side side of the curve on which the body is */
    CurveObstacle(const SplineCurve &curve, const CurveSide free_side);

    GapPoint<2>
    gap(const dealii::Point<2> &x, dealii::Point<1> &hint) const override;

  private:
    ClosestPoint search;
  };
} // namespace asperity

#endif
