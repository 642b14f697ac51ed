#ifndef asperity_topography_make_profile_h
#define asperity_topography_make_profile_h

#include <asperity/topography/autocorrelation.h>
#include <asperity/topography/missing_data.h>
#include <asperity/topography/roughness.h>
#include <asperity/topography/sanity_report.h>
#include <asperity/topography/topography_parameters.h>

#include <string>
#include <vector>

namespace asperity
{
  /** Everything that happened between the file and the profile. */
  struct TopographyReport
  {
    SanityReport sanity;

    /** What was done, one sentence with its numbers for each step. */
    std::vector<std::string> steps;

    /** Beyond those of the sanity report. */
    std::vector<std::string> warnings;

    std::size_t n_spikes = 0;

    /** Zeros, missing where spikes were not searched for and may be; or empty.
     */
    HeightMap spikes;
    Window    window; // of the file that was used
    double    Sq_before_form = 0.;

    /** After form removal and filters. */
    HeightMap      map;
    ArealRoughness areal;
    ArealTexture   texture;

    /** The measured profile without missing ends and gaps, and its line. */
    Profile          measured;
    ProfileLine      line;
    std::size_t      n_trimmed = 0;
    std::size_t      n_filled  = 0;
    ProfileRoughness measured_roughness;

    /** The finished profile: scaled and periodic. */
    Profile            profile;
    ProfileRoughness   profile_roughness;
    ContinuationReport continuation; // before scaling
    double             scale_x = 1.;
    double             scale_z = 1.;
  };

  /**
   * Read the file, remove spikes, crop, remove the form and filter: the map of
   * which make_profile() takes its profile. The report is filled as far.
   *
   * @throw InputError if the file or one of the choices is not usable.
   */
  HeightMap
  treat_map(const TopographyParameters &parameters, TopographyReport &report);

  /**
   * Read the file, remove spikes, crop, remove the form, filter, take the
   * profile, fill its gaps, make it periodic and scale it.
   *
   * @throws InputError if the file or one of the choices is not usable.
   */
  Profile
  make_profile(const TopographyParameters &parameters,
               TopographyReport           &report);
} // namespace asperity

#endif
