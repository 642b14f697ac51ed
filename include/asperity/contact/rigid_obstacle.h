#ifndef asperity_contact_rigid_obstacle_h
#define asperity_contact_rigid_obstacle_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>

namespace asperity
{
  /**
   * Where a point of the deformable body stands to a rigid surface. The gap is
   * positive when open: gap = (x - x_p) . normal with the closest point x_p;
   * equation 14 of Lee (2025), section 2.3, has the opposite sign.
   */
  template <int dim>
  struct GapPoint
  {
    double                 gap = 0.; ///< [m]
    dealii::Tensor<1, dim> normal;   ///< outward from the rigid surface at x_p

    /** Principal directions of the rigid surface at x_p, of unit length; in
     *  two dimensions its tangent, the normal turned by +90 degrees. */
    std::array<dealii::Tensor<1, dim>, dim - 1> direction;

    /** Principal curvatures of the rigid surface at x_p [1/m], positive where
     *  it bulges towards the body (an asperity), negative in a valley. */
    std::array<double, dim - 1> curvature{};

    /** How the normal turns as the point moves,
     *  n' = sum_k normal_rotation(k) (t_k . dx) t_k with the principal
     *  directions t_k: the Hessian of the distance [1/m]. Beyond the centre of
     *  curvature of a valley the closest point jumps; the bound keeps the
     *  number finite there, where gaps are large and pressures zero. */
    double
    normal_rotation(const unsigned int k = 0) const
    {
      return curvature[k] / std::max(0.1, 1. + curvature[k] * gap);
    }
  };

  /** A vector of the plane, turned by +90 degrees. */
  inline dealii::Tensor<1, 2>
  turned(const dealii::Tensor<1, 2> &v)
  {
    dealii::Tensor<1, 2> result;
    result[0] = -v[1];
    result[1] = v[0];
    return result;
  }

  /** A rigid surface that never moves or is moved as a whole. */
  template <int dim>
  class RigidObstacle
  {
  public:
    virtual ~RigidObstacle() = default;

    /**
     * @param x position [m]
     * @param hint the parameters of the surface where the last search for this
     *   point ended; any to start with; rewritten
     */
    virtual GapPoint<dim>
    gap(const dealii::Point<dim> &x, dealii::Point<dim - 1> &hint) const = 0;
  };
} // namespace asperity

#endif
