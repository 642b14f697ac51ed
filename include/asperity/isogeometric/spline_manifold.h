#ifndef asperity_isogeometric_spline_manifold_h
#define asperity_isogeometric_spline_manifold_h

#include <asperity/splines/closest_point.h>
#include <asperity/splines/spline_curve.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/manifold.h>

#include <memory>

namespace asperity
{
  /**
   * A spline curve as the manifold of mesh faces: new points lie on the curve,
   * half-way in its parameter. The chart of a point is the parameter of the
   * closest point of the curve, so points near the curve may be given, too. On
   * a periodic curve the parameter goes on from turn to turn, so that a mesh
   * over one period needs no seam.
   *
   * Use it for boundary faces only; cells next to them need a
   * TransfiniteInterpolationManifold or a flat interior.
   */
  class SplineManifold : public dealii::ChartManifold<2, 2, 1>
  {
  public:
    explicit SplineManifold(const SplineCurve &curve);

    std::unique_ptr<dealii::Manifold<2, 2>>
    clone() const override;

    dealii::Point<1>
    pull_back(const dealii::Point<2> &point) const override;

    dealii::Point<2>
    push_forward(const dealii::Point<1> &parameter) const override;

    dealii::DerivativeForm<1, 1, 2>
    push_forward_gradient(const dealii::Point<1> &parameter) const override;

    const SplineCurve &
    curve() const;

  private:
    /** Shared by clones: it does not change. */
    std::shared_ptr<const ClosestPoint> closest_point;
  };
} // namespace asperity

#endif
