#ifndef asperity_splines_parametrization_h
#define asperity_splines_parametrization_h

#include <asperity/splines/knot_vector.h>

#include <deal.II/base/point.h>

#include <vector>

namespace asperity
{
  /** Parameters in [0, 1] proportional to the chord lengths to the power
   *  `exponent`: 1 chord length, 0.5 centripetal (Piegl and Tiller 9.4-9.6).
   *  @throws InputError if there are fewer than two points, or two in one place
   */
  std::vector<double>
  chord_parameters(const std::vector<dealii::Point<2>> &points,
                   const double                         exponent = 1.);

  /** The open knots of interpolation, by averaging (Piegl and Tiller 9.8).
   *  @throws InputError if there are fewer parameters than degree + 1 */
  KnotVector
  averaged_knots(const std::vector<double> &parameters,
                 const unsigned int         degree);
} // namespace asperity

#endif
