#ifndef asperity_splines_closest_point_h
#define asperity_splines_closest_point_h

#include <asperity/splines/spline_curve.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <vector>

namespace asperity
{
  /** The side of a curve, seen along increasing parameter, on which distances
   *  are positive and to which normals point: the free side. For a tool above
   *  the chip whose parameter runs with x that is `right` (below). */
  enum class CurveSide
  {
    left,
    right
  };



  /** The point of a curve that is closest to a given point. */
  struct Projection
  {
    /** What kind of point the curve has there. */
    enum class Place
    {
      smooth, ///< the connecting line is normal to the curve
      kink,   ///< at a corner of the curve, between the two normals
      end     ///< beyond the first or last point of an open curve
    };

    /** The method that converged. */
    enum class Method
    {
      newton,
      sqp,
      levenberg_marquardt,
      subdivision,
      none
    };

    double           parameter = 0.; ///< unwrapped: of any turn if periodic
    dealii::Point<2> point;          ///< [m]

    /** Distance [m], positive on the free side. */
    double distance = 0.;

    /** Gradient of `distance` with respect to the given point: the unit normal
     *  of the curve to the free side or, at a kink or end, the signed direction
     *  to the point. */
    dealii::Tensor<1, 2> normal;

    /** Unit vector along increasing parameter; at a kink from the right. */
    dealii::Tensor<1, 2> tangent;

    /** |dC/dt| [m]. */
    double speed = 0.;

    /** Rate at which the tangent turns towards `normal` [1/m]: positive where
     *  the curve bends towards the free side (valley), so that the closest
     *  point is unique up to the distance 1/curvature. */
    double curvature = 0.;

    Place        place      = Place::smooth;
    Method       method     = Method::none;
    unsigned int iterations = 0;

    /** A local minimum of the distance was found to round-off. */
    bool converged = false;

    /** Proved: no point of the curve is closer (up to round-off). */
    bool certified = false;
  };



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
   * No function allocates memory; all are thread-safe.
   */
  class ClosestPoint
  {
  public:
    /** @throw InputError if the degree exceeds 10. */
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

    /** The local minimum of the distance that is reached from a guess; never
     *  certified. The fastest way to follow a point that moves little. */
    Projection
    project_locally(const dealii::Point<2> &point, const double guess) const;

  private:
    struct Implementation;
    std::unique_ptr<const Implementation> implementation;
  };
} // namespace asperity

#endif
