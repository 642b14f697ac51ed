#include "likelihood_maximizer.h"

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** Of any logarithm in one step: a factor of 20. */
    constexpr double largest_step = 3.;

    double
    product(const std::vector<double> &a, const std::vector<double> &b)
    {
      double sum = 0.;
      for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
      return sum;
    }

    std::vector<double>
    difference(const std::vector<double> &a, const std::vector<double> &b)
    {
      std::vector<double> result(a);
      for (std::size_t i = 0; i < a.size(); ++i)
        result[i] -= b[i];
      return result;
    }

    std::vector<double>
    scaled_identity(const std::size_t n, const double scale)
    {
      std::vector<double> h(n * n, 0.);
      for (std::size_t i = 0; i < n; ++i)
        h[i * n + i] = scale;
      return h;
    }

    /** Without knowledge of second derivatives: a first step of length one. */
    std::vector<double>
    steepest_descent(const std::vector<double> &gradient)
    {
      const double length = std::sqrt(product(gradient, gradient));
      return scaled_identity(gradient.size(), 1. / std::max(length, 1e-10));
    }

    /** H <- (1 - s y^T / s.y) H (1 - y s^T / s.y) + s s^T / s.y, unless the
     *  curvature along s is not positive. */
    void
    update_inverse_hessian(const std::vector<double> &s,
                           const std::vector<double> &y,
                           std::vector<double>       &h)
    {
      const std::size_t n  = s.size();
      const double      sy = product(s, y);
      if (sy <= 1e-10 * std::sqrt(product(s, s) * product(y, y)))
        return;
      std::vector<double> hy(n, 0.);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          hy[i] += h[i * n + j] * y[j];
      const double weight = 1. + product(y, hy) / sy;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          h[i * n + j] +=
            (weight * s[i] * s[j] - hy[i] * s[j] - s[i] * hy[j]) / sy;
    }
  } // namespace



  Hyperparameters
  hyperparameters_of(const std::vector<double> &logarithms)
  {
    Hyperparameters result;
    result.signal_variance = std::exp(logarithms.front());
    result.noise_variance  = std::exp(logarithms.back());
    for (std::size_t i = 1; i + 1 < logarithms.size(); ++i)
      result.length_scales.push_back(std::exp(logarithms[i]));
    return result;
  }



  LikelihoodMaximizer::LikelihoodMaximizer(
    const KernelKind                   kernel,
    const TrainingData                &data,
    const std::vector<LogarithmRange> &ranges)
    : ranges(ranges)
    , covariance(kernel, data)
  {}



  unsigned int
  LikelihoodMaximizer::n_evaluations() const
  {
    return n_evaluations_;
  }



  void
  LikelihoodMaximizer::evaluate_value(Point &point)
  {
    ++n_evaluations_;
    // otherwise as bad as can be: the line search turns back
    if (covariance.factorize(hyperparameters_of(point.place)))
      point.value = -covariance.log_likelihood();
    else
      point.value = std::numeric_limits<double>::infinity();
  }



  void
  LikelihoodMaximizer::evaluate_gradient(Point &point)
  {
    point.gradient = covariance.log_likelihood_gradient();
    for (double &derivative : point.gradient)
      derivative *= -1.;
  }



  std::vector<double>
  LikelihoodMaximizer::direction(const Point               &point,
                                 const std::vector<double> &h) const
  {
    const std::size_t n       = ranges.size();
    const auto        is_held = [&](const std::size_t i) {
      return (point.place[i] <= ranges[i].lower && point.gradient[i] > 0.) ||
             (point.place[i] >= ranges[i].upper && point.gradient[i] < 0.);
    };
    std::vector<double> result(n, 0.);
    double              longest = 0.;
    for (std::size_t i = 0; i < n; ++i)
      {
        for (std::size_t j = 0; j < n; ++j)
          if (!is_held(i) && !is_held(j))
            result[i] -= h[i * n + j] * point.gradient[j];
        longest = std::max(longest, std::abs(result[i]));
      }
    if (longest > largest_step)
      for (double &component : result)
        component *= largest_step / longest;
    return result;
  }



  bool
  LikelihoodMaximizer::search_line(const Point               &from,
                                   const std::vector<double> &direction,
                                   Point                     &to)
  {
    double t = 1.;
    for (unsigned int trial = 0; trial < 20; ++trial)
      {
        to.place = from.place;
        for (std::size_t i = 0; i < ranges.size(); ++i)
          to.place[i] = std::clamp(from.place[i] + t * direction[i],
                                   ranges[i].lower,
                                   ranges[i].upper);
        evaluate_value(to);
        const double slope =
          product(from.gradient, difference(to.place, from.place));
        if (to.value <= from.value + 1e-4 * slope)
          return true;
        // to the minimum of the parabola through what is known, if that is wise
        const double excess = to.value - from.value - slope;
        const double shrink =
          std::isfinite(excess) && excess > 0. ? -0.5 * slope / excess : 0.1;
        t *= std::clamp(shrink, 0.1, 0.5);
      }
    return false;
  }



  LikelihoodMaximum
  LikelihoodMaximizer::climb(const LikelihoodMaximum &start,
                             const unsigned int       max_iterations)
  {
    Point point;
    point.place = start.logarithms;
    evaluate_value(point);
    if (!std::isfinite(point.value))
      return {};
    evaluate_gradient(point);

    std::vector<double> h        = start.inverse_hessian;
    bool                is_fresh = h.empty();
    if (is_fresh)
      h = steepest_descent(point.gradient);
    for (unsigned int i = 0; i < max_iterations; ++i)
      {
        const std::vector<double> step = direction(point, h);
        // What a quadratic model expects to gain: hyperparameters within one
        // of the maximum of the log likelihood are about as likely.
        const double expected = -0.5 * product(point.gradient, step);
        Point        next;
        if (!is_fresh && expected < 1e-4)
          break;
        if (!search_line(point, step, next))
          {
            if (is_fresh)
              break;
            is_fresh = true;
            h        = steepest_descent(point.gradient);
            continue;
          }
        evaluate_gradient(next);
        const std::vector<double> s = difference(next.place, point.place),
                                  y = difference(next.gradient, point.gradient);
        if (is_fresh && product(s, y) > 0.)
          h = scaled_identity(s.size(), product(s, y) / product(y, y));
        is_fresh = is_fresh && product(s, y) <= 0.;
        update_inverse_hessian(s, y, h);
        point = std::move(next);
      }
    return {point.place, -point.value, h};
  }
} // namespace asperity
