#ifndef asperity_splines_patch_search_h
#define asperity_splines_patch_search_h

#include <asperity/base/convergence_report.h>
#include <asperity/splines/spline_patch.h>

#include <deal.II/base/point.h>

#include <memory>

namespace asperity
{
  /**
   * The inverse of a patch: the parameters of a point of the plane. An R-tree
   * of the bounding boxes of the Bezier elements (which contain them, by the
   * convex hull property) finds the elements that may hold the point; Newton's
   * method with step halving decides.
   */
  class PatchSearch
  {
  public:
    struct Result
    {
      bool              inside = false;
      dealii::Point<2>  parameter; ///< (xi, eta), of any turn if periodic
      ConvergenceReport report;    ///< residual: distance [m] at the parameter
    };

    explicit PatchSearch(const SplinePatch &patch);

    ~PatchSearch();

    /** Where the point lies; `inside` is false if it is in no element. */
    Result
    find(const dealii::Point<2> &point) const;

  private:
    struct Implementation;
    std::unique_ptr<const Implementation> implementation;
  };
} // namespace asperity

#endif
