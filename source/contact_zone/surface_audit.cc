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

    void
    audit_texture(const TopographyReport &topography,
                  const std::string      &whose,
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
           "above 0.3 a profile in plane strain, a ridge without end, stands "
           "for hills"});
      if (texture.has_lay())
        return;
      const std::string ratio = format_quantity(texture.Str_bound, "1", 2);
      audit.warnings.push_back(
        whose + " surface: " +
        (is_known ?
           "its texture aspect ratio Str is " + ratio +
             ", and above 0.3 one profile in plane strain, a ridge without "
             "end, cannot stand for its hills: eight profiles of the blasted "
             "tool of the examples differ by 33 % in mu; asperity "
             "sensitivity tells what another one changes." :
           "whether one profile in plane strain can stand for it, for which "
           "its texture aspect ratio Str should be at most 0.3, the map is too "
           "small to tell: Str is at most " +
             ratio + "."));
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
                SceneAudit              &audit)
  {
    if (!surface.topography)
      return;
    audit_treatment(parameters.topography, *surface.topography, whose, audit);
    audit_texture(*surface.topography, whose, audit);
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
