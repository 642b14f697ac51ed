#ifndef asperity_topography_commands_h
#define asperity_topography_commands_h

#include <string>

namespace asperity
{
  /**
   * The command `asperity topography FILE`: print what is known of the surface
   * and of each step to the profile, and write report.json, the processed
   * surface (surface.x3p), profile.csv, measured_profile.csv and a picture
   * (topography.svg).
   *
   * FILE is a parameter file, which names the output directory, or a height map
   * of any format that read_height_map() knows, recognised by its content. For
   * a map all entries have their defaults (Crop is hole-free if a tenth of its
   * points is missing), and the files are written into
   * output/topography/ and the name of the map without its extension.
   *
   * @return the exit status 0
   * @throws InputError as make_profile(), or if a file cannot be written
   */
  int
  topography_report(const std::string &file);
} // namespace asperity

#endif
