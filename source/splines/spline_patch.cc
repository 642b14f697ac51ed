#include <asperity/base/errors.h>
#include <asperity/splines/spline_patch.h>

#include <cmath>
#include <string>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** From the derivatives of w S and of w those of S, in place: Leibniz' rule
     *  in two variables (Piegl and Tiller, equation 4.20). */
    void
    divide_by_weight(const std::vector<std::vector<double>> &w,
                     std::vector<std::vector<Tensor<1, 2>>> &S)
    {
      for (unsigned int k = 0; k < S.size(); ++k)
        for (unsigned int l = 0; l < S[k].size(); ++l)
          {
            double binomial_k = 1.;
            for (unsigned int i = 0; i <= k; ++i)
              {
                double binomial_l = 1.;
                for (unsigned int j = 0; j <= l; ++j)
                  {
                    if (i + j > 0)
                      S[k][l] -=
                        binomial_k * binomial_l * w[i][j] * S[k - i][l - j];
                    binomial_l *= double(l - j) / (j + 1);
                  }
                binomial_k *= double(k - i) / (i + 1);
              }
            S[k][l] /= w[0][0];
          }
    }
  } // namespace



  SplinePatch::SplinePatch(const std::array<KnotVector, 2>   &knot_vectors,
                           const std::vector<Point<2>>       &control_points,
                           const std::vector<double>         &weights,
                           const std::array<Tensor<1, 2>, 2> &periods)
    : knot_vectors(knot_vectors)
    , control_points_(control_points)
    , weights_(weights)
    , periods(periods)
  {
    const unsigned int n =
      knot_vectors[0].n_basis() * knot_vectors[1].n_basis();
    if (control_points.size() != n)
      throw InputError("A patch has " + std::to_string(control_points.size()) +
                       " control points, but its basis expects " +
                       std::to_string(n) + ".");
    if (!weights.empty() && weights.size() != n)
      throw InputError("A NURBS patch has " + std::to_string(weights.size()) +
                       " weights for " + std::to_string(n) +
                       " control points, but one each is expected.");
    for (const double weight : weights)
      if (!(weight > 0.) || !std::isfinite(weight))
        throw InputError("A NURBS patch has the weight " +
                         std::to_string(weight) +
                         ", but positive numbers are expected.");
    for (unsigned int d = 0; d < 2; ++d)
      if (!knot_vectors[d].is_periodic() && periods[d].norm() != 0.)
        throw InputError(
          "A patch was given a period in a direction whose knots "
          "are open, but only a periodic one can have it.");
  }



  const KnotVector &
  SplinePatch::knot_vector(const unsigned int direction) const
  {
    return knot_vectors[direction];
  }



  const std::vector<Point<2>> &
  SplinePatch::control_points() const
  {
    return control_points_;
  }



  const std::vector<double> &
  SplinePatch::weights() const
  {
    return weights_;
  }



  bool
  SplinePatch::is_rational() const
  {
    return !weights_.empty();
  }



  const Tensor<1, 2> &
  SplinePatch::period(const unsigned int direction) const
  {
    return periods[direction];
  }



  Point<2>
  SplinePatch::value(const double xi, const double eta) const
  {
    return Point<2>(derivatives(xi, eta, 0)[0][0]);
  }



  std::vector<std::vector<Tensor<1, 2>>>
  SplinePatch::derivatives(const double       xi,
                           const double       eta,
                           const unsigned int n) const
  {
    const double                                    t[2] = {xi, eta};
    std::array<unsigned int, 2>                     span;
    std::array<std::vector<unsigned int>, 2>        functions;
    std::array<std::vector<std::vector<double>>, 2> basis;
    Tensor<1, 2>                                    turn_shift;
    for (unsigned int d = 0; d < 2; ++d)
      {
        const KnotVector &knots   = knot_vectors[d];
        const double      wrapped = knots.wrap(t[d]);
        span[d]                   = knots.find_span(wrapped);
        functions[d]              = knots.span_functions(span[d]);
        basis[d]                  = knots.evaluate(span[d], wrapped, n);
        if (wrapped != t[d])
          turn_shift +=
            std::round((t[d] - wrapped) / (knots.back() - knots.front())) *
            periods[d];
      }

    std::vector<std::vector<Tensor<1, 2>>> result(n + 1);
    std::vector<std::vector<double>>       w(n + 1);
    for (unsigned int k = 0; k <= n; ++k)
      {
        result[k].resize(n + 1 - k);
        w[k].resize(n + 1 - k);
      }
    for (unsigned int b = 0; b < functions[1].size(); ++b)
      for (unsigned int a = 0; a < functions[0].size(); ++a)
        {
          const unsigned int i     = index(0, functions[0][a], functions[1][b]);
          Tensor<1, 2>       point = control_points_[i];
          if (knot_vectors[0].is_wrapped(span[0], a))
            point += periods[0];
          if (knot_vectors[1].is_wrapped(span[1], b))
            point += periods[1];
          for (unsigned int k = 0; k <= n; ++k)
            for (unsigned int l = 0; k + l <= n; ++l)
              {
                const double value = basis[0][k][a] * basis[1][l][b] *
                                     (is_rational() ? weights_[i] : 1.);
                result[k][l] += value * point;
                w[k][l] += value;
              }
        }

    if (is_rational())
      divide_by_weight(w, result);
    result[0][0] += turn_shift;
    return result;
  }



  SplineCurve
  SplinePatch::edge(const unsigned int direction, const bool at_back) const
  {
    if (knot_vectors[direction].is_periodic())
      throw InputError(
        "The edge of a patch was asked for in a direction that is "
        "periodic and has none.");
    const unsigned int row =
      at_back ? knot_vectors[direction].n_basis() - 1 : 0;
    const KnotVector     &along = knot_vectors[1 - direction];
    std::vector<Point<2>> points;
    std::vector<double>   weights;
    for (unsigned int i = 0; i < along.n_basis(); ++i)
      {
        points.push_back(control_points_[index(direction, row, i)]);
        if (is_rational())
          weights.push_back(weights_[index(direction, row, i)]);
      }
    return SplineCurve(along, points, weights, periods[1 - direction]);
  }



  unsigned int
  SplinePatch::index(const unsigned int direction,
                     const unsigned int function,
                     const unsigned int other) const
  {
    const unsigned int i = (direction == 0 ? function : other);
    const unsigned int j = (direction == 0 ? other : function);
    return j * knot_vectors[0].n_basis() + i;
  }



  dealii::FullMatrix<double>
  tensor_product(const dealii::FullMatrix<double> &xi,
                 const dealii::FullMatrix<double> &eta)
  {
    dealii::FullMatrix<double> result(xi.m() * eta.m(), xi.n() * eta.n());
    for (unsigned int b = 0; b < eta.m(); ++b)
      for (unsigned int a = 0; a < xi.m(); ++a)
        for (unsigned int l = 0; l < eta.n(); ++l)
          for (unsigned int k = 0; k < xi.n(); ++k)
            result(b * xi.m() + a, l * xi.n() + k) = xi(a, k) * eta(b, l);
    return result;
  }
} // namespace asperity
