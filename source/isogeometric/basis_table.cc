#include <asperity/base/errors.h>
#include <asperity/isogeometric/basis_table.h>
#include <asperity/isogeometric/bernstein.h>
#include <asperity/isogeometric/l2_projection.h>
#include <asperity/isogeometric/spline_space.h>

#include <numeric>
#include <string>

namespace asperity
{
  std::vector<dealii::Point<2>>
  edge_points(const dealii::Quadrature<1> &quadrature, const Edge edge)
  {
    std::vector<dealii::Point<2>> points;
    for (const auto &point : quadrature.get_points())
      switch (edge)
        {
          case Edge::left:
            points.emplace_back(0., point[0]);
            break;
          case Edge::right:
            points.emplace_back(1., point[0]);
            break;
          case Edge::bottom:
            points.emplace_back(point[0], 0.);
            break;
          case Edge::top:
            points.emplace_back(point[0], 1.);
            break;
        }
    return points;
  }



  PatchGeometry
  PatchGeometry::from_map(
    const SplineSpace                                               &space,
    const std::function<dealii::Point<2>(const dealii::Point<2> &)> &map)
  {
    const auto coefficients = space.project(
      [&map](const dealii::Point<2> &parameter) {
        const auto offset = map(parameter) - parameter;
        return std::vector<double>{offset[0], offset[1]};
      },
      2);
    PatchGeometry geometry;
    geometry.offset.resize(space.n_functions());
    for (unsigned int a = 0; a < space.n_functions(); ++a)
      for (unsigned int d = 0; d < 2; ++d)
        geometry.offset[a][d] = coefficients[d][a];
    return geometry;
  }



  dealii::Point<2>
  PatchGeometry::position(const SplineSpace      &space,
                          const dealii::Point<2> &parameter) const
  {
    dealii::Point<2> X = parameter;
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
    /** Values and gradients of a cell's functions at points of the unit square
     *  that are common to all cells. */
    class CellEvaluator
    {
    public:
      CellEvaluator(const SplineSpace            &space,
                    const PatchGeometry          &geometry,
                    std::vector<dealii::Point<2>> points)
        : space(space)
        , geometry(geometry)
        , points(std::move(points))
        , bernstein(space.degree(), this->points)
      {}

      /** Fills the element, positions and parameters; `jacobians` gets
       *  dX/dxi at the points. Gradients are parametric after this. */
      void
      evaluate(const std::vector<unsigned int>   &rows,
               BasisTable::Element               &element,
               BasisTable                        &table,
               std::vector<dealii::Tensor<2, 2>> &jacobians)
      {
        const auto &all_functions = space.cell_functions(element.cell);
        element.first_point       = table.position.size();
        element.functions.clear();
        for (const unsigned int row : rows)
          element.functions.push_back(all_functions[row]);
        fill(rows, element);

        // The geometry needs all functions, which may be more than the rows.
        const auto [low, high] = space.cell_box(element.cell);
        jacobians.assign(points.size(), dealii::Tensor<2, 2>());
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            dealii::Point<2> parameter;
            for (unsigned int d = 0; d < 2; ++d)
              {
                parameter[d]       = low[d] + points[q][d] * (high[d] - low[d]);
                jacobians[q][d][d] = 1.;
              }
            table.parameter.push_back(parameter);
            table.position.push_back(parameter);
          }
        if (!geometry.offset.empty())
          add_offset(element, table, jacobians);
      }

    private:
      void
      fill(const std::vector<unsigned int> &rows,
           BasisTable::Element             &element) const
      {
        const auto         &extraction = space.cell_extraction(element.cell);
        const auto          box        = space.cell_box(element.cell);
        const unsigned int  n_a        = rows.size();
        const unsigned int  n_b        = extraction.n();
        const double        scale_x    = 1. / (box.second[0] - box.first[0]);
        const double        scale_y    = 1. / (box.second[1] - box.first[1]);
        std::vector<double> transposed(n_b * n_a);
        for (unsigned int a = 0; a < n_a; ++a)
          for (unsigned int b = 0; b < n_b; ++b)
            transposed[b * n_a + a] = extraction(rows[a], b);

        std::vector<double> N(n_a), N_x(n_a), N_y(n_a);
        element.values.resize(points.size() * n_a);
        element.gradients.resize(points.size() * n_a);
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            std::fill(N.begin(), N.end(), 0.);
            std::fill(N_x.begin(), N_x.end(), 0.);
            std::fill(N_y.begin(), N_y.end(), 0.);
            for (unsigned int b = 0; b < n_b; ++b)
              {
                const double  B   = bernstein.values[q][b];
                const double  B_x = bernstein.gradients[q][b][0] * scale_x;
                const double  B_y = bernstein.gradients[q][b][1] * scale_y;
                const double *row = &transposed[b * n_a];
                for (unsigned int a = 0; a < n_a; ++a)
                  {
                    N[a] += B * row[a];
                    N_x[a] += B_x * row[a];
                    N_y[a] += B_y * row[a];
                  }
              }
            for (unsigned int a = 0; a < n_a; ++a)
              {
                element.values[q * n_a + a]       = N[a];
                element.gradients[q * n_a + a][0] = N_x[a];
                element.gradients[q * n_a + a][1] = N_y[a];
              }
          }
      }

      void
      add_offset(const BasisTable::Element         &element,
                 BasisTable                        &table,
                 std::vector<dealii::Tensor<2, 2>> &jacobians)
      {
        const BasisTable::Element *full = &element;
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

      const SplineSpace                  &space;
      const PatchGeometry                &geometry;
      const std::vector<dealii::Point<2>> points;
      const BernsteinTable                bernstein;
      BasisTable::Element                 complete;
    };



    double
    checked_determinant(const dealii::Tensor<2, 2> &jacobian,
                        const dealii::Point<2>     &parameter)
    {
      const double determinant = dealii::determinant(jacobian);
      if (!(determinant > 0.))
        throw ComputationError(
          "The reference geometry folds at parameter (" +
          std::to_string(parameter[0]) + ", " + std::to_string(parameter[1]) +
          "): the determinant of its gradient is " +
          std::to_string(determinant) + ", a positive value is needed.");
      return determinant;
    }
  } // namespace



  BasisTable
  tabulate_cells(const SplineSpace           &space,
                 const PatchGeometry         &geometry,
                 const dealii::Quadrature<2> &quadrature)
  {
    BasisTable table;
    table.points_per_element = quadrature.size();
    table.elements.resize(space.n_cells());
    table.JxW.reserve(space.n_cells() * quadrature.size());
    table.position.reserve(space.n_cells() * quadrature.size());
    table.parameter.reserve(space.n_cells() * quadrature.size());

    CellEvaluator evaluator(space, geometry, quadrature.get_points());
    std::vector<dealii::Tensor<2, 2>> jacobians;
    std::vector<unsigned int>         rows;
    for (unsigned int cell = 0; cell < space.n_cells(); ++cell)
      {
        auto &element = table.elements[cell];
        element.cell  = cell;
        rows.resize(space.cell_functions(cell).size());
        std::iota(rows.begin(), rows.end(), 0);
        evaluator.evaluate(rows, element, table, jacobians);

        const auto [low, high]  = space.cell_box(cell);
        const double       area = (high[0] - low[0]) * (high[1] - low[1]);
        const unsigned int n_a  = rows.size();
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const double determinant =
              checked_determinant(jacobians[q],
                                  table.parameter[element.first_point + q]);
            table.JxW.push_back(determinant * area * quadrature.weight(q));
            const dealii::Tensor<2, 2> inverse_transposed =
              transpose(invert(jacobians[q]));
            for (unsigned int a = 0; a < n_a; ++a)
              element.gradients[q * n_a + a] =
                inverse_transposed * element.gradients[q * n_a + a];
          }
      }
    return table;
  }



  BasisTable
  tabulate_edge(const SplineSpace           &space,
                const PatchGeometry         &geometry,
                const Edge                   edge,
                const dealii::Quadrature<1> &quadrature,
                const bool                   only_traces)
  {
    BasisTable table;
    table.points_per_element = quadrature.size();

    // Turning the direction of increasing parameter to the right gives the
    // outward normal on bottom and right, the inward one on top and left.
    const unsigned int along =
      (edge == Edge::left || edge == Edge::right) ? 1 : 0;
    const double outward =
      (edge == Edge::bottom || edge == Edge::right) ? 1. : -1.;
    CellEvaluator evaluator(space, geometry, edge_points(quadrature, edge));
    std::vector<dealii::Tensor<2, 2>> jacobians;
    const auto                        hierarchy = space.hierarchy();
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
            dealii::Tensor<1, 2> tangent;
            for (unsigned int d = 0; d < 2; ++d)
              tangent[d] = jacobians[q][d][along];
            const double length = tangent.norm();
            tangent /= length;
            dealii::Tensor<1, 2> normal;
            normal[0] = outward * tangent[1];
            normal[1] = -outward * tangent[0];
            table.normal.push_back(normal);
            table.tangent.push_back(tangent);
            table.JxW.push_back(length * (high[along] - low[along]) *
                                quadrature.weight(q));
            const dealii::Tensor<2, 2> inverse_transposed =
              transpose(invert(jacobians[q]));
            for (unsigned int a = 0; a < n_a; ++a)
              {
                const dealii::Tensor<1, 2> gradient =
                  inverse_transposed * element.gradients[q * n_a + a];
                element.gradients[q * n_a + a][0] = gradient * tangent;
                element.gradients[q * n_a + a][1] = gradient * normal;
              }
          }
      }
    return table;
  }
} // namespace asperity
