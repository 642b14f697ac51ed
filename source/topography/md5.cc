#include <asperity/topography/md5.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace asperity
{
  namespace
  {
    using State = std::array<std::uint32_t, 4>;

    /** The 64 steps of RFC 1321 on one block of 64 bytes. */
    void
    digest_block(const char *block, State &state)
    {
      static const unsigned int shifts[4][4] = {{7, 12, 17, 22},
                                                {5, 9, 14, 20},
                                                {4, 11, 16, 23},
                                                {6, 10, 15, 21}};
      std::uint32_t             words[16];
      std::memcpy(words, block, sizeof(words));
      auto [a, b, c, d] = state;
      for (unsigned int i = 0; i < 64; ++i)
        {
          const unsigned int        round = i / 16;
          const std::uint32_t       mix   = round == 0 ? (b & c) | (~b & d) :
                                            round == 1 ? (d & b) | (~d & c) :
                                            round == 2 ? b ^ c ^ d :
                                                         c ^ (b | ~d);
          static const unsigned int factors[] = {1, 5, 3, 7};
          static const unsigned int offsets[] = {0, 1, 5, 0};
          const auto                constant  = static_cast<std::uint32_t>(
            std::floor(std::abs(std::sin(i + 1.)) * 4294967296.));
          const std::uint32_t sum =
            a + mix + constant +
            words[(factors[round] * i + offsets[round]) % 16];
          const unsigned int shift = shifts[round][i % 4];
          a                        = d;
          d                        = c;
          c                        = b;
          b += sum << shift | sum >> (32 - shift);
        }
      state[0] += a;
      state[1] += b;
      state[2] += c;
      state[3] += d;
    }
  } // namespace

  std::string
  md5(const std::string &bytes)
  {
    State state = {{0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476}};
    const std::size_t n_full = bytes.size() / 64 * 64;
    for (std::size_t i = 0; i < n_full; i += 64)
      digest_block(bytes.data() + i, state);

    // A one, zeros, and the number of bits fill up the last block or two.
    std::string rest = bytes.substr(n_full) + '\x80';
    rest.resize(rest.size() <= 56 ? 56 : 120, '\0');
    const std::uint64_t n_bits = 8 * static_cast<std::uint64_t>(bytes.size());
    rest.append(reinterpret_cast<const char *>(&n_bits), sizeof(n_bits));
    for (std::size_t i = 0; i < rest.size(); i += 64)
      digest_block(rest.data() + i, state);

    std::string text;
    for (unsigned int i = 0; i < 16; ++i)
      {
        char two[3];
        std::snprintf(two,
                      sizeof(two),
                      "%02x",
                      state[i / 4] >> (8 * (i % 4)) & 255);
        text += two;
      }
    return text;
  }
} // namespace asperity
