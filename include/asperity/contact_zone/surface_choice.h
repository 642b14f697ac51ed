#ifndef asperity_contact_zone_surface_choice_h
#define asperity_contact_zone_surface_choice_h

#include <asperity/base/commented_parameters.h>
#include <asperity/topography/topography_parameters.h>

#include <string>
#include <vector>

namespace asperity
{
  /** How a height map becomes the tool of a scene, and what the tool is. */
  struct SurfaceChoice
  {
    TopographyParameters topography;

    /** What of it is chosen, with reasons; paths from the subsection
     *  Topography on, "Crop". */
    std::vector<CommentedEntry> entries;

    /** The choices in short, and what the user should know of the map. */
    std::vector<std::string> findings;
    std::vector<std::string> warnings;

    /** Of the finished profile: nesting index of the S-filter [m], period [m],
     *  peak-to-valley height [m], root mean square and largest slope. */
    double shortest_wave  = 0.;
    double period         = 0.;
    double peak_to_valley = 0.;
    double rms_slope      = 0.;
    double largest_slope  = 0.;
  };

  /**
   * Derives the treatment of a map from its pixels, noise, slopes, lay and
   * correlation:
   *
   * - points beyond eight robust standard deviations are spikes if they are
   *   rare; else they are the surface;
   * - the largest rectangle without holes if more than 1 % is missing;
   * - the degree of the form rises from the plane while that lowers Sq by more
   *   than 20 %;
   * - the S-filter is the first nesting index of ISO 25178-3 that is at least
   *   three pixels, leaves pixel noise at most a quarter of the root mean
   *   square slope, and no slope above 45 degrees in the profile;
   * - the profile runs across a lay (aspect ratio of the slopes below 0.6),
   *   along x else; it is eight autocorrelation lengths long, within 10 and 20
   *   times the S-filter, and 100 um if that is no less than 10 times;
   * - the L-filter takes out longer waves than the period if they hold more
   *   than 10 % of Sq^2;
   * - of all pieces of that length the one nearest to the medians of Rq and
   *   Rdq.
   *
   * @param given file, units and spacing; all other members are chosen
   * @throws InputError if the file cannot be read, is flat, or is too small or
   *   too coarse for a contact zone
   */
  SurfaceChoice
  choose_surface(const TopographyParameters &given);
} // namespace asperity

#endif
