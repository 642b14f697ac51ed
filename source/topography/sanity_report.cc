#include <asperity/topography/sanity_report.h>

#include <algorithm>
#include <cstdio>

namespace asperity
{
  namespace
  {
    std::string
    scientific(const double value)
    {
      char text[32];
      std::snprintf(text, sizeof(text), "%.2g", value);
      return text;
    }

    void
    check_proportions(const HeightMap &map, SanityReport &report)
    {
      const double aspect = (report.maximum - report.minimum) /
                            std::max(report.length_x, report.length_y);
      if (report.maximum == report.minimum)
        report.warnings.push_back("All heights are equal: this is no measured "
                                  "surface.");
      else if (aspect < 1e-6 || aspect > 1.)
        report.warnings.push_back(
          "The range of heights over the length of the map is " +
          scientific(aspect) +
          ", outside 1e-6 to 1: check the units of heights and spacing.");
      // Scans of a contact are micrometres to millimetres wide.
      const double spacing = std::max(map.dx, map.dy);
      if (spacing > 1e-3 || spacing < 1e-10)
        report.warnings.push_back("Samples " + scientific(spacing) +
                                  " m apart are unusual for a microscope: "
                                  "check the lateral unit.");
      if (map.ny > 1 && std::abs(map.dx - map.dy) > 1e-3 * spacing)
        report.warnings.push_back("The spacing differs between x (" +
                                  scientific(map.dx) + " m) and y (" +
                                  scientific(map.dy) + " m).");
    }
  } // namespace

  SanityReport
  check_sanity(const HeightMap &map)
  {
    SanityReport report;
    report.file             = map.provenance.file;
    report.format           = map.provenance.format;
    report.description      = map.provenance.description;
    report.unit_source      = map.provenance.unit_source;
    report.nx               = map.nx;
    report.ny               = map.ny;
    report.dx               = map.dx;
    report.dy               = map.dy;
    report.length_x         = map.length_x();
    report.length_y         = map.length_y();
    report.missing_fraction = map.missing_fraction();
    report.warnings         = map.provenance.warnings;

    report.minimum = std::numeric_limits<double>::infinity();
    report.maximum = -report.minimum;
    for (const double z : map.heights)
      if (!std::isnan(z))
        {
          report.minimum = std::min(report.minimum, z);
          report.maximum = std::max(report.maximum, z);
        }
    check_proportions(map, report);
    if (map.ny == 1)
      report.warnings.push_back("The file holds a single profile: areal "
                                "parameters do not apply.");
    return report;
  }
} // namespace asperity
