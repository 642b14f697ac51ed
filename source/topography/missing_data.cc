#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/topography/form_removal.h>
#include <asperity/topography/missing_data.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    /** Median of the values, which are reordered; 0 if there are none. */
    double
    median(std::vector<double> &values)
    {
      if (values.empty())
        return 0.;
      const auto middle = values.begin() + values.size() / 2;
      std::nth_element(values.begin(), middle, values.end());
      if (values.size() % 2 == 1)
        return *middle;
      return 0.5 * (*middle + *std::max_element(values.begin(), middle));
    }

    /**
     * Median of the valid points around (column, row) without itself: on a
     * smooth slope the point would be its own median, and half of all
     * differences zero. A point without neighbours returns its own height.
     */
    double
    median_of_neighbours(const HeightMap     &map,
                         const int            column,
                         const int            row,
                         std::vector<double> &buffer)
    {
      constexpr int reach = 2;
      buffer.clear();
      for (int j = std::max(0, row - reach);
           j <= std::min<int>(map.ny - 1, row + reach);
           ++j)
        for (int i = std::max(0, column - reach);
             i <= std::min<int>(map.nx - 1, column + reach);
             ++i)
          if (!std::isnan(map(i, j)) && (i != column || j != row))
            buffer.push_back(map(i, j));
      return buffer.empty() ? map(column, row) : median(buffer);
    }
  } // namespace

  Window
  largest_window_without_holes(const HeightMap &map)
  {
    // The largest rectangle under a histogram, row by row: of each column the
    // number of valid points above, and a stack of columns with rising counts.
    Window                    best;
    std::size_t               best_area = 0;
    std::vector<unsigned int> count(map.nx + 1, 0);
    for (unsigned int j = 0; j < map.ny; ++j)
      {
        for (unsigned int i = 0; i < map.nx; ++i)
          count[i] = std::isnan(map(i, j)) ? 0 : count[i] + 1;
        std::vector<unsigned int> stack;
        for (unsigned int i = 0; i <= map.nx; ++i) // count[nx] stays zero
          {
            while (!stack.empty() && count[stack.back()] >= count[i])
              {
                const unsigned int height = count[stack.back()];
                stack.pop_back();
                const unsigned int begin = stack.empty() ? 0 : stack.back() + 1;
                const std::size_t  area  = std::size_t(height) * (i - begin);
                if (area > best_area)
                  {
                    best_area = area;
                    best      = {begin, j + 1 - height, i - begin, height};
                  }
              }
            stack.push_back(i);
          }
      }
    return best;
  }

  HeightMap
  crop(const HeightMap &map, const Window &window)
  {
    if (window.nx < 2 || window.ny < 1 || window.nx > map.nx ||
        window.ny > map.ny || window.column > map.nx - window.nx ||
        window.row > map.ny - window.ny)
      throw InputError(
        "The crop of " + quoted_name(map.provenance.file) + " to columns " +
        std::to_string(window.column) + " .. " +
        std::to_string(std::int64_t(window.column) + window.nx - 1) +
        " and rows " + std::to_string(window.row) + " .. " +
        std::to_string(std::int64_t(window.row) + window.ny - 1) +
        " is empty or leaves its " + std::to_string(map.nx) + " x " +
        std::to_string(map.ny) + " points.");
    HeightMap result;
    result.nx         = window.nx;
    result.ny         = window.ny;
    result.dx         = map.dx;
    result.dy         = map.dy;
    result.provenance = map.provenance;
    result.heights.reserve(std::size_t(window.nx) * window.ny);
    for (unsigned int j = 0; j < window.ny; ++j)
      for (unsigned int i = 0; i < window.nx; ++i)
        result.heights.push_back(map(window.column + i, window.row + j));
    return result;
  }

  std::size_t
  remove_spikes(HeightMap &map, const double threshold)
  {
    // Windows at the edges are one-sided, so that a tilt would stand out there.
    HeightMap level = map;
    remove_form(level, 1);
    std::vector<double> difference(map.heights.size(), 0.), absolute, buffer;
    for (unsigned int j = 0; j < map.ny; ++j)
      for (unsigned int i = 0; i < map.nx; ++i)
        if (!std::isnan(level(i, j)))
          {
            const double d =
              std::abs(level(i, j) - median_of_neighbours(level, i, j, buffer));
            difference[std::size_t(j) * map.nx + i] = d;
            absolute.push_back(d);
          }
    const double sigma = 1.4826 * median(absolute);
    std::size_t  n     = 0;
    for (std::size_t i = 0; i < map.heights.size(); ++i)
      if (difference[i] > threshold * sigma)
        {
          map.heights[i] = missing_height;
          ++n;
        }
    return n;
  }

  std::size_t
  fill_gaps(std::vector<double> &values)
  {
    const int   n        = values.size();
    int         previous = -1; // the last valid one
    std::size_t n_filled = 0;
    for (int i = 0; i <= n; ++i)
      {
        if (i < n && std::isnan(values[i]))
          continue;
        for (int k = previous + 1; k < i; ++k, ++n_filled)
          if (previous < 0 && i == n)
            throw InputError("The profile holds no valid height.");
          else if (previous < 0)
            values[k] = values[i];
          else if (i == n)
            values[k] = values[previous];
          else
            values[k] = values[previous] + (values[i] - values[previous]) *
                                             (k - previous) / (i - previous);
        previous = i;
      }
    return n_filled;
  }
} // namespace asperity
