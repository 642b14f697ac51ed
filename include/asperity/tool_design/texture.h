#ifndef asperity_tool_design_texture_h
#define asperity_tool_design_texture_h

#include <cstddef>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * A periodic profile of a tool without its size: heights h(x_i) at the places
   * x_i = i/n of a period of 1, out of the tool, as multiples of their root
   * mean square, and of mean 0.
   */
  struct ToolTexture
  {
    std::string         kind; ///< "grooves", "measured", ...
    std::vector<double> heights;
  };

  /**
   * A periodic profile as the tool of a scene has it,
   *
   *   h(x) = sum over k = 1 .. n of a_k cos(2 pi k x/L + phi_k).
   */
  struct Harmonics
  {
    std::vector<double> amplitudes; ///< a_k, not negative
    std::vector<double> phases;     ///< phi_k [rad]

    /** Root mean square height. */
    double
    rms() const;

    /** h at n equidistant places of the period. */
    std::vector<double>
    heights(const std::size_t n) const;
  };

  /** The first n waves of heights at equidistant places, without their mean.
   *  @throws InputError if the heights do not determine so many */
  Harmonics
  harmonics_of(const std::vector<double> &heights, const unsigned int n);

  /** What a Gaussian filter (ISO 16610-21) leaves of a wave: half of it at the
   *  nesting index. @param wavelength over the nesting index */
  double
  gaussian_transmission(const double wavelength);

  /** Mean 0 and root mean square 1. @throws InputError if they are all the same
   *  or no numbers */
  std::vector<double>
  normalized(std::vector<double> heights);
} // namespace asperity

#endif
