#ifndef asperity_postprocess_surface_picture_h
#define asperity_postprocess_surface_picture_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace asperity
{
  /**
   * A surface in space as squares of n x n points each, with values at them:
   * the tool, the contact face. Names carry the unit, "contact pressure [Pa]".
   */
  struct SurfacePicture
  {
    template <typename Value>
    using Fields = std::vector<std::pair<std::string, std::vector<Value>>>;

    unsigned int points_a_side = 2; ///< n

    /** Current positions [m], square by square, the first direction fastest. */
    std::vector<dealii::Point<3>> points;
    Fields<double>                scalars;
    Fields<dealii::Tensor<1, 3>>  vectors;
  };

  /**
   * Writes a surface as VTU.
   *
   * @param time physical time [s] of the picture
   * @throws ComputationError naming the field whose length is wrong or that
   *   holds a number that is not finite (in single precision, which VTU stores)
   */
  void
  write_surface(std::ostream         &out,
                const SurfacePicture &surface,
                const double          time,
                const unsigned int    step);

  /**
   * Values at the equidistant points of squares, edges included, from those at
   * as many Gauss points, through the polynomial that interpolates them; within
   * the range that they have there if limited.
   * @param n points a direction
   */
  template <typename Value>
  std::vector<Value>
  from_gauss_points(const std::vector<Value> &values,
                    const unsigned int        n,
                    const bool                limited);
} // namespace asperity

#endif
