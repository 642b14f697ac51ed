#ifndef asperity_contact_zone_sheet_surface_h
#define asperity_contact_zone_sheet_surface_h

#include <asperity/contact_zone/scene_parameters.h>
#include <asperity/splines/spline_sheet.h>
#include <asperity/topography/make_window.h>

#include <optional>
#include <string>
#include <utility>

namespace asperity
{
  /** A surface that repeats along x and y, z = s(x, y), and what is known of
   *  it: what Surface is in two dimensions. */
  struct SheetSurface
  {
    SplineSheet sheet; ///< [m]

    std::string description; ///< a few words for people

    /** What was made of the file of a measured surface. */
    std::optional<TopographyReport> topography;

    /** What making its window periodic changed. */
    std::optional<WindowReport> window;

    double
    minimum() const;

    double
    maximum() const;

    /** max |grad s| */
    double
    largest_slope() const;

    /** max |ds/dx|, or |ds/dy| for a direction of 1 */
    double
    largest_slope(const unsigned int direction) const;

    /** factor s(x, y) + offset */
    SheetSurface
    mapped(const double factor, const double offset) const;

    /** s(x - along_x, y - along_y), exactly. */
    SheetSurface
    moved(const double along_x, const double along_y) const;
  };

  /**
   * Tool and chip of a scene in three dimensions, with the same periods, as
   * make_surfaces() has them in two.
   * @throws InputError if no periodic surface can be made of the map
   */
  std::pair<SheetSurface, SheetSurface>
  make_sheets(const SceneParameters &parameters);

  /** Smallest vertical distance between two surfaces of the same periods [m]:
   *  exact if one of them is flat, else of a fine grid. */
  double
  smallest_gap(const SheetSurface &lower, const SheetSurface &upper);
} // namespace asperity

#endif
