#include <asperity/base/errors.h>
#include <asperity/tool_design/texture.h>

#include <cmath>
#include <numeric>

namespace asperity
{
  double
  Harmonics::rms() const
  {
    return std::sqrt(0.5 * std::inner_product(amplitudes.begin(),
                                              amplitudes.end(),
                                              amplitudes.begin(),
                                              0.));
  }



  std::vector<double>
  Harmonics::heights(const std::size_t n) const
  {
    std::vector<double> h(n, 0.);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < amplitudes.size(); ++k)
        h[i] +=
          amplitudes[k] * std::cos(2. * M_PI * (k + 1.) * i / n + phases[k]);
    return h;
  }



  Harmonics
  harmonics_of(const std::vector<double> &heights, const unsigned int n)
  {
    const std::size_t n_heights = heights.size();
    if (2 * n >= n_heights)
      throw InputError("A profile of " + std::to_string(n_heights) +
                       " heights does not determine " + std::to_string(n) +
                       " waves.");
    Harmonics result;
    for (unsigned int k = 1; k <= n; ++k)
      {
        double c = 0., s = 0.;
        for (std::size_t i = 0; i < n_heights; ++i)
          {
            const double angle = 2. * M_PI * k * i / n_heights;
            c += heights[i] * std::cos(angle);
            s += heights[i] * std::sin(angle);
          }
        result.amplitudes.push_back(2. * std::hypot(c, s) / n_heights);
        result.phases.push_back(std::atan2(-s, c));
      }
    return result;
  }



  double
  gaussian_transmission(const double wavelength)
  {
    // exp(-pi (alpha/wavelength)^2), alpha^2 = ln(2)/pi
    return std::exp2(-1. / (wavelength * wavelength));
  }



  std::vector<double>
  normalized(std::vector<double> heights)
  {
    const double n    = heights.size();
    const double mean = std::accumulate(heights.begin(), heights.end(), 0.) / n;
    double       sum = 0., largest = 0.;
    for (double &h : heights)
      {
        largest = std::max(largest, std::abs(h));
        h -= mean;
        sum += h * h;
      }
    const double rms = std::sqrt(sum / n);
    if (!(rms > 1e-12 * largest) || !std::isfinite(rms))
      throw InputError("A profile whose heights are all the same has no "
                       "texture.");
    for (double &h : heights)
      h /= rms;
    return heights;
  }
} // namespace asperity
