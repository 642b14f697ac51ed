#include <asperity/contact_zone/surface_layer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace asperity
{
  namespace
  {
    /** Gauss points of a cell in each direction. */
    template <int dim>
    unsigned int
    points_a_direction(const BasisTable<dim> &body)
    {
      return std::lround(std::pow(body.points_per_element, 1. / dim));
    }
  } // namespace



  template <int dim>
  std::vector<typename SurfaceLayer<dim>::Column>
  SurfaceLayer<dim>::columns_under(const BasisTable<dim> &body,
                                   const BasisTable<dim> &edge)
  {
    std::set<unsigned int> cells;
    for (const auto &element : edge.elements)
      cells.insert(element.cell);
    // The points of a cell are numbered along the edge first.
    const unsigned int  n       = points_a_direction(body);
    const unsigned int  n_layer = body.points_per_element / n;
    const double        height  = edge.parameter.front()[dim - 1];
    std::vector<Column> result;
    for (const auto &element : body.elements)
      if (cells.count(element.cell) > 0)
        for (unsigned int i = 0; i < n_layer; ++i)
          {
            const unsigned int top =
              element.first_point + n_layer * (n - 1) + i;
            const unsigned int below = top - n_layer;
            const double       upper = body.parameter[top][dim - 1];
            result.push_back(
              {top,
               below,
               (height - upper) / (upper - body.parameter[below][dim - 1])});
          }
    return result;
  }



  template <>
  SurfaceLayer<2>::SurfaceLayer(const BasisTable<2> &body,
                                const BasisTable<2> &edge,
                                const double         period)
    : columns(columns_under(body, edge))
  {
    std::sort(columns.begin(),
              columns.end(),
              [&](const Column &a, const Column &b) {
                return body.parameter[a.top][0] < body.parameter[b.top][0];
              });
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
        const double       begin  = x(left) - (after == 0 ? period : 0.);
        const double       end    = x(right) + (after == n ? period : 0.);
        const double       weight = (parameter[0] - begin) / (end - begin);
        places.push_back({{{left, right}}, {{1. - weight, weight}}});
      }
  }



  template <>
  SurfaceLayer<3>::SurfaceLayer(const BasisTable<3> &body,
                                const BasisTable<3> &edge,
                                const double)
    : columns(columns_under(body, edge))
  {
    for (const Column &column : columns)
      area.push_back(body.JxW[column.top]);
    const unsigned int                   n = points_a_direction(body);
    std::map<unsigned int, unsigned int> first_column; // of a cell
    for (const auto &element : body.elements)
      first_column[element.cell] = element.first_point;
    std::map<unsigned int, unsigned int> column_of; // an uppermost point
    for (unsigned int i = 0; i < columns.size(); ++i)
      column_of[columns[i].top] = i;

    for (const auto &element : edge.elements)
      {
        const unsigned int first =
          column_of.at(first_column.at(element.cell) + n * n * (n - 1));
        // Two neighbours of n in a direction, and the weight of the second.
        const auto between = [&](const double value, const unsigned int d) {
          const unsigned int stride = d == 0 ? 1 : n;
          const auto         x      = [&](const unsigned int i) {
            return body.parameter[columns[first + i * stride].top][d];
          };
          unsigned int i = 0;
          while (i + 2 < n && value > x(i + 1))
            ++i;
          return std::pair<unsigned int, double>(i,
                                                 (value - x(i)) /
                                                   (x(i + 1) - x(i)));
        };
        for (unsigned int q = 0; q < edge.points_per_element; ++q)
          {
            const auto &at            = edge.parameter[element.first_point + q];
            const auto [i, wx]        = between(at[0], 0);
            const auto [j, wy]        = between(at[1], 1);
            const unsigned int corner = first + j * n + i;
            places.push_back(
              {{{corner, corner + 1, corner + n, corner + n + 1}},
               {{(1. - wx) * (1. - wy),
                 wx * (1. - wy),
                 (1. - wx) * wy,
                 wx * wy}}});
          }
      }
  }



  template <int dim>
  typename SurfaceLayer<dim>::Point
  SurfaceLayer<dim>::at_top(const std::vector<MaterialState> &history,
                            const Column                     &column) const
  {
    const MaterialState &a = history[column.top], &b = history[column.below];
    const double         w = column.beyond;
    return {std::max((1. + w) * a.plastic_strain - w * b.plastic_strain, 0.),
            (1. + w) * a.temperature - w * b.temperature};
  }



  template <int dim>
  std::vector<typename SurfaceLayer<dim>::Point>
  SurfaceLayer<dim>::at_edge(const std::vector<MaterialState> &history) const
  {
    std::vector<Point> points;
    for (const Place &place : places)
      {
        Point sum{0., 0.};
        for (unsigned int i = 0; i < place.column.size(); ++i)
          {
            const Point a = at_top(history, columns[place.column[i]]);
            sum.plastic_strain += place.weight[i] * a.plastic_strain;
            sum.temperature += place.weight[i] * a.temperature;
          }
        // Beyond the outermost material points of a cell weights are negative.
        sum.plastic_strain = std::max(sum.plastic_strain, 0.);
        points.push_back(sum);
      }
    return points;
  }



  template <int dim>
  double
  SurfaceLayer<dim>::mean_temperature(
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



  template class SurfaceLayer<2>;
  template class SurfaceLayer<3>;
} // namespace asperity
