#include <asperity/base/errors.h>
#include <asperity/topography/png_image.h>

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace asperity
{
  namespace
  {
    std::string
    big_endian(const std::uint32_t n)
    {
      return {static_cast<char>(n >> 24),
              static_cast<char>(n >> 16),
              static_cast<char>(n >> 8),
              static_cast<char>(n)};
    }

    std::string
    chunk(const std::string &type, const std::string &data)
    {
      const std::string body = type + data;
      const auto        crc =
        crc32(0, reinterpret_cast<const Bytef *>(body.data()), body.size());
      return big_endian(data.size()) + body + big_endian(crc);
    }
  } // namespace

  Colour
  viridis(const double t)
  {
    // Every eighth of the colour map of matplotlib (CC0).
    static const double table[9][3] = {{68, 1, 84},
                                       {71, 44, 122},
                                       {59, 81, 139},
                                       {44, 113, 142},
                                       {33, 144, 141},
                                       {39, 173, 129},
                                       {92, 200, 99},
                                       {170, 220, 50},
                                       {253, 231, 37}};
    const double        u           = 8. * std::clamp(t, 0., 1.);
    const int           i           = std::min(7, static_cast<int>(u));
    Colour              colour;
    for (unsigned int c = 0; c < 3; ++c)
      colour[c] = static_cast<unsigned char>(
        std::lround(table[i][c] + (u - i) * (table[i + 1][c] - table[i][c])));
    return colour;
  }

  std::string
  encode_png(const unsigned int         width,
             const unsigned int         height,
             const std::vector<Colour> &pixels)
  {
    std::string raw;
    for (unsigned int row = 0; row < height; ++row)
      {
        raw += '\0'; // no filter
        for (unsigned int column = 0; column < width; ++column)
          for (const unsigned char c :
               pixels[std::size_t(row) * width + column])
            raw += static_cast<char>(c);
      }
    uLongf      length = compressBound(raw.size());
    std::string packed(length, '\0');
    if (compress(reinterpret_cast<Bytef *>(packed.data()),
                 &length,
                 reinterpret_cast<const Bytef *>(raw.data()),
                 raw.size()) != Z_OK)
      throw ComputationError("The picture cannot be compressed.");
    packed.resize(length);
    // 8 bits a channel, RGB, deflate, no interlacing
    const std::string header = big_endian(width) + big_endian(height) +
                               std::string("\x08\x02\x00\x00\x00", 5);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", packed) +
           chunk("IEND", "");
  }

  std::string
  base64(const std::string &bytes)
  {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                 "abcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string       text;
    for (std::size_t i = 0; i < bytes.size(); i += 3)
      {
        const std::size_t n     = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t     group = 0;
        for (std::size_t k = 0; k < 3; ++k)
          group =
            group << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0);
        for (std::size_t k = 0; k < 4; ++k)
          text += k <= n ? digits[group >> (18 - 6 * k) & 63] : '=';
      }
    return text;
  }
} // namespace asperity
