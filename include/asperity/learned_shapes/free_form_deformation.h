#ifndef asperity_learned_shapes_free_form_deformation_h
#define asperity_learned_shapes_free_form_deformation_h

#include <asperity/splines/knot_vector.h>

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace asperity
{
  /**
   * Free-form deformation (Sederberg and Parry 1986): a B-spline area or volume
   * around a body, whose control points carry along what lies in it,
   *
   *   x -> sum over lattice points of N_i(xi) N_j(eta) ... B_ij...,
   *
   * xi, eta, ... being the place of x in the box before the deformation.
   */
  template <int dim>
  class FreeFormDeformation
  {
  public:
    /** Changes nothing as yet.
     *  @param lower,upper corners of the box
     *  @param knot_vectors open ones on [0, 1], a direction each
     *  @throws InputError if the box is empty or the knots are others */
    FreeFormDeformation(const dealii::Point<dim>          &lower,
                        const dealii::Point<dim>          &upper,
                        const std::array<KnotVector, dim> &knot_vectors);

    /** The first direction running fastest. */
    std::vector<dealii::Point<dim>> &
    control_points()
    {
      return control_points_;
    }

    /** Place of a control point among those of a direction. */
    unsigned int
    row(const std::size_t control_point, const unsigned int direction) const;

    unsigned int
    n_rows(const unsigned int direction) const
    {
      return knot_vectors[direction].n_basis();
    }

    /** Where a point goes; beyond the box its last polynomials hold. */
    dealii::Point<dim>
    value(const dealii::Point<dim> &point) const;

  private:
    dealii::Point<dim>              lower, upper;
    std::array<KnotVector, dim>     knot_vectors;
    std::vector<dealii::Point<dim>> control_points_;
  };

  /** The deformations of figure 5 in the paper of section 3.1 of Lee (2025), of
   *  a body that stands on the lowest face of its box: lengths in halves of the
   *  box. */
  struct ShapeDeformation
  {
    double shrink_x        = 0.; ///< share by which it is narrower
    double translate_top_x = 0.;

    /** In space along the second horizontal direction, in the plane upwards. */
    double translate_top_y = 0.;

    double expand_middle = 0.; ///< share by which the middle row is wider
    double expand_top    = 0.; ///< the same of the top

    /** [rad], in space about the vertical axis, in the plane in it */
    double rotate_top = 0.;
  };

  /** Of a box with three rows of control points in the vertical direction, the
   *  last one, and two in the others: quadratic upwards, linear across. */
  template <int dim>
  FreeFormDeformation<dim>
  free_form_deformation(const dealii::Point<dim> &lower,
                        const dealii::Point<dim> &upper,
                        const ShapeDeformation   &deformation);
} // namespace asperity

#endif
