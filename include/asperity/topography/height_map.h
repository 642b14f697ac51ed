#ifndef asperity_topography_height_map_h
#define asperity_topography_height_map_h

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * Where a height map comes from: what its sanity report tells the user.
   */
  struct Provenance
  {
    std::string file;
    std::string format;

    /** Instrument, creator, date, comment: whatever the file says of itself. */
    std::string description;

    /** Who says what a number means, e.g. "the format fixes metres". */
    std::string unit_source;

    /** False if neither file nor user gave units: the metres are a guess. */
    bool has_unit = true;

    /** One sentence for each oddity that the reader met and lived with. */
    std::vector<std::string> warnings;

    /** One sentence each on what of the file was no height and skipped. */
    std::vector<std::string> notes;
  };

  /**
   * A measured surface on a regular grid: heights z [m] over columns along x
   * and rows along y, in the order of the file (row 0 first). Samples stand at
   * (i dx, j dy); a map of nx samples counts as nx dx long, as instruments do.
   * A missing point is a NaN.
   */
  struct HeightMap
  {
    unsigned int nx = 0;
    unsigned int ny = 0;

    /** Sample spacing along a row and along a column [m]. */
    double dx = 0.;
    double dy = 0.;

    /** nx*ny heights [m], row-major, x fastest. */
    std::vector<double> heights;

    Provenance provenance;

    double
    operator()(const unsigned int column, const unsigned int row) const
    {
      return heights[static_cast<std::size_t>(row) * nx + column];
    }

    double &
    operator()(const unsigned int column, const unsigned int row)
    {
      return heights[static_cast<std::size_t>(row) * nx + column];
    }

    double
    length_x() const
    {
      return nx * dx;
    }

    double
    length_y() const
    {
      return ny * dy;
    }

    std::size_t
    n_valid() const
    {
      std::size_t n = 0;
      for (const double z : heights)
        n += !std::isnan(z);
      return n;
    }

    /** Missing points over all points, in [0, 1]. */
    double
    missing_fraction() const
    {
      return heights.empty() ? 0. : 1. - double(n_valid()) / heights.size();
    }
  };

  constexpr double missing_height = std::numeric_limits<double>::quiet_NaN();
} // namespace asperity

#endif
