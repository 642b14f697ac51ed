#ifndef asperity_topography_report_output_h
#define asperity_topography_report_output_h

#include <asperity/topography/make_profile.h>

#include <iosfwd>
#include <string>

namespace asperity
{
  /** The report as a table for people. */
  void
  print_report(const TopographyReport &report, std::ostream &out);

  /** The report as JSON text, all lengths in metres. */
  std::string
  report_json(const TopographyReport &report);

  /**
   * A picture: the processed map with the line of the profile, the measured
   * and the finished profile, and the roughness numbers (SVG, self-contained).
   */
  std::string
  report_svg(const TopographyReport &report);

  /** Lines "x z" in metres as CSV, with a header that names the surface. */
  std::string
  profile_csv(const Profile &profile, const std::string &title);
} // namespace asperity

#endif
