// What ranks of a patch would do and send, counted for 1 to 64 parts of its
// mesh on one machine. Prints a table for each mesh.
//   partition_benchmark [spans of the finest level, 80]
//
// The mesh is that of a patch of 20 x 20 um: two levels below a contact face,
// degree 2, rows that grow downwards by 2.

#include <asperity/base/environment.h>
#include <asperity/base/mpi_session.h>
#include <asperity/contact_zone/scene.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "markdown_table.h"

namespace
{
  using namespace asperity;

  constexpr double       period = 20e-6, height = 10e-6, strip = 0.25e-6;
  constexpr unsigned int degree = 2, levels = 2;

  std::string
  text(const double value, const int digits = 3)
  {
    std::ostringstream out;
    out << std::setprecision(digits) << value;
    return out.str();
  }

  KnotVector
  columns(const unsigned int n)
  {
    std::vector<double> breaks(n + 1);
    for (unsigned int i = 0; i <= n; ++i)
      breaks[i] = period * i / n;
    return KnotVector(degree, breaks, true);
  }

  /** @param n spans of the finest level, a multiple of 2^levels */
  std::unique_ptr<SplineSpace<3>>
  patch(const unsigned int n)
  {
    const unsigned int coarse = n >> levels;
    MeshParameters     mesh;
    mesh.refinement = levels;
    mesh.strip      = strip;
    auto space      = std::make_unique<SplineSpace<3>>(
      columns(coarse),
      columns(coarse),
      KnotVector(degree, graded_rows(height, period / coarse, 2.)));
    for (unsigned int level = 1; level <= levels; ++level)
      space->refine_to_level(
        level, [&](const dealii::Point<3> &, const dealii::Point<3> &upper) {
          return is_in_strip(mesh, level, height - upper[2]);
        });
    return space;
  }

  /** Bytes that a part sends or receives when a distributed vector of three
   *  components is summed. */
  double
  bytes(const PartitionCounts &counts)
  {
    return 3. * sizeof(double) * counts.most_ghosts;
  }

  void
  count(const unsigned int n)
  {
    const auto            mesh    = patch(n);
    const SplineSpace<3> &space   = *mesh;
    const auto            weights = cell_weights(space, Edge::top, {1000, 600});
    std::cout << "\n"
              << n << " x " << n << " spans at the face, " << space.n_cells()
              << " cells, " << 3 * space.n_functions() << " unknowns\n\n";
    markdown_table::row("parts",
                        "cells of a part",
                        "largest work over the mean",
                        "functions of several parts",
                        "ghosts over functions",
                        "kB that a part exchanges");
    markdown_table::row("---", "---", "---", "---", "---", "---");
    for (unsigned int parts = 1; parts <= 64; parts *= 2)
      {
        const auto part   = partition_cells(space, weights, parts);
        const auto counts = count_partition(space, weights, part, parts);
        markdown_table::row(parts,
                            std::to_string(counts.least_cells) + " to " +
                              std::to_string(counts.most_cells),
                            text(counts.imbalance, 4),
                            text(100. * counts.shared_functions) + " %",
                            text(100. * counts.ghosts) + " %",
                            text(1e-3 * bytes(counts)));
      }
  }
} // namespace

int
main(int argc, char **argv)
{
  use_one_thread_per_rank();
  const MpiSession mpi(argc, argv);
  if (argc > 1)
    count(std::stoul(argv[1]));
  else
    for (const unsigned int n : {40, 80})
      count(n);
}
