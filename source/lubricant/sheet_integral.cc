#include <asperity/lubricant/sheet_integral.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace asperity
{
  namespace
  {
    /** Integrals of the functions of a span from its beginning to x [m], by a
     *  rule that is exact for their degree. */
    std::vector<double>
    integrals_of_functions(const KnotVector  &knots,
                           const unsigned int span,
                           const double       x)
    {
      const dealii::QGauss<1> gauss(knots.degree() / 2 + 1);
      const double            begin = knots.breakpoints()[span];
      std::vector<double>     sum(knots.degree() + 1, 0.);
      for (unsigned int q = 0; q < gauss.size(); ++q)
        {
          const double at    = begin + (x - begin) * gauss.point(q)[0];
          const auto   basis = knots.evaluate(span, at, 0);
          for (unsigned int a = 0; a < sum.size(); ++a)
            sum[a] += gauss.weight(q) * (x - begin) * basis[0][a];
        }
      return sum;
    }
  } // namespace



  SheetIntegral::SheetIntegral(const SplineSheet &sheet)
    : sheet(sheet)
    , cumulative(sheet.knot_vector(1).n_basis(), std::vector<double>(1, 0.))
  {
    const KnotVector &knots = sheet.knot_vector(0);
    for (unsigned int span = 0; span < knots.n_spans(); ++span)
      {
        const auto functions = knots.span_functions(span);
        const auto integrals =
          integrals_of_functions(knots, span, knots.breakpoints()[span + 1]);
        for (unsigned int b = 0; b < cumulative.size(); ++b)
          {
            double sum = cumulative[b].back();
            for (unsigned int a = 0; a < functions.size(); ++a)
              sum += integrals[a] *
                     sheet.coefficients()[b * knots.n_basis() + functions[a]];
            cumulative[b].push_back(sum);
          }
      }
  }



  template <typename Row>
  SheetIntegral::Values
  SheetIntegral::across(const double y, const Row &integral_of_row) const
  {
    const KnotVector  &knots     = sheet.knot_vector(1);
    const double       wrapped   = knots.wrap(y);
    const unsigned int span      = knots.find_span(wrapped);
    const auto         functions = knots.span_functions(span);
    const auto         basis     = knots.evaluate(span, wrapped, 2);
    Values             values;
    for (unsigned int b = 0; b < functions.size(); ++b)
      {
        const double r = integral_of_row(functions[b]);
        values.P += basis[0][b] * r;
        values.P_y += basis[1][b] * r;
        values.P_yy += basis[2][b] * r;
      }
    return values;
  }



  SheetIntegral::Values
  SheetIntegral::at(const dealii::Point<2> &place) const
  {
    const KnotVector  &knots     = sheet.knot_vector(0);
    const double       x         = knots.wrap(place[0]);
    const double       turns     = std::round((place[0] - x) / sheet.period(0));
    const unsigned int span      = knots.find_span(x);
    const auto         functions = knots.span_functions(span);
    const auto         integrals = integrals_of_functions(knots, span, x);
    return across(place[1], [&](const unsigned int row) {
      double sum = cumulative[row][span] + turns * cumulative[row].back();
      for (unsigned int a = 0; a < functions.size(); ++a)
        sum += integrals[a] *
               sheet.coefficients()[row * knots.n_basis() + functions[a]];
      return sum;
    });
  }



  SheetIntegral::Values
  SheetIntegral::over_period(const double y) const
  {
    return across(y, [&](const unsigned int row) {
      return cumulative[row].back();
    });
  }
} // namespace asperity
