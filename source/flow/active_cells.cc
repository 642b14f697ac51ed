#include <asperity/base/errors.h>
#include <asperity/flow/fluid_space.h>

#include <boost/pending/disjoint_sets.hpp>

#include <map>

// Which cells of a FluidSpace are on, and what hangs together.
namespace asperity
{
  void
  FluidSpace::set_active(const std::vector<bool> &active)
  {
    const unsigned int n_cells = dofs_.get_triangulation().n_active_cells();
    if (active.size() != n_cells)
      throw InputError("A flow has " + std::to_string(n_cells) +
                       " cells that can be on or off, found " +
                       std::to_string(active.size()) + " values.");
    active_ = active;
    cells_.clear();
    for (const Cell &cell : dofs_.active_cell_iterators())
      if (active[cell->active_cell_index()])
        cells_.push_back(cell);
    mark_unknowns();
    find_parts();
  }



  void
  FluidSpace::mark_unknowns()
  {
    in_active.assign(dofs_.n_dofs(), false);
    in_inactive.assign(dofs_.n_dofs(), false);
    std::vector<dealii::types::global_dof_index> cell_dofs(
      fe.n_dofs_per_cell());
    for (const Cell &cell : dofs_.active_cell_iterators())
      {
        cell->get_dof_indices(cell_dofs);
        for (const auto i : cell_dofs)
          (active_[cell->active_cell_index()] ? in_active : in_inactive)[i] =
            true;
      }
    // What constrains an unknown is where that is. An image by periodicity is
    // wherever the other one is, too; a hanging node need not be.
    for (auto *marks : {&in_active, &in_inactive})
      {
        for (const auto &line : topology_.get_lines())
          if ((*marks)[line.index])
            for (const auto &entry : line.entries)
              (*marks)[entry.first] = true;
        for (const auto &line : topology_.get_lines())
          if (line.entries.size() == 1)
            (*marks)[line.index] = (*marks)[line.entries.front().first];
      }
  }



  void
  FluidSpace::find_parts()
  {
    const unsigned int                           n = dofs_.n_dofs();
    boost::disjoint_sets_with_storage<>          sets(n);
    std::vector<dealii::types::global_dof_index> cell_dofs(
      fe.n_dofs_per_cell());
    const unsigned int first = fe.component_to_system_index(2, 0);
    for (const Cell &cell : cells_)
      {
        cell->get_dof_indices(cell_dofs);
        for (unsigned int k = 0; k < cell_dofs.size(); ++k)
          if (fe.system_to_component_index(k).first == 2)
            sets.union_set(cell_dofs[first], cell_dofs[k]);
      }
    for (const auto &line : topology_.get_lines())
      if (line.index >= n_velocity && in_active[line.index])
        for (const auto &entry : line.entries)
          sets.union_set(line.index, entry.first);
    std::map<unsigned int, unsigned int> part; // representative -> number
    parts_.clear();
    for (unsigned int i = n_velocity; i < n; ++i)
      if (in_active[i])
        {
          const unsigned int number =
            part.emplace(sets.find_set(i), part.size()).first->second;
          parts_.resize(part.size());
          parts_[number].push_back(i);
        }
    part_of_cell_.assign(active_.size(), dealii::numbers::invalid_unsigned_int);
    for (const Cell &cell : cells_)
      {
        cell->get_dof_indices(cell_dofs);
        part_of_cell_[cell->active_cell_index()] =
          part.at(sets.find_set(cell_dofs[first]));
      }
  }



  const std::vector<bool> &
  FluidSpace::active() const
  {
    return active_;
  }



  const std::vector<FluidSpace::Cell> &
  FluidSpace::cells() const
  {
    return cells_;
  }



  bool
  FluidSpace::is_idle(const unsigned int unknown) const
  {
    return !in_active[unknown];
  }



  std::vector<unsigned int>
  FluidSpace::idle_dofs() const
  {
    std::vector<unsigned int> idle;
    for (unsigned int i = 0; i < in_active.size(); ++i)
      if (!in_active[i] && !topology_.is_constrained(i))
        idle.push_back(i);
    return idle;
  }



  bool
  FluidSpace::is_on_inner_wall(const unsigned int unknown) const
  {
    return in_active[unknown] && in_inactive[unknown];
  }



  const std::vector<std::vector<unsigned int>> &
  FluidSpace::parts() const
  {
    return parts_;
  }



  unsigned int
  FluidSpace::part_of_cell(const unsigned int cell) const
  {
    return part_of_cell_[cell];
  }
} // namespace asperity
