#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/space_transfer.h>

#include <deal.II/base/exceptions.h>

#include <cmath>
#include <functional>

namespace asperity
{
  namespace
  {
    // Weights are of size one; smaller ones are rounding.
    constexpr double zero_weight = 1e-15;

    using Matrix = dealii::FullMatrix<double>;

    Matrix
    transposed(const Matrix &matrix)
    {
      Matrix result(matrix.n(), matrix.m());
      result.copy_transposed(matrix);
      return result;
    }



    /** Restriction of univariate polynomials from a span to one of its
     *  descendants `levels` below it, which has the number `span`. */
    Matrix
    restriction(const unsigned int degree,
                const unsigned int levels,
                const unsigned int span)
    {
      Matrix result(degree + 1, degree + 1);
      for (unsigned int b = 0; b <= degree; ++b)
        result(b, b) = 1.;
      for (unsigned int l = levels; l-- > 0;)
        {
          Matrix next(degree + 1, degree + 1);
          result.mmult(next, bernstein_half(degree, (span >> l) % 2 == 1));
          result = next;
        }
      return result;
    }



    /** restriction() in the directions of a cell, from its ancestor. */
    template <int dim>
    std::array<Matrix, dim>
    restrictions(const unsigned int    degree,
                 const unsigned int    levels,
                 const CellIndex<dim> &cell)
    {
      std::array<Matrix, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = restriction(degree, levels, cell.spans[d]);
      return result;
    }



    template <int dim>
    DirectionMatrices<dim>
    pointers(const std::array<Matrix, dim> &matrices)
    {
      DirectionMatrices<dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = &matrices[d];
      return result;
    }



    /** Bernstein coefficients of a cell's functions on a part of the cell. */
    template <int dim>
    Matrix
    restricted_extraction(const SplineHierarchy<dim> &hierarchy,
                          const unsigned int          cell,
                          const CellIndex<dim>       &part)
    {
      const unsigned int levels = part.level - hierarchy.cell_index(cell).level;
      if (levels == 0)
        return hierarchy.cell_extraction(cell);
      return tensor_transform<dim>(
        hierarchy.cell_extraction(cell),
        pointers<dim>(restrictions(hierarchy.degree(), levels, part)));
    }
  } // namespace



  template <int dim>
  bool
  is_refinement(const SplineHierarchy<dim> &coarse,
                const SplineHierarchy<dim> &fine)
  {
    for (unsigned int cell = 0; cell < coarse.n_cells(); ++cell)
      {
        const CellIndex<dim> &index = coarse.cell_index(cell);
        if (fine.nodes()[fine.find_node(index)].index.level < index.level)
          return false;
      }
    return true;
  }



  template <int dim>
  SpaceTransfer<dim>::SpaceTransfer(const SplineHierarchy<dim> &from,
                                    const SplineHierarchy<dim> &to)
    : exact(is_refinement(from, to))
    , n_old_functions(from.n_functions())
    , n_new_functions(to.n_functions())
  {
    if (exact)
      build_exact(from, to);
    else
      build_projection(from, to);
  }



  template <int dim>
  SpaceTransfer<dim>::~SpaceTransfer() = default;



  template <int dim>
  bool
  SpaceTransfer<dim>::is_exact() const
  {
    return exact;
  }



  template <int dim>
  void
  SpaceTransfer<dim>::build_exact(const SplineHierarchy<dim> &from,
                                  const SplineHierarchy<dim> &to)
  {
    const unsigned int n   = to.degree() + 1;
    const unsigned int n_b = tensor_size<dim>(n);
    weights.resize(n_new_functions);
    for (unsigned int f = 0; f < n_new_functions; ++f)
      {
        // The coefficient is row (weights of Bernstein coefficients on the
        // home) times the Bernstein coefficients of the old spline there.
        const auto [home, place]       = to.function_home(f);
        const CellIndex<dim>   &index  = to.cell_index(home);
        const auto              digits = tensor_index<dim>(place, n);
        std::array<Matrix, dim> inverse;
        for (unsigned int d = 0; d < dim; ++d)
          {
            inverse[d].reinit(n, n);
            inverse[d].invert(
              to.span_extraction(index.level, d, index.spans[d]));
          }
        Matrix row(1, n_b);
        for (unsigned int b = 0; b < n_b; ++b)
          {
            const auto b_digits = tensor_index<dim>(b, n);
            row(0, b)           = 1.;
            for (unsigned int d = 0; d < dim; ++d)
              row(0, b) *= inverse[d](b_digits[d], digits[d]);
          }

        const auto        &old_node = from.nodes()[from.find_node(index)];
        const unsigned int levels   = index.level - old_node.index.level;
        if (levels > 0)
          {
            auto restricted = restrictions(to.degree(), levels, index);
            for (Matrix &matrix : restricted)
              matrix = transposed(matrix);
            row = tensor_transform<dim>(row, pointers<dim>(restricted));
          }

        const auto &functions  = from.cell_functions(old_node.cell);
        const auto &extraction = from.cell_extraction(old_node.cell);
        for (unsigned int a = 0; a < functions.size(); ++a)
          {
            double weight = 0.;
            for (unsigned int b = 0; b < n_b; ++b)
              weight += extraction(a, b) * row(0, b);
            if (std::abs(weight) > zero_weight)
              weights[f].emplace_back(functions[a], weight);
          }
      }
  }



  template <int dim>
  void
  SpaceTransfer<dim>::build_projection(const SplineHierarchy<dim> &from,
                                       const SplineHierarchy<dim> &to)
  {
    const Matrix gramian  = bernstein_gramian(to.degree());
    const auto   gramians = in_all_directions<dim>(gramian);
    // One cell of the common refinement: part of a new and of an old cell.
    const auto add = [&](const unsigned int    new_cell,
                         const unsigned int    old_cell,
                         const CellIndex<dim> &part) {
      Products product;
      product.rows          = to.cell_functions(new_cell);
      product.columns       = from.cell_functions(old_cell);
      const Matrix test     = restricted_extraction(to, new_cell, part);
      const Matrix trial    = restricted_extraction(from, old_cell, part);
      const Matrix weighted = tensor_transform<dim>(test, gramians);
      product.values.reinit(product.rows.size(), product.columns.size());
      weighted.mTmult(product.values, trial);
      product.values *= measure(part.level == to.cell_index(new_cell).level ?
                                  to.cell_box(new_cell) :
                                  from.cell_box(old_cell));
      products.push_back(std::move(product));
    };
    for (unsigned int cell = 0; cell < to.n_cells(); ++cell)
      {
        const CellIndex<dim>             &index = to.cell_index(cell);
        std::function<void(unsigned int)> visit = [&](const unsigned int n) {
          const auto &node = from.nodes()[n];
          if (node.cell >= 0)
            add(cell,
                node.cell,
                node.index.level > index.level ? node.index : index);
          else
            for (const int child : node.children)
              visit(child);
        };
        visit(from.find_node(index));
      }
    projection = std::make_unique<L2Projection<dim>>(to);
  }



  template <int dim>
  std::vector<double>
  SpaceTransfer<dim>::apply(const std::vector<double> &coefficients,
                            const unsigned int         n_components) const
  {
    AssertThrow(coefficients.size() == n_components * n_old_functions,
                dealii::ExcDimensionMismatch(coefficients.size(),
                                             n_components * n_old_functions));
    std::vector<double> result(n_components * n_new_functions, 0.);
    if (exact)
      {
        for (unsigned int f = 0; f < n_new_functions; ++f)
          for (const auto &[old, weight] : weights[f])
            for (unsigned int c = 0; c < n_components; ++c)
              result[f * n_components + c] +=
                weight * coefficients[old * n_components + c];
        return result;
      }
    for (unsigned int c = 0; c < n_components; ++c)
      {
        dealii::Vector<double> load(n_new_functions);
        for (const Products &product : products)
          for (unsigned int a = 0; a < product.rows.size(); ++a)
            {
              double sum = 0.;
              for (unsigned int b = 0; b < product.columns.size(); ++b)
                sum += product.values(a, b) *
                       coefficients[product.columns[b] * n_components + c];
              load[product.rows[a]] += sum;
            }
        projection->solve(load);
        for (unsigned int f = 0; f < n_new_functions; ++f)
          result[f * n_components + c] = load[f];
      }
    return result;
  }



  template <int dim>
  PatchGeometry<dim>
  SpaceTransfer<dim>::apply(const PatchGeometry<dim> &geometry) const
  {
    PatchGeometry<dim> result;
    if (geometry.offset.empty())
      return result;
    std::vector<double> coefficients;
    for (const auto &D : geometry.offset)
      coefficients.insert(coefficients.end(), D.begin_raw(), D.end_raw());
    coefficients = apply(coefficients, dim);
    result.offset.resize(n_new_functions);
    for (unsigned int a = 0; a < n_new_functions; ++a)
      for (unsigned int d = 0; d < dim; ++d)
        result.offset[a][d] = coefficients[dim * a + d];
    return result;
  }



  template bool
  is_refinement(const SplineHierarchy<2> &, const SplineHierarchy<2> &);
  template class SpaceTransfer<2>;
  template bool
  is_refinement(const SplineHierarchy<3> &, const SplineHierarchy<3> &);
  template class SpaceTransfer<3>;
} // namespace asperity
