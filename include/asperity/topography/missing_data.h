#ifndef asperity_topography_missing_data_h
#define asperity_topography_missing_data_h

#include <asperity/topography/height_map.h>

#include <vector>

namespace asperity
{
  /** Columns [column, column+nx) and rows [row, row+ny) of a map. */
  struct Window
  {
    unsigned int column = 0;
    unsigned int row    = 0;
    unsigned int nx     = 0;
    unsigned int ny     = 0;
  };

  /** The rectangle with the most points in which no point is missing. */
  Window
  largest_window_without_holes(const HeightMap &map);

  /** @throws InputError if the window is empty or leaves the map. */
  HeightMap
  crop(const HeightMap &map, const Window &window);

  /** Robust standard deviations beyond which points are taken for errors of the
   *  instrument, if they are no larger part of the surface than this. */
  constexpr double usual_spike_threshold  = 8.;
  constexpr double largest_spike_fraction = 0.002;

  /** Points that a search for spikes needs. */
  constexpr std::size_t smallest_map_with_spikes = 100;

  /**
   * Declare spikes missing: points that (after removal of a plane) differ from
   * the median of their up to 24 neighbours by more than @p threshold times the
   * robust standard deviation (1.4826 times the median of the absolute
   * differences) of the whole map. Returns how many.
   *
   * @throws InputError if the valid points do not determine a plane.
   */
  std::size_t
  remove_spikes(HeightMap &map, const double threshold);

  /**
   * Fill missing values by straight lines between their neighbours, ends with
   * the nearest value. Returns how many were filled.
   *
   * @throws InputError if no value is valid.
   */
  std::size_t
  fill_gaps(std::vector<double> &values);
} // namespace asperity

#endif
