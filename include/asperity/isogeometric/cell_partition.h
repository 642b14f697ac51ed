#ifndef asperity_isogeometric_cell_partition_h
#define asperity_isogeometric_cell_partition_h

#include <asperity/base/ranks.h>
#include <asperity/isogeometric/spline_space.h>

#include <cstddef>
#include <vector>

namespace asperity
{
  /** The ranks of a scene, and which of them integrates a cell. */
  struct CellShare
  {
    Ranks                     ranks;
    std::vector<unsigned int> owner; ///< rank of each cell; empty: one has all

    bool
    is_own(const unsigned int cell) const
    {
      return owner.empty() || owner[cell] == ranks.rank();
    }
  };

  /** What the work on a cell costs, in units of a thousandth of a cell without
   *  contact, as METIS counts it. */
  struct CellWork
  {
    /** Of a cell with (degree + 1)^dim functions; others cost as the square of
     *  their number. */
    unsigned int volume = 1000;
    unsigned int face   = 0; ///< more, of a cell with a face in contact
  };

  /** Weight of each cell. @param edge whose cells are in contact */
  template <int dim>
  std::vector<unsigned int>
  cell_weights(const SplineSpace<dim> &space,
               const Edge              edge,
               const CellWork         &work);

  /**
   * Divides cells into parts of nearly equal weight that share few functions:
   * METIS on the graph that joins all cells with a common function. Splines
   * reach over several cells, so that joining neighbours by faces only would
   * count too little.
   * @return the part of each cell, 0 to n_parts - 1
   */
  template <int dim>
  std::vector<unsigned int>
  partition_cells(const SplineSpace<dim>          &space,
                  const std::vector<unsigned int> &weights,
                  const unsigned int               n_parts);

  /** The part to which a function belongs: that of the cell which holds most
   *  of it. */
  template <int dim>
  std::vector<unsigned int>
  function_owners(const SplineSpace<dim>          &space,
                  const std::vector<unsigned int> &part_of_cell);

  /** What a partition costs. */
  struct PartitionCounts
  {
    std::size_t least_cells = 0, most_cells = 0; ///< of a part

    /** Largest weight of a part over the mean: the time of a step over that of
     *  perfect balance. */
    double imbalance = 1.;

    /** Functions that cells of more than one part need, over all. */
    double shared_functions = 0.;

    /** Functions that the cells of a part need and that belong to another,
     *  summed over the parts, over all functions. */
    double ghosts = 0.;

    /** The most ghosts that one part has: what it sends or receives when a
     *  distributed vector is summed. */
    std::size_t most_ghosts = 0;
  };

  template <int dim>
  PartitionCounts
  count_partition(const SplineSpace<dim>          &space,
                  const std::vector<unsigned int> &weights,
                  const std::vector<unsigned int> &part_of_cell,
                  const unsigned int               n_parts);
} // namespace asperity

#endif
