#ifndef asperity_contact_sheet_obstacle_h
#define asperity_contact_sheet_obstacle_h

#include <asperity/contact/rigid_obstacle.h>
#include <asperity/splines/closest_point_on_sheet.h>

namespace asperity
{
  /** A rigid surface z = s(x, y) above the body, periodic, with certified
   *  projection. */
  class SheetObstacle : public RigidObstacle<3>
  {
  public:
    explicit SheetObstacle(const SplineSheet &sheet);

    GapPoint<3>
    gap(const dealii::Point<3> &x, dealii::Point<2> &hint) const override;

  private:
    ClosestPointOnSheet search;
  };
} // namespace asperity

#endif
