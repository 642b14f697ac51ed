#include <asperity/base/errors.h>
#include <asperity/isogeometric/space_transfer.h>
#include <asperity/isogeometric/spline_space.h>

namespace asperity
{
  template <int dim>
  bool
  SplineSpace<dim>::step_towards(
    const std::function<int(const unsigned int)> &missing_levels)
  {
    bool flagged = false;
    for (const auto &cell : triangulation().active_cell_iterators())
      {
        const int change = missing_levels(cell->active_cell_index());
        if (change > 0)
          cell->set_refine_flag();
        else if (change < 0 && cell->level() > 0)
          cell->set_coarsen_flag();
        flagged = flagged || change != 0;
      }
    if (flagged)
      execute_refinement();
    return flagged;
  }



  template <int dim>
  void
  SplineSpace<dim>::refine_to_level(const unsigned int   level,
                                    const CellCondition &wanted)
  {
    bool goes_on = true;
    for (unsigned int sweep = 0; sweep < level && goes_on; ++sweep)
      goes_on = step_towards([&](const unsigned int cell) {
        const auto box = cell_box(cell);
        return hierarchy()->cell_index(cell).level < level &&
                   wanted(box.first, box.second) ?
                 1 :
                 0;
      });
  }



  template <int dim>
  void
  SplineSpace<dim>::refine_like(const SplineHierarchy<dim> &target)
  {
    // Each sweep settles at least one level, up or down.
    const unsigned int n_sweeps =
      target.n_levels() + hierarchy()->n_levels() + 1;
    for (unsigned int sweep = 0; sweep < n_sweeps; ++sweep)
      if (!step_towards([&](const unsigned int cell) {
            const CellIndex<dim> &index = hierarchy()->cell_index(cell);
            const auto &node = target.nodes()[target.find_node(index)];
            return node.index.level < index.level ? -1 : node.cell < 0 ? 1 : 0;
          }))
        return;
    throw ComputationError(
      "The mesh could not be brought to the cells of another spline space, "
      "since that space is not graded.");
  }



  template <int dim>
  void
  SplineSpace<dim>::adapt(const CellLevel &wanted)
  {
    // Where the grading refuses to coarsen, sweeps change nothing at last.
    for (;;)
      {
        const auto before = hierarchy();
        if (!step_towards([&](const unsigned int cell) {
              const auto box = cell_box(cell);
              return static_cast<int>(wanted(box.first, box.second)) -
                     static_cast<int>(hierarchy()->cell_index(cell).level);
            }) ||
            (before->n_cells() == hierarchy()->n_cells() &&
             is_refinement(*before, *hierarchy())))
          return;
      }
  }



  template void
  SplineSpace<2>::refine_to_level(const unsigned int, const CellCondition &);
  template void
  SplineSpace<3>::refine_to_level(const unsigned int, const CellCondition &);
  template void
  SplineSpace<2>::adapt(const CellLevel &);
  template void
  SplineSpace<3>::adapt(const CellLevel &);
  template void
  SplineSpace<2>::refine_like(const SplineHierarchy<2> &);
  template void
  SplineSpace<3>::refine_like(const SplineHierarchy<3> &);
} // namespace asperity
