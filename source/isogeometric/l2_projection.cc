#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/l2_projection.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>

#include <algorithm>
#include <utility>

namespace asperity
{
  std::vector<unsigned int>
  edge_bernstein(const unsigned int degree, const Edge edge)
  {
    const unsigned int        n = degree + 1;
    std::vector<unsigned int> result(n);
    for (unsigned int k = 0; k < n; ++k)
      switch (edge)
        {
          case Edge::left:
            result[k] = k * n;
            break;
          case Edge::right:
            result[k] = k * n + degree;
            break;
          case Edge::bottom:
            result[k] = k;
            break;
          case Edge::top:
            result[k] = degree * n + k;
            break;
        }
    return result;
  }



  std::vector<unsigned int>
  trace_rows(const SplineHierarchy &hierarchy,
             const unsigned int     cell,
             const Edge             edge)
  {
    const auto &extraction = hierarchy.cell_extraction(cell);
    const auto  on_edge    = edge_bernstein(hierarchy.degree(), edge);
    std::vector<unsigned int> rows;
    for (unsigned int a = 0; a < extraction.m(); ++a)
      if (std::any_of(on_edge.begin(),
                      on_edge.end(),
                      [&](const unsigned int b) {
                        return extraction(a, b) != 0.;
                      }))
        rows.push_back(a);
    return rows;
  }



  std::vector<unsigned int>
  edge_cells(const SplineHierarchy &hierarchy, const Edge edge)
  {
    const unsigned int normal =
      (edge == Edge::left || edge == Edge::right) ? 0 : 1;
    const bool at_end = edge == Edge::right || edge == Edge::top;

    std::vector<std::pair<double, unsigned int>> found;
    for (unsigned int cell = 0; cell < hierarchy.n_cells(); ++cell)
      {
        const CellIndex   &index = hierarchy.cell_index(cell);
        const unsigned int span  = normal == 0 ? index.i : index.j;
        const unsigned int last =
          hierarchy.knots(index.level, normal).n_spans() - 1;
        if (span == (at_end ? last : 0))
          found.emplace_back(hierarchy.cell_box(cell).first[1 - normal], cell);
      }
    std::sort(found.begin(), found.end());
    std::vector<unsigned int> cells;
    for (const auto &entry : found)
      cells.push_back(entry.second);
    return cells;
  }



  std::vector<Edge>
  boundary_edges(const SplineHierarchy &hierarchy)
  {
    if (hierarchy.periodic_x())
      return {Edge::bottom, Edge::top};
    return {Edge::left, Edge::right, Edge::bottom, Edge::top};
  }



  dealii::FullMatrix<double>
  bernstein_gramian(const unsigned int degree)
  {
    const auto binomial = [](const unsigned int n, const unsigned int k) {
      double result = 1.;
      for (unsigned int i = 1; i <= k; ++i)
        result = result * (n - k + i) / i;
      return result;
    };
    dealii::FullMatrix<double> gramian(degree + 1, degree + 1);
    for (unsigned int a = 0; a <= degree; ++a)
      for (unsigned int b = 0; b <= degree; ++b)
        gramian(a, b) = binomial(degree, a) * binomial(degree, b) /
                        (binomial(2 * degree, a + b) * (2 * degree + 1));
    return gramian;
  }



  namespace
  {
    /** Calls add(global i, global j, value) for the products of functions. */
    template <typename Add>
    void
    assemble(const SplineHierarchy &hierarchy,
             const double           edge_weight,
             const Add             &add)
    {
      const auto gramian = bernstein_gramian(hierarchy.degree());
      dealii::FullMatrix<double> product;
      for (unsigned int cell = 0; cell < hierarchy.n_cells(); ++cell)
        {
          const auto &functions  = hierarchy.cell_functions(cell);
          const auto &extraction = hierarchy.cell_extraction(cell);
          const auto [low, high] = hierarchy.cell_box(cell);
          const double area      = (high[0] - low[0]) * (high[1] - low[1]);
          const auto weighted = tensor_transform(extraction, gramian, gramian);
          product.reinit(functions.size(), functions.size());
          weighted.mTmult(product, extraction);
          for (unsigned int a = 0; a < functions.size(); ++a)
            for (unsigned int b = 0; b < functions.size(); ++b)
              add(functions[a], functions[b], area * product(a, b));
        }
      if (edge_weight == 0.)
        return;
      for (const Edge edge : boundary_edges(hierarchy))
        {
          const auto on_edge = edge_bernstein(hierarchy.degree(), edge);
          for (const unsigned int cell : edge_cells(hierarchy, edge))
            {
              const auto &functions  = hierarchy.cell_functions(cell);
              const auto &extraction = hierarchy.cell_extraction(cell);
              const auto [low, high] = hierarchy.cell_box(cell);
              // The length of the face times the width normal to it.
              const double weight =
                edge_weight * (high[0] - low[0]) * (high[1] - low[1]);
              const auto rows = trace_rows(hierarchy, cell, edge);
              for (const unsigned int a : rows)
                for (const unsigned int b : rows)
                  {
                    double sum = 0.;
                    for (unsigned int k = 0; k < on_edge.size(); ++k)
                      for (unsigned int l = 0; l < on_edge.size(); ++l)
                        sum += extraction(a, on_edge[k]) * gramian(k, l) *
                               extraction(b, on_edge[l]);
                    add(functions[a], functions[b], weight * sum);
                  }
            }
        }
    }
  } // namespace



  L2Projection::L2Projection(const SplineHierarchy &hierarchy,
                             const double           edge_weight)
  {
    dealii::DynamicSparsityPattern pattern(hierarchy.n_functions());
    for (unsigned int cell = 0; cell < hierarchy.n_cells(); ++cell)
      for (const unsigned int a : hierarchy.cell_functions(cell))
        for (const unsigned int b : hierarchy.cell_functions(cell))
          pattern.add(a, b);
    dealii::SparsityPattern sparsity;
    sparsity.copy_from(pattern);
    dealii::SparseMatrix<double> matrix(sparsity);
    assemble(hierarchy,
             edge_weight,
             [&](const unsigned int i, const unsigned int j, const double v) {
               matrix.add(i, j, v);
             });
    factorization.initialize(matrix);
  }



  dealii::FullMatrix<double>
  L2Projection::gramian(const SplineHierarchy &hierarchy)
  {
    dealii::FullMatrix<double> matrix(hierarchy.n_functions(),
                                      hierarchy.n_functions());
    assemble(hierarchy,
             0.,
             [&](const unsigned int i, const unsigned int j, const double v) {
               matrix(i, j) += v;
             });
    return matrix;
  }



  void
  L2Projection::solve(dealii::Vector<double> &right_hand_side) const
  {
    factorization.solve(right_hand_side);
  }
} // namespace asperity
