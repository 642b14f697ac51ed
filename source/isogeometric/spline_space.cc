#include <asperity/base/errors.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/space_transfer.h>
#include <asperity/isogeometric/spline_space.h>

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <string>

namespace asperity
{
  struct SplineSpace::Implementation
  {
    Implementation(const KnotVector &knots_x, const KnotVector &knots_y)
      : knots{{knots_x, knots_y}}
    {}

    std::array<KnotVector, 2>              knots;
    dealii::Triangulation<2>               triangulation;
    std::shared_ptr<const SplineHierarchy> hierarchy;

    /** Level and spans of an active cell, from its centre. */
    CellIndex
    index_of(const dealii::CellAccessor<2> &cell) const
    {
      // The centre is far from all breakpoints: rounding does no harm.
      const auto center = cell.center();
      CellIndex  index;
      index.level = cell.level();
      std::array<unsigned int, 2> spans;
      for (unsigned int d = 0; d < 2; ++d)
        {
          const auto        &breakpoints = knots[d].breakpoints();
          const unsigned int root        = knots[d].find_span(center[d]);
          const double       n_children  = 1u << index.level;
          spans[d] =
            root * (1u << index.level) +
            static_cast<unsigned int>(
              (center[d] - breakpoints[root]) /
              (breakpoints[root + 1] - breakpoints[root]) * n_children);
        }
      index.i = spans[0];
      index.j = spans[1];
      return index;
    }

    void
    rebuild()
    {
      std::vector<CellIndex> cells;
      cells.reserve(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        cells.push_back(index_of(*cell));
      hierarchy =
        std::make_shared<const SplineHierarchy>(knots[0], knots[1], cells);
    }

    /** Calls f(node) for the cells of the index's level, or the active ones
     *  that contain them, within `degree` spans. */
    template <typename Function>
    void
    for_each_neighbour(const CellIndex &index, const Function &f) const
    {
      const int degree = hierarchy->degree();
      const int n_x    = knots[0].n_spans() << index.level;
      const int n_y    = knots[1].n_spans() << index.level;
      for (int j = int(index.j) - degree; j <= int(index.j) + degree; ++j)
        for (int i = int(index.i) - degree; i <= int(index.i) + degree; ++i)
          {
            const int wrapped =
              knots[0].is_periodic() ? ((i % n_x) + n_x) % n_x : i;
            if (j >= 0 && j < n_y && wrapped >= 0 && wrapped < n_x)
              f(hierarchy->nodes()[hierarchy->find_node(
                {index.level, unsigned(wrapped), unsigned(j)})]);
          }
    }

    /** Adds to `refine` what the grading needs. */
    void
    grade_refinement(std::vector<bool> &refine) const
    {
      std::vector<unsigned int> pending;
      const auto               &nodes = hierarchy->nodes();
      for (unsigned int n = 0; n < nodes.size(); ++n)
        if (nodes[n].cell < 0 || refine[nodes[n].cell])
          pending.push_back(n);
      while (!pending.empty())
        {
          const CellIndex index = nodes[pending.back()].index;
          pending.pop_back();
          for_each_neighbour(index, [&](const SplineHierarchy::Node &node) {
            if (node.index.level < index.level && !refine[node.cell])
              {
                refine[node.cell] = true;
                pending.push_back(hierarchy->find_node(node.index));
              }
          });
        }
    }

    /** Removes from `coarsen` what the grading forbids: a child must stay if a
     *  cell within `degree` spans of it is or becomes refined. */
    void
    grade_coarsening(const std::vector<bool> &refine,
                     std::vector<bool>       &coarsen) const
    {
      for (const auto &node : hierarchy->nodes())
        if (node.cell >= 0 && coarsen[node.cell])
          {
            bool allowed = node.parent >= 0;
            if (allowed)
              for_each_neighbour(node.index,
                                 [&](const SplineHierarchy::Node &other) {
                                   if (other.cell < 0 || refine[other.cell])
                                     allowed = false;
                                 });
            // deal.II coarsens only families whose four flags are set.
            coarsen[node.cell] = allowed;
          }
    }
  };



  SplineSpace::SplineSpace(const KnotVector &knots_x, const KnotVector &knots_y)
    : implementation(std::make_unique<Implementation>(knots_x, knots_y))
  {
    if (knots_x.degree() != knots_y.degree())
      throw InputError("A spline space needs one degree in both directions, " +
                       std::to_string(knots_x.degree()) + " and " +
                       std::to_string(knots_y.degree()) + " were given.");
    if (knots_y.is_periodic())
      throw InputError(
        "A spline space may be periodic in the first parameter only.");
    std::vector<std::vector<double>> steps(2);
    for (unsigned int d = 0; d < 2; ++d)
      {
        const auto &t = implementation->knots[d].breakpoints();
        for (unsigned int span = 0; span + 1 < t.size(); ++span)
          steps[d].push_back(t[span + 1] - t[span]);
      }
    dealii::GridGenerator::subdivided_hyper_rectangle(
      implementation->triangulation,
      steps,
      dealii::Point<2>(knots_x.front(), knots_y.front()),
      dealii::Point<2>(knots_x.back(), knots_y.back()),
      /*colorize=*/true);
    implementation->rebuild();
  }



  SplineSpace::~SplineSpace() = default;



  unsigned int
  SplineSpace::degree() const
  {
    return implementation->hierarchy->degree();
  }



  bool
  SplineSpace::periodic_x() const
  {
    return implementation->hierarchy->periodic_x();
  }



  unsigned int
  SplineSpace::n_functions() const
  {
    return implementation->hierarchy->n_functions();
  }



  unsigned int
  SplineSpace::n_cells() const
  {
    return implementation->hierarchy->n_cells();
  }



  const dealii::Triangulation<2> &
  SplineSpace::triangulation() const
  {
    return implementation->triangulation;
  }



  dealii::Triangulation<2> &
  SplineSpace::triangulation()
  {
    return implementation->triangulation;
  }



  std::shared_ptr<const SplineHierarchy>
  SplineSpace::hierarchy() const
  {
    return implementation->hierarchy;
  }



  void
  SplineSpace::execute_refinement()
  {
    auto             &triangulation = implementation->triangulation;
    std::vector<bool> refine(n_cells(), false), coarsen(n_cells(), false);
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        refine[cell->active_cell_index()]  = cell->refine_flag_set();
        coarsen[cell->active_cell_index()] = cell->coarsen_flag_set();
      }
    implementation->grade_refinement(refine);
    implementation->grade_coarsening(refine, coarsen);
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        cell->clear_refine_flag();
        cell->clear_coarsen_flag();
        if (refine[cell->active_cell_index()])
          cell->set_refine_flag();
        else if (coarsen[cell->active_cell_index()])
          cell->set_coarsen_flag();
      }
    triangulation.execute_coarsening_and_refinement();
    implementation->rebuild();
  }



  bool
  SplineSpace::step_towards(
    const std::function<int(const unsigned int)> &missing_levels)
  {
    bool flagged = false;
    for (const auto &cell :
         implementation->triangulation.active_cell_iterators())
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



  void
  SplineSpace::refine_to_level(const unsigned int   level,
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



  void
  SplineSpace::refine_like(const SplineHierarchy &target)
  {
    // Each sweep settles at least one level, up or down.
    const unsigned int n_sweeps =
      target.n_levels() + implementation->hierarchy->n_levels() + 1;
    for (unsigned int sweep = 0; sweep < n_sweeps; ++sweep)
      if (!step_towards([&](const unsigned int cell) {
            const CellIndex &index = hierarchy()->cell_index(cell);
            const auto      &node  = target.nodes()[target.find_node(index)];
            return node.index.level < index.level ? -1 : node.cell < 0 ? 1 : 0;
          }))
        return;
    throw ComputationError(
      "The mesh could not be brought to the cells of another spline space, "
      "since that space is not graded.");
  }



  void
  SplineSpace::adapt(const CellLevel &wanted)
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



  const std::vector<unsigned int> &
  SplineSpace::cell_functions(const unsigned int cell) const
  {
    return implementation->hierarchy->cell_functions(cell);
  }



  const dealii::FullMatrix<double> &
  SplineSpace::cell_extraction(const unsigned int cell) const
  {
    return implementation->hierarchy->cell_extraction(cell);
  }



  std::pair<dealii::Point<2>, dealii::Point<2>>
  SplineSpace::cell_box(const unsigned int cell) const
  {
    return implementation->hierarchy->cell_box(cell);
  }



  unsigned int
  SplineSpace::find_cell(const dealii::Point<2> &parameter) const
  {
    return implementation->hierarchy->find_cell(parameter);
  }



  std::vector<unsigned int>
  SplineSpace::edge_cells(const Edge edge) const
  {
    return asperity::edge_cells(*implementation->hierarchy, edge);
  }



  std::vector<unsigned int>
  SplineSpace::edge_functions(const Edge edge) const
  {
    std::vector<unsigned int> functions;
    for (const unsigned int cell : edge_cells(edge))
      for (const unsigned int row :
           trace_rows(*implementation->hierarchy, cell, edge))
        functions.push_back(cell_functions(cell)[row]);
    std::sort(functions.begin(), functions.end());
    functions.erase(std::unique(functions.begin(), functions.end()),
                    functions.end());
    return functions;
  }



  void
  SplineSpace::evaluate(const unsigned int                 cell,
                        const dealii::Point<2>            &parameter,
                        std::vector<double>               &values,
                        std::vector<dealii::Tensor<1, 2>> *gradients) const
  {
    implementation->hierarchy->evaluate(cell, parameter, values, gradients);
  }
} // namespace asperity
