#include <asperity/base/errors.h>
#include <asperity/splines/curve_pieces.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity
{
  namespace
  {
    /** Coefficients of powers of s in [-1, 1] of one component from those of
     * the Bernstein polynomials on [0, 1]: subdivision at the middle gives the
     *  derivatives there as forward differences. */
    void
    powers_from_bernstein(const double      *bernstein,
                          const unsigned int p,
                          double            *powers)
    {
      std::vector<double> right(p + 1);
      for (unsigned int i = 0; i <= p; ++i)
        right[i] = bernstein[3 * i];
      for (unsigned int k = 0; k < p; ++k)
        for (unsigned int i = 0; i < p - k; ++i)
          right[i] = (right[i] + right[i + 1]) / 2.;
      // right[i] now holds the i-th coefficient on [1/2, 1], which s maps to
      // [0, 1]: the k-th derivative over k! is binomial(p, k) Delta^k.
      double binomial = 1.;
      for (unsigned int k = 0; k <= p; ++k)
        {
          powers[3 * k] = binomial * right[0];
          for (unsigned int i = 0; i + k < p; ++i)
            right[i] = right[i + 1] - right[i];
          binomial *= double(p - k) / (k + 1);
        }
    }
  } // namespace



  CurvePieces::CurvePieces(const SplineCurve &curve)
    : knots(curve.knot_vector())
    , p(curve.degree())
    , rational(curve.is_rational())
    , periodic(curve.is_periodic())
    , turn_shift(curve.period())
  {
    if (p > max_degree)
      throw InputError("Closest points are sought on a curve of degree " +
                       std::to_string(p) + ", but at most " +
                       std::to_string(max_degree) + " is supported.");
    const auto       bezier_pieces = curve.bezier_pieces();
    dealii::Point<2> low = bezier_pieces[0].points[0], high = low;
    for (const BezierPiece &piece : bezier_pieces)
      {
        middle.push_back((piece.begin + piece.end) / 2.);
        half_width.push_back((piece.end - piece.begin) / 2.);
        for (unsigned int i = 0; i <= p; ++i)
          {
            const double w = (rational ? piece.weights[i] : 1.);
            bernstein_table.push_back(w * piece.points[i][0]);
            bernstein_table.push_back(w * piece.points[i][1]);
            bernstein_table.push_back(w);
            largest_coordinate = std::max({largest_coordinate,
                                           std::abs(piece.points[i][0]),
                                           std::abs(piece.points[i][1])});
            for (unsigned int d = 0; d < 2; ++d)
              {
                low[d]  = std::min(low[d], piece.points[i][d]);
                high[d] = std::max(high[d], piece.points[i][d]);
              }
          }
      }
    box_diagonal = low.distance(high);
    power_table.resize(bernstein_table.size());
    for (unsigned int piece = 0; piece < size(); ++piece)
      for (unsigned int component = 0; component < 3; ++component)
        powers_from_bernstein(bernstein(piece) + component,
                              p,
                              power_table.data() + 3 * (p + 1) * piece +
                                component);

    const double gap =
      (curve.derivatives_on_span(0, knots.front(), 0)[0] -
       curve.derivatives_on_span(knots.n_spans() - 1, knots.back(), 0)[0])
        .norm();
    closed = periodic || gap <= 1e-14 * largest_coordinate;
  }



  CurveLocation
  CurvePieces::locate(const double parameter) const
  {
    const double  wrapped = knots.wrap(parameter);
    CurveLocation location;
    location.piece = knots.find_span(wrapped);
    if (wrapped != parameter)
      location.turn =
        std::lround((parameter - wrapped) / (knots.back() - knots.front()));
    location.s =
      (wrapped - middle[location.piece]) / half_width[location.piece];
    location.s = std::max(-1., std::min(1., location.s));
    return location;
  }



  double
  CurvePieces::parameter(const CurveLocation &location) const
  {
    const double t =
      middle[location.piece] + location.s * half_width[location.piece];
    return location.turn == 0 ?
             t :
             t + location.turn * (knots.back() - knots.front());
  }



  bool
  CurvePieces::step_over(CurveLocation &location, const int direction) const
  {
    const bool last =
      (direction > 0 ? location.piece + 1 == size() : location.piece == 0);
    if (last && !closed)
      return false;
    if (last)
      {
        location.piece = (direction > 0 ? 0 : size() - 1);
        if (periodic)
          location.turn += direction;
      }
    else
      location.piece += direction;
    location.s = -direction;
    return true;
  }



  template <unsigned int P>
  void
  CurvePieces::evaluate(const double *table,
                        const double  s,
                        DistanceJet  &jet) const
  {
    // Horner's rule for value, first and half the second derivative; P = 0
    // stands for a degree that is not known to the compiler.
    const unsigned int degree = (P == 0 ? p : P);
    double             x = table[3 * degree], y = table[3 * degree + 1];
    double             x1 = 0., y1 = 0., x2 = 0., y2 = 0.;
    for (int k = int(degree) - 1; k >= 0; --k)
      {
        x2 = x2 * s + x1;
        y2 = y2 * s + y1;
        x1 = x1 * s + x;
        y1 = y1 * s + y;
        x  = x * s + table[3 * k];
        y  = y * s + table[3 * k + 1];
      }
    jet.rx += x;
    jet.ry += y;
    jet.x1 = x1;
    jet.y1 = y1;
    jet.x2 = 2. * x2;
    jet.y2 = 2. * y2;
  }



  void
  CurvePieces::evaluate_rational(const double *table,
                                 const double  s,
                                 DistanceJet  &jet) const
  {
    double a[3], a1[3] = {}, a2[3] = {};
    for (unsigned int c = 0; c < 3; ++c)
      {
        a[c] = table[3 * p + c];
        for (int k = int(p) - 1; k >= 0; --k)
          {
            a2[c] = a2[c] * s + a1[c];
            a1[c] = a1[c] * s + a[c];
            a[c]  = a[c] * s + table[3 * k + c];
          }
        a2[c] *= 2.;
      }
    const double x = a[0] / a[2], y = a[1] / a[2];
    jet.x1 = (a1[0] - a1[2] * x) / a[2];
    jet.y1 = (a1[1] - a1[2] * y) / a[2];
    jet.x2 = (a2[0] - 2. * a1[2] * jet.x1 - a2[2] * x) / a[2];
    jet.y2 = (a2[1] - 2. * a1[2] * jet.y1 - a2[2] * y) / a[2];
    jet.rx += x;
    jet.ry += y;
  }



  DistanceJet
  CurvePieces::jet(const CurveLocation &location,
                   const double         px,
                   const double         py) const
  {
    DistanceJet result;
    // The small difference of two large coordinates is formed first.
    result.rx           = location.turn * turn_shift[0] - px;
    result.ry           = location.turn * turn_shift[1] - py;
    const double *table = power_table.data() + 3 * (p + 1) * location.piece;
    if (rational)
      evaluate_rational(table, location.s, result);
    else
      switch (p)
        {
          case 1:
            evaluate<1>(table, location.s, result);
            break;
          case 2:
            evaluate<2>(table, location.s, result);
            break;
          case 3:
            evaluate<3>(table, location.s, result);
            break;
          case 4:
            evaluate<4>(table, location.s, result);
            break;
          case 5:
            evaluate<5>(table, location.s, result);
            break;
          default:
            evaluate<0>(table, location.s, result);
        }
    return result;
  }
} // namespace asperity
