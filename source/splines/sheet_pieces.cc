#include <asperity/base/errors.h>
#include <asperity/splines/sheet_pieces.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity
{
  namespace
  {
    /** Coefficients of powers of s in [-1, 1] from those of the Bernstein
     *  polynomials on [0, 1], in place, for one line of a net. Subdivision at
     *  the middle gives the derivatives there as forward differences. */
    void
    bernstein_to_powers(double            *c,
                        const unsigned int p,
                        const unsigned int step)
    {
      std::vector<double> right(p + 1);
      for (unsigned int i = 0; i <= p; ++i)
        right[i] = c[i * step];
      for (unsigned int k = 0; k < p; ++k)
        for (unsigned int i = 0; i < p - k; ++i)
          right[i] = (right[i] + right[i + 1]) / 2.;
      double binomial = 1.;
      for (unsigned int k = 0; k <= p; ++k)
        {
          c[k * step] = binomial * right[0];
          for (unsigned int i = 0; i + k < p; ++i)
            right[i] = right[i + 1] - right[i];
          binomial *= double(p - k) / (k + 1);
        }
    }



    /** The derivative of a net by one direction, raised to the degree of the
     *  net, so that nets of different derivatives can be combined. */
    std::vector<double>
    differentiated(const std::vector<double>         &net,
                   const std::array<unsigned int, 2> &degree,
                   const unsigned int                 direction,
                   const double                       width)
    {
      std::vector<double> result(net.size());
      const unsigned int  step = (direction == 0 ? 1 : degree[0] + 1);
      for (unsigned int i = 0; i < net.size(); ++i)
        {
          const unsigned int k = (i / step) % (degree[direction] + 1);
          if (k > 0)
            result[i] += k * (net[i] - net[i - step]);
          if (k < degree[direction])
            result[i] += (degree[direction] - k) * (net[i + step] - net[i]);
          result[i] /= width;
        }
      return result;
    }



    /** Eigenvalues and norms are convex (or concave) functions, so that their
     *  extremes over the control values bound them. */
    SheetBending
    bending_of(const SheetPiece                  &piece,
               const std::array<unsigned int, 2> &degree)
    {
      const double w[] = {piece.end[0] - piece.begin[0],
                          piece.end[1] - piece.begin[1]};
      const auto   d   = [&](const std::vector<double> &net, unsigned int k) {
        return differentiated(net, degree, k, w[k]);
      };
      const auto xx = d(d(piece.heights, 0), 0), xy = d(d(piece.heights, 0), 1),
                 yy  = d(d(piece.heights, 1), 1);
      const auto xxx = d(xx, 0), xxy = d(xx, 1), xyy = d(yy, 0), yyy = d(yy, 1);
      SheetBending bending;
      for (unsigned int i = 0; i < xx.size(); ++i)
        {
          const double mean   = (xx[i] + yy[i]) / 2.;
          const double radius = std::hypot((xx[i] - yy[i]) / 2., xy[i]);
          bending.include({mean - radius,
                           mean + radius,
                           std::sqrt(xxx[i] * xxx[i] + 3. * xxy[i] * xxy[i] +
                                     3. * xyy[i] * xyy[i] + yyy[i] * yyy[i])});
        }
      return bending;
    }
  } // namespace



  void
  SheetBending::include(const SheetBending &other)
  {
    least    = std::min(least, other.least);
    greatest = std::max(greatest, other.greatest);
    change   = std::max(change, other.change);
  }



  SheetPieces::SheetPieces(const SplineSheet &sheet)
  {
    for (unsigned int d = 0; d < 2; ++d)
      {
        const KnotVector &knots = sheet.knot_vector(d);
        if (knots.degree() < 2 || knots.degree() > max_degree)
          throw InputError("Closest points are sought on a sheet of degree " +
                           std::to_string(knots.degree()) + ", but 2 to " +
                           std::to_string(max_degree) + " are expected.");
        Axis &axis            = axes[d];
        axis.degree           = knots.degree();
        axis.n                = knots.n_spans();
        axis.front            = knots.front();
        axis.period           = sheet.period(d);
        axis.spans_per_length = axis.n / axis.period;
        axis.breakpoints      = knots.breakpoints();
        for (unsigned int i = 0; i < axis.n; ++i)
          {
            const double a = axis.breakpoints[i], b = axis.breakpoints[i + 1];
            axis.middle.push_back((a + b) / 2.);
            axis.inverse_half_width.push_back(2. / (b - a));
          }
      }
    const std::array<unsigned int, 2> degree = {
      {axes[0].degree, axes[1].degree}};
    n_coefficients = (degree[0] + 1) * (degree[1] + 1);
    for (const SheetPiece &piece : sheet.bezier_pieces())
      {
        bernstein.insert(bernstein.end(),
                         piece.heights.begin(),
                         piece.heights.end());
        std::vector<double> net = piece.heights;
        for (unsigned int j = 0; j <= degree[1]; ++j)
          bernstein_to_powers(&net[j * (degree[0] + 1)], degree[0], 1);
        for (unsigned int i = 0; i <= degree[0]; ++i)
          bernstein_to_powers(&net[i], degree[1], degree[0] + 1);
        powers.insert(powers.end(), net.begin(), net.end());
        const auto range =
          std::minmax_element(piece.heights.begin(), piece.heights.end());
        height_bounds.push_back(*range.first);
        height_bounds.push_back(*range.second);
        bendings.push_back(bending_of(piece, degree));
        all_bending.include(bendings.back());
      }
    const auto [low, high] =
      std::minmax_element(bernstein.begin(), bernstein.end());
    all_lowest       = *low;
    all_highest      = *high;
    place_of_lowest  = middle_of((low - bernstein.begin()) / n_coefficients);
    place_of_highest = middle_of((high - bernstein.begin()) / n_coefficients);
    build_blocks();
  }



  void
  SheetPieces::build_blocks()
  {
    const unsigned int n        = axes[0].n;
    const unsigned int n_blocks = (n + spans_of_block - 1) / spans_of_block;
    for (std::size_t piece = 0; piece < bendings.size(); ++piece)
      {
        const unsigned int block =
          piece / n / spans_of_block * n_blocks + piece % n / spans_of_block;
        block_of.push_back(block);
        if (block >= blocks.size())
          blocks.resize(block + 1, {{all_highest, all_lowest}});
        blocks[block][0] = std::min(blocks[block][0], lowest(piece));
        blocks[block][1] = std::max(blocks[block][1], highest(piece));
      }
  }



  long
  SheetPieces::end_of_block(const unsigned int direction, const long span) const
  {
    const long n = axes[direction].n, of_turn = ((span % n) + n) % n;
    const long end = (of_turn / spans_of_block + 1) * spans_of_block;
    return span - of_turn + std::min(end, n);
  }



  std::array<double, 2>
  SheetPieces::middle_of(const std::size_t piece) const
  {
    return {
      {axes[0].middle[piece % axes[0].n], axes[1].middle[piece / axes[0].n]}};
  }



  unsigned int
  SheetPieces::Axis::locate(const double t, double &s) const
  {
    double wrapped = t;
    if (!(t >= front && t < front + period))
      {
        wrapped = t - period * std::floor((t - front) / period);
        // A place that is no number must not lead out of the table.
        if (!(wrapped >= front && wrapped < front + period))
          wrapped = front;
      }
    // With equal spans the first attempt is right up to round-off.
    unsigned int span =
      std::min(unsigned((wrapped - front) * spans_per_length), n - 1);
    while (span > 0 && wrapped < breakpoints[span])
      --span;
    while (span + 1 < n && wrapped >= breakpoints[span + 1])
      ++span;
    s = (wrapped - middle[span]) * inverse_half_width[span];
    return span;
  }



  template <unsigned int P, unsigned int Q>
  void
  SheetPieces::evaluate(const double *table,
                        const double  s,
                        const double  t,
                        double       *values) const
  {
    // Horner's rule for value, first and half the second derivative, of the
    // rows in s, then of their results in t; zero stands for a degree that is
    // not known to the compiler.
    const int p = (P == 0 ? axes[0].degree : P);
    const int q = (Q == 0 ? axes[1].degree : Q);
    double    z = 0., zs = 0., zss = 0., zt = 0., zst = 0., ztt = 0.;
    for (int j = q; j >= 0; --j)
      {
        const double *row = table + j * (p + 1);
        double        a = row[p], a1 = 0., a2 = 0.;
        for (int i = p - 1; i >= 0; --i)
          {
            a2 = a2 * s + a1;
            a1 = a1 * s + a;
            a  = a * s + row[i];
          }
        ztt = ztt * t + zt;
        zt  = zt * t + z;
        z   = z * t + a;
        zst = zst * t + zs;
        zs  = zs * t + a1;
        zss = zss * t + a2;
      }
    values[0] = z;
    values[1] = zs;
    values[2] = zt;
    values[3] = 2. * zss;
    values[4] = zst;
    values[5] = 2. * ztt;
  }



  SheetJet
  SheetPieces::jet(const double x, const double y) const
  {
    double             s, t, values[6];
    const unsigned int u = axes[0].locate(x, s);
    const unsigned int v = axes[1].locate(y, t);
    const double      *table =
      powers.data() + (std::size_t(v) * axes[0].n + u) * n_coefficients;
    if (axes[0].degree == 3 && axes[1].degree == 3)
      evaluate<3, 3>(table, s, t, values);
    else if (axes[0].degree == 2 && axes[1].degree == 2)
      evaluate<2, 2>(table, s, t, values);
    else if (axes[0].degree == 5 && axes[1].degree == 5)
      evaluate<5, 5>(table, s, t, values);
    else
      evaluate<0, 0>(table, s, t, values);
    const double a = axes[0].inverse_half_width[u];
    const double b = axes[1].inverse_half_width[v];
    SheetJet     jet;
    jet.height        = values[0];
    jet.gradient[0]   = a * values[1];
    jet.gradient[1]   = b * values[2];
    jet.hessian[0][0] = a * a * values[3];
    jet.hessian[0][1] = a * b * values[4];
    jet.hessian[1][1] = b * b * values[5];
    return jet;
  }



  long
  SheetPieces::span(const unsigned int direction, const double t) const
  {
    const Axis  &axis = axes[direction];
    const double turn = std::floor((t - axis.front) / axis.period);
    double       s;
    return long(turn) * axis.n + axis.locate(t, s);
  }



  double
  SheetPieces::begin(const unsigned int direction, const long span) const
  {
    const Axis &axis = axes[direction];
    const long  n    = axis.n;
    const long  turn = (span >= 0 ? span / n : -((n - 1 - span) / n));
    return axis.breakpoints[span - turn * n] + turn * axis.period;
  }



  std::size_t
  SheetPieces::piece(const long span_x, const long span_y) const
  {
    const long n = axes[0].n, m = axes[1].n;
    const long i = ((span_x % n) + n) % n, j = ((span_y % m) + m) % m;
    return std::size_t(j) * n + i;
  }
} // namespace asperity
