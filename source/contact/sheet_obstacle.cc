#include <asperity/contact/sheet_obstacle.h>

namespace asperity
{
  SheetObstacle::SheetObstacle(const SplineSheet &sheet)
    : search(sheet, SheetSide::below)
  {}



  GapPoint<3>
  SheetObstacle::gap(const dealii::Point<3> &x, dealii::Point<2> &hint) const
  {
    const SheetProjection closest = search.project(x, hint);
    hint                          = closest.parameters;
    GapPoint<3> gap;
    gap.gap       = closest.distance;
    gap.normal    = closest.normal;
    gap.direction = closest.direction;
    // Projection counts a valley as positive.
    for (unsigned int k = 0; k < 2; ++k)
      gap.curvature[k] = -closest.curvature[k];
    return gap;
  }
} // namespace asperity
