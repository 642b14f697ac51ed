#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/space_transfer.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
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



    /** Bernstein coefficients of a cell's functions on a part of the cell. */
    Matrix
    restricted_extraction(const SplineHierarchy &hierarchy,
                          const unsigned int     cell,
                          const CellIndex       &part)
    {
      const unsigned int levels = part.level - hierarchy.cell_index(cell).level;
      if (levels == 0)
        return hierarchy.cell_extraction(cell);
      const unsigned int p = hierarchy.degree();
      return tensor_transform(hierarchy.cell_extraction(cell),
                              restriction(p, levels, part.i),
                              restriction(p, levels, part.j));
    }
  } // namespace



  bool
  is_refinement(const SplineHierarchy &coarse, const SplineHierarchy &fine)
  {
    for (unsigned int cell = 0; cell < coarse.n_cells(); ++cell)
      {
        const CellIndex &index = coarse.cell_index(cell);
        if (fine.nodes()[fine.find_node(index)].index.level < index.level)
          return false;
      }
    return true;
  }



  SpaceTransfer::SpaceTransfer(const SplineHierarchy &from,
                               const SplineHierarchy &to)
    : exact(is_refinement(from, to))
    , n_old_functions(from.n_functions())
    , n_new_functions(to.n_functions())
  {
    if (exact)
      build_exact(from, to);
    else
      build_projection(from, to);
  }



  SpaceTransfer::~SpaceTransfer() = default;



  bool
  SpaceTransfer::is_exact() const
  {
    return exact;
  }



  void
  SpaceTransfer::build_exact(const SplineHierarchy &from,
                             const SplineHierarchy &to)
  {
    const unsigned int n = to.degree() + 1;
    weights.resize(n_new_functions);
    for (unsigned int f = 0; f < n_new_functions; ++f)
      {
        // The coefficient is row (weights of Bernstein coefficients on the
        // home) times the Bernstein coefficients of the old spline there.
        const auto [home, place]  = to.function_home(f);
        const CellIndex    &index = to.cell_index(home);
        std::vector<Matrix> inverse(2, Matrix(n, n));
        inverse[0].invert(to.span_extraction(index.level, 0, index.i));
        inverse[1].invert(to.span_extraction(index.level, 1, index.j));
        Matrix row(1, n * n);
        for (unsigned int b_y = 0; b_y < n; ++b_y)
          for (unsigned int b_x = 0; b_x < n; ++b_x)
            row(0, b_y * n + b_x) =
              inverse[0](b_x, place % n) * inverse[1](b_y, place / n);

        const auto        &old_node = from.nodes()[from.find_node(index)];
        const unsigned int levels   = index.level - old_node.index.level;
        if (levels > 0)
          row = tensor_transform(
            row,
            transposed(restriction(to.degree(), levels, index.i)),
            transposed(restriction(to.degree(), levels, index.j)));

        const auto &functions  = from.cell_functions(old_node.cell);
        const auto &extraction = from.cell_extraction(old_node.cell);
        for (unsigned int a = 0; a < functions.size(); ++a)
          {
            double weight = 0.;
            for (unsigned int b = 0; b < n * n; ++b)
              weight += extraction(a, b) * row(0, b);
            if (std::abs(weight) > zero_weight)
              weights[f].emplace_back(functions[a], weight);
          }
      }
  }



  void
  SpaceTransfer::build_projection(const SplineHierarchy &from,
                                  const SplineHierarchy &to)
  {
    const auto gramian = bernstein_gramian(to.degree());
    // One cell of the common refinement: part of a new and of an old cell.
    const auto add = [&](const unsigned int new_cell,
                         const unsigned int old_cell,
                         const CellIndex   &part) {
      Products product;
      product.rows          = to.cell_functions(new_cell);
      product.columns       = from.cell_functions(old_cell);
      const Matrix test     = restricted_extraction(to, new_cell, part);
      const Matrix trial    = restricted_extraction(from, old_cell, part);
      const Matrix weighted = tensor_transform(test, gramian, gramian);
      product.values.reinit(product.rows.size(), product.columns.size());
      weighted.mTmult(product.values, trial);
      const auto [low, high] = part.level == to.cell_index(new_cell).level ?
                                 to.cell_box(new_cell) :
                                 from.cell_box(old_cell);
      product.values *= (high[0] - low[0]) * (high[1] - low[1]);
      products.push_back(std::move(product));
    };
    for (unsigned int cell = 0; cell < to.n_cells(); ++cell)
      {
        const CellIndex                  &index = to.cell_index(cell);
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
    projection = std::make_unique<L2Projection>(to);
  }



  std::vector<double>
  SpaceTransfer::apply(const std::vector<double> &coefficients,
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



  PatchGeometry
  SpaceTransfer::apply(const PatchGeometry &geometry) const
  {
    PatchGeometry result;
    if (geometry.offset.empty())
      return result;
    std::vector<double> coefficients;
    for (const auto &D : geometry.offset)
      coefficients.insert(coefficients.end(), {D[0], D[1]});
    coefficients = apply(coefficients, 2);
    result.offset.resize(n_new_functions);
    for (unsigned int a = 0; a < n_new_functions; ++a)
      for (unsigned int d = 0; d < 2; ++d)
        result.offset[a][d] = coefficients[2 * a + d];
    return result;
  }
} // namespace asperity
