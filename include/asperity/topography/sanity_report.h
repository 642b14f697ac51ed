#ifndef asperity_topography_sanity_report_h
#define asperity_topography_sanity_report_h

#include <asperity/topography/height_map.h>

#include <string>
#include <vector>

namespace asperity
{
  /**
   * What a user should know of a file before trusting a number from it.
   * Lengths in metres.
   */
  struct SanityReport
  {
    std::string  file;
    std::string  format;
    std::string  description;
    std::string  unit_source;
    unsigned int nx               = 0;
    unsigned int ny               = 0;
    double       dx               = 0.;
    double       dy               = 0.;
    double       length_x         = 0.;
    double       length_y         = 0.;
    double       minimum          = 0.;
    double       maximum          = 0.;
    double       missing_fraction = 0.;

    /** One sentence each; those of the reader come first. */
    std::vector<std::string> warnings;
  };

  /** Look at the map as read, before anything is done to it. */
  SanityReport
  check_sanity(const HeightMap &map);
} // namespace asperity

#endif
