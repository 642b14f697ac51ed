#include <asperity/isogeometric/cell_partition.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "example_spaces.h"

using namespace asperity;

namespace
{
  KnotVector
  open_knots(const unsigned int degree, const unsigned int n)
  {
    std::vector<double> breaks(n + 1);
    std::iota(breaks.begin(), breaks.end(), 0.);
    return KnotVector(degree, breaks);
  }

  /** 8 x 6 x 4 unit cells. */
  SplineSpace<3>
  block(const unsigned int degree)
  {
    return SplineSpace<3>(open_knots(degree, 8),
                          open_knots(degree, 6),
                          open_knots(degree, 4));
  }
} // namespace



// Functions of degree p that cross a plane of knots: p times those along it.
TEST(CellPartition, counts_what_a_plane_cuts)
{
  for (const unsigned int p : {1u, 2u, 3u})
    {
      const SplineSpace<3>      space = block(p);
      std::vector<unsigned int> part(space.n_cells());
      for (unsigned int cell = 0; cell < part.size(); ++cell)
        part[cell] = space.cell_box(cell).first[0] < 2. ? 0 : 1;
      const std::vector<unsigned int> weights(space.n_cells(), 1);
      const PartitionCounts counts = count_partition(space, weights, part, 2);
      EXPECT_EQ(counts.least_cells, 2u * 6 * 4);
      EXPECT_EQ(counts.most_cells, 6u * 6 * 4);
      EXPECT_DOUBLE_EQ(counts.imbalance, 6. / 4.);
      const double cut = p * (6. + p) * (4. + p) / space.n_functions();
      EXPECT_DOUBLE_EQ(counts.shared_functions, cut);
      EXPECT_DOUBLE_EQ(counts.ghosts, cut);
    }
}



TEST(CellPartition, balances_weights_of_cells)
{
  const SplineSpace<3> space = block(2);
  const auto weights = cell_weights(space, Edge::top, CellWork{1000, 3000});
  EXPECT_EQ(std::accumulate(weights.begin(), weights.end(), 0u),
            8u * 6 * (3 * 1000 + 4000));
  for (const unsigned int n_parts : {1u, 2u, 4u})
    {
      const auto part = partition_cells(space, weights, n_parts);
      ASSERT_EQ(part.size(), space.n_cells());
      EXPECT_LT(*std::max_element(part.begin(), part.end()), n_parts);
      EXPECT_LT(count_partition(space, weights, part, n_parts).imbalance, 1.1);
    }
}



// Finer cells below the top: each function has an owner that needs it.
TEST(CellPartition, gives_each_function_to_a_part_that_needs_it)
{
  const auto                      space = example::graded(2, true);
  const std::vector<unsigned int> weights(space->n_cells(), 1);
  const auto                      part  = partition_cells(*space, weights, 3);
  const auto                      owner = function_owners(*space, part);
  std::vector<bool>               is_needed(space->n_functions(), false);
  for (unsigned int cell = 0; cell < space->n_cells(); ++cell)
    for (const unsigned int a : space->cell_functions(cell))
      if (part[cell] == owner[a])
        is_needed[a] = true;
  EXPECT_TRUE(std::all_of(is_needed.begin(), is_needed.end(), [](const bool b) {
    return b;
  }));
}
