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

    /** Sorted coordinates of points that lie symmetrically in a period from 0
     *  on, as Gauss points of its cells do. */
    class PeriodicCoordinates
    {
    public:
      /** The points on both sides, and the weight of the second. */
      struct Neighbours
      {
        unsigned int before, after;
        double       weight;
      };

      PeriodicCoordinates() = default;

      /** @param values each as often as there are points with it */
      explicit PeriodicCoordinates(std::vector<double> values)
      {
        std::sort(values.begin(), values.end());
        period = values.front() + values.back();
        for (const double value : values)
          if (x.empty() || value - x.back() > 1e-9 * period)
            x.push_back(value);
      }

      unsigned int
      size() const
      {
        return x.size();
      }

      unsigned int
      nearest(const double value) const
      {
        return std::lower_bound(x.begin(), x.end(), value - 1e-9 * period) -
               x.begin();
      }

      Neighbours
      around(const double value) const
      {
        const unsigned int n     = size();
        const unsigned int first = std::upper_bound(x.begin(), x.end(), value) -
                                   x.begin(); // that is larger
        const unsigned int before = (first + n - 1) % n, after = first % n;
        const double       begin = x[before] - (first == 0 ? period : 0.),
                     end         = x[after] + (first == n ? period : 0.);
        return {before, after, (value - begin) / (end - begin)};
      }

    private:
      std::vector<double> x;
      double              period = 0.;
    };
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



  template <int dim>
  SurfaceLayer<dim>::SurfaceLayer(const BasisTable<dim> &body,
                                  const BasisTable<dim> &edge)
    : columns(columns_under(body, edge))
  {
    if (!place_on_grid(body, edge))
      place_in_cells(body, edge);
    for (const Column &column : columns)
      area.push_back(body.JxW[column.top]);
  }



  template <int dim>
  bool
  SurfaceLayer<dim>::place_on_grid(const BasisTable<dim> &body,
                                   const BasisTable<dim> &edge)
  {
    const auto parameter_of = [&](const Column &column) {
      return body.parameter[column.top];
    };
    // Of the columns, along each parameter of the edge.
    std::array<PeriodicCoordinates, dim - 1> along;
    for (unsigned int d = 0; d < dim - 1; ++d)
      {
        std::vector<double> values;
        for (const Column &column : columns)
          values.push_back(parameter_of(column)[d]);
        along[d] = PeriodicCoordinates(values);
      }
    unsigned int n_grid = 1;
    for (const PeriodicCoordinates &coordinates : along)
      n_grid *= coordinates.size();
    if (n_grid != columns.size())
      return false;
    const auto number = [&](const Column &column) {
      unsigned int n = 0;
      for (unsigned int d = dim - 1; d-- > 0;)
        n = n * along[d].size() + along[d].nearest(parameter_of(column)[d]);
      return n;
    };
    std::sort(columns.begin(),
              columns.end(),
              [&](const Column &a, const Column &b) {
                return number(a) < number(b);
              });
    for (const auto &parameter : edge.parameter)
      {
        Place place;
        place.column.fill(0);
        place.weight.fill(1.);
        for (unsigned int d = dim - 1; d-- > 0;)
          {
            const auto between = along[d].around(parameter[d]);
            for (unsigned int i = 0; i < place.column.size(); ++i)
              {
                const bool is_after = (i >> d) % 2 == 1;
                place.column[i]     = place.column[i] * along[d].size() +
                                  (is_after ? between.after : between.before);
                place.weight[i] *=
                  is_after ? between.weight : 1. - between.weight;
              }
          }
        places.push_back(place);
      }
    return true;
  }



  template <int dim>
  void
  SurfaceLayer<dim>::place_in_cells(const BasisTable<dim> &body,
                                    const BasisTable<dim> &edge)
  {
    const unsigned int n = points_a_direction(body);
    // In the order of columns_under().
    std::map<unsigned int, unsigned int> first_column;
    for (const auto &element : edge.elements)
      first_column[element.cell] = 0;
    unsigned int n_columns = 0;
    for (auto &cell : first_column)
      {
        cell.second = n_columns;
        n_columns += body.points_per_element / n;
      }
    for (const auto &element : edge.elements)
      for (unsigned int q = 0; q < edge.points_per_element; ++q)
        {
          const auto parameter = edge.parameter[element.first_point + q];
          Place      place;
          place.column.fill(first_column[element.cell]);
          place.weight.fill(1.);
          unsigned int stride = 1;
          for (unsigned int d = 0; d < dim - 1; ++d, stride *= n)
            {
              const auto at = [&](const unsigned int i) {
                const Column &column =
                  columns[first_column[element.cell] + i * stride];
                return body.parameter[column.top][d];
              };
              unsigned int before = 0;
              while (before + 2 < n && at(before + 1) < parameter[d])
                ++before;
              const double after =
                std::min(std::max((parameter[d] - at(before)) /
                                    (at(before + 1) - at(before)),
                                  0.),
                         1.);
              for (unsigned int i = 0; i < place.column.size(); ++i)
                {
                  const bool is_after = (i >> d) % 2 == 1;
                  place.column[i] += (before + (is_after ? 1 : 0)) * stride;
                  place.weight[i] *= is_after ? after : 1. - after;
                }
            }
          places.push_back(place);
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
