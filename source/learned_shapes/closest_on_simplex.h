#ifndef source_learned_shapes_closest_on_simplex_h
#define source_learned_shapes_closest_on_simplex_h

#include <deal.II/base/point.h>

#include <array>

namespace asperity
{
  /** Weights of the corners of a segment or triangle whose sum is its point
   *  that is closest to another one; exactly zero for corners that do not
   *  count. */
  template <int dim>
  std::array<double, 2>
  closest_on_segment(const dealii::Point<dim> &a,
                     const dealii::Point<dim> &b,
                     const dealii::Point<dim> &point)
  {
    const double length = (b - a).norm_square();
    const double t      = length > 0. ? (point - a) * (b - a) / length : 0.;
    if (t <= 0.)
      return {{1., 0.}};
    return t >= 1. ? std::array<double, 2>{{0., 1.}} :
                     std::array<double, 2>{{1. - t, t}};
  }



  inline std::array<double, 2>
  closest_on_simplex(const std::array<dealii::Point<2>, 2> &corners,
                     const dealii::Point<2>                &point)
  {
    return closest_on_segment(corners[0], corners[1], point);
  }



  inline std::array<double, 3>
  closest_on_simplex(const std::array<dealii::Point<3>, 3> &corners,
                     const dealii::Point<3>                &point)
  {
    // inside of the triangle if all coordinates of the foot are positive
    const auto   a  = corners[1] - corners[0];
    const auto   b  = corners[2] - corners[0];
    const auto   r  = point - corners[0];
    const double aa = a * a, ab = a * b, bb = b * b;
    const double determinant = aa * bb - ab * ab;
    const double v           = bb * (r * a) - ab * (r * b);
    const double w           = aa * (r * b) - ab * (r * a);
    if (determinant > 0. && v > 0. && w > 0. && v + w < determinant)
      return {{1. - (v + w) / determinant, v / determinant, w / determinant}};
    std::array<double, 3> best{{1., 0., 0.}};
    double                least = corners[0].distance_square(point);
    for (unsigned int k = 0; k < 3; ++k)
      {
        const auto  &begin = corners[k], &end = corners[(k + 1) % 3];
        const auto   weights = closest_on_segment(begin, end, point);
        const double distance =
          (begin + weights[1] * (end - begin)).distance_square(point);
        if (distance > least)
          continue;
        least             = distance;
        best              = {{0., 0., 0.}};
        best[k]           = weights[0];
        best[(k + 1) % 3] = weights[1];
      }
    return best;
  }
} // namespace asperity

#endif
