#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/topography/autocorrelation.h>
#include <asperity/topography/gaussian_filter.h>
#include <asperity/topography/typical_profile.h>

#include <algorithm>
#include <cmath>

#include "surface_chooser.h"

// From the level map to filters and a profile.

namespace asperity
{
  namespace
  {
    constexpr double pixels_a_wave         = 3.;
    constexpr double largest_noise_share   = 0.25; ///< of the slope
    constexpr double steepest              = 1.;   ///< tan 45 degrees
    constexpr double snap_to_axis          = 5. * M_PI / 180.;
    constexpr double fewest_waves          = 5.; ///< in a profile
    constexpr double waves_a_period        = 10.;
    constexpr double most_waves_a_period   = 20.;
    constexpr double longest_usual_period  = 100e-6;
    constexpr double correlations_a_period = 8.;
    constexpr double negligible_waviness   = 0.1;    ///< share of Sq^2
    constexpr double coarsest_wave         = 200e-6; ///< of a contact zone
    constexpr double finest_asperities     = 5e-6;
  } // namespace



  bool
  SurfaceChooser::filter_more()
  {
    const double next = nesting_index_of_at_least(1.01 * wave);
    if (next > std::max(map.length_x(), map.length_y()) / waves_a_period)
      return false;
    wave = next;
    return true;
  }



  bool
  SurfaceChooser::noise_disturbs(const Texture &texture)
  {
    const double slope = filtered_noise_slope(map, noise, wave);
    if (slope <= largest_noise_share * texture.largest_slope)
      return false;
    const std::string before = um(wave);
    if (!filter_more())
      return false;
    reason_of_wave += " Behind " + before + " the pixel noise of " +
                      format_quantity(noise, "nm", 3) +
                      " would still have a slope of " + number(slope) +
                      ", too much against the surface's " +
                      number(texture.largest_slope) + ".";
    return true;
  }



  void
  SurfaceChooser::choose_profile()
  {
    const double pixel = std::max(map.dx, map.dy);
    noise              = pixel_noise(map);
    wave               = nesting_index_of_at_least(pixels_a_wave * pixel);
    reason_of_wave = "the first nesting index of ISO 25178-3 that is at least "
                     "three pixels of " +
                     um(pixel) + ".";
    if (wave > coarsest_wave)
      throw InputError("The pixels of " + quoted_name(choice.topography.file) +
                       " are " + um(pixel) +
                       " wide, and show nothing of the asperities of a "
                       "contact zone; pixels of 60 um or less are expected.");
    while (true)
      {
        HeightMap filtered = map;
        apply_s_filter(filtered, wave);
        const Texture texture = measure_texture(filtered);
        if (noise_disturbs(texture))
          continue;
        choose_direction(texture, areal_texture(filtered));
        choose_period_and_l_filter(filtered);
        choose_place(filtered);
        SurfaceParameters parameters;
        parameters.kind       = SurfaceKind::measured;
        parameters.topography = choice.topography;
        surface               = make_surface(parameters, 0.);
        const double slope    = surface.largest_slope();
        const auto   before   = um(wave);
        if (slope <= steepest || !filter_more())
          break;
        reason_of_wave += " Behind " + before +
                          " the profile would still be "
                          "as steep as " +
                          number(std::atan(slope) * 180. / M_PI) +
                          " degrees; a mesh that is pressed into flanks above "
                          "45 degrees folds.";
      }
    look_at_profile();
  }



  void
  SurfaceChooser::choose_direction(const Texture      &texture,
                                   const ArealTexture &areal)
  {
    const std::string slopes =
      "the root mean square slope is " + number(texture.largest_slope) +
      " at " + std::to_string(std::lround(texture.direction * 180. / M_PI)) +
      " deg" + " to x and " + number(texture.smallest_slope) +
      " across that, the texture aspect ratio Str " +
      (std::isnan(areal.Str) ? "at most " : "") + number(areal.Str_bound);
    std::string reason;
    direction = 0.;
    if (map.ny == 1)
      reason = "the map is a single profile.";
    else if (!areal.has_lay())
      reason = slopes + ", above " +
               number(ArealTexture::largest_ratio_of_lay) +
               ": no lay; any direction will do.";
    else
      {
        direction = texture.direction;
        for (const double axis : {-M_PI / 2., 0., M_PI / 2.})
          if (std::abs(direction - axis) < snap_to_axis)
            direction = std::abs(axis);
        direction = std::round(direction * 180. / M_PI) * M_PI / 180.;
        reason    = slopes + ": across the lay. If the chip flows another "
                             "way, set that.";
      }
    available = length_through_middle(map, direction);
    if (available < fewest_waves * wave && map.ny > 1)
      {
        const double other =
          std::abs(std::sin(direction)) > std::sqrt(0.5) ? 0. : M_PI / 2.;
        if (length_through_middle(map, other) > available)
          {
            direction = other;
            available = length_through_middle(map, direction);
            reason    = slopes + "; only this way the map is long enough.";
          }
      }
    if (available < fewest_waves * wave)
      throw InputError(quoted_name(choice.topography.file) +
                       " is too small for a scene: with "
                       "pixels of " +
                       um(std::max(map.dx, map.dy)) + " it shows waves from " +
                       um(wave) + " on, and its profiles are " + um(available) +
                       " long; five of these waves are expected, " +
                       um(fewest_waves * wave) + ".");
    set("Profile direction", format_quantity(direction, "deg", 4), reason);
    choice.findings.clear();
    choice.findings.push_back(
      "Direction " + format_quantity(direction, "deg", 3) + ": " + reason);
  }



  void
  SurfaceChooser::choose_period_and_l_filter(HeightMap &filtered)
  {
    const double correlation = Autocorrelation(filtered).decay(direction).lag;
    const double longest =
      std::max(waves_a_period * wave,
               std::min(most_waves_a_period * wave, longest_usual_period));
    period = std::clamp(correlations_a_period * correlation,
                        waves_a_period * wave,
                        longest);
    period = std::min(period, available);

    l_filter                 = 0.;
    const double index       = nesting_index_of_at_least(period);
    HeightMap    short_waves = filtered;
    std::string  reason;
    const double before = areal_roughness(filtered).Sq;
    apply_l_filter(short_waves, index);
    const double share =
      1. - std::pow(areal_roughness(short_waves).Sq / before, 2);
    const std::string found = "waves longer than " + um(index) + " hold " +
                              percent(std::max(0., share)) + " of Sq^2";
    if (share <= negligible_waviness)
      reason = found + ": too little to be filtered.";
    else if (index > 0.5 * std::max(map.length_x(), map.length_y()))
      reason = "the map is too small to tell waves longer than the period "
               "from its form.";
    else
      {
        l_filter = index;
        filtered = short_waves;
        reason   = found + ", and a period of about " + um(period) +
                 " has no room for them.";
      }
    set("L-filter nesting index", um(l_filter), reason);
    set("S-filter nesting index", um(wave), reason_of_wave);
    reason_of_length = number(period / correlation) +
                       " autocorrelation lengths of " + um(correlation) + ", " +
                       number(period / wave) + " times the S-filter" +
                       (period == available ? ": all that the map has." : ".");
  }



  void
  SurfaceChooser::choose_place(const HeightMap &filtered)
  {
    const TypicalProfile piece = find_typical_profile(
      filtered, direction, period, std::max(wave, 0.5 * l_filter));
    const std::string reason =
      "of " + std::to_string(piece.n_pieces) + " pieces the one whose Rq " +
      um(piece.Rq) + " and slope Rdq " + number(piece.Rdq) +
      " are nearest to the medians, " + um(piece.median_Rq) + " and " +
      number(piece.median_Rdq) + ", and whose ends meet.";
    if (map.ny > 1)
      set("Profile position",
          (piece.along_y ? "column " : "row ") + std::to_string(piece.line),
          reason);
    set("Profile start",
        format_quantity(piece.start, "um", 7),
        map.ny > 1 ? "as Profile position." : reason);
    set("Profile length",
        format_quantity(piece.length, "um", 7),
        reason_of_length);
    choice.findings.push_back("Place: " + reason);
  }



  void
  SurfaceChooser::look_at_profile()
  {
    const ProfileRoughness &roughness = surface.topography->profile_roughness;
    choice.shortest_wave              = wave;
    choice.period                     = surface.period;
    choice.peak_to_valley             = surface.maximum() - surface.minimum();
    choice.rms_slope                  = roughness.Rdq;
    choice.largest_slope              = surface.largest_slope();
    if (!(choice.peak_to_valley > 0.))
      throw InputError("Nothing is left of the roughness of " +
                       quoted_name(choice.topography.file) +
                       " behind its filters; a rougher surface or a finer "
                       "map is expected.");
    if (choice.largest_slope > steepest)
      choice.warnings.push_back(
        "The profile is " +
        number(std::atan(choice.largest_slope) * 180. / M_PI) +
        " degrees steep, and the map is too small to filter it more: the run "
        "may end early.");
    if (wave > finest_asperities)
      choice.warnings.push_back(
        "The map shows no asperity shorter than " + um(wave) +
        "; finer and steeper ones would raise mu, so that this mu is a lower "
        "bound: measure with pixels of 1 um or less.");
    if (choice.period < 0.9 * waves_a_period * wave)
      choice.warnings.push_back(
        "The profile holds only " + number(choice.period / wave) +
        " of the shortest waves: mu is that of this piece, no mean.");
    for (const auto &list :
         {surface.topography->sanity.warnings, surface.topography->warnings})
      choice.warnings.insert(choice.warnings.end(), list.begin(), list.end());
  }
} // namespace asperity
