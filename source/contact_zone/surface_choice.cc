#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/topography/form_removal.h>

#include <algorithm>
#include <cmath>

#include "surface_chooser.h"

// From the file to a level map without spikes and holes.

namespace asperity
{
  namespace
  {
    constexpr double largest_hole_fraction = 0.01;
    constexpr double worthwhile_form       = 0.8; ///< Sq after over before
  }                                               // namespace



  SurfaceChooser::SurfaceChooser(const TopographyParameters &given)
    : declarator(handler)
  {
    choice.topography      = given;
    choice.topography.form = FormChoice::none;
    choice.topography.crop = CropChoice::none;
    map                    = treat_map(choice.topography, report);
    choice.topography.declare(declarator);
    if (!(areal_roughness(map).Sq > 0.))
      throw InputError("All heights of " + quoted_name(given.file) +
                       " are equal; a rough surface is expected.");
  }



  SurfaceChoice
  SurfaceChooser::choose()
  {
    // Spikes are errors within the surface and no reason to crop it.
    const double missing   = map.missing_fraction();
    const Window hole_free = largest_window_without_holes(map);
    choose_spikes();
    choose_crop(missing, hole_free);
    choose_form();
    choose_profile();
    describe();
    return choice;
  }



  void
  SurfaceChooser::set(const std::string &key,
                      const std::string &text,
                      const std::string &reason)
  {
    declarator.set(key, text);
    auto &entries = choice.entries;
    entries.erase(std::remove_if(entries.begin(),
                                 entries.end(),
                                 [&](const auto &e) { return e.path == key; }),
                  entries.end());
    entries.push_back({key, text, reason});
  }



  void
  SurfaceChooser::choose_spikes()
  {
    if (map.ny == 1 || map.n_valid() < smallest_map_with_spikes)
      return;
    HeightMap         without = map;
    const std::size_t n       = remove_spikes(without, usual_spike_threshold);
    const double      share   = double(n) / map.n_valid();
    const std::string found = std::to_string(n) + " points (" + percent(share) +
                              ") differ from their "
                              "neighbours by more than 8 "
                              "robust standard deviations";
    if (share > largest_spike_fraction)
      set("Spike threshold",
          "0",
          found + "; so many are the surface itself, not errors of the "
                  "instrument.");
    else
      {
        set("Spike threshold",
            "8",
            found + "; so few are errors of the instrument.");
        map = without;
      }
  }



  void
  SurfaceChooser::choose_crop(const double missing, const Window &w)
  {
    if (missing <= largest_hole_fraction)
      {
        set("Crop",
            "none",
            percent(missing) + " of the points are missing; the profile is "
                               "taken where none is.");
        return;
      }
    map = crop(map, w);
    set("Crop",
        "window",
        percent(missing) +
          " of the points are missing: the largest "
          "rectangle without holes, " +
          um(map.length_x()) + " x " + um(map.length_y()) + ".");
    const auto range = [](const unsigned int first, const unsigned int n) {
      return std::to_string(first) + " .. " + std::to_string(first + n - 1);
    };
    set("Crop columns", range(w.column, w.nx), "as Crop says.");
    set("Crop rows", range(w.row, w.ny), "as Crop says.");
  }



  void
  SurfaceChooser::choose_form()
  {
    const auto without_form = [this](const unsigned int degree) {
      HeightMap result = map;
      remove_form(result, degree);
      return result;
    };
    const auto   Sq = [](const HeightMap &m) { return areal_roughness(m).Sq; };
    const double tilted = Sq(map);
    HeightMap    best   = without_form(1);
    std::string  course = um(tilted) + " -> " + um(Sq(best));
    unsigned int degree = 1;
    while (degree < 4)
      {
        HeightMap next;
        try
          {
            next = without_form(degree + 1);
          }
        catch (const InputError &)
          {
            break; // too few points
          }
        if (Sq(next) > worthwhile_form * Sq(best))
          break;
        best = next;
        course += " -> " + um(Sq(best));
        ++degree;
      }
    map = best;
    if (!(Sq(map) > 1e-6 * tilted) || !(Sq(map) > 1e-12))
      throw InputError(quoted_name(choice.topography.file) +
                       " is a smooth form without roughness; a rough "
                       "surface is expected.");
    if (degree == 1)
      set("F-operator",
          "plane",
          "the tilt of the specimen, Sq " + course +
            "; a curved form would lower Sq by less than 20 %.");
    else
      {
        set("F-operator",
            "polynomial",
            "the tilt and the curvature of the specimen, Sq " + course +
              " by degree 0 to " + std::to_string(degree) + ".");
        set("Polynomial degree",
            std::to_string(degree),
            "one more would lower Sq by less than 20 %.");
      }
  }



  void
  SurfaceChooser::describe()
  {
    const ProfileRoughness &roughness = surface.topography->profile_roughness;
    const auto              text      = [this](const std::string &key) {
      return declarator.get(key);
    };
    auto &findings = choice.findings;
    findings.insert(
      findings.begin(),
      {"Map: " + report.sanity.format + ", " +
         std::to_string(report.sanity.nx) + " x " +
         std::to_string(report.sanity.ny) + " points, " +
         um(report.sanity.length_x) + " x " + um(report.sanity.length_y) +
         ", " + percent(report.sanity.missing_fraction) + " missing; used " +
         um(map.length_x()) + " x " + um(map.length_y()) + ".",
       "S-filter " + text("S-filter nesting index") + ": " + reason_of_wave});
    findings.push_back(
      "Profile: period " + um(choice.period) + ", Rq " + um(roughness.Rq) +
      ", peak to valley " + um(choice.peak_to_valley) + ", slope " +
      number(roughness.Rdq) + " rms, " + number(choice.largest_slope) +
      " at most; L-filter " +
      (l_filter > 0. ? um(l_filter) : std::string("none")) + ".");
  }



  SurfaceChoice
  choose_surface(const TopographyParameters &given)
  {
    return SurfaceChooser(given).choose();
  }
} // namespace asperity
