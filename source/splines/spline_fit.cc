#include <asperity/base/errors.h>
#include <asperity/splines/banded_solver.h>
#include <asperity/splines/collocation.h>
#include <asperity/splines/spline_fit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    using Row = CollocationRow;



    std::vector<double>
    checked_weights(const FitOptions &options, const unsigned int n_data)
    {
      if (options.weights.empty())
        return std::vector<double>(n_data, 1. / n_data);
      if (options.weights.size() != n_data)
        throw InputError("A spline fit has " +
                         std::to_string(options.weights.size()) +
                         " weights for " + std::to_string(n_data) + " points.");
      double sum = 0.;
      for (const double weight : options.weights)
        {
          if (!(weight > 0.) || !std::isfinite(weight))
            throw InputError("A weight of a spline fit is " +
                             std::to_string(weight) +
                             ", but positive numbers are expected.");
          sum += weight;
        }
      std::vector<double> weights = options.weights;
      for (double &weight : weights)
        weight /= sum;
      return weights;
    }



    FitReport
    make_report(const std::vector<Row>      &rows,
                const std::vector<Point<2>> &control_points)
    {
      FitReport report;
      report.n_control_points = control_points.size();
      double sum              = 0.;
      for (const Row &row : rows)
        {
          const double error = residual(row, control_points).norm();
          report.residuals.push_back(error);
          report.max_error = std::max(report.max_error, error);
          sum += error * error;
        }
      report.rms_error = std::sqrt(sum / rows.size());
      return report;
    }



    /** The data in the order of the functions that they determine, so that the
     *  collocation matrix is banded: sorted by parameter and, in the periodic
     *  case, counted from the function that is largest at the first one. */
    std::vector<unsigned int>
    equation_order(const KnotVector          &knots,
                   const std::vector<double> &parameters,
                   const std::vector<Row>    &rows)
    {
      std::vector<unsigned int> order(rows.size());
      std::iota(order.begin(), order.end(), 0u);
      std::sort(order.begin(),
                order.end(),
                [&](unsigned int a, unsigned int b) {
                  return knots.wrap(parameters[a]) < knots.wrap(parameters[b]);
                });
      if (knots.is_periodic())
        {
          const Row &first = rows[order[0]];
          const auto largest =
            std::max_element(first.values.begin(), first.values.end());
          const unsigned int shift =
            first.functions[largest - first.values.begin()];
          std::rotate(order.begin(), order.end() - shift, order.end());
        }
      return order;
    }



    [[noreturn]] void
    refuse_singular(const std::string &hint)
    {
      throw InputError("The data of a spline fit do not determine the curve: "
                       "some spans hold too few of them; " +
                       hint + ".");
    }
  } // namespace



  SplineFit
  interpolate(const KnotVector            &knot_vector,
              const std::vector<Point<2>> &points,
              const std::vector<double>   &parameters,
              const Tensor<1, 2>          &period)
  {
    const unsigned int n = knot_vector.n_basis();
    if (points.size() != n || parameters.size() != n)
      throw InputError("Interpolation with " + std::to_string(n) +
                       " functions has " + std::to_string(points.size()) +
                       " points, but as many are expected.");
    const std::vector<Row> rows =
      collocation(knot_vector, points, parameters, period);

    // In the periodic case a datum may be one function away from its own.
    const unsigned int bandwidth =
      knot_vector.degree() + (knot_vector.is_periodic() ? 1 : 0);
    BandedSolver solver(n, bandwidth, knot_vector.is_periodic());
    std::array<std::vector<double>, 2> right_hand_sides;
    for (auto &right_hand_side : right_hand_sides)
      right_hand_side.resize(n);
    const std::vector<unsigned int> order =
      equation_order(knot_vector, parameters, rows);
    for (unsigned int i = 0; i < n; ++i)
      {
        const Row &row = rows[order[i]];
        for (unsigned int j = 0; j < row.functions.size(); ++j)
          {
            const unsigned int function = row.functions[j];
            unsigned int offset = std::max(function, i) - std::min(function, i);
            if (knot_vector.is_periodic())
              offset = std::min(offset, n - offset);
            if (offset <= bandwidth)
              solver.add(i, function, row.values[j]);
            else if (row.values[j] != 0.)
              refuse_singular("spread them as the Greville points are");
          }
        for (unsigned int d = 0; d < 2; ++d)
          right_hand_sides[d][i] = row.target[d];
      }
    if (!solver.factorize())
      refuse_singular("spread them as the Greville points are");

    std::vector<Point<2>> control_points(n);
    for (unsigned int d = 0; d < 2; ++d)
      {
        solver.solve(right_hand_sides[d]);
        for (unsigned int i = 0; i < n; ++i)
          control_points[i][d] = right_hand_sides[d][i];
      }
    return {SplineCurve(knot_vector, control_points, {}, period),
            make_report(rows, control_points)};
  }



  SplineFit
  interpolate(const std::vector<Point<2>> &points, const unsigned int degree)
  {
    const std::vector<double> parameters = chord_parameters(points);
    return interpolate(averaged_knots(parameters, degree), points, parameters);
  }



  namespace
  {
    /**
     * Normal equations square the condition number; two corrections with the
     * residual of the data themselves recover the accuracy of a QR solution.
     * @param ends fixed first and last control point, or null pointers
     */
    std::vector<Point<2>>
    solve_least_squares(const BandedSolver        &matrix,
                        const std::vector<Row>    &rows,
                        const std::vector<double> &weights,
                        const unsigned int         n,
                        const Point<2> *const      ends[2])
    {
      std::vector<Point<2>> control_points(n);
      for (unsigned int correction = 0; correction < 3; ++correction)
        {
          std::array<std::vector<double>, 2> right_hand_sides;
          for (auto &right_hand_side : right_hand_sides)
            right_hand_side.resize(n);
          for (unsigned int i = 0; i < rows.size(); ++i)
            {
              const Tensor<1, 2> r = residual(rows[i], control_points);
              for (unsigned int a = 0; a < rows[i].functions.size(); ++a)
                for (unsigned int d = 0; d < 2; ++d)
                  right_hand_sides[d][rows[i].functions[a]] +=
                    weights[i] * rows[i].values[a] * r[d];
            }
          for (unsigned int d = 0; d < 2; ++d)
            {
              if (ends[0] != nullptr)
                right_hand_sides[d][0] = (*ends[0])[d] - control_points[0][d];
              if (ends[1] != nullptr)
                right_hand_sides[d][n - 1] =
                  (*ends[1])[d] - control_points[n - 1][d];
              matrix.solve(right_hand_sides[d]);
              for (unsigned int i = 0; i < n; ++i)
                control_points[i][d] += right_hand_sides[d][i];
            }
        }
      return control_points;
    }
  } // namespace



  SplineFit
  fit_least_squares(const KnotVector            &knot_vector,
                    const std::vector<Point<2>> &points,
                    const std::vector<double>   &parameters,
                    const FitOptions            &options)
  {
    const unsigned int  n        = knot_vector.n_basis();
    const bool          periodic = knot_vector.is_periodic();
    std::vector<double> weights  = checked_weights(options, points.size());
    std::vector<Row>    rows =
      collocation(knot_vector, points, parameters, options.period);
    const std::vector<Row> data = rows;
    if (options.bending > 0.)
      {
        const auto bending =
          bending_rows(knot_vector, options.bending, options.period, weights);
        rows.insert(rows.end(), bending.begin(), bending.end());
      }

    BandedSolver matrix   = normal_equations(knot_vector, rows, weights);
    const bool   fix_ends = options.interpolate_ends && !periodic;
    if (fix_ends)
      {
        matrix.set_identity_row(0);
        matrix.set_identity_row(n - 1);
      }
    if (!matrix.factorize())
      refuse_singular("take fewer spans or a bending term");

    const Point<2> *ends[2] = {fix_ends ? &points.front() : nullptr,
                               fix_ends ? &points.back() : nullptr};
    const std::vector<Point<2>> control_points =
      solve_least_squares(matrix, rows, weights, n, ends);
    return {SplineCurve(knot_vector, control_points, {}, options.period),
            make_report(data, control_points)};
  }
} // namespace asperity
