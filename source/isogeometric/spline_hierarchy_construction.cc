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
  } // namespace



  SplineHierarchy::Level::Level(const std::array<KnotVector, 2> &knots)
    : knots(knots)
  {
    for (unsigned int d = 0; d < 2; ++d)
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



  SplineHierarchy::SplineHierarchy(const KnotVector             &knots_x,
                                   const KnotVector             &knots_y,
                                   const std::vector<CellIndex> &cell_indices)
  {
    cells.resize(cell_indices.size());
    for (unsigned int c = 0; c < cells.size(); ++c)
      cells[c].index = cell_indices[c];
    build_levels(knots_x, knots_y);
    build_tree();
    select_functions();
    const unsigned int n_roots = knots_x.n_spans() * knots_y.n_spans();
    for (unsigned int root = 0; root < n_roots; ++root)
      extract(tree[root], {}, dealii::FullMatrix<double>());
    find_homes();
  }



  void
  SplineHierarchy::build_levels(const KnotVector &knots_x,
                                const KnotVector &knots_y)
  {
    unsigned int finest = 0;
    for (const Cell &cell : cells)
      finest = std::max(finest, cell.index.level);
    levels.emplace_back(std::array<KnotVector, 2>{{knots_x, knots_y}});
    for (unsigned int l = 1; l <= finest; ++l)
      {
        const std::array<KnotVector, 2> coarse = levels.back().knots;
        levels.emplace_back(std::array<KnotVector, 2>{
          {coarse[0].dyadic_refinement(), coarse[1].dyadic_refinement()}});
        for (unsigned int d = 0; d < 2; ++d)
          levels[l].two_scale[d] =
            two_scale_relation(coarse[d], levels[l].knots[d]);
      }
  }



  void
  SplineHierarchy::build_tree()
  {
    const unsigned int n_x = levels[0].knots[0].n_spans();
    const unsigned int n_y = levels[0].knots[1].n_spans();
    for (unsigned int j = 0; j < n_y; ++j)
      for (unsigned int i = 0; i < n_x; ++i)
        {
          Node root;
          root.index = {0, i, j};
          tree.push_back(root);
        }
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        const CellIndex index = cells[c].index;
        unsigned int    node =
          (index.j >> index.level) * n_x + (index.i >> index.level);
        for (unsigned int l = 1; l <= index.level; ++l)
          {
            const unsigned int shift = index.level - l;
            const CellIndex    child = {l, index.i >> shift, index.j >> shift};
            const unsigned int place = 2 * (child.j % 2) + child.i % 2;
            if (tree[node].children[place] < 0)
              {
                tree[node].children[place] = tree.size();
                Node next;
                next.index  = child;
                next.parent = node;
                tree.push_back(next);
              }
            node = tree[node].children[place];
          }
        tree[node].cell = c;
      }
  }



  std::vector<std::uint64_t>
  SplineHierarchy::bsplines_of(const CellIndex &index) const
  {
    const Level               &level = levels[index.level];
    const std::uint64_t        n_x   = level.knots[0].n_basis();
    std::vector<std::uint64_t> result;
    for (const unsigned int f_y : level.functions[1][index.j])
      for (const unsigned int f_x : level.functions[0][index.i])
        result.push_back(f_y * n_x + f_x);
    return result;
  }



  void
  SplineHierarchy::select_functions()
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
        const std::uint64_t        n_x   = level.knots[0].n_basis();
        std::vector<std::uint64_t> active;
        for (const auto &[bspline, count] : counts[l])
          if (count.n_cells ==
              level.support[0][bspline % n_x] * level.support[1][bspline / n_x])
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



  void
  SplineHierarchy::extract(const Node                       &node,
                           const std::vector<unsigned int>  &coarse_functions,
                           const dealii::FullMatrix<double> &coarse_operators)
  {
    const Level                     &level    = levels[node.index.level];
    const std::vector<std::uint64_t> bsplines = bsplines_of(node.index);
    const unsigned int               n        = bsplines.size();

    dealii::FullMatrix<double> refined;
    if (coarse_functions.size() > 0)
      refined = tensor_transform(coarse_operators,
                                 level.two_scale[0][node.index.i],
                                 level.two_scale[1][node.index.j]);

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
          tensor_transform(operators,
                           level.extraction[0][node.index.i],
                           level.extraction[1][node.index.j]);
      }
  }



  void
  SplineHierarchy::find_homes()
  {
    homes.assign(n_functions(), {inactive, inactive});
    std::vector<double> share(n_functions(), -1.);
    for (unsigned int c = 0; c < n_cells(); ++c)
      {
        const CellIndex                 &index    = cells[c].index;
        const std::vector<std::uint64_t> bsplines = bsplines_of(index);
        const auto                      &inside   = levels[index.level].inside;
        const auto                       box      = cell_box(c);
        const double                     area =
          (box.second[0] - box.first[0]) * (box.second[1] - box.first[1]);
        const auto &extraction_x = span_extraction(index.level, 0, index.i);
        const auto &extraction_y = span_extraction(index.level, 1, index.j);
        const unsigned int n     = degree() + 1;
        for (unsigned int b = 0; b < bsplines.size(); ++b)
          {
            const auto it = inside.find(bsplines[b]);
            if (it == inside.end() || it->second == inactive)
              continue;
            // The integral of a polynomial is the mean of its coefficients.
            double sum_x = 0, sum_y = 0;
            for (unsigned int k = 0; k < n; ++k)
              {
                sum_x += extraction_x(b % n, k);
                sum_y += extraction_y(b / n, k);
              }
            // The margin makes equal shares choose the first cell.
            const double integral = sum_x * sum_y * area;
            if (integral > share[it->second] * (1. + 1e-10))
              {
                share[it->second] = integral;
                homes[it->second] = {c, b};
              }
          }
      }
  }
} // namespace asperity
