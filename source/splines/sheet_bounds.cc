#include <asperity/splines/spline_sheet.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity
{
  using dealii::Tensor;

  namespace
  {
    constexpr double relative_tolerance = 1e-9;

    double
    size(const double value)
    {
      return std::abs(value);
    }

    double
    size(const Tensor<1, 2> &value)
    {
      return value.norm();
    }



    /** Bernstein coefficients of degree (p, q), along x fastest. */
    template <typename T>
    struct Net
    {
      unsigned int   p = 0, q = 0;
      std::vector<T> values;

      T &
      operator()(const unsigned int i, const unsigned int j)
      {
        return values[j * (p + 1) + i];
      }

      const T &
      operator()(const unsigned int i, const unsigned int j) const
      {
        return values[j * (p + 1) + i];
      }
    };



    /** Sum of the second differences along x and along y: what keeps the net
     *  from being met at its corners. */
    template <typename T>
    std::pair<double, double>
    bends(const Net<T> &net)
    {
      std::pair<double, double> result(0., 0.);
      for (unsigned int j = 0; j <= net.q; ++j)
        for (unsigned int i = 0; i <= net.p; ++i)
          {
            if (i >= 2)
              result.first +=
                size(net(i, j) - 2. * net(i - 1, j) + net(i - 2, j));
            if (j >= 2)
              result.second +=
                size(net(i, j) - 2. * net(i, j - 1) + net(i, j - 2));
          }
      return result;
    }



    /** De Casteljau at the middle: the left half is returned, `net` becomes the
     *  right one. */
    template <typename T>
    Net<T>
    bisect(Net<T> &net, const bool along_x)
    {
      Net<T>             left    = net;
      const unsigned int degree  = (along_x ? net.p : net.q);
      const unsigned int n_lines = (along_x ? net.q : net.p) + 1;
      const auto         at =
        [&](Net<T> &of, unsigned int i, unsigned int line) -> T & {
        return along_x ? of(i, line) : of(line, i);
      };
      for (unsigned int line = 0; line < n_lines; ++line)
        for (unsigned int k = 1; k <= degree; ++k)
          {
            for (unsigned int i = 0; i <= degree - k; ++i)
              at(net, i, line) =
                0.5 * (at(net, i, line) + at(net, i + 1, line));
            at(left, k, line) = at(net, 0, line);
          }
      return left;
    }



    /**
     * The largest value of a convex function of polynomials: on each part it is
     * at most that of one of the control values, and it has those of the
     * corners. Parts that could be better than the best corner by more than the
     * tolerance are bisected.
     */
    template <typename T, typename Function>
    class LargestValue
    {
    public:
      LargestValue(const std::vector<Net<T>> &nets,
                   const Function            &function,
                   const double               tolerance)
        : function(function)
        , tolerance(tolerance)
      {
        for (const Net<T> &net : nets)
          look_at_corners(net);
        for (const Net<T> &net : nets)
          search(net);
      }

      double best = -std::numeric_limits<double>::max();

    private:
      void
      look_at_corners(const Net<T> &net)
      {
        for (const unsigned int i : {0u, net.p})
          for (const unsigned int j : {0u, net.q})
            best = std::max(best, function(net(i, j)));
      }

      void
      search(const Net<T> &net)
      {
        bool exceeded = false;
        for (const T &value : net.values)
          exceeded = exceeded || function(value) > best + tolerance;
        if (!exceeded)
          return;
        const auto   bend  = bends(net);
        Net<T>       right = net;
        const Net<T> left  = bisect(right, bend.first >= bend.second);
        look_at_corners(left);
        look_at_corners(right);
        search(left);
        search(right);
      }

      const Function &function;
      const double    tolerance;
    };



    std::vector<Net<double>>
    height_nets(const SplineSheet &sheet)
    {
      std::vector<Net<double>> nets;
      for (const SheetPiece &piece : sheet.bezier_pieces())
        nets.push_back({sheet.degree(0), sheet.degree(1), piece.heights});
      return nets;
    }



    /** The gradient with Bernstein coefficients of the degree of the sheet: the
     *  derivative, raised by one degree, in each direction. */
    std::vector<Net<Tensor<1, 2>>>
    gradient_nets(const SplineSheet &sheet)
    {
      const unsigned int degree[] = {sheet.degree(0), sheet.degree(1)};
      std::vector<Net<Tensor<1, 2>>> nets;
      for (const SheetPiece &piece : sheet.bezier_pieces())
        {
          Net<Tensor<1, 2>> net;
          net.p = degree[0];
          net.q = degree[1];
          net.values.resize(piece.heights.size());
          for (unsigned int j = 0; j <= net.q; ++j)
            for (unsigned int i = 0; i <= net.p; ++i)
              for (unsigned int d = 0; d < 2; ++d)
                {
                  const unsigned int k      = (d == 0 ? i : j);
                  const unsigned int stride = (d == 0 ? 1 : net.p + 1);
                  const double *height = &piece.heights[j * (net.p + 1) + i];
                  double        rise   = 0.;
                  if (k > 0)
                    rise += k * (height[0] - *(height - stride));
                  if (k < degree[d])
                    rise += (degree[d] - k) * (height[stride] - height[0]);
                  net(i, j)[d] = rise / (piece.end[d] - piece.begin[d]);
                }
          nets.push_back(net);
        }
      return nets;
    }



    double
    height_tolerance(const SplineSheet &sheet)
    {
      const auto range = std::minmax_element(sheet.coefficients().begin(),
                                             sheet.coefficients().end());
      // Round-off of large heights must not be searched for extremes.
      return relative_tolerance * (*range.second - *range.first) +
             1e-14 * std::max(std::abs(*range.first), std::abs(*range.second));
    }
  } // namespace



  double
  SplineSheet::minimum() const
  {
    const auto negative = [](const double z) { return -z; };
    return -LargestValue(height_nets(*this), negative, height_tolerance(*this))
              .best;
  }



  double
  SplineSheet::maximum() const
  {
    const auto itself = [](const double z) { return z; };
    return LargestValue(height_nets(*this), itself, height_tolerance(*this))
      .best;
  }



  namespace
  {
    /** max of a norm of the gradient, which is at most its length. */
    template <typename Norm>
    double
    largest_norm(const SplineSheet &sheet, const Norm &norm)
    {
      const auto nets  = gradient_nets(sheet);
      double     bound = 0.;
      for (const auto &net : nets)
        for (const auto &gradient : net.values)
          bound = std::max(bound, gradient.norm());
      return LargestValue(nets, norm, relative_tolerance * bound).best;
    }
  } // namespace



  double
  SplineSheet::largest_slope() const
  {
    return largest_norm(*this, [](const Tensor<1, 2> &g) { return g.norm(); });
  }



  double
  SplineSheet::largest_slope(const unsigned int direction) const
  {
    return largest_norm(*this, [direction](const Tensor<1, 2> &g) {
      return std::abs(g[direction]);
    });
  }
} // namespace asperity
