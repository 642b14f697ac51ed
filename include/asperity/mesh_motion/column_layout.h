#ifndef asperity_mesh_motion_column_layout_h
#define asperity_mesh_motion_column_layout_h

#include <asperity/splines/spline_curve.h>

#include <functional>
#include <vector>

namespace asperity
{
  /**
   * Parameters of columns on a periodic edge: every span of its knots is
   * divided into equal parts, so that a quadratic edge is met exactly by
   * quadratic cells.
   * @param n_columns aimed at; a span has one at least
   * @param density of columns over the parameter, to any scale, positive;
   *   empty for a constant one
   * @return increasing, from the first to the last breakpoint
   */
  std::vector<double>
  columns_on_spans(const KnotVector                    &knots,
                   const unsigned int                   n_columns,
                   const std::function<double(double)> &density = {});

  /**
   * Column density for a film between two graphs,
   *   sqrt(1 + y_t'^2) / sqrt(max(h, h_0)),   h_0 = 0.01 of the mean of |h|:
   * as many columns on slopes as their length asks for, and in narrow places as
   * many as the pressure asks for, whose peak over a gap h with curvature k is
   * of the width sqrt(h/k).
   * @param chip the lower edge, over its parameter
   * @param tool a graph whose parameter is x
   * @param tool_shift what the tool has moved by [m]
   */
  std::function<double(double)>
  film_density(const SplineCurve          &chip,
               const SplineCurve          &tool,
               const dealii::Tensor<1, 2> &tool_shift);

  /**
   * Heights of rows, from 0 to 1, symmetric to the middle.
   * @param ratio of a row in the middle to one at a wall; 1 for equal ones
   */
  std::vector<double>
  graded_rows(const unsigned int n_rows, const double ratio = 1.);
} // namespace asperity

#endif
