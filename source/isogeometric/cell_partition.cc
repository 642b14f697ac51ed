#include <asperity/isogeometric/cell_partition.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  template <int dim>
  std::vector<unsigned int>
  cell_weights(const SplineSpace<dim> &space,
               const Edge              edge,
               const CellWork         &work)
  {
    std::vector<unsigned int> weights(space.n_cells());
    const double              usual = std::pow(space.degree() + 1., dim);
    for (unsigned int cell = 0; cell < weights.size(); ++cell)
      {
        const double n = space.cell_functions(cell).size() / usual;
        weights[cell]  = std::lround(work.volume * n * n);
      }
    for (const unsigned int cell : space.edge_cells(edge))
      weights[cell] += work.face;
    return weights;
  }



  namespace
  {
    /** Cells of each function. */
    template <int dim>
    std::vector<std::vector<unsigned int>>
    cells_of_functions(const SplineSpace<dim> &space)
    {
      std::vector<std::vector<unsigned int>> cells(space.n_functions());
      for (unsigned int cell = 0; cell < space.n_cells(); ++cell)
        for (const unsigned int a : space.cell_functions(cell))
          cells[a].push_back(cell);
      return cells;
    }
  } // namespace



  template <int dim>
  std::vector<unsigned int>
  partition_cells(const SplineSpace<dim>          &space,
                  const std::vector<unsigned int> &weights,
                  const unsigned int               n_parts)
  {
    std::vector<unsigned int> parts(space.n_cells(), 0);
    if (n_parts < 2)
      return parts;
    const auto                     cells = cells_of_functions(space);
    dealii::DynamicSparsityPattern graph(space.n_cells());
    for (unsigned int cell = 0; cell < space.n_cells(); ++cell)
      for (const unsigned int a : space.cell_functions(cell))
        graph.add_entries(cell, cells[a].begin(), cells[a].end(), true);
    dealii::SparsityPattern compressed;
    compressed.copy_from(graph);
    dealii::SparsityTools::partition(compressed, weights, n_parts, parts);
    return parts;
  }



  template <int dim>
  std::vector<unsigned int>
  function_owners(const SplineSpace<dim>          &space,
                  const std::vector<unsigned int> &part_of_cell)
  {
    const auto                hierarchy = space.hierarchy();
    std::vector<unsigned int> owners(space.n_functions());
    for (unsigned int a = 0; a < owners.size(); ++a)
      owners[a] = part_of_cell[hierarchy->function_home(a).first];
    return owners;
  }



  template <int dim>
  PartitionCounts
  count_partition(const SplineSpace<dim>          &space,
                  const std::vector<unsigned int> &weights,
                  const std::vector<unsigned int> &part_of_cell,
                  const unsigned int               n_parts)
  {
    std::vector<std::size_t> n_cells(n_parts), ghosts(n_parts);
    std::vector<double>      weight(n_parts);
    double                   total = 0.;
    for (unsigned int cell = 0; cell < part_of_cell.size(); ++cell)
      {
        ++n_cells[part_of_cell[cell]];
        weight[part_of_cell[cell]] += weights[cell];
        total += weights[cell];
      }
    const auto      owners   = function_owners(space, part_of_cell);
    std::size_t     n_shared = 0, n_ghosts = 0;
    PartitionCounts counts;
    unsigned int    function = 0;
    for (const auto &cells : cells_of_functions(space))
      {
        std::vector<unsigned int> parts = {owners[function++]};
        for (const unsigned int cell : cells)
          parts.push_back(part_of_cell[cell]);
        std::sort(parts.begin() + 1, parts.end());
        parts.erase(std::unique(parts.begin() + 1, parts.end()), parts.end());
        for (std::size_t i = 1; i < parts.size(); ++i)
          if (parts[i] != parts[0])
            {
              ++ghosts[parts[i]];
              ++n_ghosts;
            }
        if (parts.size() > 2)
          ++n_shared;
      }
    const auto [least, most] =
      std::minmax_element(n_cells.begin(), n_cells.end());
    counts.least_cells = *least;
    counts.most_cells  = *most;
    counts.imbalance =
      *std::max_element(weight.begin(), weight.end()) * n_parts / total;
    counts.shared_functions = double(n_shared) / space.n_functions();
    counts.ghosts           = double(n_ghosts) / space.n_functions();
    counts.most_ghosts      = *std::max_element(ghosts.begin(), ghosts.end());
    return counts;
  }



  template std::vector<unsigned int>
  cell_weights(const SplineSpace<2> &, const Edge, const CellWork &);
  template std::vector<unsigned int>
  cell_weights(const SplineSpace<3> &, const Edge, const CellWork &);
  template std::vector<unsigned int>
  partition_cells(const SplineSpace<2> &,
                  const std::vector<unsigned int> &,
                  const unsigned int);
  template std::vector<unsigned int>
  partition_cells(const SplineSpace<3> &,
                  const std::vector<unsigned int> &,
                  const unsigned int);
  template std::vector<unsigned int>
  function_owners(const SplineSpace<2> &, const std::vector<unsigned int> &);
  template std::vector<unsigned int>
  function_owners(const SplineSpace<3> &, const std::vector<unsigned int> &);
  template PartitionCounts
  count_partition(const SplineSpace<2> &,
                  const std::vector<unsigned int> &,
                  const std::vector<unsigned int> &,
                  const unsigned int);
  template PartitionCounts
  count_partition(const SplineSpace<3> &,
                  const std::vector<unsigned int> &,
                  const std::vector<unsigned int> &,
                  const unsigned int);
} // namespace asperity
