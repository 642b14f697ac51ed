#ifndef tests_learned_shapes_exact_distances_h
#define tests_learned_shapes_exact_distances_h

#include <deal.II/base/point.h>

#include <algorithm>
#include <cmath>

/** Signed distance to a box around zero from its half edges: the length of the
 *  part of |x| - half that is positive or, inside, its largest component. */
template <int dim>
double
distance_to_box(const dealii::Point<dim> &point, const dealii::Point<dim> &half)
{
  double outside = 0., largest = -1e300;
  for (unsigned int d = 0; d < dim; ++d)
    {
      const double excess = std::abs(point[d]) - half[d];
      outside += std::pow(std::max(0., excess), 2);
      largest = std::max(largest, excess);
    }
  return largest > 0. ? std::sqrt(outside) : largest;
}

#endif
