#include <asperity/topography/roughness.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    struct Moments
    {
      double mean     = 0.;
      double absolute = 0.;
      double rms      = 0.;
      double skewness = 0.;
      double kurtosis = 0.;
      double peak     = 0.;
      double valley   = 0.;
    };

    /** Of the valid heights about their mean; zero if there are none. */
    Moments
    moments(const std::vector<double> &heights)
    {
      Moments     m;
      std::size_t n   = 0;
      double      sum = 0.;
      for (const double z : heights)
        if (!std::isnan(z))
          {
            sum += z;
            ++n;
          }
      if (n == 0)
        return m;
      // A second pass takes the round-off out of the mean of tall offsets.
      double correction = 0.;
      for (const double z : heights)
        if (!std::isnan(z))
          correction += z - sum / n;
      m.mean       = sum / n + correction / n;
      double third = 0., fourth = 0.;
      for (const double height : heights)
        if (!std::isnan(height))
          {
            const double z = height - m.mean;
            m.absolute += std::abs(z) / n;
            m.rms += z * z / n;
            third += z * z * z / n;
            fourth += z * z * z * z / n;
            m.peak   = std::max(m.peak, z);
            m.valley = std::max(m.valley, -z);
          }
      m.rms = std::sqrt(m.rms);
      if (m.rms > 0.)
        {
          m.skewness = third / std::pow(m.rms, 3);
          m.kurtosis = fourth / std::pow(m.rms, 4);
        }
      return m;
    }

    struct Slopes
    {
      double rms;            ///< root mean square
      double developed_area; ///< over the projected one, less 1
    };

    /** Over the points that have three valid neighbours on either side in each
     *  direction of @p map; NaN if there are none. */
    Slopes
    slopes(const HeightMap &map)
    {
      const int   margin_y = map.ny == 1 ? 0 : 3;
      double      sum = 0., area = 0.;
      std::size_t n = 0;
      for (int j = margin_y; j + margin_y < static_cast<int>(map.ny); ++j)
        for (int i = 3; i + 3 < static_cast<int>(map.nx); ++i)
          {
            double square = std::pow(
              slope_at([&](const int k) { return map(i + k, j); }, map.dx), 2);
            if (margin_y > 0)
              square +=
                std::pow(slope_at([&](const int k) { return map(i, j + k); },
                                  map.dy),
                         2);
            if (!std::isnan(square))
              {
                sum += square;
                area += square / (1. + std::sqrt(1. + square));
                ++n;
              }
          }
      if (n == 0)
        return {missing_height, missing_height};
      return {std::sqrt(sum / n), area / n};
    }
  } // namespace

  ArealRoughness
  areal_roughness(const HeightMap &map)
  {
    const Moments  m = moments(map.heights);
    const Slopes   s = slopes(map);
    ArealRoughness roughness;
    roughness.Sa  = m.absolute;
    roughness.Sq  = m.rms;
    roughness.Sp  = m.peak;
    roughness.Sv  = m.valley;
    roughness.Sz  = m.peak + m.valley;
    roughness.Ssk = m.skewness;
    roughness.Sku = m.kurtosis;
    roughness.Sdq = s.rms;
    roughness.Sdr = s.developed_area;
    return roughness;
  }

  ProfileRoughness
  profile_roughness(const std::vector<double> &heights, const double spacing)
  {
    const Moments    m = moments(heights);
    ProfileRoughness roughness;
    roughness.Ra  = m.absolute;
    roughness.Rq  = m.rms;
    roughness.Rt  = m.peak + m.valley;
    roughness.Rsk = m.skewness;
    roughness.Rku = m.kurtosis;

    HeightMap line;
    line.nx       = heights.size();
    line.ny       = 1;
    line.dx       = spacing;
    line.dy       = spacing;
    line.heights  = heights;
    roughness.Rdq = slopes(line).rms;

    // If five does not divide the number of samples, the first sections get
    // one more.
    constexpr unsigned int n_sections = 5;
    std::size_t            begin      = 0;
    for (unsigned int s = 0; s < n_sections; ++s)
      {
        const std::size_t n =
          heights.size() / n_sections + (s < heights.size() % n_sections);
        const Moments section =
          moments({heights.begin() + begin, heights.begin() + begin + n});
        roughness.Rz += (section.peak + section.valley) / n_sections;
        begin += n;
      }
    return roughness;
  }
} // namespace asperity
