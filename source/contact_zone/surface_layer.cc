#include <asperity/contact_zone/surface_layer.h>

#include <algorithm>
#include <set>

namespace asperity
{
  namespace
  {
    /** Of the cells at the edge, the uppermost row of points each, in the order
     *  of their first parameter. */
    std::vector<unsigned int>
    points_under(const BasisTable &body, const BasisTable &edge)
    {
      std::set<unsigned int> cells;
      for (const auto &element : edge.elements)
        cells.insert(element.cell);
      std::vector<unsigned int> points;
      for (const auto &element : body.elements)
        {
          if (cells.count(element.cell) == 0)
            continue;
          const unsigned int end =
            element.first_point + body.points_per_element;
          double top = 0.;
          for (unsigned int q = element.first_point; q < end; ++q)
            top = std::max(top, body.parameter[q][1]);
          for (unsigned int q = element.first_point; q < end; ++q)
            if (body.parameter[q][1] > top * (1. - 1e-9))
              points.push_back(q);
        }
      std::sort(points.begin(), points.end(), [&](const auto a, const auto b) {
        return body.parameter[a][0] < body.parameter[b][0];
      });
      return points;
    }
  } // namespace



  SurfaceLayer::SurfaceLayer(const BasisTable &body,
                             const BasisTable &edge,
                             const double      period)
    : uppermost(points_under(body, edge))
  {
    for (const unsigned int q : uppermost)
      area.push_back(body.JxW[q]);
    const unsigned int n = uppermost.size();
    for (const auto &parameter : edge.parameter)
      {
        const double       x = parameter[0];
        const unsigned int after =
          std::upper_bound(uppermost.begin(),
                           uppermost.end(),
                           x,
                           [&](const double value, const unsigned int q) {
                             return value < body.parameter[q][0];
                           }) -
          uppermost.begin();
        const unsigned int right = uppermost[after % n],
                           left  = uppermost[(after + n - 1) % n];
        const double begin =
          body.parameter[left][0] - (after == 0 ? period : 0.);
        const double end =
          body.parameter[right][0] + (after == n ? period : 0.);
        places.push_back({left, right, (x - begin) / (end - begin)});
      }
  }



  std::vector<SurfaceLayer::Point>
  SurfaceLayer::at_edge(const std::vector<MaterialState> &history) const
  {
    std::vector<Point> points;
    for (const Place &place : places)
      {
        const MaterialState &a = history[place.left], &b = history[place.right];
        const double         w = place.weight;
        points.push_back({(1. - w) * a.plastic_strain + w * b.plastic_strain,
                          (1. - w) * a.temperature + w * b.temperature});
      }
    return points;
  }



  double
  SurfaceLayer::mean_temperature(
    const std::vector<MaterialState> &history) const
  {
    double sum = 0., total = 0.;
    for (unsigned int i = 0; i < uppermost.size(); ++i)
      {
        sum += area[i] * history[uppermost[i]].temperature;
        total += area[i];
      }
    return sum / total;
  }
} // namespace asperity
