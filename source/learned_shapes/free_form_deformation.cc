#include <asperity/base/errors.h>
#include <asperity/learned_shapes/free_form_deformation.h>

#include <cmath>

namespace asperity
{
  using namespace dealii;

  template <int dim>
  FreeFormDeformation<dim>::FreeFormDeformation(
    const Point<dim>                  &lower,
    const Point<dim>                  &upper,
    const std::array<KnotVector, dim> &knot_vectors)
    : lower(lower)
    , upper(upper)
    , knot_vectors(knot_vectors)
  {
    std::size_t n = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const KnotVector &knots = knot_vectors[d];
        if (!(upper[d] > lower[d]))
          throw InputError("The box of a free-form deformation is empty.");
        if (knots.is_periodic() || knots.front() != 0. || knots.back() != 1.)
          throw InputError("The knots of a free-form deformation are open ones "
                           "from 0 to 1.");
        n *= knots.n_basis();
      }
    control_points_.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      for (unsigned int d = 0; d < dim; ++d)
        control_points_[i][d] =
          lower[d] +
          knot_vectors[d].greville()[row(i, d)] * (upper[d] - lower[d]);
  }



  template <int dim>
  unsigned int
  FreeFormDeformation<dim>::row(const std::size_t  control_point,
                                const unsigned int direction) const
  {
    std::size_t rest = control_point;
    for (unsigned int d = 0; d < direction; ++d)
      rest /= knot_vectors[d].n_basis();
    return rest % knot_vectors[direction].n_basis();
  }



  template <int dim>
  Point<dim>
  FreeFormDeformation<dim>::value(const Point<dim> &point) const
  {
    std::array<std::vector<unsigned int>, dim> functions;
    std::array<std::vector<double>, dim>       values;
    std::size_t                                n = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const double       t    = (point[d] - lower[d]) / (upper[d] - lower[d]);
        const unsigned int span = knot_vectors[d].find_span(t);
        functions[d]            = knot_vectors[d].span_functions(span);
        values[d]               = knot_vectors[d].evaluate(span, t)[0];
        n *= functions[d].size();
      }
    Point<dim> result;
    for (std::size_t i = 0; i < n; ++i)
      {
        std::size_t rest = i, index = 0, stride = 1;
        double      product = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          {
            const std::size_t k = rest % functions[d].size();
            rest /= functions[d].size();
            index += stride * functions[d][k];
            stride *= knot_vectors[d].n_basis();
            product *= values[d][k];
          }
        result += product * control_points_[index];
      }
    return result;
  }



  template <int dim>
  FreeFormDeformation<dim>
  free_form_deformation(const Point<dim>       &lower,
                        const Point<dim>       &upper,
                        const ShapeDeformation &deformation)
  {
    std::array<KnotVector, dim> knots;
    for (unsigned int d = 0; d < dim; ++d)
      knots[d] = KnotVector(d == dim - 1 ? 2 : 1, {0., 1.});
    FreeFormDeformation<dim> result(lower, upper, knots);
    const Point<dim>         centre = lower + 0.5 * (upper - lower);
    const Tensor<1, dim>     half   = 0.5 * (upper - lower);
    for (std::size_t i = 0; i < result.control_points().size(); ++i)
      {
        const unsigned int row    = result.row(i, dim - 1);
        const bool         is_top = row == 2;
        Point<dim>        &point  = result.control_points()[i];
        Point<dim>         foot   = centre; // of the row
        foot[dim - 1]             = point[dim - 1];
        Tensor<1, dim> r          = point - foot;
        r[0] *= 1. - deformation.shrink_x;
        if (row > 0)
          r *=
            1. + (is_top ? deformation.expand_top : deformation.expand_middle);
        if (is_top)
          {
            const double c = std::cos(deformation.rotate_top);
            const double s = std::sin(deformation.rotate_top);
            const double x = r[0], y = r[1];
            r[0] = c * x - s * y + deformation.translate_top_x * half[0];
            r[1] = s * x + c * y + deformation.translate_top_y * half[1];
          }
        point = foot + r;
      }
    return result;
  }



  template class FreeFormDeformation<2>;
  template class FreeFormDeformation<3>;

  template FreeFormDeformation<2>
  free_form_deformation(const Point<2> &,
                        const Point<2> &,
                        const ShapeDeformation &);
  template FreeFormDeformation<3>
  free_form_deformation(const Point<3> &,
                        const Point<3> &,
                        const ShapeDeformation &);
} // namespace asperity
