#include <asperity/base/errors.h>
#include <asperity/splines/spline_fit.h>

#include <algorithm>

namespace asperity
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    /** x(t) = t, which a fitted graph holds up to round-off. */
    SplineCurve
    exact_graph(const SplineCurve &curve)
    {
      std::vector<double> heights;
      for (const Point<2> &point : curve.control_points())
        heights.push_back(point[1]);
      return SplineCurve::graph(curve.knot_vector(), heights);
    }

    SplineFit
    interpolate_graph(const KnotVector          &knots,
                      const std::vector<double> &x,
                      const std::vector<double> &heights)
    {
      std::vector<Point<2>> points;
      for (std::size_t i = 0; i < x.size(); ++i)
        points.emplace_back(x[i], heights[i]);
      Tensor<1, 2> turn;
      turn[0]       = knots.back() - knots.front();
      SplineFit fit = interpolate(knots, points, x, turn);
      fit.curve     = exact_graph(fit.curve);
      return fit;
    }
  } // namespace



  SplineFit
  fit_periodic_graph(const std::vector<double> &x,
                     const std::vector<double> &y,
                     const double               period,
                     const unsigned int         n_spans,
                     const unsigned int         degree,
                     const FitOptions          &options)
  {
    if (x.empty() || x.size() != y.size())
      throw InputError("A profile has " + std::to_string(x.size()) +
                       " positions and " + std::to_string(y.size()) +
                       " heights, but as many of each are expected.");
    const KnotVector knots = KnotVector::uniform_periodic(
      degree, n_spans, *std::min_element(x.begin(), x.end()), period);
    std::vector<Point<2>> points;
    for (unsigned int i = 0; i < x.size(); ++i)
      points.emplace_back(x[i], y[i]);

    FitOptions graph_options = options;
    graph_options.period[0]  = knots.back() - knots.front();
    graph_options.period[1]  = 0.;
    SplineFit fit = fit_least_squares(knots, points, x, graph_options);

    fit.curve = exact_graph(fit.curve);
    return fit;
  }



  SplineCurve
  interpolate_periodic_function(const std::function<double(double)> &function,
                                const double                         x_begin,
                                const double                         period,
                                const unsigned int                   n_spans,
                                const unsigned int                   degree)
  {
    const KnotVector knots =
      KnotVector::uniform_periodic(degree, n_spans, x_begin, period);
    const std::vector<double> x = knots.greville();
    std::vector<double>       heights;
    for (const double position : x)
      heights.push_back(function(position));
    return interpolate_graph(knots, x, heights).curve;
  }



  SplineFit
  interpolate_periodic_graph(const std::vector<double> &heights,
                             const double               period,
                             const unsigned int         degree)
  {
    const std::size_t n = heights.size();
    if (degree % 2 == 0 || n < 2 * degree + 2)
      throw InputError("A profile of " + std::to_string(n) +
                       " points cannot be interpolated by a periodic spline of "
                       "degree " +
                       std::to_string(degree) +
                       "; expected an odd degree p and at least 2 p + 2 "
                       "points.");
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i)
      x[i] = period * i / n;
    return interpolate_graph(
      KnotVector::uniform_periodic(degree, n, 0., period), x, heights);
  }
} // namespace asperity
