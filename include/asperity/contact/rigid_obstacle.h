#ifndef asperity_contact_rigid_obstacle_h
#define asperity_contact_rigid_obstacle_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>

namespace asperity
{
  /**
   * Where a point of the deformable body stands to a rigid surface. The gap is
   * positive when open: gap = (x - x_p) . normal with the closest point x_p;
   * equation 14 of Lee (2025), section 2.3, has the opposite sign.
   */
  struct GapPoint
  {
    double               gap = 0.; ///< [m]
    dealii::Tensor<1, 2> normal;   ///< outward from the rigid surface at x_p

    /** Curvature of the rigid surface at x_p [1/m], positive where it bulges
     *  towards the body (an asperity), negative in a valley. */
    double curvature = 0.;

    /** How the normal turns as the point moves along the tangent t, the normal
     *  turned by 90 degrees: n' = normal_rotation() (t . dx) t, the Hessian of
     *  the distance [1/m]. Beyond the centre of curvature of a valley the
     *  closest point jumps; the bound keeps the number finite there, where gaps
     *  are large and pressures zero. */
    double
    normal_rotation() const
    {
      return curvature / std::max(0.1, 1. + curvature * gap);
    }
  };

  /** A rigid surface that never moves or is moved as a whole. */
  class RigidObstacle
  {
  public:
    virtual ~RigidObstacle() = default;

    /**
     * @param x position [m]
     * @param hint where the last search for this point ended; any number to
     *   start with; rewritten
     */
    virtual GapPoint
    gap(const dealii::Point<2> &x, double &hint) const = 0;
  };
} // namespace asperity

#endif
