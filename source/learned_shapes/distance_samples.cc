#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learned_shapes/distance_samples.h>

#include <cmath>

namespace asperity
{
  using dealii::Point;

  template <int dim>
  FieldSample
  sample_distances(const Shape<dim>       &shape,
                   const std::string      &name,
                   const DistanceSampling &sampling,
                   RandomNumbers          &random)
  {
    if (sampling.n_points == 0)
      throw InputError("The distances of a shape are taken at one point or "
                       "more.");
    FieldSample result;
    result.name       = name;
    const double n    = sampling.n_points;
    const double near = n * sampling.share_near;
    for (unsigned int i = 0; i < sampling.n_points; ++i)
      {
        Point<dim> p;
        if (i < near)
          {
            const double deviation = std::sqrt(
              i % 2 == 0 ? sampling.near_variance : sampling.far_variance);
            p = shape.surface_point(random);
            for (unsigned int d = 0; d < dim; ++d)
              p[d] += deviation * random.normal();
          }
        else
          for (unsigned int d = 0; d < dim; ++d)
            p[d] = sampling.half_box * (2. * random.uniform() - 1.);
        for (unsigned int d = 0; d < dim; ++d)
          result.positions.push_back(p[d]);
        result.values.push_back(shape.signed_distance(p));
      }
    return result;
  }



  template FieldSample
  sample_distances(const Shape<2> &,
                   const std::string &,
                   const DistanceSampling &,
                   RandomNumbers &);
  template FieldSample
  sample_distances(const Shape<3> &,
                   const std::string &,
                   const DistanceSampling &,
                   RandomNumbers &);
} // namespace asperity
