#ifndef asperity_tests_splines_brute_force_h
#define asperity_tests_splines_brute_force_h

#include <asperity/splines/spline_curve.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity
{
  /**
   * The independent answer: the nearest of many samples, then golden-section
   * search around every sample that could hide a closer point. Evaluates its
   * own Taylor polynomials of the curve (not of rational ones: there the
   * curve's value() itself).
   */
  class BruteForce
  {
  public:
    BruteForce(const SplineCurve &curve, const unsigned int samples_per_span)
      : curve(curve)
    {
      const KnotVector &knots = curve.knot_vector();
      for (unsigned int span = 0; span < knots.n_spans(); ++span)
        {
          const double a = knots.breakpoints()[span];
          const double b = knots.breakpoints()[span + 1];
          auto         taylor =
            curve.derivatives_on_span(span, (a + b) / 2., curve.degree());
          double factorial = 1.;
          for (unsigned int k = 1; k < taylor.size(); ++k)
            {
              factorial *= k;
              taylor[k] /= factorial;
            }
          taylors.push_back(taylor);
          for (unsigned int i = 0; i <= samples_per_span; ++i)
            {
              const double t = a + (b - a) * i / samples_per_span;
              const auto   C = curve.derivatives_on_span(span, t, 1);
              t_.push_back(t);
              x_.push_back(C[0][0]);
              y_.push_back(C[0][1]);
              span_.push_back(span);
            }
        }
      for (unsigned int i = 0; i + 1 < t_.size(); ++i)
        spacing =
          std::max(spacing, std::hypot(x_[i + 1] - x_[i], y_[i + 1] - y_[i]));
      distances.resize(t_.size());
    }

    double
    distance(const dealii::Point<2> &point)
    {
      const double L      = curve.period()[0];
      double       best   = 1e300;
      int          centre = (L > 0. ? std::floor((point[0] - x_[0]) / L) : 0);
      for (int turn = centre - (L > 0. ? 1 : 0);
           turn <= centre + (L > 0. ? 1 : 0);
           ++turn)
        best = std::min(best, distance_to_turn(point - turn * curve.period()));
      return best;
    }

  private:
    double
    distance_to_turn(const dealii::Point<2> &point)
    {
      double nearest = 1e300;
      for (unsigned int i = 0; i < t_.size(); ++i)
        {
          const double dx = x_[i] - point[0], dy = y_[i] - point[1];
          distances[i] = dx * dx + dy * dy;
          nearest      = std::min(nearest, distances[i]);
        }
      // Between two samples the curve comes at most a spacing closer.
      const double limit = std::pow(std::sqrt(nearest) + spacing, 2);
      double       best  = std::sqrt(nearest);
      for (unsigned int i = 0; i < t_.size(); ++i)
        if (distances[i] <= limit)
          {
            const bool left  = i > 0 && span_[i - 1] == span_[i];
            const bool right = i + 1 < t_.size() && span_[i + 1] == span_[i];
            if ((!left || distances[i] <= distances[i - 1]) &&
                (!right || distances[i] <= distances[i + 1]))
              best = std::min(
                best,
                golden_section(point, span_[i], t_[i - left], t_[i + right]));
          }
      return best;
    }

    double
    at(const dealii::Point<2> &point,
       const unsigned int      span,
       const double            t) const
    {
      if (curve.is_rational())
        return (curve.derivatives_on_span(span, t, 0)[0] - point).norm();
      const auto  &breakpoints = curve.knot_vector().breakpoints();
      const double h = t - (breakpoints[span] + breakpoints[span + 1]) / 2.;
      double       x = 0., y = 0.;
      for (unsigned int k = taylors[span].size(); k-- > 0;)
        {
          x = x * h + taylors[span][k][0];
          y = y * h + taylors[span][k][1];
        }
      return std::hypot(x - point[0], y - point[1]);
    }

    double
    golden_section(const dealii::Point<2> &point,
                   const unsigned int      span,
                   double                  a,
                   double                  b) const
    {
      const double ratio = (std::sqrt(5.) - 1.) / 2.;
      double       c = b - ratio * (b - a), d = a + ratio * (b - a);
      double       fc = at(point, span, c), fd = at(point, span, d);
      double       best = std::min(at(point, span, a), at(point, span, b));
      for (unsigned int i = 0; i < 36; ++i)
        if (fc < fd)
          {
            b = d, d = c, fd = fc, c = b - ratio * (b - a);
            fc = at(point, span, c);
          }
        else
          {
            a = c, c = d, fc = fd, d = a + ratio * (b - a);
            fd = at(point, span, d);
          }
      return std::min({best, fc, fd});
    }

    const SplineCurve                             &curve;
    std::vector<std::vector<dealii::Tensor<1, 2>>> taylors;
    std::vector<double>                            t_, x_, y_, distances;
    std::vector<unsigned int>                      span_;
    double                                         spacing = 0.;
  };
} // namespace asperity

#endif
