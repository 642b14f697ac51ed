#ifndef asperity_topography_text_list_h
#define asperity_topography_text_list_h

#include <asperity/topography/text_table.h>

#include <optional>

namespace asperity
{
  /** Points "x z" or "x y z" on a regular grid, one a row of a table. */
  struct PointList
  {
    /** Of the grid; ny = 1 for a profile. */
    std::size_t nx = 0;
    std::size_t ny = 0;

    /** Spacing in the unit of the coordinates. */
    double dx = 0.;
    double dy = 0.;

    /** Of each row of the table, x fastest. */
    std::vector<std::size_t> place;

    /** Column of the heights; those behind it are not read. */
    std::size_t height_column = 0;
  };

  /**
   * The table as a list of points, or nothing if it is a matrix of heights.
   *
   * A list of two columns has equally spaced x in order. One of three and more
   * columns has x and y that span a regular grid, each point at most once, and
   * fills more than a twentieth of it (half of it where points are few or
   * further columns follow).
   * A profile along y is turned to x.
   *
   * @throws InputError if the table is as long and narrow as a list of two to
   *   four columns and is none of these: as a matrix its coordinates would
   *   become heights.
   */
  std::optional<PointList>
  find_point_list(const FileContent &file, const TextTable &table);
} // namespace asperity

#endif
