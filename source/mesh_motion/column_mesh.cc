#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/mesh_motion/column_mesh.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** Values and the means of neighbours between them. */
    std::vector<double>
    with_middles(const std::vector<double> &values)
    {
      std::vector<double> result;
      for (unsigned int i = 0; i + 1 < values.size(); ++i)
        {
          result.push_back(values[i]);
          result.push_back(0.5 * (values[i] + values[i + 1]));
        }
      result.push_back(values.back());
      return result;
    }



    bool
    increases(const std::vector<double> &values)
    {
      for (unsigned int i = 1; i < values.size(); ++i)
        if (!(values[i] > values[i - 1]))
          return false;
      return values.size() >= 2;
    }



    /** Smallest slope of the quadratic through three equidistant values; it is
     *  linear, so it lies at an end. */
    double
    smallest_slope(const double *x)
    {
      return std::min(-3. * x[0] + 4. * x[1] - x[2],
                      x[0] - 4. * x[1] + 3. * x[2]);
    }



    /**
     * The smallest middle value with which the quadratic through h0, ., h2 is
     * nowhere below m, for h0, h2 >= m. In Bernstein form with the coefficients
     * m + a, m + b, m + c the minimum is m if b = -sqrt(a c).
     */
    double
    smallest_middle(const double h0, const double h2, const double m)
    {
      const double a = h0 - m, c = h2 - m;
      return m + 0.25 * (a - 2. * std::sqrt(a * c) + c);
    }
  } // namespace



  struct ColumnMesh::Columns
  {
    std::vector<Point<2>> chip; ///< lowest nodes
    std::vector<double>   gap;
  };



  ColumnMesh::ColumnMesh(const SplineCurve  &chip,
                         const SplineCurve  &tool_curve,
                         const ColumnLayout &column_layout)
    : tool(tool_curve)
    , layout(column_layout)
    , period(chip.period()[0])
    , node_parameters(with_middles(layout.columns))
    , node_heights(with_middles(layout.rows))
  {
    if (!chip.is_periodic() || !tool.is_periodic() || !(period > 0.) ||
        std::abs(tool.period()[0] - period) > 1e-10 * period)
      throw InputError("A column mesh lies between two periodic curves of one "
                       "period along x, but the periods are " +
                       format_number(period) + " m and " +
                       format_number(tool.period()[0]) + " m.");
    for (const double x : tool.knot_vector().breakpoints())
      if (std::abs(tool.value(x)[0] - x) > 1e-10 * period)
        throw InputError("The tool above a column mesh must be a graph whose "
                         "parameter is x, but at the parameter " +
                         format_number(x) + " its x is " +
                         format_number(tool.value(x)[0]) + ".");
    const KnotVector &knots = chip.knot_vector();
    const double      turn  = knots.back() - knots.front();
    if (!increases(layout.columns) ||
        std::abs(layout.columns.back() - layout.columns.front() - turn) >
          1e-10 * turn)
      throw InputError("The columns of a mesh must increase over one period of "
                       "the chip's edge, " +
                       format_number(turn) + ".");
    if (!increases(layout.rows) || layout.rows.front() != 0. ||
        layout.rows.back() != 1.)
      throw InputError("The rows of a column mesh must increase from 0 to 1.");
    if (!(layout.residual_film > 0.))
      throw InputError("The residual film of a column mesh is " +
                       format_number(layout.residual_film) +
                       " m, but must be positive.");
    make_rectangle();
    number_nodes();
  }



  void
  ColumnMesh::make_rectangle()
  {
    // Nearly square cells, one period long.
    const unsigned int  n_columns = layout.columns.size() - 1;
    const unsigned int  n_rows    = layout.rows.size() - 1;
    const double        height    = period * n_rows / n_columns;
    const double        first     = layout.columns.front();
    const double        turn      = layout.columns.back() - first;
    std::vector<double> x, y;
    for (const double s : layout.columns)
      x.push_back(period * ((s - first) / turn));
    for (const double eta : layout.rows)
      y.push_back(height * eta);
    std::vector<std::vector<double>> steps(2);
    for (unsigned int i = 0; i < n_columns; ++i)
      steps[0].push_back(x[i + 1] - x[i]);
    for (unsigned int j = 0; j < n_rows; ++j)
      steps[1].push_back(y[j + 1] - y[j]);
    dealii::GridGenerator::subdivided_hyper_rectangle(
      mesh, steps, Point<2>(), Point<2>(x.back(), y.back()), true);
    reference_x = with_middles(x);
    reference_y = with_middles(y);
  }



  void
  ColumnMesh::number_nodes()
  {
    const dealii::FESystem<2> fe(dealii::FE_Q<2>(2), 2);
    dof_handler.reinit(mesh);
    dof_handler.distribute_dofs(fe);
    displacement_.reinit(dof_handler.n_dofs());
    lift_.assign(reference_x.size(), 0.);

    const auto nearest = [](const std::vector<double> &values,
                            const double               value) {
      const auto above = std::lower_bound(values.begin(), values.end(), value);
      if (above == values.begin())
        return above - values.begin();
      const bool below =
        above == values.end() || value - *(above - 1) < *above - value;
      return above - values.begin() - below;
    };
    std::vector<Point<2>> points(dof_handler.n_dofs());
    dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<2>(),
                                                 dof_handler,
                                                 points);
    const unsigned int n_rows = reference_y.size();
    node_dofs.resize(reference_x.size() * n_rows);
    std::vector<dealii::types::global_dof_index> local(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(local);
        for (unsigned int k = 0; k < local.size(); ++k)
          {
            const Point<2> &X = points[local[k]];
            auto &node        = node_dofs[nearest(reference_x, X[0]) * n_rows +
                                   nearest(reference_y, X[1])];
            (fe.system_to_component_index(k).first == 0 ? node.first :
                                                          node.second) =
              local[k];
          }
      }
    column_of_cell_.resize(mesh.n_active_cells());
    for (const auto &cell : mesh.active_cell_iterators())
      column_of_cell_[cell->active_cell_index()] =
        nearest(reference_x, cell->center()[0]) / 2;
    for (unsigned int i = 0; i < reference_x.size(); ++i)
      {
        const auto &below = node_dofs[i * n_rows];
        const auto &above = node_dofs[i * n_rows + n_rows - 1];
        chip_wall_nodes.push_back(
          {node_parameters[i], below.first, below.second});
        tool_wall_nodes.push_back(
          {node_parameters[i], above.first, above.second});
      }
  }



  ConvergenceReport
  ColumnMesh::update(const SplineCurve &chip, const Tensor<1, 2> &tool_shift)
  {
    Columns           columns = measure(chip, tool_shift);
    ConvergenceReport report;
    for (unsigned int i = 0; i + 2 < columns.chip.size(); i += 2)
      {
        const double x[] = {columns.chip[i][0],
                            columns.chip[i + 1][0],
                            columns.chip[i + 2][0]};
        if (!(smallest_slope(x) > 0.))
          {
            report.reason = "the chip's edge is no graph over x near x = " +
                            format_number(x[1]) + " m";
            return report;
          }
      }
    const std::vector<double> true_gap = columns.gap;
    lift_to_residual_film(columns);
    place_nodes(columns);
    report_film(columns, true_gap);
    report.converged = true;
    return report;
  }



  ColumnMesh::Columns
  ColumnMesh::measure(const SplineCurve  &chip,
                      const Tensor<1, 2> &tool_shift) const
  {
    Columns columns;
    for (const double s : node_parameters)
      {
        columns.chip.push_back(chip.value(s));
        const double x = columns.chip.back()[0] - tool_shift[0];
        columns.gap.push_back(tool.value(x)[1] + tool_shift[1] -
                              columns.chip.back()[1]);
      }
    // The two sides are one to the last bit.
    columns.chip.back() = columns.chip.front() + Point<2>(period, 0.);
    columns.gap.back()  = columns.gap.front();
    return columns;
  }



  void
  ColumnMesh::lift_to_residual_film(Columns &columns) const
  {
    const double         m   = layout.residual_film;
    std::vector<double> &gap = columns.gap;
    for (unsigned int i = 0; i < gap.size(); i += 2)
      gap[i] = std::max(gap[i], m);
    for (unsigned int i = 1; i < gap.size(); i += 2)
      gap[i] = std::max(gap[i], smallest_middle(gap[i - 1], gap[i + 1], m));
  }



  void
  ColumnMesh::place_nodes(const Columns &columns)
  {
    const unsigned int n_rows = reference_y.size();
    for (unsigned int i = 0; i < reference_x.size(); ++i)
      for (unsigned int j = 0; j < n_rows; ++j)
        {
          const auto &[dof_x, dof_y] = node_dofs[i * n_rows + j];
          displacement_(dof_x)       = columns.chip[i][0] - reference_x[i];
          displacement_(dof_y)       = columns.chip[i][1] +
                                 node_heights[j] * columns.gap[i] -
                                 reference_y[j];
        }
  }



  void
  ColumnMesh::report_film(const Columns             &columns,
                          const std::vector<double> &true_gap)
  {
    film_              = Film();
    film_.smallest_gap = *std::min_element(true_gap.begin(), true_gap.end());
    for (unsigned int i = 0; i < true_gap.size(); ++i)
      {
        lift_[i]           = columns.gap[i] - true_gap[i];
        film_.largest_lift = std::max(film_.largest_lift, lift_[i]);
      }
    smallest_gaps_.clear();
    for (unsigned int i = 0; i + 2 < true_gap.size(); i += 2)
      {
        smallest_gaps_.push_back(
          std::min({true_gap[i], true_gap[i + 1], true_gap[i + 2]}));
        // Simpson's rule
        const double lifted =
          (lift_[i] > 0.) + 4. * (lift_[i + 1] > 0.) + (lift_[i + 2] > 0.);
        film_.fraction +=
          lifted / 6. * (columns.chip[i + 2][0] - columns.chip[i][0]) / period;
      }
  }
} // namespace asperity
