#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/spline_hierarchy.h>

#include <cmath>

namespace asperity
{
  template <int dim>
  unsigned int
  SplineHierarchy<dim>::degree() const
  {
    return levels[0].knots[0].degree();
  }



  template <int dim>
  bool
  SplineHierarchy<dim>::is_periodic(const unsigned int direction) const
  {
    return levels[0].knots[direction].is_periodic();
  }



  template <int dim>
  unsigned int
  SplineHierarchy<dim>::n_levels() const
  {
    return levels.size();
  }



  template <int dim>
  unsigned int
  SplineHierarchy<dim>::n_functions() const
  {
    return n_functions_;
  }



  template <int dim>
  unsigned int
  SplineHierarchy<dim>::n_cells() const
  {
    return cells.size();
  }



  template <int dim>
  const KnotVector &
  SplineHierarchy<dim>::knots(const unsigned int level,
                              const unsigned int direction) const
  {
    return levels[level].knots[direction];
  }



  template <int dim>
  const CellIndex<dim> &
  SplineHierarchy<dim>::cell_index(const unsigned int cell) const
  {
    return cells[cell].index;
  }



  template <int dim>
  CellBox<dim>
  SplineHierarchy<dim>::cell_box(const unsigned int cell) const
  {
    const CellIndex<dim> &index = cells[cell].index;
    CellBox<dim>          box;
    for (unsigned int d = 0; d < dim; ++d)
      {
        const auto &ends = levels[index.level].knots[d].breakpoints();
        box.first[d]     = ends[index.spans[d]];
        box.second[d]    = ends[index.spans[d] + 1];
      }
    return box;
  }



  template <int dim>
  const std::vector<unsigned int> &
  SplineHierarchy<dim>::cell_functions(const unsigned int cell) const
  {
    return cells[cell].functions;
  }



  template <int dim>
  const dealii::FullMatrix<double> &
  SplineHierarchy<dim>::cell_extraction(const unsigned int cell) const
  {
    return cells[cell].extraction;
  }



  template <int dim>
  const std::pair<unsigned int, unsigned int> &
  SplineHierarchy<dim>::function_home(const unsigned int function) const
  {
    return homes[function];
  }



  template <int dim>
  const dealii::FullMatrix<double> &
  SplineHierarchy<dim>::span_extraction(const unsigned int level,
                                        const unsigned int direction,
                                        const unsigned int span) const
  {
    return levels[level].extraction[direction][span];
  }



  template <int dim>
  const std::vector<typename SplineHierarchy<dim>::Node> &
  SplineHierarchy<dim>::nodes() const
  {
    return tree;
  }



  template <int dim>
  unsigned int
  SplineHierarchy<dim>::root(const CellIndex<dim> &index) const
  {
    unsigned int node = 0;
    for (unsigned int d = dim; d-- > 0;)
      node = node * knots(0, d).n_spans() + index.spans[d];
    return node;
  }



  template <int dim>
  unsigned int
  SplineHierarchy<dim>::find_node(const CellIndex<dim> &index) const
  {
    unsigned int node = root(index.ancestor(index.level));
    for (unsigned int l = 1; l <= index.level && tree[node].cell < 0; ++l)
      node =
        tree[node].children[index.ancestor(index.level - l).child_number()];
    return node;
  }



  template <int dim>
  unsigned int
  SplineHierarchy<dim>::find_cell(const dealii::Point<dim> &parameter) const
  {
    CellIndex<dim> index;
    index.level = n_levels() - 1;
    for (unsigned int d = 0; d < dim; ++d)
      index.spans[d] = knots(index.level, d).find_span(parameter[d]);
    return tree[find_node(index)].cell;
  }



  template <int dim>
  dealii::Point<dim>
  SplineHierarchy<dim>::to_unit_cell(const unsigned int        cell,
                                     const dealii::Point<dim> &parameter) const
  {
    const auto [low, high] = cell_box(cell);
    dealii::Point<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      {
        double x = parameter[d];
        if (is_periodic(d))
          {
            const double period = knots(0, d).back() - knots(0, d).front();
            x -= period * std::round((x - 0.5 * (low[d] + high[d])) / period);
          }
        result[d] = (x - low[d]) / (high[d] - low[d]);
      }
    return result;
  }



  template <int dim>
  void
  SplineHierarchy<dim>::evaluate(
    const unsigned int                   cell,
    const dealii::Point<dim>            &parameter,
    std::vector<double>                 &values,
    std::vector<dealii::Tensor<1, dim>> *gradients) const
  {
    const BernsteinTable<dim> table(degree(), {to_unit_cell(cell, parameter)});
    const auto                box        = cell_box(cell);
    const auto               &extraction = cell_extraction(cell);
    values.assign(extraction.m(), 0.);
    if (gradients != nullptr)
      gradients->assign(extraction.m(), dealii::Tensor<1, dim>());
    for (unsigned int a = 0; a < extraction.m(); ++a)
      for (unsigned int b = 0; b < extraction.n(); ++b)
        {
          values[a] += extraction(a, b) * table.values[0][b];
          if (gradients != nullptr)
            for (unsigned int d = 0; d < dim; ++d)
              (*gradients)[a][d] += extraction(a, b) *
                                    table.gradients[0][b][d] /
                                    (box.second[d] - box.first[d]);
        }
  }



  template class SplineHierarchy<1>;
  template class SplineHierarchy<2>;
  template class SplineHierarchy<3>;
} // namespace asperity
