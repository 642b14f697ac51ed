#ifndef asperity_topography_commands_h
#define asperity_topography_commands_h

#include <string>

namespace asperity
{
  /**
   * The command `asperity topography FILE.prm`: print what is known of the
   * surface and of each step to the profile, and write report.json, the
   * processed surface (surface.x3p), profile.csv, measured_profile.csv and a
   * picture (topography.svg) into the output directory.
   *
   * Returns the exit status 0; @throw InputError as make_profile().
   */
  int
  topography_report(const std::string &prm_file);
} // namespace asperity

#endif
