#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/splines/refinement.h>

#include <algorithm>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  double
  discrete_b_spline(const std::vector<double> &t,
                    const unsigned int         i,
                    const unsigned int         p,
                    const std::vector<double> &tau)
  {
    std::vector<double> alpha(p + 1);
    for (unsigned int j = 0; j <= p; ++j)
      alpha[j] = (t[i + j] <= tau[0] && tau[0] < t[i + j + 1]) ? 1. : 0.;
    for (unsigned int k = 1; k <= p; ++k)
      for (unsigned int j = 0; j + k <= p; ++j)
        {
          const double left = t[i + j], right = t[i + j + k + 1];
          double       sum = 0.;
          if (alpha[j] != 0.)
            sum += (tau[k] - left) / (t[i + j + k] - left) * alpha[j];
          if (alpha[j + 1] != 0.)
            sum += (right - tau[k]) / (right - t[i + j + 1]) * alpha[j + 1];
          alpha[j] = sum;
        }
    return alpha[0];
  }



  namespace
  {
    /** The knot at which the nonempty span of t begins, in unwrapped indices.
     */
    unsigned int
    span_start(const KnotVector &basis, const double t)
    {
      return std::upper_bound(basis.knots().begin(), basis.knots().end(), t) -
             basis.knots().begin() - 1;
    }



    /** Fills the rows: `coefficient(i, j)` is that of the old function i for
     * the new one j, both unwrapped. */
    template <typename Coefficient>
    BasisTransfer
    make_transfer(const KnotVector  &old_basis,
                  const KnotVector  &new_basis,
                  const Coefficient &coefficient)
    {
      BasisTransfer result;
      result.knot_vector = new_basis;
      result.rows.resize(new_basis.n_basis());
      // The functions that begin in the period: only there are all old
      // functions known that overlap with them.
      const unsigned int first =
        (new_basis.is_periodic() ? new_basis.degree() : 0);
      for (unsigned int j = first; j < first + new_basis.n_basis(); ++j)
        {
          const unsigned int start =
            span_start(old_basis, new_basis.knots()[j]);
          for (unsigned int i = start - old_basis.degree(); i <= start; ++i)
            {
              const double factor = coefficient(i, j);
              if (factor == 0.)
                continue;
              const int old_turn = i / old_basis.n_basis();
              const int new_turn = j / new_basis.n_basis();
              result.rows[j % new_basis.n_basis()].push_back(
                {i % old_basis.n_basis(), old_turn - new_turn, factor});
            }
        }
      return result;
    }



    BasisTransfer
    same_degree(const KnotVector &old_basis, const KnotVector &new_basis)
    {
      std::vector<double> tau(old_basis.degree() + 1);
      return make_transfer(
        old_basis, new_basis, [&](const unsigned int i, const unsigned int j) {
          std::copy_n(new_basis.knots().begin() + j, tau.size(), tau.begin());
          return discrete_b_spline(old_basis.knots(),
                                   i,
                                   old_basis.degree(),
                                   tau);
        });
    }
  } // namespace



  BasisTransfer
  knot_insertion(const KnotVector          &knot_vector,
                 const std::vector<double> &new_knots)
  {
    for (const double knot : new_knots)
      if (!(knot > knot_vector.front() && knot < knot_vector.back()))
        throw InputError("The knot " + format_number(knot) +
                         " was to be inserted, but values between " +
                         format_number(knot_vector.front()) + " and " +
                         format_number(knot_vector.back()) + " are expected.");

    std::vector<double> knots =
      (knot_vector.is_periodic() ? knot_vector.breakpoints() :
                                   knot_vector.knots());
    knots.insert(knots.end(), new_knots.begin(), new_knots.end());
    std::sort(knots.begin(), knots.end());
    return same_degree(knot_vector,
                       knot_vector.is_periodic() ?
                         KnotVector(knot_vector.degree(), knots, true) :
                         KnotVector::from_knots(knot_vector.degree(), knots));
  }



  BasisTransfer
  clamping(const KnotVector &knot_vector)
  {
    return same_degree(knot_vector,
                       knot_vector.is_periodic() ?
                         KnotVector(knot_vector.degree(),
                                    knot_vector.breakpoints()) :
                         knot_vector);
  }



  BasisTransfer
  degree_elevation(const KnotVector &knot_vector)
  {
    if (knot_vector.is_periodic())
      throw InputError(
        "The degree of a periodic spline cannot be elevated: its "
        "knots would be double, but only simple periodic knots "
        "are supported; clamp it first.");
    std::vector<double> knots;
    for (const double knot : knot_vector.knots())
      {
        if (knots.empty() || knots.back() != knot)
          knots.push_back(knot);
        knots.push_back(knot);
      }
    const unsigned int  p        = knot_vector.degree();
    const KnotVector    elevated = KnotVector::from_knots(p + 1, knots);
    std::vector<double> tau(p + 1);
    // The blossom of the elevated polynomial is the mean of the old one over
    // all choices of p among p + 1 arguments.
    return make_transfer(
      knot_vector, elevated, [&](const unsigned int i, const unsigned int j) {
        double sum = 0.;
        for (unsigned int left_out = 1; left_out <= p + 1; ++left_out)
          {
            tau[0] = knots[j];
            for (unsigned int k = 1; k <= p; ++k)
              tau[k] = knots[j + k + (k < left_out ? 0 : 1)];
            sum += discrete_b_spline(knot_vector.knots(), i, p, tau);
          }
        return sum / (p + 1);
      });
  }



  SplineCurve
  transfer(const SplineCurve &curve, const BasisTransfer &basis_transfer)
  {
    std::vector<Point<2>> points;
    std::vector<double>   weights;
    for (const auto &row : basis_transfer.rows)
      {
        Tensor<1, 2> point;
        double       weight = 0.;
        for (const auto &term : row)
          {
            const double w =
              term.factor *
              (curve.is_rational() ? curve.weights()[term.function] : 1.);
            point += w * (curve.control_points()[term.function] +
                          term.turns * curve.period());
            weight += w;
          }
        // Without weights the factors add up to one but for round-off.
        points.emplace_back(curve.is_rational() ? point / weight : point);
        if (curve.is_rational())
          weights.push_back(weight);
      }
    return SplineCurve(basis_transfer.knot_vector,
                       points,
                       weights,
                       basis_transfer.knot_vector.is_periodic() ?
                         curve.period() :
                         Tensor<1, 2>());
  }
} // namespace asperity
