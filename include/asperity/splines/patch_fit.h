#ifndef asperity_splines_patch_fit_h
#define asperity_splines_patch_fit_h

#include <asperity/splines/spline_fit.h>
#include <asperity/splines/spline_patch.h>

#include <array>
#include <vector>

namespace asperity
{
  struct PatchFit
  {
    SplinePatch patch;
    FitReport   report;
  };

  /**
   * Least squares on a grid of data, direction by direction (Piegl and Tiller,
   * section 9.4.3); with as many data as functions it interpolates (section
   * 9.2.5). Weights, bending and fixed ends are not supported here.
   * @param points [m], xi fastest
   * @param parameters of the grid lines in xi and eta
   * @throws InputError if their grid has another number of points
   */
  PatchFit
  fit_patch(const std::array<KnotVector, 2>           &knot_vectors,
            const std::vector<dealii::Point<2>>       &points,
            const std::array<std::vector<double>, 2>  &parameters,
            const std::array<dealii::Tensor<1, 2>, 2> &periods = {});
} // namespace asperity

#endif
