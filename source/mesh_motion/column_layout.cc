#include <asperity/mesh_motion/column_layout.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace asperity
{
  namespace
  {
    /** Sample points in each span for what only steers the columns. */
    constexpr unsigned int n_samples = 8;

    double
    sample(const std::vector<double> &breakpoints,
           const unsigned int         span,
           const unsigned int         k)
    {
      const double length = breakpoints[span + 1] - breakpoints[span];
      return breakpoints[span] + length * (k + 0.5) / n_samples;
    }
  } // namespace



  std::vector<double>
  columns_on_spans(const KnotVector                    &knots,
                   const unsigned int                   n_columns,
                   const std::function<double(double)> &density)
  {
    const std::vector<double> &breakpoints = knots.breakpoints();
    std::vector<double>        share(knots.n_spans(), 0.);
    for (unsigned int span = 0; span < share.size(); ++span)
      for (unsigned int k = 0; k < n_samples; ++k)
        share[span] += (density ? density(sample(breakpoints, span, k)) : 1.) *
                       (breakpoints[span + 1] - breakpoints[span]);
    const double sum = std::accumulate(share.begin(), share.end(), 0.);

    std::vector<double> columns;
    for (unsigned int span = 0; span < share.size(); ++span)
      {
        const double length = breakpoints[span + 1] - breakpoints[span];
        const double parts =
          std::max(1., std::round(n_columns * share[span] / sum));
        for (unsigned int k = 0; k < parts; ++k)
          columns.push_back(breakpoints[span] + length * k / parts);
      }
    columns.push_back(breakpoints.back());
    return columns;
  }



  std::function<double(double)>
  film_density(const SplineCurve          &chip,
               const SplineCurve          &tool,
               const dealii::Tensor<1, 2> &tool_shift)
  {
    const auto gap_and_slope = [chip, tool, tool_shift](const double s) {
      const dealii::Point<2> below = chip.value(s);
      const auto above = tool.derivatives(below[0] - tool_shift[0], 1);
      return std::pair<double, double>(above[0][1] + tool_shift[1] - below[1],
                                       above[1][1] / above[1][0]);
    };
    const std::vector<double> &breakpoints = chip.knot_vector().breakpoints();
    const unsigned int         n_spans     = breakpoints.size() - 1;
    double                     mean        = 0.;
    for (unsigned int span = 0; span < n_spans; ++span)
      for (unsigned int k = 0; k < n_samples; ++k)
        mean += std::abs(gap_and_slope(sample(breakpoints, span, k)).first) /
                (n_spans * n_samples);
    const double smallest = 0.01 * mean;
    return [gap_and_slope, smallest](const double s) {
      const auto [h, slope] = gap_and_slope(s);
      return std::sqrt((1. + slope * slope) / std::max(h, smallest));
    };
  }



  std::vector<double>
  graded_rows(const unsigned int n_rows, const double ratio)
  {
    // Row j is 1 at the walls and ratio in the middle, linear between them.
    std::vector<double> heights(n_rows + 1, 0.);
    for (unsigned int j = 0; j < n_rows; ++j)
      {
        const double to_wall = std::min(j, n_rows - 1 - j);
        const double middle  = std::max(1., std::ceil(0.5 * n_rows) - 1.);
        heights[j + 1] = heights[j] + 1. + (ratio - 1.) * to_wall / middle;
      }
    for (double &height : heights)
      height /= heights.back();
    heights.back() = 1.;
    return heights;
  }
} // namespace asperity
