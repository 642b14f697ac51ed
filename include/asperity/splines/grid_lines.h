#ifndef asperity_splines_grid_lines_h
#define asperity_splines_grid_lines_h

#include <cstddef>
#include <vector>

namespace asperity
{
  /**
   * Applies a map of lines to every row (direction 0) or column (direction 1)
   * of a grid with rows of n_x values. The images, all of one length, take the
   * place of the lines.
   * @param map takes and returns a vector of values
   */
  template <typename Map>
  std::vector<double>
  map_lines(const unsigned int         direction,
            const std::size_t          n_x,
            const std::vector<double> &grid,
            const Map                 &map)
  {
    const std::size_t   n_y     = grid.size() / n_x;
    const std::size_t   n_lines = (direction == 0 ? n_y : n_x);
    std::vector<double> line(direction == 0 ? n_x : n_y), result;
    for (std::size_t j = 0; j < n_lines; ++j)
      {
        for (std::size_t i = 0; i < line.size(); ++i)
          line[i] = grid[direction == 0 ? j * n_x + i : i * n_x + j];
        const std::vector<double> image = map(line);
        result.resize(n_lines * image.size());
        for (std::size_t i = 0; i < image.size(); ++i)
          result[direction == 0 ? j * image.size() + i : i * n_lines + j] =
            image[i];
      }
    return result;
  }
} // namespace asperity

#endif
