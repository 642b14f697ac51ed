#ifndef asperity_isogeometric_spline_manifold_h
#define asperity_isogeometric_spline_manifold_h

#include <asperity/splines/closest_point.h>
#include <asperity/splines/spline_curve.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/manifold.h>
#include <deal.II/grid/tria.h>

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
   * Use it for boundary faces only, see set_spline_wall(); cells next to them
   * need a manifold of their own or a flat interior.
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

  /**
   * Makes a boundary of a mesh a piece of a curve: nodes that refinement or a
   * mapping of high degree puts on its faces lie on the curve. The manifold
   * takes the boundary's id as its own.
   * @param wall its vertices must lie on the curve already
   * @throws InputError if one does not, by more than 1e-6 of its face's length
   */
  void
  set_spline_wall(dealii::Triangulation<2>        &mesh,
                  const dealii::types::boundary_id wall,
                  const SplineCurve               &curve);
} // namespace asperity

#endif
