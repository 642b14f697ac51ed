#include <asperity/base/errors.h>
#include <asperity/splines/parametrization.h>

#include <cmath>
#include <string>

namespace asperity
{
  using dealii::Point;

  std::vector<double>
  chord_parameters(const std::vector<Point<2>> &points, const double exponent)
  {
    if (points.size() < 2)
      throw InputError("A curve through " + std::to_string(points.size()) +
                       " points was asked for, but at least 2 are expected.");
    std::vector<double> parameters(points.size());
    for (unsigned int i = 1; i < points.size(); ++i)
      {
        const double chord = (points[i] - points[i - 1]).norm();
        if (!(chord > 0.))
          throw InputError("Points " + std::to_string(i - 1) + " and " +
                           std::to_string(i) +
                           " of a curve coincide, so that they have no "
                           "chord-length parameters.");
        parameters[i] = parameters[i - 1] + std::pow(chord, exponent);
      }
    const double total = parameters.back();
    for (double &parameter : parameters)
      parameter /= total;
    parameters.back() = 1.;
    return parameters;
  }



  KnotVector
  averaged_knots(const std::vector<double> &parameters,
                 const unsigned int         degree)
  {
    if (parameters.size() < degree + 1)
      throw InputError("A curve of degree " + std::to_string(degree) +
                       " through " + std::to_string(parameters.size()) +
                       " points was asked for, but at least " +
                       std::to_string(degree + 1) + " are expected.");
    std::vector<double> knots(degree + 1, parameters.front());
    for (unsigned int j = 1; j + degree < parameters.size(); ++j)
      {
        double sum = 0.;
        for (unsigned int i = j; i < j + degree; ++i)
          sum += parameters[i];
        knots.push_back(sum / degree);
      }
    knots.insert(knots.end(), degree + 1, parameters.back());
    return KnotVector::from_knots(degree, knots);
  }
} // namespace asperity
