#ifndef asperity_topography_treatment_warnings_h
#define asperity_topography_treatment_warnings_h

#include <asperity/topography/make_profile.h>

namespace asperity
{
  /** A map of the same size that has no heights, missing where a point stands
   *  out of its neighbours as errors of the instrument do. Empty if none does,
   *  or so many that they are the surface itself. */
  HeightMap
  mark_spikes(const HeightMap &map);

  /** Warns of spikes on the profile that nothing has removed, and of a trend
   *  that was removed from a profile whose ends fit better with it: a step that
   *  does not lie in the middle has one, too. */
  void
  warn_of_treatment(TopographyReport &report);
} // namespace asperity

#endif
