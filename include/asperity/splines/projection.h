#ifndef asperity_splines_projection_h
#define asperity_splines_projection_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace asperity
{
  /** The side of a curve, seen along increasing parameter, on which distances
   *  are positive and to which normals point: the free side. For a tool above
   *  the chip whose parameter runs with x that is `right` (below). */
  enum class CurveSide
  {
    left,
    right
  };



  /** The point of a curve that is closest to a given point. */
  struct Projection
  {
    /** What kind of point the curve has there. */
    enum class Place
    {
      smooth, ///< the connecting line is normal to the curve
      kink,   ///< at a corner of the curve, between the two normals
      end     ///< beyond the first or last point of an open curve
    };

    /** The method that converged. */
    enum class Method
    {
      newton,
      sqp,
      levenberg_marquardt,
      subdivision,
      none
    };

    double           parameter = 0.; ///< unwrapped: of any turn if periodic
    dealii::Point<2> point;          ///< [m]

    /** Distance [m], positive on the free side. */
    double distance = 0.;

    /** Gradient of `distance` with respect to the given point: the unit normal
     *  of the curve to the free side or, at a kink or end, the signed direction
     *  to the point. */
    dealii::Tensor<1, 2> normal;

    /** Unit vector along increasing parameter; at a kink from the right. */
    dealii::Tensor<1, 2> tangent;

    /** |dC/dt| [m]. */
    double speed = 0.;

    /** Rate at which the tangent turns towards the curve's normal to the
     *  free side [1/m]: positive where the curve bends to that side (valley),
     * so that the closest point is unique up to the distance 1/curvature. The
     *  gradient of `normal` with respect to the given point is
     *  -curvature/(1 - curvature distance) tangent tangent^T on smooth places,
     *  (1 - normal normal^T)/distance at kinks and ends. */
    double curvature = 0.;

    Place        place      = Place::smooth;
    Method       method     = Method::none;
    unsigned int iterations = 0;

    /** A local minimum of the distance was found to round-off. */
    bool converged = false;

    /** Proved: no point of the curve is closer (up to round-off). */
    bool certified = false;
  };
} // namespace asperity

#endif
