#include <asperity/base/errors.h>
#include <asperity/splines/bezier_extraction.h>
#include <asperity/splines/spline_curve.h>

#include <deal.II/base/quadrature_lib.h>

#include <cmath>
#include <string>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  SplineCurve::SplineCurve(const KnotVector            &knot_vector,
                           const std::vector<Point<2>> &control_points,
                           const std::vector<double>   &weights,
                           const Tensor<1, 2>          &period)
    : knot_vector_(knot_vector)
    , weights_(weights)
    , period_(period)
  {
    set_control_points(control_points);
    if (!weights.empty() && weights.size() != control_points.size())
      throw InputError("A NURBS curve has " + std::to_string(weights.size()) +
                       " weights for " + std::to_string(control_points.size()) +
                       " control points, but one each is expected.");
    for (const double weight : weights)
      if (!(weight > 0.) || !std::isfinite(weight))
        throw InputError("A NURBS curve has the weight " +
                         std::to_string(weight) +
                         ", but positive numbers are expected.");
    if (!knot_vector.is_periodic() && period.norm() != 0.)
      throw InputError(
        "A curve on open knots was given a period, but only a curve on periodic "
        "knots can have one.");
  }



  SplineCurve
  SplineCurve::graph(const KnotVector          &knot_vector,
                     const std::vector<double> &values)
  {
    const std::vector<double> greville = knot_vector.greville();
    std::vector<Point<2>>     points;
    for (unsigned int i = 0; i < values.size() && i < greville.size(); ++i)
      points.emplace_back(greville[i], values[i]);
    Tensor<1, 2> period;
    if (knot_vector.is_periodic())
      period[0] = knot_vector.back() - knot_vector.front();
    return SplineCurve(knot_vector, points, {}, period);
  }



  void
  SplineCurve::set_control_points(const std::vector<Point<2>> &control_points)
  {
    if (control_points.size() != knot_vector_.n_basis())
      throw InputError("A curve has " + std::to_string(control_points.size()) +
                       " control points, but its basis expects " +
                       std::to_string(knot_vector_.n_basis()) + ".");
    control_points_ = control_points;
  }



  const KnotVector &
  SplineCurve::knot_vector() const
  {
    return knot_vector_;
  }



  unsigned int
  SplineCurve::degree() const
  {
    return knot_vector_.degree();
  }



  bool
  SplineCurve::is_periodic() const
  {
    return knot_vector_.is_periodic();
  }



  bool
  SplineCurve::is_rational() const
  {
    return !weights_.empty();
  }



  const std::vector<Point<2>> &
  SplineCurve::control_points() const
  {
    return control_points_;
  }



  const std::vector<double> &
  SplineCurve::weights() const
  {
    return weights_;
  }



  const Tensor<1, 2> &
  SplineCurve::period() const
  {
    return period_;
  }



  Point<2>
  SplineCurve::value(const double t) const
  {
    return Point<2>(derivatives(t, 0)[0]);
  }



  std::vector<Tensor<1, 2>>
  SplineCurve::derivatives(const double t, const unsigned int n) const
  {
    const double wrapped = knot_vector_.wrap(t);
    auto         result =
      derivatives_on_span(knot_vector_.find_span(wrapped), wrapped, n);
    if (wrapped != t)
      result[0] += std::round((t - wrapped) /
                              (knot_vector_.back() - knot_vector_.front())) *
                   period_;
    return result;
  }



  Tensor<1, 3>
  SplineCurve::homogeneous_control_point(const unsigned int span,
                                         const unsigned int j,
                                         const unsigned int function) const
  {
    Tensor<1, 2> point = control_points_[function];
    // A function that was wrapped belongs to the next turn.
    if (knot_vector_.is_wrapped(span, j))
      point += period_;
    const double weight = (is_rational() ? weights_[function] : 1.);
    Tensor<1, 3> result;
    result[0] = weight * point[0];
    result[1] = weight * point[1];
    result[2] = weight;
    return result;
  }



  std::vector<Tensor<1, 2>>
  SplineCurve::derivatives_on_span(const unsigned int span,
                                   const double       t,
                                   const unsigned int n) const
  {
    const auto values    = knot_vector_.evaluate(span, t, n);
    const auto functions = knot_vector_.span_functions(span);

    std::vector<Tensor<1, 3>> homogeneous(n + 1);
    for (unsigned int j = 0; j < functions.size(); ++j)
      {
        const Tensor<1, 3> point =
          homogeneous_control_point(span, j, functions[j]);
        for (unsigned int k = 0; k <= n; ++k)
          homogeneous[k] += values[k][j] * point;
      }

    // Leibniz' rule for (w C); Piegl and Tiller, equation 4.8.
    std::vector<Tensor<1, 2>> result(n + 1);
    for (unsigned int k = 0; k <= n; ++k)
      {
        result[k][0] = homogeneous[k][0];
        result[k][1] = homogeneous[k][1];
        if (!is_rational())
          continue;
        double binomial = 1.;
        for (unsigned int i = 1; i <= k; ++i)
          {
            binomial *= double(k - i + 1) / i;
            result[k] -= binomial * homogeneous[i][2] * result[k - i];
          }
        result[k] /= homogeneous[0][2];
      }
    return result;
  }



  std::vector<BezierPiece>
  SplineCurve::bezier_pieces() const
  {
    const auto               operators = bezier_extraction(knot_vector_);
    const unsigned int       p         = degree();
    std::vector<BezierPiece> pieces(operators.size());
    for (unsigned int span = 0; span < pieces.size(); ++span)
      {
        const auto                functions = knot_vector_.span_functions(span);
        std::vector<Tensor<1, 3>> points(p + 1);
        for (unsigned int a = 0; a <= p; ++a)
          for (unsigned int b = 0; b <= p; ++b)
            points[b] += operators[span](a, b) *
                         homogeneous_control_point(span, a, functions[a]);

        BezierPiece &piece = pieces[span];
        piece.begin        = knot_vector_.breakpoints()[span];
        piece.end          = knot_vector_.breakpoints()[span + 1];
        for (const Tensor<1, 3> &point : points)
          if (is_rational())
            {
              piece.points.emplace_back(point[0] / point[2],
                                        point[1] / point[2]);
              piece.weights.push_back(point[2]);
            }
          else
            piece.points.emplace_back(point[0], point[1]);
      }
    return pieces;
  }



  double
  SplineCurve::length(const double       t0,
                      const double       t1,
                      const unsigned int n_points) const
  {
    const dealii::QGauss<1> quadrature(n_points);
    double                  sum = 0.;
    for (double begin = std::min(t0, t1); begin < std::max(t0, t1);)
      {
        // up to the next breakpoint, or the end
        const double wrapped = knot_vector_.wrap(begin);
        const double rest =
          knot_vector_.breakpoints()[knot_vector_.find_span(wrapped) + 1] -
          wrapped;
        double end = std::max(t0, t1);
        if (rest > 0. && begin + rest > begin)
          end = std::min(end, begin + rest);
        for (unsigned int q = 0; q < n_points; ++q)
          sum +=
            quadrature.weight(q) * (end - begin) *
            derivatives(begin + quadrature.point(q)[0] * (end - begin), 1)[1]
              .norm();
        begin = end;
      }
    return t1 < t0 ? -sum : sum;
  }
} // namespace asperity
