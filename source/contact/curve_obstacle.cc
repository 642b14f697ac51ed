#include <asperity/contact/curve_obstacle.h>

namespace asperity
{
  CurveObstacle::CurveObstacle(const SplineCurve &curve,
                               const CurveSide    free_side)
    : search(curve, free_side)
  {}



  GapPoint
  CurveObstacle::gap(const dealii::Point<2> &x, double &hint) const
  {
    const Projection closest = search.project(x, hint);
    hint                     = closest.parameter;
    GapPoint gap;
    gap.gap    = closest.distance;
    gap.normal = closest.normal;
    // Projection counts a valley as positive.
    gap.curvature = -closest.curvature;
    return gap;
  }
} // namespace asperity
