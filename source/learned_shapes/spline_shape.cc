#include <asperity/base/errors.h>
#include <asperity/base/random_numbers.h>
#include <asperity/learned_shapes/spline_shape.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using dealii::Point;

  namespace
  {
    /** Twice the area that a polygon encloses counterclockwise. */
    double
    doubled_area(const std::vector<Point<2>> &points)
    {
      double sum = 0.;
      for (std::size_t i = 0; i < points.size(); ++i)
        {
          const Point<2> &a = points[i], &b = points[(i + 1) % points.size()];
          sum += a[0] * b[1] - a[1] * b[0];
        }
      return sum;
    }
  } // namespace



  SplineShape::SplineShape(const SplineCurve &curve)
  {
    const KnotVector     &knots  = curve.knot_vector();
    const unsigned int    n      = 16 * knots.n_spans();
    const auto           &b      = knots.breakpoints();
    double                length = 0.;
    std::vector<Point<2>> points;
    for (unsigned int i = 0; i <= n; ++i)
      {
        const unsigned int span = std::min(i / 16, knots.n_spans() - 1);
        const double       part = (i - 16. * span) / 16.;
        parameters.push_back(b[span] + part * (b[span + 1] - b[span]));
        points.push_back(curve.value(parameters.back()));
        if (i > 0)
          length += points[i].distance(points[i - 1]);
        lengths.push_back(length);
      }
    if (!(points.front().distance(points.back()) <= 1e-10 * length))
      throw InputError("The curve around a shape is not closed.");
    // distances are positive outside
    closest_point = std::make_unique<ClosestPoint>(
      curve, doubled_area(points) > 0. ? CurveSide::right : CurveSide::left);
  }



  double
  SplineShape::signed_distance(const Point<2> &point) const
  {
    return closest_point->project(point).distance;
  }



  Point<2>
  SplineShape::surface_point(RandomNumbers &random) const
  {
    const double place = random.uniform() * lengths.back();
    const auto   end =
      std::upper_bound(lengths.begin() + 1, lengths.end() - 1, place);
    const std::size_t i    = end - lengths.begin();
    const double      part = (place - lengths[i - 1]) / (*end - lengths[i - 1]);
    return closest_point->curve().value(
      parameters[i - 1] + part * (parameters[i] - parameters[i - 1]));
  }



  SplineCurve
  circle(const Point<2> &centre, const double radius)
  {
    const double          x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1};
    const double          y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    std::vector<Point<2>> points;
    std::vector<double>   weights;
    for (unsigned int i = 0; i < 9; ++i)
      {
        points.emplace_back(centre[0] + radius * x[i],
                            centre[1] + radius * y[i]);
        weights.push_back(i % 2 == 0 ? 1. : std::sqrt(0.5));
      }
    return {KnotVector::from_knots(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}),
            points,
            weights};
  }
} // namespace asperity
