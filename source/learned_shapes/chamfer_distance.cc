#include <asperity/base/random_numbers.h>
#include <asperity/learned_shapes/chamfer_distance.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  template <int dim>
  ChamferDistance
  chamfer_distance(const Shape<dim>  &first,
                   const Shape<dim>  &second,
                   const unsigned int n)
  {
    ChamferDistance result;
    RandomNumbers   random(1);
    const auto      add = [&](const Shape<dim> &from, const Shape<dim> &to) {
      for (unsigned int i = 0; i < n; ++i)
        {
          const double d =
            std::abs(to.signed_distance(from.surface_point(random)));
          result.mean += 0.5 * d / n;
          result.squared += d * d / n;
          result.largest = std::max(result.largest, d);
        }
    };
    add(first, second);
    add(second, first);
    return result;
  }



  template ChamferDistance
  chamfer_distance(const Shape<2> &, const Shape<2> &, const unsigned int);
  template ChamferDistance
  chamfer_distance(const Shape<3> &, const Shape<3> &, const unsigned int);
} // namespace asperity
