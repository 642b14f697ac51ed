#ifndef asperity_topography_read_height_map_h
#define asperity_topography_read_height_map_h

#include <asperity/topography/height_map.h>

#include <string>

namespace asperity
{
  /**
   * What the user says about a file that does not say it itself.
   */
  struct ReadOptions
  {
    /**
     * Metres per unit of the lateral coordinates and of the heights; zero
     * means that the file has to tell. A value overrules a file that carries
     * no unit, never one that does.
     */
    double lateral_unit = 0.;
    double height_unit  = 0.;

    /** Spacing [m] of the samples of a text matrix, which has none. */
    double spacing_x = 0.;
    double spacing_y = 0.;
  };

  /**
   * Read @p file. The format is recognised by the content, never by the name:
   * X3P (ISO 25178-72), SDF (ISO 25178-71, ASCII and binary), SUR (Digital
   * Surf, plain and compressed), AL3D (Alicona), PLUX (Sensofar), GSF
   * (Gwyddion) and text (matrix, or columns x z or x y z).
   *
   * A file that carries no unit is read as metres with a warning if its format
   * is binary, and refused if it is text without a unit from @p options.
   * Infinite heights and those beyond 1 km become missing points, with a
   * warning.
   *
   * @throws InputError one sentence if the file is missing, empty, cut off,
   *   of no known format, or of a kind that a height map cannot represent, or
   *   if its header and its data disagree.
   */
  HeightMap
  read_height_map(const std::string &file, const ReadOptions &options = {});

  /**
   * Write @p map as X3P: heights as float64, missing points as NaN.
   *
   * @throws InputError if the file cannot be written.
   */
  void
  write_x3p(const HeightMap &map, const std::string &file);
} // namespace asperity

#endif
