#include <asperity/contact_zone/surface_layer.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace asperity
{
  std::vector<SurfaceLayer::Column>
  SurfaceLayer::columns_under(const BasisTable<2> &body,
                              const BasisTable<2> &edge)
  {
    std::set<unsigned int> cells;
    for (const auto &element : edge.elements)
      cells.insert(element.cell);
    // The points of a cell are numbered along the edge first.
    const unsigned int  n = std::lround(std::sqrt(body.points_per_element));
    const double        height = edge.parameter.front()[1];
    std::vector<Column> result;
    for (const auto &element : body.elements)
      if (cells.count(element.cell) > 0)
        for (unsigned int i = 0; i < n; ++i)
          {
            const unsigned int top   = element.first_point + n * (n - 1) + i;
            const unsigned int below = top - n;
            const double       upper = body.parameter[top][1];
            result.push_back(
              {top,
               below,
               (height - upper) / (upper - body.parameter[below][1])});
          }
    std::sort(result.begin(),
              result.end(),
              [&](const Column &a, const Column &b) {
                return body.parameter[a.top][0] < body.parameter[b.top][0];
              });
    return result;
  }



  SurfaceLayer::SurfaceLayer(const BasisTable<2> &body,
                             const BasisTable<2> &edge,
                             const double         period)
    : columns(columns_under(body, edge))
  {
    for (const Column &column : columns)
      area.push_back(body.JxW[column.top]);
    const unsigned int n = columns.size();
    const auto         x = [&](const unsigned int i) {
      return body.parameter[columns[i].top][0];
    };
    for (const auto &parameter : edge.parameter)
      {
        const unsigned int after =
          std::upper_bound(columns.begin(),
                           columns.end(),
                           parameter[0],
                           [&](const double value, const Column &column) {
                             return value < body.parameter[column.top][0];
                           }) -
          columns.begin();
        const unsigned int right = after % n, left = (after + n - 1) % n;
        const double       begin = x(left) - (after == 0 ? period : 0.);
        const double       end   = x(right) + (after == n ? period : 0.);
        places.push_back({left, right, (parameter[0] - begin) / (end - begin)});
      }
  }



  SurfaceLayer::Point
  SurfaceLayer::at_top(const std::vector<MaterialState> &history,
                       const Column                     &column) const
  {
    const MaterialState &a = history[column.top], &b = history[column.below];
    const double         w = column.beyond;
    return {std::max((1. + w) * a.plastic_strain - w * b.plastic_strain, 0.),
            (1. + w) * a.temperature - w * b.temperature};
  }



  std::vector<SurfaceLayer::Point>
  SurfaceLayer::at_edge(const std::vector<MaterialState> &history) const
  {
    std::vector<Point> points;
    for (const Place &place : places)
      {
        const Point a  = at_top(history, columns[place.left]),
                    b  = at_top(history, columns[place.right]);
        const double w = place.weight;
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
    for (unsigned int i = 0; i < columns.size(); ++i)
      {
        sum += area[i] * at_top(history, columns[i]).temperature;
        total += area[i];
      }
    return sum / total;
  }
} // namespace asperity
