#ifndef asperity_topography_png_image_h
#define asperity_topography_png_image_h

#include <array>
#include <string>
#include <vector>

namespace asperity
{
  /** Red, green, blue. */
  using Colour = std::array<unsigned char, 3>;

  /** Blue-green-yellow (viridis) for t in [0, 1]; even in lightness. */
  Colour
  viridis(const double t);

  /** A PNG file of width*height pixels, row-major from the upper left.
   *  @throws ComputationError if it cannot be compressed */
  std::string
  encode_png(const unsigned int         width,
             const unsigned int         height,
             const std::vector<Colour> &pixels);

  std::string
  base64(const std::string &bytes);
} // namespace asperity

#endif
