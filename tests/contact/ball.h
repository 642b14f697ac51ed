#ifndef asperity_tests_contact_ball_h
#define asperity_tests_contact_ball_h

#include <asperity/contact/rigid_obstacle.h>

namespace example
{
  using asperity::GapPoint;
  using dealii::Point;
  using dealii::Tensor;

  /** A ball above its lowest point. */
  class Ball : public asperity::RigidObstacle<3>
  {
  public:
    Ball(const Point<3> &lowest, const double radius)
      : lowest(lowest)
      , radius(radius)
    {}

    GapPoint<3>
    gap(const Point<3> &x, Point<2> &) const override
    {
      const Tensor<1, 3> s = x - lowest;
      Tensor<1, 3>       from_center(s);
      from_center[2] -= radius;
      const double distance = from_center.norm();
      GapPoint<3>  gap;
      gap.gap    = (s.norm_square() - 2. * radius * s[2]) / (distance + radius);
      gap.normal = from_center / distance;
      Tensor<1, 3> along;
      along[1]         = 1.;
      gap.direction[0] = along - (along * gap.normal) * gap.normal;
      gap.direction[0] /= gap.direction[0].norm();
      gap.direction[1] = cross_product_3d(gap.normal, gap.direction[0]);
      gap.curvature    = {{1. / radius, 1. / radius}};
      return gap;
    }

  private:
    Point<3> lowest;
    double   radius;
  };
} // namespace example

#endif
