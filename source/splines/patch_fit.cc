#include <asperity/base/errors.h>
#include <asperity/splines/patch_fit.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  PatchFit
  fit_patch(const std::array<KnotVector, 2>          &knot_vectors,
            const std::vector<Point<2>>              &points,
            const std::array<std::vector<double>, 2> &parameters,
            const std::array<Tensor<1, 2>, 2>        &periods)
  {
    const unsigned int n_xi  = parameters[0].size(),
                       n_eta = parameters[1].size();
    if (points.size() != n_xi * n_eta)
      throw InputError("A patch fit has " + std::to_string(points.size()) +
                       " points, but its grid of " + std::to_string(n_xi) +
                       " by " + std::to_string(n_eta) +
                       " parameters expects one at each crossing.");

    // Each line of the grid becomes a curve in xi; then the control points of
    // these curves are the data in eta.
    FitOptions options;
    options.period = periods[0];
    std::vector<SplineCurve> lines;
    for (unsigned int j = 0; j < n_eta; ++j)
      lines.push_back(fit_least_squares(knot_vectors[0],
                                        {points.begin() + j * n_xi,
                                         points.begin() + (j + 1) * n_xi},
                                        parameters[0],
                                        options)
                        .curve);

    options.period = periods[1];
    std::vector<SplineCurve> columns;
    for (unsigned int i = 0; i < knot_vectors[0].n_basis(); ++i)
      {
        std::vector<Point<2>> data;
        for (const SplineCurve &line : lines)
          data.push_back(line.control_points()[i]);
        columns.push_back(
          fit_least_squares(knot_vectors[1], data, parameters[1], options)
            .curve);
      }

    PatchFit fit;
    fit.patch =
      SplinePatch::from_control_rows(0, knot_vectors[0], columns, periods[0]);
    fit.report.n_control_points = fit.patch.control_points().size();
    double sum                  = 0.;
    for (unsigned int j = 0; j < n_eta; ++j)
      for (unsigned int i = 0; i < n_xi; ++i)
        {
          const double error = points[j * n_xi + i].distance(
            fit.patch.value(parameters[0][i], parameters[1][j]));
          fit.report.residuals.push_back(error);
          fit.report.max_error = std::max(fit.report.max_error, error);
          sum += error * error;
        }
    fit.report.rms_error = std::sqrt(sum / points.size());
    return fit;
  }
} // namespace asperity
