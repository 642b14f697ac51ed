#ifndef asperity_splines_closest_point_h
#define asperity_splines_closest_point_h

#include <asperity/splines/projection.h>
#include <asperity/splines/spline_curve.h>

#include <deal.II/base/point.h>

#include <memory>

namespace asperity
{
  /**
   * Closest-point projection on a plane curve of degree 1 to 10, polynomial or
   * rational, open, closed or periodic.
   *
   * Local minima are found from a seed by Newton's method and, where that
   * fails, by sequential quadratic programming (a bounded, convexified Newton
   * step with line search) and the Levenberg-Marquardt method. The certificate:
   * all Bezier pieces whose bounding box lies within the distance found
   * (R-tree) are searched for better points. On a piece the squared distance is
   * a polynomial in Bernstein form; its smallest coefficient bounds it from
   * below, the sign changes of its derivative's coefficients bound the number
   * of stationary points (Descartes), and de Casteljau subdivision sharpens
   * both; T. Sederberg, T. Nishita, Computer-Aided Design 22 (1990) 538-549.
   *
   * With a guess that is near nothing allocates memory. All functions are
   * thread-safe. A point that is not finite gives `certified = false`.
   */
  class ClosestPoint
  {
  public:
    /** @throws InputError if the degree exceeds 10. */
    explicit ClosestPoint(const SplineCurve &curve,
                          const CurveSide    free_side = CurveSide::right);

    ~ClosestPoint();

    const SplineCurve &
    curve() const;

    /** The closest point of all: seeds, local search, certificate. */
    Projection
    project(const dealii::Point<2> &point) const;

    /** As above, starting from a parameter that is thought to be near, of which
     *  the certificate makes sure. */
    Projection
    project(const dealii::Point<2> &point, const double guess) const;

  private:
    struct Implementation;
    std::unique_ptr<const Implementation> implementation;
  };
} // namespace asperity

#endif
