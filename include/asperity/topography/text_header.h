#ifndef asperity_topography_text_header_h
#define asperity_topography_text_header_h

#include <asperity/topography/file_content.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * What the lines before the numbers say, as Gwyddion ("# Width: 1.6 µm",
   * "# Height: 1.2 µm", "# Value units: m", also in German) and SPIP
   * ("# x-pixels = 256", "# x-length = 1000", in nanometres) write them.
   */
  struct TextHeader
  {
    /** Lengths of the map along x and y [m]. */
    std::optional<double> length_x;
    std::optional<double> length_y;

    /** Metres per unit of the heights. */
    std::optional<double> height_unit;

    std::optional<std::int64_t> nx;
    std::optional<std::int64_t> ny;

    /** The lines that say so, for messages. */
    std::vector<std::string> lines;

    /** Lines that name a length or unit which is none of length. */
    std::vector<std::string> not_understood;
  };

  /** @p lines without their comment signs. */
  TextHeader
  read_text_header(const std::vector<std::string> &lines);
} // namespace asperity

#endif
