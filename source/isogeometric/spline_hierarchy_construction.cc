#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/spline_hierarchy.h>
#include <asperity/splines/bezier_extraction.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    constexpr unsigned int inactive = dealii::numbers::invalid_unsigned_int;

    // Coefficients of B-splines are of size one; what is smaller than this is
    // rounding and would only widen the sparsity pattern.
    constexpr double zero_coefficient = 1e-14;

    /** The matrices of a cell's spans, of [direction][span]. */
    template <int dim>
    DirectionMatrices<dim>
    at(const std::array<std::vector<dealii::FullMatrix<double>>, dim> &matrices,
       const CellIndex<dim>                                           &index)
    {
      DirectionMatrices<dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = &matrices[d][index.spans[d]];
      return result;
    }
  } // namespace



  template <int dim>
  SplineHierarchy<dim>::Level::Level(const std::array<KnotVector, dim> &knots)
    : knots(knots)
  {
    for (unsigned int d = 0; d < dim; ++d)
      {
        extraction[d] = bezier_extraction(knots[d]);
        support[d].resize(knots[d].n_basis(), 0);
        for (unsigned int span = 0; span < knots[d].n_spans(); ++span)
          {
            functions[d].push_back(knots[d].span_functions(span));
            for (const unsigned int function : functions[d].back())
              ++support[d][function];
          }
      }
  }



  template <int dim>
  SplineHierarchy<dim>::SplineHierarchy(
    const std::array<KnotVector, dim> &knots,
    const std::vector<CellIndex<dim>> &cell_indices)
  {
    cells.resize(cell_indices.size());
    for (unsigned int c = 0; c < cells.size(); ++c)
      cells[c].index = cell_indices[c];
    build_levels(knots);
    build_tree();
    select_functions();
    for (const Node &node : tree)
      if (node.index.level == 0)
        extract(node, {}, dealii::FullMatrix<double>());
    find_homes();
  }



  template <int dim>
  void
  SplineHierarchy<dim>::build_levels(const std::array<KnotVector, dim> &knots)
  {
    unsigned int finest = 0;
    for (const Cell &cell : cells)
      finest = std::max(finest, cell.index.level);
    levels.emplace_back(knots);
    for (unsigned int l = 1; l <= finest; ++l)
      {
        const std::array<KnotVector, dim> coarse = levels.back().knots;
        std::array<KnotVector, dim>       fine;
        for (unsigned int d = 0; d < dim; ++d)
          fine[d] = coarse[d].dyadic_refinement();
        levels.emplace_back(fine);
        for (unsigned int d = 0; d < dim; ++d)
          levels[l].two_scale[d] = two_scale_relation(coarse[d], fine[d]);
      }
  }



  template <int dim>
  void
  SplineHierarchy<dim>::build_tree()
  {
    unsigned int n_roots = 1;
    for (const KnotVector &knots : levels[0].knots)
      n_roots *= knots.n_spans();
    for (unsigned int r = 0; r < n_roots; ++r)
      {
        CellIndex<dim> index;
        unsigned int   rest = r;
        for (unsigned int d = 0; d < dim; ++d)
          {
            index.spans[d] = rest % levels[0].knots[d].n_spans();
            rest /= levels[0].knots[d].n_spans();
          }
        tree.emplace_back(index, -1);
      }
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        const CellIndex<dim> &index = cells[c].index;
        unsigned int          node  = root(index.ancestor(index.level));
        for (unsigned int l = 1; l <= index.level; ++l)
          {
            const CellIndex<dim> child = index.ancestor(index.level - l);
            const unsigned int   place = child.child_number();
            if (tree[node].children[place] < 0)
              {
                tree[node].children[place] = tree.size();
                tree.emplace_back(child, node);
              }
            node = tree[node].children[place];
          }
        tree[node].cell = c;
      }
  }



  template <int dim>
  std::vector<std::uint64_t>
  SplineHierarchy<dim>::bsplines_of(const CellIndex<dim> &index) const
  {
    const Level               &level = levels[index.level];
    std::vector<std::uint64_t> result(1, 0);
    for (unsigned int d = dim; d-- > 0;)
      {
        std::vector<std::uint64_t> next;
        for (const std::uint64_t slower : result)
          for (const unsigned int f : level.functions[d][index.spans[d]])
            next.push_back(slower * level.knots[d].n_basis() + f);
        result.swap(next);
      }
    return result;
  }



  template <int dim>
  unsigned int
  SplineHierarchy<dim>::support_of(const Level  &level,
                                   std::uint64_t bspline) const
  {
    unsigned int n_cells = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        n_cells *= level.support[d][bspline % level.knots[d].n_basis()];
        bspline /= level.knots[d].n_basis();
      }
    return n_cells;
  }



  template <int dim>
  void
  SplineHierarchy<dim>::select_functions()
  {
    // A support lies inside Omega^l if all its cells of level l exist; it is
    // not inside Omega^(l+1) if one of them is active.
    struct Count
    {
      unsigned int n_cells     = 0;
      bool         active_cell = false;
    };
    std::vector<std::unordered_map<std::uint64_t, Count>> counts(levels.size());
    for (const Node &node : tree)
      for (const std::uint64_t bspline : bsplines_of(node.index))
        {
          Count &count = counts[node.index.level][bspline];
          ++count.n_cells;
          count.active_cell = count.active_cell || node.cell >= 0;
        }
    for (unsigned int l = 0; l < levels.size(); ++l)
      {
        Level                     &level = levels[l];
        std::vector<std::uint64_t> active;
        for (const auto &[bspline, count] : counts[l])
          if (count.n_cells == support_of(level, bspline))
            {
              level.inside[bspline] = inactive;
              if (count.active_cell)
                active.push_back(bspline);
            }
        std::sort(active.begin(), active.end());
        for (const std::uint64_t bspline : active)
          level.inside[bspline] = n_functions_++;
      }
  }



  template <int dim>
  void
  SplineHierarchy<dim>::extract(
    const Node                       &node,
    const std::vector<unsigned int>  &coarse_functions,
    const dealii::FullMatrix<double> &coarse_operators)
  {
    const Level                     &level    = levels[node.index.level];
    const std::vector<std::uint64_t> bsplines = bsplines_of(node.index);
    const unsigned int               n        = bsplines.size();

    dealii::FullMatrix<double> refined;
    if (coarse_functions.size() > 0)
      refined = tensor_transform<dim>(coarse_operators,
                                      at<dim>(level.two_scale, node.index));

    std::vector<unsigned int>        functions;
    std::vector<std::vector<double>> rows;
    std::vector<bool>                truncated;
    for (const std::uint64_t bspline : bsplines)
      truncated.push_back(level.inside.count(bspline) > 0);
    for (unsigned int a = 0; a < coarse_functions.size(); ++a)
      {
        std::vector<double> row(n, 0.);
        for (unsigned int b = 0; b < n; ++b)
          if (!truncated[b] && std::abs(refined(a, b)) > zero_coefficient)
            row[b] = refined(a, b);
        if (std::any_of(row.begin(), row.end(), [](const double value) {
              return value != 0.;
            }))
          {
            functions.push_back(coarse_functions[a]);
            rows.push_back(std::move(row));
          }
      }
    for (unsigned int b = 0; b < n; ++b)
      if (truncated[b] && level.inside.at(bsplines[b]) != inactive)
        {
          functions.push_back(level.inside.at(bsplines[b]));
          rows.emplace_back(n, 0.);
          rows.back()[b] = 1.;
        }

    dealii::FullMatrix<double> operators(rows.size(), n);
    for (unsigned int a = 0; a < rows.size(); ++a)
      for (unsigned int b = 0; b < n; ++b)
        operators(a, b) = rows[a][b];
    if (node.cell < 0)
      for (const int child : node.children)
        {
          Assert(child >= 0, dealii::ExcMessage("The cells leave a hole."));
          extract(tree[child], functions, operators);
        }
    else
      {
        cells[node.cell].functions = functions;
        cells[node.cell].extraction =
          tensor_transform<dim>(operators,
                                at<dim>(level.extraction, node.index));
      }
  }



  template <int dim>
  void
  SplineHierarchy<dim>::find_homes()
  {
    homes.assign(n_functions(), {inactive, inactive});
    std::vector<double> share(n_functions(), -1.);
    for (unsigned int c = 0; c < n_cells(); ++c)
      {
        const CellIndex<dim>            &index    = cells[c].index;
        const std::vector<std::uint64_t> bsplines = bsplines_of(index);
        const Level                     &level    = levels[index.level];
        const double                     volume   = measure(cell_box(c));
        const auto         extraction = at<dim>(level.extraction, index);
        const unsigned int n          = degree() + 1;
        for (unsigned int b = 0; b < bsplines.size(); ++b)
          {
            const auto it = level.inside.find(bsplines[b]);
            if (it == level.inside.end() || it->second == inactive)
              continue;
            // The integral of a polynomial is the mean of its coefficients.
            const auto place    = tensor_index<dim>(b, n);
            double     integral = 1.;
            for (unsigned int d = 0; d < dim; ++d)
              {
                double sum = 0.;
                for (unsigned int k = 0; k < n; ++k)
                  sum += (*extraction[d])(place[d], k);
                integral *= sum;
              }
            integral *= volume;
            // The margin makes equal shares choose the first cell.
            if (integral > share[it->second] * (1. + 1e-10))
              {
                share[it->second] = integral;
                homes[it->second] = {c, b};
              }
          }
      }
  }



  template SplineHierarchy<1>::SplineHierarchy(
    const std::array<KnotVector, 1> &,
    const std::vector<CellIndex<1>> &);
  template SplineHierarchy<2>::SplineHierarchy(
    const std::array<KnotVector, 2> &,
    const std::vector<CellIndex<2>> &);
  template SplineHierarchy<3>::SplineHierarchy(
    const std::array<KnotVector, 3> &,
    const std::vector<CellIndex<3>> &);
} // namespace asperity
