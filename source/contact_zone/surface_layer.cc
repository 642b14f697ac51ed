#include <asperity/contact_zone/surface_layer.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "face_columns.h"

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

    /** Where a value is between sorted abscissae: after that of an index, by a
     *  share of the way to the next one, which is beyond 0 and 1 outside. */
    std::pair<unsigned int, double>
    position_between(const std::vector<double> &abscissae, const double value)
    {
      unsigned int before = 0;
      while (before + 2 < abscissae.size() && abscissae[before + 1] < value)
        ++before;
      return {before,
              (value - abscissae[before]) /
                (abscissae[before + 1] - abscissae[before])};
    }

    /** The cells of a body as they lie on one another, seen by their Gauss
     *  points, which are numbered along the last parameter last. */
    template <int dim>
    class CellStacks
    {
    public:
      explicit CellStacks(const BasisTable<dim> &body)
        : body(body)
        , n(points_a_direction(body))
        , n_row(body.points_per_element / n)
      {
        // From the points of a cell to its sides.
        const double inset =
          dealii::QGauss<1>(n).point(0)[0]; // of a cell of length 1
        for (const auto &element : body.elements)
          {
            const auto &first = body.parameter[element.first_point];
            const auto &last =
              body.parameter[element.first_point + body.points_per_element - 1];
            const auto rim = inset / (1. - 2. * inset) * (last - first);
            boxes.emplace_back(std::make_pair(first - rim, last + rim));
          }
        std::vector<std::pair<dealii::BoundingBox<dim>, unsigned int>> numbered;
        for (const auto &box : boxes)
          numbered.emplace_back(box, numbered.size());
        tree = dealii::pack_rtree(numbered);
      }

      /** The uppermost points of a cell. */
      std::vector<unsigned int>
      upper_row(const unsigned int e) const
      {
        std::vector<unsigned int> row(n_row);
        std::iota(row.begin(),
                  row.end(),
                  body.elements[e].first_point + n_row * (n - 1));
        return row;
      }

      /** Points and their weights, which are linear along the edge: of the
       *  upper row of the cell below, where there is one, or else of the
       *  second row of this one.
       *  @param top of the upper row of the cell e */
      std::vector<std::pair<unsigned int, double>>
      below(const unsigned int e, const unsigned int top) const
      {
        const auto under = cell_under(e);
        if (!under)
          return {{top - n_row, 1.}};
        std::vector<std::pair<unsigned int, double>> points = {
          {upper_row(*under).front(), 1.}};
        unsigned int stride = 1;
        for (unsigned int d = 0; d < dim - 1; ++d, stride *= n)
          {
            std::vector<double> abscissae;
            for (unsigned int i = 0; i < n; ++i)
              abscissae.push_back(
                body.parameter[upper_row(*under).front() + i * stride][d]);
            const auto [before, after] =
              position_between(abscissae, body.parameter[top][d]);
            std::vector<std::pair<unsigned int, double>> products;
            for (const auto &[point, weight] : points)
              for (const unsigned int i : {0, 1})
                {
                  const double share = i == 1 ? after : 1. - after;
                  if (std::abs(share) > 1e-12) // as across a cell as wide
                    products.emplace_back(point + (before + i) * stride,
                                          weight * share);
                }
            points = products;
          }
        return points;
      }

    private:
      std::optional<unsigned int>
      cell_under(const unsigned int e) const
      {
        dealii::Point<dim> below = boxes[e].center();
        // Less deep than any cell is high.
        below[dim - 1] -= 0.501 * boxes[e].side_length(dim - 1);
        namespace bgi = boost::geometry::index;
        for (const auto &[box, under] :
             tree | bgi::adaptors::queried(bgi::intersects(below)))
          return under;
        return {};
      }

      const BasisTable<dim>                                           &body;
      unsigned int                                                     n, n_row;
      std::vector<dealii::BoundingBox<dim>>                            boxes;
      dealii::RTree<std::pair<dealii::BoundingBox<dim>, unsigned int>> tree;
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
    const CellStacks<dim> stacks(body);
    const double          height = edge.parameter.front()[dim - 1];
    std::vector<Column>   result;
    for (unsigned int e = 0; e < body.elements.size(); ++e)
      if (cells.count(body.elements[e].cell) > 0)
        for (const unsigned int top : stacks.upper_row(e))
          {
            Column column;
            column.top   = top;
            column.below = stacks.below(e, top);
            // All of a row are at one depth.
            const unsigned int below = column.below.front().first;
            const double       upper = body.parameter[top][dim - 1];
            column.beyond =
              (height - upper) / (upper - body.parameter[below][dim - 1]);
            result.push_back(column);
          }
    return result;
  }



  template <int dim>
  SurfaceLayer<dim>::SurfaceLayer(const BasisTable<dim> &body,
                                  const BasisTable<dim> &edge)
    : columns(columns_under(body, edge))
  {
    if (!place_on_grid(body, edge))
      place_between_cells(body, edge);
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
    std::vector<Column> ordered(n_grid);
    for (const Column &column : columns)
      {
        unsigned int number = 0;
        for (unsigned int d = dim - 1; d-- > 0;)
          number = number * along[d].size() +
                   along[d].nearest(parameter_of(column)[d]);
        ordered[number] = column;
      }
    columns = ordered;
    for (const auto &parameter : edge.parameter)
      {
        Place place = {{0, 1.}};
        for (unsigned int d = dim - 1; d-- > 0;)
          {
            const auto between = along[d].around(parameter[d]);
            Place      finer;
            for (const auto &[column, weight] : place)
              {
                const unsigned int first = column * along[d].size();
                finer.emplace_back(first + between.before,
                                   weight * (1. - between.weight));
                finer.emplace_back(first + between.after,
                                   weight * between.weight);
              }
            place = finer;
          }
        places.push_back(place);
      }
    return true;
  }



  template <int dim>
  void
  SurfaceLayer<dim>::place_between_cells(const BasisTable<dim> &body,
                                         const BasisTable<dim> &edge)
  {
    // The columns of an edge are a grid.
    if constexpr (dim == 3)
      {
        const unsigned int            n = points_a_direction(body);
        std::vector<dealii::Point<2>> parameters;
        for (const Column &column : columns)
          parameters.emplace_back(body.parameter[column.top][0],
                                  body.parameter[column.top][1]);
        const FaceColumns face(parameters, n);
        // In the order of columns_under().
        std::map<unsigned int, unsigned int> first_column;
        for (const auto &element : edge.elements)
          first_column[element.cell] = 0;
        unsigned int n_columns = 0;
        for (auto &cell : first_column)
          {
            cell.second = n_columns;
            n_columns += n * n;
          }
        for (const auto &element : edge.elements)
          for (unsigned int q = 0; q < edge.points_per_element; ++q)
            {
              const auto &x = edge.parameter[element.first_point + q];
              places.push_back(
                face.around({x[0], x[1]}, first_column[element.cell]));
            }
      }
  }



  template <int dim>
  typename SurfaceLayer<dim>::Point
  SurfaceLayer<dim>::at_top(const std::vector<MaterialState> &history,
                            const Column                     &column) const
  {
    const MaterialState &top = history[column.top];
    Point                below{0., 0.};
    for (const auto &[point, weight] : column.below)
      {
        below.plastic_strain += weight * history[point].plastic_strain;
        below.temperature += weight * history[point].temperature;
      }
    const double w = column.beyond;
    return {std::max((1. + w) * top.plastic_strain - w * below.plastic_strain,
                     0.),
            (1. + w) * top.temperature - w * below.temperature};
  }



  template <int dim>
  std::vector<typename SurfaceLayer<dim>::Point>
  SurfaceLayer<dim>::at_edge(const std::vector<MaterialState> &history) const
  {
    std::vector<Point> tops;
    for (const Column &column : columns)
      tops.push_back(at_top(history, column));
    std::vector<Point> points;
    for (const Place &place : places)
      {
        Point sum{0., 0.};
        for (const auto &[column, weight] : place)
          {
            sum.plastic_strain += weight * tops[column].plastic_strain;
            sum.temperature += weight * tops[column].temperature;
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
