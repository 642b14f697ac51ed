#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/topography/gaussian_filter.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    /**
     * out[i] = sum over k of weights[|k - i|] in[k] over one line of a map,
     * whose elements lie @p stride apart. Applied to heights and to ones, it
     * gives the numerator and the norm of the filter, the latter being the end
     * correction.
     */
    void
    convolve(const double              *in,
             double                    *out,
             const unsigned int         n,
             const std::size_t          stride,
             const std::vector<double> &weights)
    {
      const int reach = static_cast<int>(weights.size()) - 1;
      for (int i = 0; i < static_cast<int>(n); ++i)
        {
          const int begin = std::max(0, i - reach);
          const int end   = std::min<int>(n - 1, i + reach);
          double    sum   = 0.;
          for (int k = begin; k <= end; ++k)
            sum += weights[std::abs(k - i)] * in[k * stride];
          out[i * stride] = sum;
        }
    }

    /** Both directions of a map, one after the other. */
    std::vector<double>
    convolve_map(const HeightMap           &map,
                 const std::vector<double> &values,
                 const std::vector<double> &weights_x,
                 const std::vector<double> &weights_y)
    {
      std::vector<double> rows(values.size()), result(values.size());
      for (unsigned int j = 0; j < map.ny; ++j)
        convolve(&values[std::size_t(j) * map.nx],
                 &rows[std::size_t(j) * map.nx],
                 map.nx,
                 1,
                 weights_x);
      for (unsigned int i = 0; i < map.nx; ++i)
        convolve(&rows[i], &result[i], map.ny, map.nx, weights_y);
      return result;
    }

    void
    check_index(const HeightMap   &map,
                const double       nesting_index,
                const std::string &name)
    {
      const double spacing = std::max(map.dx, map.dy);
      if (!(nesting_index > 2. * spacing))
        throw InputError("The nesting index of the " + name + "-filter, " +
                         format_quantity(nesting_index, "um", 4) +
                         ", is not above two sample spacings, " +
                         format_quantity(2. * spacing, "um", 4) + ", of " +
                         quoted_name(map.provenance.file) + ".");
    }
  } // namespace

  std::vector<double>
  gaussian_weights(const double spacing, const double cutoff)
  {
    const double        pi    = std::acos(-1.);
    const double        alpha = std::sqrt(std::log(2.) / pi);
    const auto          reach = static_cast<unsigned int>(cutoff / spacing);
    std::vector<double> weights;
    for (unsigned int k = 0; k <= reach; ++k)
      weights.push_back(
        std::exp(-pi * std::pow(k * spacing / (alpha * cutoff), 2)));
    return weights;
  }

  std::vector<double>
  gaussian_low_pass(const std::vector<double> &values,
                    const double               spacing,
                    const double               cutoff,
                    const bool                 periodic)
  {
    const auto          weights = gaussian_weights(spacing, cutoff);
    const int           reach   = static_cast<int>(weights.size()) - 1;
    const int           n       = values.size();
    std::vector<double> result(n, missing_height);
    for (int i = 0; i < n; ++i)
      {
        if (std::isnan(values[i]))
          continue;
        double sum = 0., norm = 0.;
        for (int k = -reach; k <= reach; ++k)
          {
            const int j = periodic ? ((i + k) % n + n) % n : i + k;
            if (j < 0 || j >= n || std::isnan(values[j]))
              continue;
            sum += weights[std::abs(k)] * values[j];
            norm += weights[std::abs(k)];
          }
        result[i] = sum / norm;
      }
    return result;
  }

  HeightMap
  gaussian_low_pass(const HeightMap &map, const double cutoff)
  {
    const auto          wx = gaussian_weights(map.dx, cutoff);
    const auto          wy = gaussian_weights(map.dy, cutoff);
    std::vector<double> valid(map.heights.size()), values(map.heights.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      {
        valid[i]  = !std::isnan(map.heights[i]);
        values[i] = std::isnan(map.heights[i]) ? 0. : map.heights[i];
      }
    const auto sums  = convolve_map(map, values, wx, wy);
    const auto norms = convolve_map(map, valid, wx, wy);

    HeightMap result = map;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!std::isnan(map.heights[i]))
        result.heights[i] = sums[i] / norms[i];
    return result;
  }

  void
  apply_s_filter(HeightMap &map, const double nesting_index)
  {
    check_index(map, nesting_index, "S");
    map = gaussian_low_pass(map, nesting_index);
  }

  void
  apply_l_filter(HeightMap &map, const double nesting_index)
  {
    check_index(map, nesting_index, "L");
    const HeightMap waviness = gaussian_low_pass(map, nesting_index);
    for (std::size_t i = 0; i < map.heights.size(); ++i)
      map.heights[i] -= waviness.heights[i];
  }
} // namespace asperity
