#include <asperity/base/errors.h>
#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/spline_space.h>

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <string>

namespace asperity
{
  template <int dim>
  struct SplineSpace<dim>::Implementation
  {
    explicit Implementation(const std::array<KnotVector, dim> &knots)
      : knots(knots)
    {}

    const std::array<KnotVector, dim>           knots;
    dealii::Triangulation<dim>                  triangulation;
    std::shared_ptr<const SplineHierarchy<dim>> hierarchy;

    /** Level and spans of an active cell, from its centre. */
    CellIndex<dim>
    index_of(const dealii::CellAccessor<dim> &cell) const
    {
      // The centre is far from all breakpoints: rounding does no harm.
      const auto     center = cell.center();
      CellIndex<dim> index;
      index.level = cell.level();
      for (unsigned int d = 0; d < dim; ++d)
        {
          const auto        &breakpoints = knots[d].breakpoints();
          const unsigned int root        = knots[d].find_span(center[d]);
          const double       n_children  = 1u << index.level;
          index.spans[d] =
            root * (1u << index.level) +
            static_cast<unsigned int>(
              (center[d] - breakpoints[root]) /
              (breakpoints[root + 1] - breakpoints[root]) * n_children);
        }
      return index;
    }

    void
    rebuild()
    {
      std::vector<CellIndex<dim>> cells;
      cells.reserve(triangulation.n_active_cells());
      for (const auto &cell : triangulation.active_cell_iterators())
        cells.push_back(index_of(*cell));
      hierarchy = std::make_shared<const SplineHierarchy<dim>>(knots, cells);
    }

    /** Calls f(node) for the cells of the index's level, or the active ones
     *  that contain them, within `degree` spans. */
    template <typename Function>
    void
    for_each_neighbour(const CellIndex<dim> &index, const Function &f) const
    {
      const int          degree = hierarchy->degree();
      const unsigned int width  = 2 * degree + 1;
      for (unsigned int n = 0; n < tensor_size<dim>(width); ++n)
        {
          const auto     steps     = tensor_index<dim>(n, width);
          CellIndex<dim> neighbour = index;
          bool           exists    = true;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const int n_spans = knots[d].n_spans() << index.level;
              int       span    = int(index.spans[d]) + int(steps[d]) - degree;
              if (knots[d].is_periodic())
                span = ((span % n_spans) + n_spans) % n_spans;
              exists             = exists && span >= 0 && span < n_spans;
              neighbour.spans[d] = span;
            }
          if (exists)
            f(hierarchy->nodes()[hierarchy->find_node(neighbour)]);
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
          const CellIndex<dim> index = nodes[pending.back()].index;
          pending.pop_back();
          for_each_neighbour(index, [&](const auto &node) {
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
              for_each_neighbour(node.index, [&](const auto &other) {
                if (other.cell < 0 || refine[other.cell])
                  allowed = false;
              });
            // deal.II coarsens only families whose four flags are set.
            coarsen[node.cell] = allowed;
          }
    }
  };



  template <int dim>
  SplineSpace<dim>::SplineSpace(const std::array<KnotVector, dim> &knots)
    : implementation(std::make_unique<Implementation>(knots))
  {
    for (unsigned int d = 1; d < dim; ++d)
      if (knots[d].degree() != knots[0].degree())
        throw InputError("A spline space needs one degree in all directions, " +
                         std::to_string(knots[0].degree()) + " and " +
                         std::to_string(knots[d].degree()) + " were given.");
    if (knots[dim - 1].is_periodic())
      throw InputError(
        "A spline space cannot be periodic in the last parameter.");
    std::vector<std::vector<double>> steps(dim);
    dealii::Point<dim>               low, high;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const auto &t = knots[d].breakpoints();
        for (unsigned int span = 0; span + 1 < t.size(); ++span)
          steps[d].push_back(t[span + 1] - t[span]);
        low[d]  = knots[d].front();
        high[d] = knots[d].back();
      }
    dealii::GridGenerator::subdivided_hyper_rectangle(
      implementation->triangulation, steps, low, high, /*colorize=*/true);
    implementation->rebuild();
  }



  template <int dim>
  SplineSpace<dim>::~SplineSpace() = default;



  template <int dim>
  unsigned int
  SplineSpace<dim>::degree() const
  {
    return implementation->hierarchy->degree();
  }



  template <int dim>
  bool
  SplineSpace<dim>::is_periodic(const unsigned int direction) const
  {
    return implementation->hierarchy->is_periodic(direction);
  }



  template <int dim>
  unsigned int
  SplineSpace<dim>::n_functions() const
  {
    return implementation->hierarchy->n_functions();
  }



  template <int dim>
  unsigned int
  SplineSpace<dim>::n_cells() const
  {
    return implementation->hierarchy->n_cells();
  }



  template <int dim>
  const dealii::Triangulation<dim> &
  SplineSpace<dim>::triangulation() const
  {
    return implementation->triangulation;
  }



  template <int dim>
  dealii::Triangulation<dim> &
  SplineSpace<dim>::triangulation()
  {
    return implementation->triangulation;
  }



  template <int dim>
  std::shared_ptr<const SplineHierarchy<dim>>
  SplineSpace<dim>::hierarchy() const
  {
    return implementation->hierarchy;
  }



  template <int dim>
  void
  SplineSpace<dim>::execute_refinement()
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



  template <int dim>
  const std::vector<unsigned int> &
  SplineSpace<dim>::cell_functions(const unsigned int cell) const
  {
    return implementation->hierarchy->cell_functions(cell);
  }



  template <int dim>
  const dealii::FullMatrix<double> &
  SplineSpace<dim>::cell_extraction(const unsigned int cell) const
  {
    return implementation->hierarchy->cell_extraction(cell);
  }



  template <int dim>
  CellBox<dim>
  SplineSpace<dim>::cell_box(const unsigned int cell) const
  {
    return implementation->hierarchy->cell_box(cell);
  }



  template <int dim>
  unsigned int
  SplineSpace<dim>::find_cell(const dealii::Point<dim> &parameter) const
  {
    return implementation->hierarchy->find_cell(parameter);
  }



  template <int dim>
  std::vector<unsigned int>
  SplineSpace<dim>::edge_cells(const Edge edge) const
  {
    return asperity::edge_cells(*implementation->hierarchy, edge);
  }



  template <int dim>
  std::vector<unsigned int>
  SplineSpace<dim>::edge_functions(const Edge edge) const
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



  template <int dim>
  void
  SplineSpace<dim>::evaluate(
    const unsigned int                   cell,
    const dealii::Point<dim>            &parameter,
    std::vector<double>                 &values,
    std::vector<dealii::Tensor<1, dim>> *gradients) const
  {
    implementation->hierarchy->evaluate(cell, parameter, values, gradients);
  }



  template class SplineSpace<2>;
  template class SplineSpace<3>;
} // namespace asperity
