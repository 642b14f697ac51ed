#ifndef asperity_lubricant_void_regions_h
#define asperity_lubricant_void_regions_h

#include <deal.II/base/types.h>

#include <array>
#include <vector>

namespace asperity
{
  /** The regions of the void between a patch and its tool: each element of the
   *  contact face belongs to one. */
  struct VoidRegions
  {
    static constexpr unsigned int none = dealii::numbers::invalid_unsigned_int;

    unsigned int n = 0;

    /** Of each element; `none` if everything is sealed. */
    std::vector<unsigned int> region;

    /** Whether the gap exceeds the sealing gap at a corner of the element,
     *  1 or 0. */
    std::vector<char> open;

    /** Whether a region goes through the period along x and y, so that its oil
     *  could leave a patch that had ends. */
    std::vector<std::array<bool, 2>> through;
  };

  /**
   * Divides the void into regions: connected sets of elements of a periodic
   * grid between which the gap exceeds the sealing gap. Elements that touch a
   * node with a larger gap are open, and all of the same region. Sealed
   * elements join the region that they reach over the widest gaps (a maximal
   * spanning forest, by Kruskal's method), so that regions meet where the seal
   * between them is tightest, as the intervals of find_pockets() do. A region
   * goes through where a way on which the surfaces are open leads from an
   * element to its image in another period.
   *
   * @param size elements along x and y; element (i, j) has the number
   *   i + j n_x, and begins at the node of its number
   * @param gaps at the nodes [m]
   * @return regions in the order of their first elements
   */
  VoidRegions
  find_regions(const std::array<unsigned int, 2> &size,
               const std::vector<double>         &gaps,
               const double                       sealing_gap);
} // namespace asperity

#endif
