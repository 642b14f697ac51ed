#ifndef asperity_learned_shapes_chamfer_distance_h
#define asperity_learned_shapes_chamfer_distance_h

#include <asperity/learned_shapes/shape.h>

namespace asperity
{
  /** How far two surfaces are apart, from points of each to the other. */
  struct ChamferDistance
  {
    double mean    = 0.; ///< mean of the mean distances of both directions
    double squared = 0.; ///< sum of the mean squares (Park et al. 2019)
    double largest = 0.; ///< of all points: about Hausdorff's distance
  };

  /** @param n random points on each of both */
  template <int dim>
  ChamferDistance
  chamfer_distance(const Shape<dim>  &first,
                   const Shape<dim>  &second,
                   const unsigned int n = 5000);
} // namespace asperity

#endif
