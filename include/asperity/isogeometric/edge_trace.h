#ifndef asperity_isogeometric_edge_trace_h
#define asperity_isogeometric_edge_trace_h

#include <asperity/isogeometric/basis_table.h>
#include <asperity/isogeometric/spline_hierarchy.h>
#include <asperity/splines/spline_curve.h>

#include <utility>
#include <vector>

namespace asperity
{
  /**
   * The trace of the space on an edge as a univariate spline space. On the edge
   * the functions have the continuity of the level-0 knots and new breakpoints
   * only where cells of the edge meet, so that the trace of a spline is a
   * B-spline curve on these breakpoints. Nothing is fitted: its control points
   * are linear in those of the patch, and the curve equals the trace to
   * round-off.
   */
  class EdgeTrace
  {
  public:
    EdgeTrace(const SplineHierarchy<2> &hierarchy, const Edge edge);

    /** Knots of the trace, in the parameter along the edge. */
    const KnotVector &
    knots() const;

    /** Control value i of the trace is the sum of weight times coefficient over
     *  weights()[i] = {(function, weight), ...}. */
    const std::vector<std::vector<std::pair<unsigned int, double>>> &
    weights() const;

    /** Control values of the trace of a scalar spline. */
    std::vector<double>
    apply(const std::vector<double> &coefficients) const;

    /**
     * The edge X(t) of the patch as a curve; in a periodic direction it goes on
     * beyond the period.
     * @param offset as PatchGeometry::offset: that of the reference geometry,
     *   or this plus the displacement coefficients for the deformed edge;
     *   empty for the identity
     */
    SplineCurve
    curve(const std::vector<dealii::Tensor<1, 2>> &offset) const;

  private:
    Edge                                                      edge;
    double                                                    fixed_parameter;
    KnotVector                                                trace_knots;
    std::vector<std::vector<std::pair<unsigned int, double>>> trace_weights;
  };
} // namespace asperity

#endif
