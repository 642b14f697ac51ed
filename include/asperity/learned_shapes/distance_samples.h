#ifndef asperity_learned_shapes_distance_samples_h
#define asperity_learned_shapes_distance_samples_h

#include <asperity/learned_shapes/shape.h>
#include <asperity/learning/auto_decoder.h>

#include <string>

namespace asperity
{
  /** Where the distances of a shape in the unit sphere are taken (Park et al.
   *  2019, section 5): most at points of the surface that are moved by normal
   *  deviates, half of them farther, the others anywhere. */
  struct DistanceSampling
  {
    unsigned int n_points      = 2000;
    double       share_near    = 0.9; ///< theirs is 0.94 of 500000 points
    double       far_variance  = 2.5e-3;
    double       near_variance = 2.5e-4;
    double       half_box      = 1.1; ///< of the points anywhere
  };

  /** @throws InputError if there are no points */
  template <int dim>
  FieldSample
  sample_distances(const Shape<dim>       &shape,
                   const std::string      &name,
                   const DistanceSampling &sampling,
                   RandomNumbers          &random);
} // namespace asperity

#endif
