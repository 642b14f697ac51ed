#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/splines/knot_vector.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

namespace asperity
{
  namespace
  {
    void
    check_degree(const unsigned int degree)
    {
      if (degree < 1)
        throw InputError("A spline has degree 0, but at least 1 is expected.");
    }
  } // namespace



  KnotVector::KnotVector(const unsigned int         degree,
                         const std::vector<double> &breakpoints,
                         const bool                 periodic,
                         const unsigned int         multiplicity)
    : degree_(degree)
    , periodic_(periodic)
    , multiplicity_(multiplicity)
    , breakpoints_(breakpoints)
  {
    check_degree(degree);
    if (multiplicity < 1 || multiplicity > degree)
      throw InputError("Knots of a spline of degree " + std::to_string(degree) +
                       " have the multiplicity " +
                       std::to_string(multiplicity) + ", but 1 to " +
                       std::to_string(degree) + " is expected.");
    if (breakpoints.size() < 2)
      throw InputError("A knot vector has " +
                       std::to_string(breakpoints.size()) +
                       " breakpoints, but at least 2 are expected.");
    for (unsigned int i = 0; i + 1 < breakpoints.size(); ++i)
      if (!(breakpoints[i] < breakpoints[i + 1]) ||
          !std::isfinite(breakpoints[i]) || !std::isfinite(breakpoints[i + 1]))
        throw InputError("Breakpoint " + std::to_string(i + 1) +
                         " of a knot vector is " +
                         format_number(breakpoints[i + 1]) + " after " +
                         format_number(breakpoints[i]) +
                         ", but finite increasing values are expected.");
    const unsigned int n_spans = breakpoints.size() - 1;
    if (periodic && n_spans < degree + 1)
      throw InputError("A periodic knot vector of degree " +
                       std::to_string(degree) + " has " +
                       std::to_string(n_spans) + " spans, but at least " +
                       std::to_string(degree + 1) + " are expected.");

    if (periodic)
      {
        // Knot i of the sequence that repeats itself, where the last of those
        // at the start of the period has the index degree.
        const double period = breakpoints.back() - breakpoints.front();
        const int    n      = n_spans * multiplicity;
        for (int i = -int(degree); i <= n + int(degree); ++i)
          {
            const int place = i + int(multiplicity) - 1;
            const int turn  = (place < 0 ? -1 : place / n);
            const int point = (place - turn * n) / int(multiplicity);
            // The end of the period bit by bit.
            knots_.push_back(turn == 1 && point == 0 ?
                               breakpoints.back() :
                               breakpoints[point] + turn * period);
          }
      }
    else
      {
        knots_.assign(degree + 1, breakpoints.front());
        for (unsigned int i = 1; i < n_spans; ++i)
          knots_.insert(knots_.end(), multiplicity, breakpoints[i]);
        knots_.insert(knots_.end(), degree + 1, breakpoints.back());
      }
    finish();
  }



  KnotVector
  KnotVector::uniform_periodic(const unsigned int degree,
                               const unsigned int n_spans,
                               const double       begin,
                               const double       period)
  {
    if (!(period > 0.) || !std::isfinite(period))
      throw InputError("The period of a profile is " + std::to_string(period) +
                       " m, but a positive length is expected.");
    std::vector<double> breakpoints(n_spans + 1);
    for (unsigned int i = 0; i <= n_spans; ++i)
      breakpoints[i] = begin + period * i / std::max(1u, n_spans);
    return KnotVector(degree, breakpoints, true);
  }



  KnotVector
  KnotVector::from_knots(const unsigned int         degree,
                         const std::vector<double> &knots)
  {
    check_degree(degree);
    if (knots.size() < 2 * degree + 2)
      throw InputError("An open knot vector of degree " +
                       std::to_string(degree) + " has " +
                       std::to_string(knots.size()) + " knots, but at least " +
                       std::to_string(2 * degree + 2) + " are expected.");
    unsigned int multiplicity = 1;
    for (unsigned int i = 1; i < knots.size(); ++i)
      {
        if (!(knots[i - 1] <= knots[i]) || !std::isfinite(knots[i - 1]) ||
            !std::isfinite(knots[i]))
          throw InputError("Knot " + std::to_string(i) + " is " +
                           format_number(knots[i]) + " after " +
                           format_number(knots[i - 1]) +
                           ", but finite values that do not decrease are "
                           "expected.");
        multiplicity = (knots[i] == knots[i - 1] ? multiplicity + 1 : 1);
        const bool end =
          (knots[i] == knots.front() || knots[i] == knots.back());
        if (multiplicity > degree + (end ? 1 : 0))
          throw InputError("Knot " + format_number(knots[i]) +
                           " of a spline of degree " + std::to_string(degree) +
                           " occurs more than " +
                           std::to_string(degree + (end ? 1 : 0)) +
                           " times, so that the curve would break apart.");
      }
    if (knots[degree] != knots.front() ||
        knots[knots.size() - 1 - degree] != knots.back())
      throw InputError("The ends of an open knot vector of degree " +
                       std::to_string(degree) + " must be repeated " +
                       std::to_string(degree + 1) + " times.");

    KnotVector result;
    result.degree_ = degree;
    result.knots_  = knots;
    std::unique_copy(knots.begin(),
                     knots.end(),
                     std::back_inserter(result.breakpoints_));
    result.finish();
    return result;
  }



  void
  KnotVector::finish()
  {
    for (unsigned int i = degree_; i + degree_ + 1 < knots_.size(); ++i)
      if (knots_[i] < knots_[i + 1])
        span_knot_.push_back(i);
  }



  unsigned int
  KnotVector::degree() const
  {
    return degree_;
  }



  bool
  KnotVector::is_periodic() const
  {
    return periodic_;
  }



  unsigned int
  KnotVector::multiplicity() const
  {
    return multiplicity_;
  }



  unsigned int
  KnotVector::n_basis() const
  {
    return periodic_ ? n_spans() * multiplicity_ : knots_.size() - degree_ - 1;
  }



  unsigned int
  KnotVector::n_spans() const
  {
    return span_knot_.size();
  }



  const std::vector<double> &
  KnotVector::breakpoints() const
  {
    return breakpoints_;
  }



  const std::vector<double> &
  KnotVector::knots() const
  {
    return knots_;
  }



  double
  KnotVector::front() const
  {
    return breakpoints_.front();
  }



  double
  KnotVector::back() const
  {
    return breakpoints_.back();
  }



  unsigned int
  KnotVector::find_span(const double t) const
  {
    const auto right = std::upper_bound(breakpoints_.begin() + 1,
                                        breakpoints_.end() - 1,
                                        wrap(t));
    return right - breakpoints_.begin() - 1;
  }



  double
  KnotVector::wrap(const double t) const
  {
    if (!periodic_ || (t >= front() && t < back()))
      return t;
    const double period  = back() - front();
    const double wrapped = t - period * std::floor((t - front()) / period);
    // Rounding may put the image of a point just below the period onto its end.
    return (wrapped >= front() && wrapped < back()) ? wrapped : front();
  }



  std::vector<unsigned int>
  KnotVector::span_functions(const unsigned int span) const
  {
    std::vector<unsigned int> functions(degree_ + 1);
    for (unsigned int j = 0; j <= degree_; ++j)
      {
        functions[j] = span_knot_[span] - degree_ + j;
        if (periodic_)
          functions[j] %= n_basis();
      }
    return functions;
  }



  bool
  KnotVector::is_wrapped(const unsigned int span, const unsigned int j) const
  {
    return periodic_ && span_knot_[span] - degree_ + j >= n_basis();
  }



  std::vector<std::vector<double>>
  KnotVector::evaluate(const unsigned int span,
                       const double       t,
                       const unsigned int n_derivatives) const
  {
    const unsigned int p = degree_;
    const double      *u = knots_.data() + span_knot_[span];

    // Upper triangle: functions of degree 0 .. p; lower triangle: knot
    // differences (Piegl and Tiller, algorithm A2.3).
    std::vector<std::vector<double>> ndu(p + 1, std::vector<double>(p + 1));
    ndu[0][0] = 1.;
    for (unsigned int j = 1; j <= p; ++j)
      {
        double saved = 0.;
        for (unsigned int r = 0; r < j; ++r)
          {
            const double right = u[r + 1], left = u[1 + int(r) - int(j)];
            ndu[j][r]         = right - left;
            const double temp = ndu[r][j - 1] / ndu[j][r];
            ndu[r][j]         = saved + (right - t) * temp;
            saved             = (t - left) * temp;
          }
        ndu[j][j] = saved;
      }

    std::vector<std::vector<double>> values(n_derivatives + 1,
                                            std::vector<double>(p + 1, 0.));
    for (unsigned int j = 0; j <= p; ++j)
      values[0][j] = ndu[j][p];

    std::vector<double> old_row(p + 1), new_row(p + 1);
    for (int r = 0; r <= int(p); ++r)
      {
        std::fill(old_row.begin(), old_row.end(), 0.);
        old_row[0]    = 1.;
        double factor = 1.;
        for (int k = 1; k <= int(std::min(n_derivatives, p)); ++k)
          {
            // Only functions r - k .. r of degree p - k that exist contribute.
            const int low = p - k;
            double    sum = 0.;
            factor *= p - k + 1;
            for (int j = 0; j <= k; ++j)
              {
                const double here = (j < k ? old_row[j] : 0.);
                const double left = (j > 0 ? old_row[j - 1] : 0.);
                const int    i    = r - k + j;
                new_row[j]        = 0.;
                if (i < 0 || i > low)
                  continue;
                new_row[j] = (here - left) / ndu[low + 1][i];
                sum += new_row[j] * ndu[i][low];
              }
            values[k][r] = factor * sum;
            std::swap(old_row, new_row);
          }
      }
    return values;
  }



  std::vector<double>
  KnotVector::greville() const
  {
    std::vector<double> points(n_basis());
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        for (unsigned int j = 1; j <= degree_; ++j)
          points[i] += knots_[i + j];
        points[i] /= degree_;
      }
    return points;
  }



  KnotVector
  KnotVector::dyadic_refinement() const
  {
    if (periodic_)
      {
        std::vector<double> halved;
        for (unsigned int i = 0; i < n_spans(); ++i)
          {
            halved.push_back(breakpoints_[i]);
            halved.push_back((breakpoints_[i] + breakpoints_[i + 1]) / 2.);
          }
        halved.push_back(back());
        return KnotVector(degree_, halved, true, multiplicity_);
      }

    std::vector<double> halved;
    for (unsigned int i = 0; i < knots_.size(); ++i)
      {
        if (i > 0 && knots_[i - 1] < knots_[i])
          halved.insert(halved.end(),
                        multiplicity_,
                        (knots_[i - 1] + knots_[i]) / 2.);
        halved.push_back(knots_[i]);
      }
    KnotVector result    = from_knots(degree_, halved);
    result.multiplicity_ = multiplicity_;
    return result;
  }
} // namespace asperity
