#include <asperity/base/errors.h>
#include <asperity/splines/collocation.h>
#include <asperity/splines/grid_lines.h>
#include <asperity/splines/sheet_fit.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** Wrapped least squares of equidistant values along one direction, for any
     *  number of lines. */
    class LineFit
    {
    public:
      LineFit(const KnotVector  &knots,
              const unsigned int n_data,
              const double       bending)
        : n_functions(knots.n_basis())
        , n_data(n_data)
        , rows(data_rows(knots, n_data))
        , weights(n_data, 1. / n_data)
        , matrix(penalised_equations(knots, bending))
      {
        if (!matrix.factorize())
          throw InputError("The " + std::to_string(n_data) +
                           " heights along one direction of a sheet do not "
                           "determine its " +
                           std::to_string(knots.n_spans()) +
                           " spans of degree " +
                           std::to_string(knots.degree()) +
                           "; take fewer spans or a bending term.");
      }

      /** Normal equations square the condition number; two corrections with
       *  the residual of the data themselves recover the accuracy. */
      std::vector<double>
      coefficients(const std::vector<double> &data) const
      {
        std::vector<double> result(n_functions);
        for (unsigned int correction = 0; correction < 3; ++correction)
          {
            std::vector<double> right_hand_side(n_functions);
            for (unsigned int i = 0; i < rows.size(); ++i)
              {
                const double residual =
                  (i < n_data ? data[i] : 0.) - value(rows[i], result);
                for (unsigned int a = 0; a < rows[i].functions.size(); ++a)
                  right_hand_side[rows[i].functions[a]] +=
                    weights[i] * rows[i].values[a] * residual;
              }
            matrix.solve(right_hand_side);
            for (unsigned int a = 0; a < n_functions; ++a)
              result[a] += right_hand_side[a];
          }
        return result;
      }

      /** The spline where the data are. */
      std::vector<double>
      values(const std::vector<double> &coefficients) const
      {
        std::vector<double> result(n_data);
        for (unsigned int i = 0; i < n_data; ++i)
          result[i] = value(rows[i], coefficients);
        return result;
      }

    private:
      static std::vector<CollocationRow>
      data_rows(const KnotVector &knots, const unsigned int n_data)
      {
        std::vector<double> places(n_data);
        for (unsigned int i = 0; i < n_data; ++i)
          places[i] =
            knots.front() + (knots.back() - knots.front()) * i / n_data;
        return collocation(knots,
                           std::vector<Point<2>>(n_data),
                           places,
                           Tensor<1, 2>());
      }

      BandedSolver
      penalised_equations(const KnotVector &knots, const double bending)
      {
        if (bending > 0.)
          {
            const auto further =
              bending_rows(knots, bending, Tensor<1, 2>(), weights);
            rows.insert(rows.end(), further.begin(), further.end());
          }
        return normal_equations(knots, rows, weights);
      }

      static double
      value(const CollocationRow &row, const std::vector<double> &coefficients)
      {
        double sum = 0.;
        for (unsigned int a = 0; a < row.functions.size(); ++a)
          sum += row.values[a] * coefficients[row.functions[a]];
        return sum;
      }

      const unsigned int          n_functions, n_data;
      std::vector<CollocationRow> rows; // of the data, then of bending
      std::vector<double>         weights;
      BandedSolver                matrix;
    };



    void
    check_data(const PeriodicHeights &data)
    {
      const std::size_t n = std::size_t(data.n[0]) * data.n[1];
      if (n == 0 || data.heights.size() != n)
        throw InputError("A grid of " + std::to_string(data.n[0]) + " x " +
                         std::to_string(data.n[1]) + " samples has " +
                         std::to_string(data.heights.size()) +
                         " heights, but one each is expected.");
      for (std::size_t i = 0; i < n; ++i)
        if (!std::isfinite(data.heights[i]))
          throw InputError("Height " + std::to_string(i) +
                           " of a periodic grid is not a finite number.");
    }



    FitReport
    make_report(const PeriodicHeights     &data,
                const std::vector<double> &fitted,
                const std::size_t          n_coefficients)
    {
      FitReport report;
      report.n_control_points = n_coefficients;
      double sum              = 0.;
      for (std::size_t i = 0; i < fitted.size(); ++i)
        {
          const double error = std::abs(fitted[i] - data.heights[i]);
          report.residuals.push_back(error);
          report.max_error = std::max(report.max_error, error);
          sum += error * error;
        }
      report.rms_error = std::sqrt(sum / fitted.size());
      return report;
    }
  } // namespace



  SheetFit
  fit_periodic_sheet(const PeriodicHeights             &data,
                     const std::array<unsigned int, 2> &n_spans,
                     const unsigned int                 degree,
                     const double                       bending)
  {
    check_data(data);
    const auto knots = [&](const unsigned int d) {
      return KnotVector::uniform_periodic(degree,
                                          n_spans[d],
                                          0.,
                                          data.period[d]);
    };
    const std::array<KnotVector, 2> knot_vectors = {{knots(0), knots(1)}};
    const std::array<LineFit, 2>    fits         = {
                 {LineFit(knot_vectors[0], data.n[0], bending),
                  LineFit(knot_vectors[1], data.n[1], bending)}};

    std::vector<double> coefficients = data.heights;
    for (unsigned int d = 0; d < 2; ++d)
      coefficients = map_lines(d,
                               d == 0 ? data.n[0] : n_spans[0],
                               coefficients,
                               [&](const std::vector<double> &line) {
                                 return fits[d].coefficients(line);
                               });
    std::vector<double> fitted = coefficients;
    for (unsigned int d = 0; d < 2; ++d)
      fitted = map_lines(d,
                         d == 0 ? n_spans[0] : data.n[0],
                         fitted,
                         [&](const std::vector<double> &line) {
                           return fits[d].values(line);
                         });
    return {SplineSheet(knot_vectors, coefficients),
            make_report(data, fitted, coefficients.size())};
  }



  SheetFit
  interpolate_periodic_sheet(const PeriodicHeights &data,
                             const unsigned int     degree)
  {
    const unsigned int fewest = std::min(data.n[0], data.n[1]);
    if (degree % 2 == 0 || fewest < 2 * degree + 2)
      throw InputError("A grid of " + std::to_string(data.n[0]) + " x " +
                       std::to_string(data.n[1]) +
                       " heights cannot be interpolated by a periodic spline "
                       "of degree " +
                       std::to_string(degree) +
                       "; expected an odd degree p and at least 2 p + 2 "
                       "heights in each direction.");
    return fit_periodic_sheet(data, data.n, degree);
  }
} // namespace asperity
