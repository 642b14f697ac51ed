#include "face_columns.h"

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  using dealii::Point;

  FaceColumns::FaceColumns(const std::vector<Point<2>> &columns,
                           const unsigned int           n)
    : columns(columns)
    , n(n)
  {
    const double inset = dealii::QGauss<1>(n).point(0)[0];
    rim                = inset / (1. - 2. * inset);
    std::vector<std::pair<dealii::BoundingBox<2>, unsigned int>> boxes;
    for (unsigned int cell = 0; cell < columns.size(); cell += n * n)
      {
        const Point<2> &first = columns[cell],
                       &last  = columns[cell + n * n - 1];
        const auto beyond     = rim * (last - first);
        boxes.emplace_back(dealii::BoundingBox<2>(
                             std::make_pair(first - beyond, last + beyond)),
                           cell);
        for (unsigned int d = 0; d < 2; ++d)
          period[d] = std::max(period[d], last[d] + beyond[d]);
      }
    tree = dealii::pack_rtree(boxes);
  }



  double
  FaceColumns::at(const unsigned int cell,
                  const unsigned int line,
                  const unsigned int d) const
  {
    return columns[cell + line * (d == 0 ? 1 : n)][d];
  }



  unsigned int
  FaceColumns::cell_at(Point<2> x) const
  {
    for (unsigned int d = 0; d < 2; ++d)
      x[d] -= std::floor(x[d] / period[d]) * period[d];
    namespace bgi      = boost::geometry::index;
    unsigned int found = 0;
    for (const auto &[box, cell] :
         tree | bgi::adaptors::queried(bgi::nearest(x, 1)))
      found = cell;
    return found;
  }



  std::array<FaceColumns::Line, 2>
  FaceColumns::lines(const Point<2>    &x,
                     const unsigned int cell,
                     const unsigned int d) const
  {
    const double first = at(cell, 0, d), last = at(cell, n - 1, d);
    if (x[d] >= first && x[d] <= last)
      {
        unsigned int i = 0;
        while (i + 2 < n && at(cell, i + 1, d) < x[d])
          ++i;
        const double share =
          (x[d] - at(cell, i, d)) / (at(cell, i + 1, d) - at(cell, i, d));
        return {{{cell, i, 1. - share}, {cell, i + 1, share}}};
      }
    const bool   is_after = x[d] > last;
    const double own      = is_after ? last : first;
    // Less far beyond the end of the cell than any cell is long.
    const double beyond      = 1.001 * rim * (last - first);
    Point<2>     beside      = x;
    beside[d]                = is_after ? last + beyond : first - beyond;
    const unsigned int other = cell_at(beside), number = is_after ? 0 : n - 1;
    double way = (at(other, number, d) - own) * (is_after ? 1. : -1.);
    if (way <= 0.)
      way += period[d];
    const double share = std::abs(x[d] - own) / way;
    return {{{cell, is_after ? n - 1 : 0, 1. - share}, {other, number, share}}};
  }



  std::array<FaceColumns::Line, 2>
  FaceColumns::within(const unsigned int cell, const double x) const
  {
    unsigned int i = 0;
    while (i + 2 < n && at(cell, i + 1, 0) < x)
      ++i;
    const double share =
      std::clamp((x - at(cell, i, 0)) / (at(cell, i + 1, 0) - at(cell, i, 0)),
                 0.,
                 1.);
    return {{{cell, i, 1. - share}, {cell, i + 1, share}}};
  }



  FaceColumns::Place
  FaceColumns::around(const Point<2> &x, const unsigned int cell) const
  {
    Place place;
    for (const Line &line : lines(x, cell, 0))
      {
        const double x_of_line = at(line.cell, line.number, 0);
        for (const Line &row : lines({x_of_line, x[1]}, line.cell, 1))
          {
            const double       weight = line.weight * row.weight;
            const unsigned int first  = row.cell + row.number * n;
            if (row.cell == line.cell)
              place.emplace_back(first + line.number, weight);
            else
              for (const Line &column : within(row.cell, x_of_line))
                place.emplace_back(first + column.number,
                                   weight * column.weight);
          }
      }
    return place;
  }
} // namespace asperity
