#include "entry_conditions.h"

namespace asperity
{
  namespace
  {
    /** What counts only for some treatments of a measured surface. */
    EntryConditions
    conditions_of_map(const std::string &map,
                      SurfaceParameters SceneParameters::*const surface)
    {
      return {{{map + "Crop columns", map + "Crop rows"},
               "Crop = window",
               [=](const SceneParameters &p) {
                 return (p.*surface).topography.crop == CropChoice::window;
               }},
              {{map + "Profile position", map + "Profile start"},
               "a profile, Geometry/Dimension = 2: a window is in the middle",
               [](const SceneParameters &p) {
                 return p.geometry.dimension == 2;
               }},
              {{map + "Polynomial degree"},
               "F-operator = polynomial",
               [=](const SceneParameters &p) {
                 return (p.*surface).topography.form == FormChoice::polynomial;
               }},
              {{map + "Spline degree", map + "Samples per knot"},
               "the Periodic continuation wrapped spline, or a window in three "
               "dimensions",
               [=](const SceneParameters &p) {
                 return (p.*surface).topography.continuation ==
                          Continuation::wrapped_spline ||
                        p.geometry.dimension == 3;
               }},
              {{map + "Blend fraction"},
               "the Periodic continuation wrapped spline",
               [=](const SceneParameters &p) {
                 return (p.*surface).topography.continuation ==
                        Continuation::wrapped_spline;
               }}};
    }

    /** What a measured surface alone reads. */
    std::vector<std::string>
    entries_of_map(const std::string &section)
    {
      std::vector<std::string> entries = {section + "/Spline fit"};
      for (const std::string name : {"File",
                                     "Lateral unit",
                                     "Height unit",
                                     "Spacing x",
                                     "Spacing y",
                                     "Spike threshold",
                                     "Crop",
                                     "Crop columns",
                                     "Crop rows",
                                     "F-operator",
                                     "Polynomial degree",
                                     "S-filter nesting index",
                                     "L-filter nesting index",
                                     "Profile direction",
                                     "Profile position",
                                     "Profile start",
                                     "Profile length",
                                     "Largest missing fraction",
                                     "Scale x",
                                     "Periodic continuation",
                                     "Spline degree",
                                     "Samples per knot",
                                     "Blend fraction"})
        entries.push_back(section + "/Topography/" + name);
      return entries;
    }
  } // namespace



  EntryConditions
  conditions_of_surface(const std::string &section,
                        SurfaceParameters SceneParameters::*const surface)
  {
    const auto kind = [=](const SurfaceKind kind) {
      return
        [=](const SceneParameters &p) { return (p.*surface).kind == kind; };
    };
    const std::string map        = section + "/Topography/";
    EntryConditions   conditions = {
        {{section + "/Wave numbers",
          section + "/Amplitudes",
          section + "/Phases"},
         "the Kind harmonics",
         kind(SurfaceKind::harmonics)},
        {{section + "/Wave numbers across"},
         "the Kind harmonics in three dimensions",
         [=](const SceneParameters &p) {
         return (p.*surface).kind == SurfaceKind::harmonics &&
                p.geometry.dimension == 3;
       }},
        {{section + "/Spline degree", section + "/Spline spans"},
         "the Kind harmonics, and measured in two dimensions",
         [=](const SceneParameters &p) {
         const SurfaceKind k = (p.*surface).kind;
         return k == SurfaceKind::harmonics ||
                (k == SurfaceKind::measured && p.geometry.dimension == 2);
       }},
        {{section + "/Spline fit"},
         "a profile, Geometry/Dimension = 2",
         [](const SceneParameters &p) { return p.geometry.dimension == 2; }},
        {{map + "Scale z"},
         "the Kinds harmonics and measured",
         [=](const SceneParameters &p) {
         return (p.*surface).kind != SurfaceKind::flat;
       }},
        {entries_of_map(section),
         "the Kind measured",
         kind(SurfaceKind::measured)}};
    const EntryConditions of_map = conditions_of_map(map, surface);
    conditions.insert(conditions.end(), of_map.begin(), of_map.end());
    return conditions;
  }
} // namespace asperity
