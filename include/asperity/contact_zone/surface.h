#ifndef asperity_contact_zone_surface_h
#define asperity_contact_zone_surface_h

#include <asperity/contact_zone/scene_parameters.h>
#include <asperity/splines/spline_curve.h>
#include <asperity/topography/make_profile.h>

#include <optional>
#include <string>
#include <utility>

namespace asperity
{
  /** A periodic surface as a graph y = s(x), and what is known of it. */
  struct Surface
  {
    /** The curve (x, s(x)) [m]; its parameter is x. */
    SplineCurve curve;
    double      period = 0.; ///< [m]

    /** A few words for people, and how closely the spline meets the data. */
    std::string description;
    double      fit_rms = 0.; ///< [m]

    /** What was made of the file of a measured surface. */
    std::optional<TopographyReport> topography;

    double
    height(const double x) const;

    double
    minimum() const;

    double
    maximum() const;

    /** (1/L) int s dx [m] */
    double
    mean() const;

    /** max |s'(x)| */
    double
    largest_slope() const;

    /** factor s(x) + offset */
    Surface
    mapped(const double factor, const double offset) const;

    /** s(x - distance), exactly. */
    Surface
    moved(const double distance) const;
  };

  /**
   * The surface that the parameters describe, heights pointing out of its body
   * if measured, along +y otherwise.
   * @param length period of flat and harmonic surfaces; a measured one has the
   *   length of its profile
   * @throws InputError if no periodic profile can be made of the map
   */
  Surface
  make_surface(const SurfaceParameters &parameters, const double length);

  /**
   * Tool and chip of a scene with one period, as make_surface(). Measured ones
   * of different length are cut to the shorter of the two, and the report of
   * the longer one says what that changes.
   * @throws InputError if one period cannot be had
   */
  std::pair<Surface, Surface>
  make_surfaces(const SceneParameters &parameters);

  /** Smallest vertical distance between two surfaces of one period [m]. */
  double
  smallest_gap(const Surface &lower, const Surface &upper);
} // namespace asperity

#endif
