#include <asperity/splines/sheet_certificate.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity
{
  namespace
  {
    // Beyond these numbers the closest point is of no use, or cannot be told
    // from others (centre of a sphere).
    constexpr double       max_pieces  = 2e6;
    constexpr double       max_periods = 1e3;
    constexpr unsigned int max_parts   = 20000;
    constexpr unsigned int max_depth   = 80;

    // To look up bounds of more pieces costs more than it brings.
    constexpr long max_pieces_of_bounds = 16;

    /** Distance of zero to an interval. */
    double
    gap(const double low, const double high)
    {
      return std::max({0., low, -high});
    }



    /** De Casteljau at the middle, for lines of a net: `right` is the whole net
     *  at first, then its right half. */
    void
    bisect_lines(double            *left,
                 double            *right,
                 const unsigned int degree,
                 const unsigned int step,
                 const unsigned int n_lines,
                 const unsigned int line_step)
    {
      for (unsigned int line = 0; line < n_lines; ++line)
        {
          double *l = left + line * line_step, *r = right + line * line_step;
          l[0] = r[0];
          for (unsigned int k = 1; k <= degree; ++k)
            {
              for (unsigned int i = 0; i <= degree - k; ++i)
                r[i * step] = (r[i * step] + r[(i + 1) * step]) / 2.;
              l[k * step] = r[0];
            }
        }
    }
  } // namespace



  SheetCertificate::SheetCertificate(const SheetPieces   &pieces,
                                     const SheetDistance &distance,
                                     const SheetFoot     &known)
    : pieces(pieces)
    , distance(distance)
    , p(pieces.degree(0))
    , q(pieces.degree(1))
    , best_foot(known)
    , best_squared_distance(known.squared_distance())
  {}



  bool
  SheetCertificate::prove()
  {
    const double r = best_foot.rz;
    const double farthest =
      max_periods * std::max(pieces.period(0), pieces.period(1));
    if (!(best_squared_distance < farthest * farthest))
      return false;
    if (best_foot.converged)
      {
        const SheetBending &all = pieces.bending();
        if (r * (r > 0. ? all.least : all.greatest) > -1.)
          return true;
        const Circle circle = circle_around(best_foot);
        const double reach  = std::sqrt(best_squared_distance) +
                             std::hypot(best_foot.rx, best_foot.ry);
        const bool everywhere =
          circle.low[0] == -std::numeric_limits<double>::max();
        if (everywhere && circle.radius >= reach)
          return true;
        circles[n_circles++] = circle;
      }
    return examine_all();
  }



  SheetBending
  SheetCertificate::bending_within(const double radius) const
  {
    const dealii::Point<3> &point = distance.point();
    if (radius > max_pieces_of_bounds *
                   std::max(pieces.mean_width(0), pieces.mean_width(1)))
      return pieces.bending();
    const long first_x = pieces.span(0, point[0] - radius);
    const long last_x  = pieces.span(0, point[0] + radius);
    const long first_y = pieces.span(1, point[1] - radius);
    const long last_y  = pieces.span(1, point[1] + radius);
    if ((last_x - first_x + 1) * (last_y - first_y + 1) > max_pieces_of_bounds)
      return pieces.bending();
    SheetBending bending;
    for (long j = first_y; j <= last_y; ++j)
      for (long i = first_x; i <= last_x; ++i)
        bending.include(pieces.bending(pieces.piece(i, j)));
    return bending;
  }



  SheetCertificate::Circle
  SheetCertificate::circle_around(const SheetFoot &foot) const
  {
    constexpr double everywhere = std::numeric_limits<double>::max();
    Circle           circle;
    circle.x = foot.rx;
    circle.y = foot.ry;
    for (unsigned int d = 0; d < 2; ++d)
      {
        circle.low[d]  = -everywhere;
        circle.high[d] = everywhere;
      }
    // The foot and all closer places lie within its own distance.
    SheetBending bending = bending_within(std::sqrt(foot.squared_distance()));
    if (foot.rz * (foot.rz > 0. ? bending.least : bending.greatest) > -1.)
      {
        circle.radius = everywhere;
        return circle;
      }
    if (std::min(p, q) < 3)
      {
        // Second derivatives jump at the knots: only on the foot's own piece.
        const long spans[] = {pieces.span(0, foot.x), pieces.span(1, foot.y)};
        for (unsigned int d = 0; d < 2; ++d)
          {
            const double at = distance.point()[d];
            circle.low[d]   = pieces.begin(d, spans[d]) - at;
            circle.high[d]  = pieces.begin(d, spans[d] + 1) - at;
          }
        bending = pieces.bending(pieces.piece(spans[0], spans[1]));
      }
    const double decrease =
      std::abs(foot.rz) * bending.change / 3. +
      foot.jet.gradient.norm() * std::max(-bending.least, bending.greatest);
    circle.radius = std::max(0., least_eigenvalue(foot.hessian())) / decrease;
    return circle;
  }



  bool
  SheetCertificate::examine_all()
  {
    const dealii::Point<3> &point = distance.point();
    const double            above =
      gap(pieces.lowest() - point[2], pieces.highest() - point[2]);
    const double reach2 =
      std::max(0., best_squared_distance - above * above) * (1. + 1e-14);
    const double reach = std::sqrt(reach2) + distance.position_noise();
    if (4. * reach * reach >
        max_pieces * pieces.mean_width(0) * pieces.mean_width(1))
      return false;
    const long first_x = pieces.span(0, point[0] - reach);
    const long last_x  = pieces.span(0, point[0] + reach);
    const long first_y = pieces.span(1, point[1] - reach);
    const long last_y  = pieces.span(1, point[1] + reach);
    for (long j = first_y, next_j; j <= last_y; j = next_j)
      {
        next_j = std::min(pieces.end_of_block(1, j), last_y + 1);
        for (long i = first_x, next_i; i <= last_x; i = next_i)
          {
            next_i = std::min(pieces.end_of_block(0, i), last_x + 1);
            if (!examine_block({{i, j}}, {{next_i, next_j}}))
              return false;
          }
      }
    return true;
  }



  bool
  SheetCertificate::examine_block(const std::array<long, 2> &begin,
                                  const std::array<long, 2> &end)
  {
    const dealii::Point<3> &point = distance.point();
    double                  gap2  = 0.;
    for (unsigned int d = 0; d < 2; ++d)
      {
        const double here = gap(pieces.begin(d, begin[d]) - point[d],
                                pieces.begin(d, end[d]) - point[d]);
        gap2 += here * here;
      }
    const auto  &bounds = pieces.block_bounds(pieces.piece(begin[0], begin[1]));
    const double here   = gap(bounds[0] - point[2], bounds[1] - point[2]);
    if (gap2 + here * here >= best_squared_distance)
      return true;
    for (long j = begin[1]; j < end[1]; ++j)
      for (long i = begin[0]; i < end[0]; ++i)
        {
          examine(i, j);
          if (n_parts > max_parts)
            return false;
        }
    return true;
  }



  void
  SheetCertificate::examine(const long span_x, const long span_y)
  {
    const dealii::Point<3> &point    = distance.point();
    const long              spans[2] = {span_x, span_y};
    Part                    part;
    double                  gap2 = 0.;
    for (unsigned int d = 0; d < 2; ++d)
      {
        part.low[d]       = pieces.begin(d, spans[d]) - point[d];
        part.high[d]      = pieces.begin(d, spans[d] + 1) - point[d];
        const double here = gap(part.low[d], part.high[d]);
        gap2 += here * here;
      }
    const std::size_t piece = pieces.piece(span_x, span_y);
    const double      here =
      gap(pieces.lowest(piece) - point[2], pieces.highest(piece) - point[2]);
    if (gap2 + here * here >= best_squared_distance || in_a_circle(part))
      return;
    const double *heights = pieces.heights(piece);
    for (unsigned int k = 0; k < (p + 1) * (q + 1); ++k)
      part.heights[k] = heights[k] - point[2];
    if (!is_beyond_tangent_plane(part))
      search(part, 0);
  }



  bool
  SheetCertificate::in_a_circle(const Part &part) const
  {
    for (unsigned int k = 0; k < n_circles; ++k)
      {
        const Circle &circle = circles[k];
        const double  dx =
          std::max(part.high[0] - circle.x, circle.x - part.low[0]);
        const double dy =
          std::max(part.high[1] - circle.y, circle.y - part.low[1]);
        if (dx * dx + dy * dy <= circle.radius * circle.radius &&
            part.low[0] >= circle.low[0] && part.high[0] <= circle.high[0] &&
            part.low[1] >= circle.low[1] && part.high[1] <= circle.high[1])
          return true;
      }
    return false;
  }



  bool
  SheetCertificate::is_beyond_tangent_plane(const Part &part) const
  {
    // Of the sphere of the best distance, at the best foot.
    for (unsigned int j = 0; j <= q; ++j)
      {
        const double y =
          part.low[1] + (part.high[1] - part.low[1]) * j / double(q);
        for (unsigned int i = 0; i <= p; ++i)
          {
            const double x =
              part.low[0] + (part.high[0] - part.low[0]) * i / double(p);
            if (!(x * best_foot.rx + y * best_foot.ry +
                    part.heights[j * (p + 1) + i] * best_foot.rz >=
                  best_squared_distance))
              return false;
          }
      }
    return true;
  }



  void
  SheetCertificate::look_for_better(const Part &part, const unsigned int depth)
  {
    const double    x = distance.point()[0] + (part.low[0] + part.high[0]) / 2.;
    const double    y = distance.point()[1] + (part.low[1] + part.high[1]) / 2.;
    const SheetFoot middle = distance.foot(x, y);
    const bool      better = middle.squared_distance() < best_squared_distance;
    // Deep below is another minimum, as far as the best one known: a circle
    // around it spares the parts near it.
    const bool stuck = depth >= 6 && depth % 2 == 0 &&
                       n_circles < max_circles &&
                       least_eigenvalue(middle.hessian()) > 0.;
    if (!better && !stuck)
      return;
    const SheetFoot found = distance.minimize(middle);
    if (found.squared_distance() < best_squared_distance)
      {
        const unsigned int iterations = best_foot.iterations;
        best_foot                     = found;
        best_squared_distance         = found.squared_distance();
        best_foot.iterations += iterations;
      }
    if (found.converged && n_circles < max_circles)
      {
        const Circle circle = circle_around(found);
        for (unsigned int k = 0; k < n_circles; ++k)
          if (std::hypot(circle.x - circles[k].x, circle.y - circles[k].y) <
              0.1 * circles[k].radius)
            return;
        circles[n_circles++] = circle;
      }
  }



  void
  SheetCertificate::search(const Part &part, const unsigned int depth)
  {
    if (++n_parts > max_parts || depth > max_depth)
      return;
    const unsigned int n = (2 * p + 1) * (2 * q + 1);
    double             squares[(2 * max_degree + 1) * (2 * max_degree + 1)];
    const double       noise = form_squared_distance(part, squares);
    const double       limit = best_squared_distance * (1. - 1e-13) - noise;
    if (*std::min_element(squares, squares + n) >= limit ||
        is_monotonic(squares, noise))
      return;
    look_for_better(part, depth);
    if (in_a_circle(part))
      return;

    // Across the direction in which the squared distance bends most.
    const unsigned int nx      = 2 * p + 1;
    double             bend[2] = {0., 0.};
    for (unsigned int k = 0; k < n; ++k)
      {
        if (k % nx >= 2)
          bend[0] +=
            std::abs(squares[k] - 2. * squares[k - 1] + squares[k - 2]);
        if (k >= 2 * nx)
          bend[1] +=
            std::abs(squares[k] - 2. * squares[k - nx] + squares[k - 2 * nx]);
      }
    const unsigned int d    = (bend[0] >= bend[1] ? 0 : 1);
    Part               left = part, right = part;
    left.high[d] = right.low[d] = (part.low[d] + part.high[d]) / 2.;
    if (d == 0)
      bisect_lines(left.heights, right.heights, p, 1, q + 1, p + 1);
    else
      bisect_lines(left.heights, right.heights, q, p + 1, p + 1, 1);
    for (const Part *half : {&left, &right})
      if (!in_a_circle(*half) && !is_beyond_tangent_plane(*half))
        search(*half, depth + 1);
  }
} // namespace asperity
