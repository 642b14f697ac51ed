#include <asperity/contact/curve_obstacle.h>

namespace asperity
{
  CurveObstacle::CurveObstacle(const SplineCurve &curve,
                               const CurveSide    free_side)
    : search(curve, free_side)
  {}



  GapPoint<2>
  CurveObstacle::gap(const dealii::Point<2> &x, dealii::Point<1> &hint) const
  {
    const Projection closest = search.project(x, hint[0]);
    hint[0]                  = closest.parameter;
    GapPoint<2> gap;
    gap.gap          = closest.distance;
    gap.normal       = closest.normal;
    gap.direction[0] = turned(gap.normal);
    // Projection counts a valley as positive.
    gap.curvature[0] = -closest.curvature;
    return gap;
  }
} // namespace asperity
