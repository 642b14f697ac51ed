#include <asperity/topography/roughness.h>
#include <asperity/topography/texture.h>

#include <algorithm>

namespace asperity
{
  Texture
  measure_texture(const HeightMap &map)
  {
    const int   margin_y = map.ny == 1 ? 0 : 3;
    double      xx = 0., xy = 0., yy = 0.;
    std::size_t n = 0;
    for (int j = margin_y; j + margin_y < static_cast<int>(map.ny); ++j)
      for (int i = 3; i + 3 < static_cast<int>(map.nx); ++i)
        {
          const double slope_x =
            slope_at([&](const int k) { return map(i + k, j); }, map.dx);
          const double slope_y =
            margin_y == 0 ?
              0. :
              slope_at([&](const int k) { return map(i, j + k); }, map.dy);
          if (std::isnan(slope_x) || std::isnan(slope_y))
            continue;
          xx += slope_x * slope_x;
          xy += slope_x * slope_y;
          yy += slope_y * slope_y;
          ++n;
        }
    Texture texture;
    if (n == 0)
      return texture;
    const double mean      = 0.5 * (xx + yy) / n;
    const double radius    = std::hypot(0.5 * (xx - yy), xy) / n;
    texture.direction      = 0.5 * std::atan2(2. * xy, xx - yy);
    texture.largest_slope  = std::sqrt(mean + radius);
    texture.smallest_slope = std::sqrt(std::max(0., mean - radius));
    return texture;
  }



  double
  pixel_noise(const HeightMap &map)
  {
    std::vector<double> differences;
    for (unsigned int j = 0; j < map.ny; ++j)
      for (unsigned int i = 1; i + 1 < map.nx; ++i)
        {
          const double d = map(i - 1, j) - 2. * map(i, j) + map(i + 1, j);
          if (!std::isnan(d))
            differences.push_back(std::abs(d));
        }
    if (differences.empty())
      return 0.;
    const auto middle = differences.begin() + differences.size() / 2;
    std::nth_element(differences.begin(), middle, differences.end());
    return 1.4826 * *middle / std::sqrt(6.);
  }



  double
  filtered_noise_slope(const HeightMap &map,
                       const double     noise,
                       const double     cutoff)
  {
    // exp(-pi (x/(alpha cutoff))^2), alpha^2 = ln 2/pi, as exp(-x^2/(2 s^2))
    const double s = cutoff * std::sqrt(std::log(2.) / (2. * M_PI * M_PI));
    return noise * std::sqrt(map.dx * map.dy / (8. * M_PI)) / (s * s);
  }



  double
  nesting_index_of_at_least(const double length)
  {
    const double decade = std::pow(10., std::floor(std::log10(length)));
    for (const double factor : {1., 2., 2.5, 5., 8., 10.})
      if (factor * decade >= length * (1. - 1e-9))
        return factor * decade;
    return 20. * decade; // only by round-off of the logarithm
  }
} // namespace asperity
