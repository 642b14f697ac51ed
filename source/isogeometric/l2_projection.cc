#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/l2_projection.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/sparsity_pattern.h>

#include <algorithm>
#include <utility>

namespace asperity
{
  namespace
  {
    /** Of conjugate gradients: some 100 are needed, to the residual at which
     *  rounding begins. */
    constexpr unsigned int most_iterations = 2000;
    constexpr double       rounding        = 1e-14;
  } // namespace



  template <int dim>
  std::vector<unsigned int>
  edge_bernstein(const unsigned int degree, const Edge edge)
  {
    const unsigned int        n     = degree + 1;
    const unsigned int        fixed = is_at_end(edge) ? degree : 0;
    std::vector<unsigned int> result;
    for (unsigned int b = 0; b < tensor_size<dim>(n); ++b)
      if (tensor_index<dim>(b, n)[normal_direction<dim>(edge)] == fixed)
        result.push_back(b);
    return result;
  }



  template <int dim>
  std::vector<unsigned int>
  trace_rows(const SplineHierarchy<dim> &hierarchy,
             const unsigned int          cell,
             const Edge                  edge)
  {
    const auto &extraction = hierarchy.cell_extraction(cell);
    const auto  on_edge    = edge_bernstein<dim>(hierarchy.degree(), edge);
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



  template <int dim>
  std::vector<unsigned int>
  edge_cells(const SplineHierarchy<dim> &hierarchy, const Edge edge)
  {
    const unsigned int normal = normal_direction<dim>(edge);
    const auto         along  = directions_along<dim>(edge);

    // Sorted by the corner, the last direction first.
    std::vector<std::pair<std::array<double, dim - 1>, unsigned int>> found;
    for (unsigned int cell = 0; cell < hierarchy.n_cells(); ++cell)
      {
        const CellIndex<dim> &index = hierarchy.cell_index(cell);
        const unsigned int    last =
          hierarchy.knots(index.level, normal).n_spans() - 1;
        if (index.spans[normal] != (is_at_end(edge) ? last : 0))
          continue;
        const auto                  corner = hierarchy.cell_box(cell).first;
        std::array<double, dim - 1> key;
        for (unsigned int k = 0; k < dim - 1; ++k)
          key[dim - 2 - k] = corner[along[k]];
        found.emplace_back(key, cell);
      }
    std::sort(found.begin(), found.end());
    std::vector<unsigned int> cells;
    for (const auto &entry : found)
      cells.push_back(entry.second);
    return cells;
  }



  template <int dim>
  std::vector<Edge>
  boundary_edges(const SplineHierarchy<dim> &hierarchy)
  {
    std::vector<Edge> edges;
    for (const Edge edge : all_edges<dim>())
      if (!hierarchy.is_periodic(normal_direction<dim>(edge)))
        edges.push_back(edge);
    return edges;
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
    /** Products over the unit edge of the Bernstein polynomials that do not
     *  vanish there, in the order of edge_bernstein(). */
    template <int dim>
    dealii::FullMatrix<double>
    edge_gramian(const dealii::FullMatrix<double> &gramian)
    {
      const unsigned int         n   = gramian.m();
      const unsigned int         n_b = tensor_size<dim - 1>(n);
      dealii::FullMatrix<double> result(n_b, n_b);
      for (unsigned int k = 0; k < n_b; ++k)
        for (unsigned int l = 0; l < n_b; ++l)
          {
            const auto k_index = tensor_index<dim - 1>(k, n);
            const auto l_index = tensor_index<dim - 1>(l, n);
            result(k, l)       = 1.;
            for (unsigned int d = 0; d < dim - 1; ++d)
              result(k, l) *= gramian(k_index[d], l_index[d]);
          }
      return result;
    }



    /** Calls add(global i, global j, value) for the products over one edge,
     *  times the cells' widths normal to it. */
    template <int dim, typename Add>
    void
    assemble_edge(const SplineHierarchy<dim>       &hierarchy,
                  const Edge                        edge,
                  const dealii::FullMatrix<double> &gramian,
                  const double                      edge_weight,
                  const Add                        &add)
    {
      const auto on_edge = edge_bernstein<dim>(hierarchy.degree(), edge);
      for (const unsigned int cell : edge_cells(hierarchy, edge))
        {
          const auto &functions  = hierarchy.cell_functions(cell);
          const auto &extraction = hierarchy.cell_extraction(cell);
          // The measure of the face times the width normal to it.
          const auto [low, high] = hierarchy.cell_box(cell);
          double weight          = edge_weight;
          for (unsigned int d = 0; d < dim; ++d)
            weight *= high[d] - low[d];
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



    /** Calls add(global i, global j, value) for the products of functions. */
    template <int dim, typename Add>
    void
    assemble(const SplineHierarchy<dim> &hierarchy,
             const double                edge_weight,
             const Add                  &add)
    {
      const auto gramian  = bernstein_gramian(hierarchy.degree());
      const auto gramians = in_all_directions<dim>(gramian);
      dealii::FullMatrix<double> product;
      for (unsigned int cell = 0; cell < hierarchy.n_cells(); ++cell)
        {
          const auto  &functions  = hierarchy.cell_functions(cell);
          const auto  &extraction = hierarchy.cell_extraction(cell);
          const double volume     = measure(hierarchy.cell_box(cell));
          const auto   weighted   = tensor_transform<dim>(extraction, gramians);
          product.reinit(functions.size(), functions.size());
          weighted.mTmult(product, extraction);
          for (unsigned int a = 0; a < functions.size(); ++a)
            for (unsigned int b = 0; b < functions.size(); ++b)
              add(functions[a], functions[b], volume * product(a, b));
        }
      if (edge_weight != 0.)
        for (const Edge edge : boundary_edges(hierarchy))
          assemble_edge(
            hierarchy, edge, edge_gramian<dim>(gramian), edge_weight, add);
    }
  } // namespace



  template <int dim>
  L2Projection<dim>::L2Projection(const SplineHierarchy<dim> &hierarchy,
                                  const double                edge_weight)
  {
    dealii::DynamicSparsityPattern couplings(hierarchy.n_functions());
    for (unsigned int cell = 0; cell < hierarchy.n_cells(); ++cell)
      for (const unsigned int a : hierarchy.cell_functions(cell))
        for (const unsigned int b : hierarchy.cell_functions(cell))
          couplings.add(a, b);
    pattern.copy_from(couplings);
    matrix.reinit(pattern);
    assemble(hierarchy,
             edge_weight,
             [&](const unsigned int i, const unsigned int j, const double v) {
               matrix.add(i, j, v);
             });
    if (dim == 3)
      return;
    factorization.initialize(matrix);
    matrix.clear();
  }



  template <int dim>
  dealii::FullMatrix<double>
  L2Projection<dim>::gramian(const SplineHierarchy<dim> &hierarchy)
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



  template <int dim>
  void
  L2Projection<dim>::solve(dealii::Vector<double> &right_hand_side) const
  {
    if (dim == 2)
      {
        factorization.solve(right_hand_side);
        return;
      }
    dealii::PreconditionJacobi<dealii::SparseMatrix<double>> diagonal;
    diagonal.initialize(matrix);
    dealii::SolverControl                    control(most_iterations,
                                  rounding * right_hand_side.l2_norm());
    dealii::SolverCG<dealii::Vector<double>> solver(control);
    dealii::Vector<double>                   x(right_hand_side.size());
    solver.solve(matrix, x, right_hand_side, diagonal);
    right_hand_side = x;
  }



  template std::vector<unsigned int>
  edge_bernstein<2>(const unsigned int, const Edge);
  template std::vector<unsigned int>
  trace_rows(const SplineHierarchy<2> &, const unsigned int, const Edge);
  template std::vector<unsigned int>
  edge_cells(const SplineHierarchy<2> &, const Edge);
  template std::vector<Edge>
  boundary_edges(const SplineHierarchy<2> &);
  template class L2Projection<2>;
  template std::vector<unsigned int>
  edge_bernstein<3>(const unsigned int, const Edge);
  template std::vector<unsigned int>
  trace_rows(const SplineHierarchy<3> &, const unsigned int, const Edge);
  template std::vector<unsigned int>
  edge_cells(const SplineHierarchy<3> &, const Edge);
  template std::vector<Edge>
  boundary_edges(const SplineHierarchy<3> &);
  template class L2Projection<3>;
} // namespace asperity
