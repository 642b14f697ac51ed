#include <asperity/base/errors.h>
#include <asperity/splines/collocation.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <string>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  std::vector<CollocationRow>
  collocation(const KnotVector            &knots,
              const std::vector<Point<2>> &points,
              const std::vector<double>   &parameters,
              const Tensor<1, 2>          &period)
  {
    if (points.size() != parameters.size())
      throw InputError("A spline fit has " + std::to_string(points.size()) +
                       " points and " + std::to_string(parameters.size()) +
                       " parameters, but as many of each are expected.");
    const double                length = knots.back() - knots.front();
    std::vector<CollocationRow> rows(points.size());
    for (unsigned int i = 0; i < rows.size(); ++i)
      {
        if (!std::isfinite(points[i][0]) || !std::isfinite(points[i][1]) ||
            !std::isfinite(parameters[i]))
          throw InputError("Datum " + std::to_string(i) +
                           " of a spline fit is not a finite number.");
        const double       t    = knots.wrap(parameters[i]);
        const unsigned int span = knots.find_span(t);
        rows[i].functions       = knots.span_functions(span);
        rows[i].values          = knots.evaluate(span, t)[0];
        rows[i].target          = points[i];
        if (!knots.is_periodic())
          continue;
        rows[i].target -= std::round((parameters[i] - t) / length) * period;
        for (unsigned int j = 0; j <= knots.degree(); ++j)
          if (knots.is_wrapped(span, j))
            rows[i].target -= rows[i].values[j] * period;
      }
    return rows;
  }



  std::vector<CollocationRow>
  bending_rows(const KnotVector    &knots,
               const double         bending,
               const Tensor<1, 2>  &period,
               std::vector<double> &weights)
  {
    std::vector<CollocationRow> rows;
    const dealii::QGauss<1>     quadrature(knots.degree());
    for (unsigned int span = 0; span < knots.n_spans(); ++span)
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          const double   begin = knots.breakpoints()[span];
          const double   width = knots.breakpoints()[span + 1] - begin;
          CollocationRow row;
          row.functions = knots.span_functions(span);
          row.values =
            knots.evaluate(span, begin + quadrature.point(q)[0] * width, 2)[2];
          for (unsigned int j = 0; j <= knots.degree(); ++j)
            if (knots.is_wrapped(span, j))
              row.target -= row.values[j] * period;
          rows.push_back(row);
          weights.push_back(bending * width * quadrature.weight(q));
        }
    return rows;
  }



  BandedSolver
  normal_equations(const KnotVector                  &knots,
                   const std::vector<CollocationRow> &rows,
                   const std::vector<double>         &weights)
  {
    BandedSolver matrix(knots.n_basis(), knots.degree(), knots.is_periodic());
    for (unsigned int i = 0; i < rows.size(); ++i)
      for (unsigned int a = 0; a < rows[i].functions.size(); ++a)
        for (unsigned int b = 0; b < rows[i].functions.size(); ++b)
          matrix.add(rows[i].functions[a],
                     rows[i].functions[b],
                     weights[i] * rows[i].values[a] * rows[i].values[b]);
    return matrix;
  }



  Tensor<1, 2>
  residual(const CollocationRow        &row,
           const std::vector<Point<2>> &control_points)
  {
    Tensor<1, 2> result = row.target;
    for (unsigned int j = 0; j < row.functions.size(); ++j)
      result -= row.values[j] * control_points[row.functions[j]];
    return result;
  }
} // namespace asperity
