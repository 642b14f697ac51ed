#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/spline_hierarchy.h>

#include <cmath>

namespace asperity
{
  unsigned int
  SplineHierarchy::degree() const
  {
    return levels[0].knots[0].degree();
  }



  bool
  SplineHierarchy::periodic_x() const
  {
    return levels[0].knots[0].is_periodic();
  }



  unsigned int
  SplineHierarchy::n_levels() const
  {
    return levels.size();
  }



  unsigned int
  SplineHierarchy::n_functions() const
  {
    return n_functions_;
  }



  unsigned int
  SplineHierarchy::n_cells() const
  {
    return cells.size();
  }



  const KnotVector &
  SplineHierarchy::knots(const unsigned int level,
                         const unsigned int direction) const
  {
    return levels[level].knots[direction];
  }



  const CellIndex &
  SplineHierarchy::cell_index(const unsigned int cell) const
  {
    return cells[cell].index;
  }



  std::pair<dealii::Point<2>, dealii::Point<2>>
  SplineHierarchy::cell_box(const unsigned int cell) const
  {
    const CellIndex &index = cells[cell].index;
    const auto      &x     = levels[index.level].knots[0].breakpoints();
    const auto      &y     = levels[index.level].knots[1].breakpoints();
    return {dealii::Point<2>(x[index.i], y[index.j]),
            dealii::Point<2>(x[index.i + 1], y[index.j + 1])};
  }



  const std::vector<unsigned int> &
  SplineHierarchy::cell_functions(const unsigned int cell) const
  {
    return cells[cell].functions;
  }



  const dealii::FullMatrix<double> &
  SplineHierarchy::cell_extraction(const unsigned int cell) const
  {
    return cells[cell].extraction;
  }



  const std::pair<unsigned int, unsigned int> &
  SplineHierarchy::function_home(const unsigned int function) const
  {
    return homes[function];
  }



  const dealii::FullMatrix<double> &
  SplineHierarchy::span_extraction(const unsigned int level,
                                   const unsigned int direction,
                                   const unsigned int span) const
  {
    return levels[level].extraction[direction][span];
  }



  const std::vector<SplineHierarchy::Node> &
  SplineHierarchy::nodes() const
  {
    return tree;
  }



  unsigned int
  SplineHierarchy::find_node(const CellIndex &index) const
  {
    unsigned int node = (index.j >> index.level) * knots(0, 0).n_spans() +
                        (index.i >> index.level);
    for (unsigned int l = 1; l <= index.level && tree[node].cell < 0; ++l)
      {
        const unsigned int shift = index.level - l;
        node =
          tree[node]
            .children[2 * ((index.j >> shift) % 2) + (index.i >> shift) % 2];
      }
    return node;
  }



  unsigned int
  SplineHierarchy::find_cell(const dealii::Point<2> &parameter) const
  {
    const unsigned int finest = n_levels() - 1;
    return tree[find_node({finest,
                           knots(finest, 0).find_span(parameter[0]),
                           knots(finest, 1).find_span(parameter[1])})]
      .cell;
  }



  dealii::Point<2>
  SplineHierarchy::to_unit_cell(const unsigned int      cell,
                                const dealii::Point<2> &parameter) const
  {
    const auto [low, high] = cell_box(cell);
    double x               = parameter[0];
    if (periodic_x())
      {
        const double period = knots(0, 0).back() - knots(0, 0).front();
        x -= period * std::round((x - 0.5 * (low[0] + high[0])) / period);
      }
    return dealii::Point<2>((x - low[0]) / (high[0] - low[0]),
                            (parameter[1] - low[1]) / (high[1] - low[1]));
  }



  void
  SplineHierarchy::evaluate(const unsigned int                 cell,
                            const dealii::Point<2>            &parameter,
                            std::vector<double>               &values,
                            std::vector<dealii::Tensor<1, 2>> *gradients) const
  {
    const BernsteinTable table(degree(), {to_unit_cell(cell, parameter)});
    const auto           box        = cell_box(cell);
    const auto          &extraction = cell_extraction(cell);
    values.assign(extraction.m(), 0.);
    if (gradients != nullptr)
      gradients->assign(extraction.m(), dealii::Tensor<1, 2>());
    for (unsigned int a = 0; a < extraction.m(); ++a)
      for (unsigned int b = 0; b < extraction.n(); ++b)
        {
          values[a] += extraction(a, b) * table.values[0][b];
          if (gradients != nullptr)
            for (unsigned int d = 0; d < 2; ++d)
              (*gradients)[a][d] += extraction(a, b) *
                                    table.gradients[0][b][d] /
                                    (box.second[d] - box.first[d]);
        }
  }
} // namespace asperity
