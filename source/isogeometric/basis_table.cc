#include <asperity/base/errors.h>
#include <asperity/isogeometric/basis_table.h>
#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/spline_space.h>

#include <numeric>
#include <string>

namespace asperity
{
  template <int dim>
  std::vector<dealii::Point<dim>>
  edge_points(const dealii::Quadrature<dim - 1> &quadrature, const Edge edge)
  {
    const auto                      along = directions_along<dim>(edge);
    std::vector<dealii::Point<dim>> points;
    for (const auto &on_edge : quadrature.get_points())
      {
        dealii::Point<dim> point;
        point[normal_direction<dim>(edge)] = is_at_end(edge) ? 1. : 0.;
        for (unsigned int k = 0; k < dim - 1; ++k)
          point[along[k]] = on_edge[k];
        points.push_back(point);
      }
    return points;
  }



  template <int dim>
  PatchGeometry<dim>
  PatchGeometry<dim>::from_map(
    const SplineSpace<dim>                                              &space,
    const std::function<dealii::Point<dim>(const dealii::Point<dim> &)> &map)
  {
    const auto coefficients = space.project(
      [&map](const dealii::Point<dim> &parameter) {
        const dealii::Tensor<1, dim> offset = map(parameter) - parameter;
        return std::vector<double>(offset.begin_raw(), offset.end_raw());
      },
      dim);
    PatchGeometry geometry;
    geometry.offset.resize(space.n_functions());
    for (unsigned int a = 0; a < space.n_functions(); ++a)
      for (unsigned int d = 0; d < dim; ++d)
        geometry.offset[a][d] = coefficients[d][a];
    return geometry;
  }



  template <int dim>
  dealii::Point<dim>
  PatchGeometry<dim>::position(const SplineSpace<dim>   &space,
                               const dealii::Point<dim> &parameter) const
  {
    dealii::Point<dim> X = parameter;
    if (offset.empty())
      return X;
    const unsigned int  cell = space.find_cell(parameter);
    std::vector<double> values;
    space.evaluate(cell, parameter, values);
    for (unsigned int a = 0; a < values.size(); ++a)
      X += values[a] * offset[space.cell_functions(cell)[a]];
    return X;
  }



  namespace
  {
    /** Values and gradients of a cell's functions at points of the unit cell
     *  that are common to all cells. */
    template <int dim>
    class CellEvaluator
    {
    public:
      using Element = typename BasisTable<dim>::Element;

      CellEvaluator(const SplineSpace<dim>         &space,
                    const PatchGeometry<dim>       &geometry,
                    std::vector<dealii::Point<dim>> points)
        : space(space)
        , geometry(geometry)
        , points(std::move(points))
        , bernstein(space.degree(), this->points)
      {}

      /** Fills the element, positions and parameters; `jacobians` gets
       *  dX/dxi at the points. Gradients are parametric after this. */
      void
      evaluate(const std::vector<unsigned int>     &rows,
               Element                             &element,
               BasisTable<dim>                     &table,
               std::vector<dealii::Tensor<2, dim>> &jacobians)
      {
        const auto &all_functions = space.cell_functions(element.cell);
        element.first_point       = table.position.size();
        element.functions.clear();
        for (const unsigned int row : rows)
          element.functions.push_back(all_functions[row]);
        fill(rows, element);

        // The geometry needs all functions, which may be more than the rows.
        const auto box = space.cell_box(element.cell);
        jacobians.assign(points.size(), dealii::unit_symmetric_tensor<dim>());
        for (const auto &point : points)
          {
            table.parameter.push_back(from_unit_cell(box, point));
            table.position.push_back(table.parameter.back());
          }
        if (!geometry.offset.empty())
          add_offset(element, table, jacobians);
      }

    private:
      void
      fill(const std::vector<unsigned int> &rows, Element &element) const
      {
        const auto         &extraction = space.cell_extraction(element.cell);
        const auto          box        = space.cell_box(element.cell);
        const unsigned int  n_a        = rows.size();
        const unsigned int  n_b        = extraction.n();
        std::vector<double> transposed(n_b * n_a);
        for (unsigned int a = 0; a < n_a; ++a)
          for (unsigned int b = 0; b < n_b; ++b)
            transposed[b * n_a + a] = extraction(rows[a], b);

        std::vector<double>                  N(n_a);
        std::array<std::vector<double>, dim> dN;
        dN.fill(N);
        const auto add = [&transposed, n_a](const double         factor,
                                            const unsigned int   b,
                                            std::vector<double> &sum) {
          const double *row = &transposed[b * n_a];
          for (unsigned int a = 0; a < n_a; ++a)
            sum[a] += factor * row[a];
        };
        element.values.resize(points.size() * n_a);
        element.gradients.resize(points.size() * n_a);
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            std::fill(N.begin(), N.end(), 0.);
            for (auto &component : dN)
              std::fill(component.begin(), component.end(), 0.);
            for (unsigned int b = 0; b < n_b; ++b)
              {
                add(bernstein.values[q][b], b, N);
                for (unsigned int d = 0; d < dim; ++d)
                  add(bernstein.gradients[q][b][d] *
                        (1. / (box.second[d] - box.first[d])),
                      b,
                      dN[d]);
              }
            for (unsigned int a = 0; a < n_a; ++a)
              {
                element.values[q * n_a + a] = N[a];
                for (unsigned int d = 0; d < dim; ++d)
                  element.gradients[q * n_a + a][d] = dN[d][a];
              }
          }
      }

      void
      add_offset(const Element                       &element,
                 BasisTable<dim>                     &table,
                 std::vector<dealii::Tensor<2, dim>> &jacobians)
      {
        const Element *full = &element;
        if (element.functions.size() !=
            space.cell_functions(element.cell).size())
          {
            complete.cell      = element.cell;
            complete.functions = space.cell_functions(element.cell);
            std::vector<unsigned int> rows(complete.functions.size());
            std::iota(rows.begin(), rows.end(), 0);
            fill(rows, complete);
            full = &complete;
          }
        const unsigned int n_a = full->functions.size();
        for (unsigned int q = 0; q < points.size(); ++q)
          for (unsigned int a = 0; a < n_a; ++a)
            {
              const auto &D = geometry.offset[full->functions[a]];
              table.position[element.first_point + q] +=
                full->values[q * n_a + a] * D;
              jacobians[q] += outer_product(D, full->gradients[q * n_a + a]);
            }
      }

      const SplineSpace<dim>               &space;
      const PatchGeometry<dim>             &geometry;
      const std::vector<dealii::Point<dim>> points;
      const BernsteinTable<dim>             bernstein;
      Element                               complete;
    };



    template <int dim>
    double
    checked_determinant(const dealii::Tensor<2, dim> &jacobian,
                        const dealii::Point<dim>     &parameter)
    {
      const double determinant = dealii::determinant(jacobian);
      if (!(determinant > 0.))
        {
          std::string place = std::to_string(parameter[0]);
          for (unsigned int d = 1; d < dim; ++d)
            place += ", " + std::to_string(parameter[d]);
          throw ComputationError(
            "The reference geometry folds at parameter (" + place +
            "): the determinant of its gradient is " +
            std::to_string(determinant) + ", a positive value is needed.");
        }
      return determinant;
    }



    /** Orthonormal tangents and the outward normal of an edge at a point, and
     *  its measure by that of the parameters. */
    template <int dim>
    struct EdgeFrame
    {
      EdgeFrame(const dealii::Tensor<2, dim> &jacobian, const Edge edge)
      {
        const auto along = directions_along<dim>(edge);
        for (unsigned int k = 0; k < dim - 1; ++k)
          {
            for (unsigned int d = 0; d < dim; ++d)
              tangents[k][d] = jacobian[d][along[k]];
            for (unsigned int l = 0; l < k; ++l)
              tangents[k] -= (tangents[k] * tangents[l]) * tangents[l];
            const double length = tangents[k].norm();
            tangents[k] /= length;
            measure *= length;
          }
        if constexpr (dim == 2)
          normal = cross_product_2d(tangents[0]);
        else
          normal = cross_product_3d(tangents[0], tangents[1]);
        // The product points to increasing parameters in the first direction
        // and the third, to decreasing ones in the second.
        if (is_at_end(edge) != (normal_direction<dim>(edge) % 2 == 0))
          normal *= -1.;
      }

      /** A gradient by its components along the tangents and the normal. */
      dealii::Tensor<1, dim>
      components(const dealii::Tensor<1, dim> &gradient) const
      {
        dealii::Tensor<1, dim> result;
        for (unsigned int k = 0; k < dim - 1; ++k)
          result[k] = gradient * tangents[k];
        result[dim - 1] = gradient * normal;
        return result;
      }

      std::array<dealii::Tensor<1, dim>, dim - 1> tangents;
      dealii::Tensor<1, dim>                      normal;
      double                                      measure = 1.;
    };
  } // namespace



  template <int dim>
  BasisTable<dim>
  tabulate_cells(const SplineSpace<dim>                        &space,
                 const PatchGeometry<dim>                      &geometry,
                 const dealii::Quadrature<dim>                 &quadrature,
                 const std::function<bool(const unsigned int)> &wanted)
  {
    BasisTable<dim> table;
    table.points_per_element = quadrature.size();
    table.elements.resize(space.n_cells());
    table.JxW.reserve(space.n_cells() * quadrature.size());
    table.position.reserve(space.n_cells() * quadrature.size());
    table.parameter.reserve(space.n_cells() * quadrature.size());

    CellEvaluator<dim> evaluator(space, geometry, quadrature.get_points());
    std::vector<dealii::Tensor<2, dim>> jacobians;
    std::vector<unsigned int>           rows;
    for (unsigned int cell = 0; cell < space.n_cells(); ++cell)
      {
        auto &element = table.elements[cell];
        element.cell  = cell;
        rows.resize(
          !wanted || wanted(cell) ? space.cell_functions(cell).size() : 0);
        std::iota(rows.begin(), rows.end(), 0);
        evaluator.evaluate(rows, element, table, jacobians);

        const double       volume = measure(space.cell_box(cell));
        const unsigned int n_a    = rows.size();
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const double determinant =
              checked_determinant(jacobians[q],
                                  table.parameter[element.first_point + q]);
            table.JxW.push_back(determinant * volume * quadrature.weight(q));
            const dealii::Tensor<2, dim> inverse_transposed =
              transpose(invert(jacobians[q]));
            for (unsigned int a = 0; a < n_a; ++a)
              element.gradients[q * n_a + a] =
                inverse_transposed * element.gradients[q * n_a + a];
          }
      }
    return table;
  }



  template <int dim>
  BasisTable<dim>
  tabulate_edge(const SplineSpace<dim>            &space,
                const PatchGeometry<dim>          &geometry,
                const Edge                         edge,
                const dealii::Quadrature<dim - 1> &quadrature,
                const bool                         only_traces)
  {
    BasisTable<dim> table;
    table.points_per_element = quadrature.size();

    CellEvaluator<dim>                  evaluator(space,
                                 geometry,
                                 edge_points<dim>(quadrature, edge));
    std::vector<dealii::Tensor<2, dim>> jacobians;
    const auto                          hierarchy = space.hierarchy();
    for (const unsigned int cell : space.edge_cells(edge))
      {
        table.elements.emplace_back();
        auto &element = table.elements.back();
        element.cell  = cell;
        std::vector<unsigned int> rows(space.cell_functions(cell).size());
        std::iota(rows.begin(), rows.end(), 0);
        if (only_traces)
          rows = trace_rows(*hierarchy, cell, edge);
        evaluator.evaluate(rows, element, table, jacobians);

        const auto [low, high] = space.cell_box(cell);
        const unsigned int n_a = rows.size();
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            checked_determinant(jacobians[q],
                                table.parameter[element.first_point + q]);
            const EdgeFrame<dim> frame(jacobians[q], edge);
            table.normal.push_back(frame.normal);
            table.tangent.insert(table.tangent.end(),
                                 frame.tangents.begin(),
                                 frame.tangents.end());
            double JxW = frame.measure;
            for (const unsigned int d : directions_along<dim>(edge))
              JxW *= high[d] - low[d];
            table.JxW.push_back(JxW * quadrature.weight(q));
            const dealii::Tensor<2, dim> inverse_transposed =
              transpose(invert(jacobians[q]));
            for (unsigned int a = 0; a < n_a; ++a)
              element.gradients[q * n_a + a] = frame.components(
                inverse_transposed * element.gradients[q * n_a + a]);
          }
      }
    return table;
  }



  template std::vector<dealii::Point<2>>
  edge_points<2>(const dealii::Quadrature<1> &, const Edge);
  template struct PatchGeometry<2>;
  template BasisTable<2>
  tabulate_cells(const SplineSpace<2> &,
                 const PatchGeometry<2> &,
                 const dealii::Quadrature<2> &,
                 const std::function<bool(const unsigned int)> &);
  template BasisTable<2>
  tabulate_edge(const SplineSpace<2> &,
                const PatchGeometry<2> &,
                const Edge,
                const dealii::Quadrature<1> &,
                const bool);
  template std::vector<dealii::Point<3>>
  edge_points<3>(const dealii::Quadrature<2> &, const Edge);
  template struct PatchGeometry<3>;
  template BasisTable<3>
  tabulate_cells(const SplineSpace<3> &,
                 const PatchGeometry<3> &,
                 const dealii::Quadrature<3> &,
                 const std::function<bool(const unsigned int)> &);
  template BasisTable<3>
  tabulate_edge(const SplineSpace<3> &,
                const PatchGeometry<3> &,
                const Edge,
                const dealii::Quadrature<2> &,
                const bool);
} // namespace asperity
