#ifndef asperity_learned_shapes_shape_h
#define asperity_learned_shapes_shape_h

#include <deal.II/base/point.h>

namespace asperity
{
  class RandomNumbers;

  /** A body in the plane or in space. */
  template <int dim>
  class Shape
  {
  public:
    virtual ~Shape() = default;

    /** Distance to the surface, negative inside. */
    virtual double
    signed_distance(const dealii::Point<dim> &point) const = 0;

    /** Uniformly distributed on the surface. */
    virtual dealii::Point<dim>
    surface_point(RandomNumbers &random) const = 0;
  };
} // namespace asperity

#endif
