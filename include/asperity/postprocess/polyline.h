#ifndef asperity_postprocess_polyline_h
#define asperity_postprocess_polyline_h

#include <deal.II/base/point.h>

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace asperity
{
  /**
   * A line through points (at least two) with values at them: the tool, the
   * contact line. Names carry the unit, "contact pressure [Pa]".
   */
  struct Polyline
  {
    template <typename Value>
    using Fields = std::vector<std::pair<std::string, std::vector<Value>>>;

    std::vector<dealii::Point<2>> points; ///< current position [m]
    Fields<double>                scalars;
    Fields<dealii::Tensor<1, 2>>  vectors;
  };

  /**
   * Writes a polyline as VTU.
   *
   * @param time physical time [s] of the picture
   * @throws ComputationError naming the field whose length is wrong or that
   *   holds a number that is not finite (in single precision, which VTU stores)
   */
  void
  write_polyline(std::ostream      &out,
                 const Polyline    &line,
                 const double       time,
                 const unsigned int step);
} // namespace asperity

#endif
