#include "surface_audit.h"

#include <asperity/base/quantity.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** The shortest wave that a map shows. */
    constexpr double pixels_a_wave = 3.;

    /** The lowest texture aspect ratio at which patches have been compared with
     *  profiles, and where these miss mu already without shear of the interface
     *  (parameter_files/charts/10_plane_strain). */
    constexpr double largest_ratio_of_ridges = 0.05;

    /** What that chart has of the mean over the profiles of a window. */
    std::string
    error_of_ridges(const bool is_sheared)
    {
      return is_sheared ?
               "with a shear factor of 0.5 mu in the mean over profiles was 24 % "
               "below to 15 % above that of patches at Str = 0.05 to 1" :
               "without shear of the interface mu in the mean over profiles "
               "lacked up to 48 % of that of patches at Str = 0.05, 32 to 65 % "
               "at 0.15 and 0.2, and 8 to 61 % at 0.6 to 1";
    }

    void
    audit_texture(const TopographyReport &topography,
                  const std::string      &whose,
                  const bool              is_sheared,
                  SceneAudit             &audit)
    {
      if (topography.map.ny == 1)
        return;
      const ArealTexture &texture  = topography.texture;
      const bool          is_known = !std::isnan(texture.Str);
      audit.entries.push_back(
        {"texture aspect ratio Str, " + whose,
         texture.Str_bound,
         std::string(is_known ? "" :
                                "(at most: some decay takes more than half of "
                                "the map) ") +
           "above 0.05 a profile in plane strain, a ridge without end, stands "
           "for hills"});
      if (texture.Str_bound <= largest_ratio_of_ridges)
        return;
      const std::string ratio = format_quantity(texture.Str_bound, "1", 2);
      audit.warnings.push_back(
        whose + " surface: " +
        (is_known ?
           "its texture aspect ratio Str is " + ratio +
             ", and a profile in plane strain is a ridge without end: " :
           "whether a profile in plane strain, a ridge without end, can stand "
           "for it, the map is too small to tell: Str is at most " +
             ratio + ", and ") +
        error_of_ridges(is_sheared) +
        " (on one to three windows: parameter_files/charts/10_plane_strain); a "
        "patch (Geometry/Dimension = 3) has its hills." +
        (texture.has_lay() ?
           "" :
           " One profile is another matter: eight of the blasted tool of the "
           "examples differ by 33 % in mu; asperity sensitivity tells what "
           "another one changes."));
    }

    void
    audit_filter(const TopographyParameters &topography,
                 const HeightMap            &map,
                 const std::string          &whose,
                 SceneAudit                 &audit)
    {
      const double resolved = pixels_a_wave * std::max(map.dx, map.dy);
      const double ratio    = topography.s_filter / resolved;
      audit.entries.push_back(
        {"S-filter over three pixels, " + whose,
         ratio,
         "above 1 waves are left out that the map shows, which is right where "
         "they are noise"});
      if (ratio > 3.)
        audit.warnings.push_back(
          whose + " surface: the S-filter of " +
          format_quantity(topography.s_filter, "um", 3) +
          " leaves out waves that the map shows (from " +
          format_quantity(resolved, "um", 3) +
          " on). Unless they are noise, mu lacks them: behind 5, 2.5 and 1.5 "
          "um the blasted tool of the examples has 0.044, 0.106 and 0.136.");
    }
  } // namespace



  void
  audit_treatment(const TopographyParameters &topography,
                  const TopographyReport     &report,
                  const std::string          &whose,
                  SceneAudit                 &audit)
  {
    for (const auto &list : {report.sanity.warnings, report.warnings})
      for (const std::string &warning : list)
        audit.warnings.push_back(whose + " surface: " + warning);
    audit_filter(topography, report.map, whose, audit);
  }



  void
  audit_surface(const SurfaceParameters &parameters,
                const Surface           &surface,
                const std::string       &whose,
                const bool               is_sheared,
                SceneAudit              &audit)
  {
    if (!surface.topography)
      return;
    audit_treatment(parameters.topography, *surface.topography, whose, audit);
    audit_texture(*surface.topography, whose, is_sheared, audit);
  }



  void
  audit_flanks(const SheetSurface &surface,
               const std::string  &whose,
               SceneAudit         &audit)
  {
    const double slope = surface.largest_slope();
    if (slope <= 1.5)
      return;
    const std::string filter =
      surface.topography ? "filter it more (S-filter nesting index) or " : "";
    audit.warnings.push_back(
      whose + " surface: it is up to " +
      format_quantity(std::atan(slope), "deg", 3) +
      " steep, and elements that are pressed into flanks of about 60 deg fold, "
      "so that the run may end early; " +
      filter + "lower it (Scale z).");
  }
} // namespace asperity
