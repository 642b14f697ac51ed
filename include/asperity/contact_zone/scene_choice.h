#ifndef asperity_contact_zone_scene_choice_h
#define asperity_contact_zone_scene_choice_h

#include <asperity/contact_zone/scene_input.h>
#include <asperity/contact_zone/surface_choice.h>

#include <string>
#include <vector>

namespace asperity
{
  /** What the sizes of a scene follow from. Lengths in metres. */
  struct SceneScale
  {
    double shortest_wave  = 0.; ///< of the tool
    double period         = 0.;
    double peak_to_valley = 0.;
    double largest_slope  = 0.;
    double velocity       = 0.; ///< [m/s]
    double wave_speed     = 0.; ///< of pressure waves in the chip [m/s]
  };

  /**
   * Sizes of a scene in proportion to its tool, as in the reference scenes:
   * mu does not depend on the scale of a scene, only on its proportions.
   * Lengths in metres.
   */
  struct SceneSizes
  {
    explicit SceneSizes(const SceneScale &scale);

    /** Half the period, and at least five times the peak-to-valley height. */
    double chip_height;

    /** 16 for each shortest wave (the reference scene R0 needs 13 to 27), and
     *  at least 8 across the steepest asperity; a multiple of 2^levels. */
    unsigned int spans;

    /** So many that the coarsest mesh has 17 to 33 columns. */
    unsigned int levels;

    double strip;       ///< five elements
    double initial_gap; ///< 3 % of the peak-to-valley height

    /** The load comes over a tenth of the shortest wave, and not within less
     *  than 12 transits of a pressure wave, there and back [s]. */
    double ramp_time;

    double steady_distance;  ///< 0.4 shortest waves
    double steady_step;      ///< a sixtieth of the shortest wave
    double maximum_distance; ///< 4 shortest waves
  };

  /** A parameter file that is made from a map. */
  struct SceneChoice
  {
    SceneParameters             parameters;
    std::vector<CommentedEntry> entries;
    std::vector<std::string>    findings;
    std::vector<std::string>    warnings;

    /** Dry or the rung that the audit of the scene chooses. */
    LubricantModel lubricant = LubricantModel::none;

    /** The parameter file: the entries with their reasons. */
    std::string text;
  };

  /**
   * The scene in which a measured surface is the tool.
   *
   * @param given the map: file, units and spacing; the file is written into the
   *   parameter file as it is here
   * @param settings entries that the user has given, {"Load/Pressure",
   *   "450 MPa"}
   * @param name of the output directory below `output`
   * @throws InputError if the map or a setting is wrong
   */
  SceneChoice
  choose_scene(const TopographyParameters &given,
               const EntryValues          &settings,
               const std::string          &name);
} // namespace asperity

#endif
