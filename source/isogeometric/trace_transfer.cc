#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/trace_transfer.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/precondition.h>
#include <deal.II/lac/solver_cg.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace asperity
{
  namespace
  {
    /** Of conjugate gradients: some 50 are needed, to the residual at which
     *  rounding begins. */
    constexpr unsigned int most_iterations = 2000;
    constexpr double       rounding        = 1e-15;

    /** Numbers of the functions whose trace does not vanish. */
    template <int dim>
    std::map<unsigned int, unsigned int>
    numbers_of_traces(const SplineHierarchy<dim> &hierarchy, const Edge edge)
    {
      std::map<unsigned int, unsigned int> number;
      for (const unsigned int cell : edge_cells(hierarchy, edge))
        for (const unsigned int row : trace_rows(hierarchy, cell, edge))
          number[hierarchy.cell_functions(cell)[row]] = 0;
      unsigned int n = 0;
      for (auto &entry : number)
        entry.second = n++;
      return number;
    }

    /** The functions of a cell that have a trace, and their values. */
    template <int dim>
    class Traces
    {
    public:
      Traces(const SplineHierarchy<dim>                 &hierarchy,
             const unsigned int                          cell,
             const Edge                                  edge,
             const std::map<unsigned int, unsigned int> &number)
        : hierarchy(hierarchy)
        , cell(cell)
        , rows(trace_rows(hierarchy, cell, edge))
      {
        for (const unsigned int row : rows)
          numbers.push_back(number.at(hierarchy.cell_functions(cell)[row]));
      }

      const std::vector<double> &
      at(const dealii::Point<dim> &parameter)
      {
        hierarchy.evaluate(cell, parameter, all);
        values.clear();
        for (const unsigned int row : rows)
          values.push_back(all[row]);
        return values;
      }

      std::vector<unsigned int> numbers;

    private:
      const SplineHierarchy<dim> &hierarchy;
      unsigned int                cell;
      std::vector<unsigned int>   rows;
      std::vector<double>         all, values;
    };

    /** Calls visit(old cell) for the active cells of a tree along the edge of a
     *  cell, or for the one that holds it. */
    template <int dim>
    void
    for_old_cells(const SplineHierarchy<dim>              &from,
                  const CellIndex<dim>                    &index,
                  const Edge                               edge,
                  const std::function<void(unsigned int)> &visit)
    {
      const unsigned int                normal = normal_direction<dim>(edge);
      std::function<void(unsigned int)> go     = [&](const unsigned int n) {
        const auto &node = from.nodes()[n];
        if (node.cell >= 0)
          {
            visit(node.cell);
            return;
          }
        for (const int child : node.children)
          if ((from.nodes()[child].index.spans[normal] % 2 == 1) ==
              is_at_end(edge))
            go(child);
      };
      go(from.find_node(index));
    }
  } // namespace



  template <int dim>
  TraceTransfer<dim>::TraceTransfer(const SplineHierarchy<dim> &from,
                                    const SplineHierarchy<dim> &to,
                                    const Edge                  edge)
  {
    const auto old_number = numbers_of_traces(from, edge),
               new_number = numbers_of_traces(to, edge);
    n_old                 = old_number.size();
    n_new                 = new_number.size();
    const dealii::Quadrature<dim> points(
      edge_points<dim>(dealii::QGauss<dim - 1>(to.degree() + 1), edge));
    const std::vector<double> weights =
      dealii::QGauss<dim - 1>(to.degree() + 1).get_weights();
    for (const unsigned int cell : edge_cells(to, edge))
      for_old_cells<dim>(
        from, to.cell_index(cell), edge, [&](const unsigned int old) {
          const CellBox<dim> part =
            from.cell_index(old).level > to.cell_index(cell).level ?
              from.cell_box(old) :
              to.cell_box(cell);
          double size = 1.;
          for (const unsigned int d : directions_along<dim>(edge))
            size *= part.second[d] - part.first[d];
          Traces<dim> tests(to, cell, edge, new_number),
            trials(from, old, edge, old_number);
          Products product;
          product.rows    = tests.numbers;
          product.columns = trials.numbers;
          product.with_new.reinit(product.rows.size(), product.rows.size());
          product.with_old.reinit(product.rows.size(), product.columns.size());
          for (unsigned int q = 0; q < weights.size(); ++q)
            {
              const auto   x      = from_unit_cell(part, points.point(q));
              const auto  &N      = tests.at(x);
              const auto  &M      = trials.at(x);
              const double weight = size * weights[q];
              for (unsigned int a = 0; a < N.size(); ++a)
                {
                  for (unsigned int b = 0; b < N.size(); ++b)
                    product.with_new(a, b) += weight * N[a] * N[b];
                  for (unsigned int b = 0; b < M.size(); ++b)
                    product.with_old(a, b) += weight * N[a] * M[b];
                }
            }
          products.push_back(std::move(product));
        });
    build_matrix();
  }



  template <int dim>
  void
  TraceTransfer<dim>::build_matrix()
  {
    dealii::DynamicSparsityPattern couplings(n_new);
    for (const Products &product : products)
      for (const unsigned int a : product.rows)
        couplings.add_entries(a, product.rows.begin(), product.rows.end());
    pattern.copy_from(couplings);
    matrix.reinit(pattern);
    for (const Products &product : products)
      matrix.add(product.rows, product.with_new);
  }



  template <int dim>
  std::vector<double>
  TraceTransfer<dim>::apply(const std::vector<double> &coefficients) const
  {
    AssertDimension(coefficients.size(), n_old);
    dealii::Vector<double> load(n_new), result(n_new);
    for (const Products &product : products)
      for (unsigned int a = 0; a < product.rows.size(); ++a)
        for (unsigned int b = 0; b < product.columns.size(); ++b)
          load(product.rows[a]) +=
            product.with_old(a, b) * coefficients[product.columns[b]];
    // What is zero stays so.
    if (load.l2_norm() == 0.)
      return std::vector<double>(n_new, 0.);
    dealii::PreconditionJacobi<dealii::SparseMatrix<double>> diagonal;
    diagonal.initialize(matrix);
    dealii::SolverControl control(most_iterations, rounding * load.l2_norm());
    dealii::SolverCG<dealii::Vector<double>> solver(control);
    solver.solve(matrix, result, load, diagonal);
    return std::vector<double>(result.begin(), result.end());
  }



  namespace
  {
    /** The cells along an edge as a mesh of their own. */
    template <int dim>
    SplineHierarchy<dim - 1>
    mesh_of_edge(const SplineHierarchy<dim> &hierarchy, const Edge edge)
    {
      const auto                      along = directions_along<dim>(edge);
      std::array<KnotVector, dim - 1> knots;
      for (unsigned int k = 0; k < dim - 1; ++k)
        knots[k] = hierarchy.knots(0, along[k]);
      std::vector<CellIndex<dim - 1>> cells;
      for (const unsigned int cell : edge_cells(hierarchy, edge))
        {
          CellIndex<dim - 1> index;
          index.level = hierarchy.cell_index(cell).level;
          for (unsigned int k = 0; k < dim - 1; ++k)
            index.spans[k] = hierarchy.cell_index(cell).spans[along[k]];
          cells.push_back(index);
        }
      return SplineHierarchy<dim - 1>(knots, cells);
    }
  } // namespace



  template <int dim>
  std::vector<double>
  transfer_edge_history(const SplineHierarchy<dim>        &from,
                        const SplineHierarchy<dim>        &to,
                        const Edge                         edge,
                        const dealii::Quadrature<dim - 1> &quadrature,
                        const std::vector<double>         &values,
                        const unsigned int                 n_components)
  {
    return transfer_history(mesh_of_edge(from, edge),
                            mesh_of_edge(to, edge),
                            quadrature,
                            values,
                            n_components,
                            2,
                            HistoryRange::body);
  }



  template class TraceTransfer<2>;
  template class TraceTransfer<3>;
  template std::vector<double>
  transfer_edge_history(const SplineHierarchy<2> &,
                        const SplineHierarchy<2> &,
                        const Edge,
                        const dealii::Quadrature<1> &,
                        const std::vector<double> &,
                        const unsigned int);
  template std::vector<double>
  transfer_edge_history(const SplineHierarchy<3> &,
                        const SplineHierarchy<3> &,
                        const Edge,
                        const dealii::Quadrature<2> &,
                        const std::vector<double> &,
                        const unsigned int);
} // namespace asperity
