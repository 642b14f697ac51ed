#include <asperity/base/errors.h>
#include <asperity/base/md5.h>
#include <asperity/base/text.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>

namespace asperity
{
  namespace
  {
    constexpr std::size_t block_size = 64;

    /** floor(2^32 |sin(i)|), i = 1, ..., 64. */
    std::array<std::uint32_t, 64>
    sines()
    {
      std::array<std::uint32_t, 64> table;
      for (unsigned int i = 0; i < table.size(); ++i)
        table[i] = static_cast<std::uint32_t>(
          std::floor(std::abs(std::sin(i + 1.)) * 4294967296.));
      return table;
    }

    /** RFC 1321, for bytes that come in pieces. */
    class Digest
    {
    public:
      /** The size of all pieces but the last is a multiple of 64. */
      void
      add(const char *bytes, const std::size_t size)
      {
        n_bytes += size;
        for (std::size_t i = 0; i + block_size <= size; i += block_size)
          add_block(bytes + i);
        rest.assign(bytes + size / block_size * block_size, bytes + size);
      }

      std::string
      finish()
      {
        // A one, zeros, and the number of bits fill up the last block or two.
        rest += '\x80';
        rest.resize(rest.size() <= 56 ? 56 : 120, '\0');
        const std::uint64_t n_bits = 8 * n_bytes;
        rest.append(reinterpret_cast<const char *>(&n_bits), sizeof(n_bits));
        for (std::size_t i = 0; i < rest.size(); i += block_size)
          add_block(rest.data() + i);

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

    private:
      using State = std::array<std::uint32_t, 4>;

      /** Its 16 steps, whose numbers are known to the compiler: unrolled they
       *  take a third of the instructions. */
      template <unsigned int round>
      static void
      add_round(const std::uint32_t *const words, State &state)
      {
        static constexpr unsigned int shifts[4][4]       = {{7, 12, 17, 22},
                                                            {5, 9, 14, 20},
                                                            {4, 11, 16, 23},
                                                            {6, 10, 15, 21}};
        static constexpr unsigned int factors[]          = {1, 5, 3, 7};
        static constexpr unsigned int offsets[]          = {0, 1, 5, 0};
        static const std::array<std::uint32_t, 64> table = sines();
        auto &[a, b, c, d]                               = state;
#pragma GCC unroll 16
        for (unsigned int i = 0; i < 16; ++i)
          {
            const std::uint32_t mix = round == 0 ? (b & c) | (~b & d) :
                                      round == 1 ? (d & b) | (~d & c) :
                                      round == 2 ? b ^ c ^ d :
                                                   c ^ (b | ~d);
            const std::uint32_t sum =
              a + mix + table[16 * round + i] +
              words[(factors[round] * i + offsets[round]) % 16];
            const unsigned int shift = shifts[round][i % 4];
            a                        = d;
            d                        = c;
            c                        = b;
            b += sum << shift | sum >> (32 - shift);
          }
      }

      /** The 64 steps on one block. */
      void
      add_block(const char *block)
      {
        std::uint32_t words[16];
        std::memcpy(words, block, sizeof(words));
        State next = state;
        add_round<0>(words, next);
        add_round<1>(words, next);
        add_round<2>(words, next);
        add_round<3>(words, next);
        for (unsigned int i = 0; i < 4; ++i)
          state[i] += next[i];
      }

      State         state = {{0x67452301, 0xefcdab89, 0x98badcfe, 0x10325476}};
      std::uint64_t n_bytes = 0;
      std::string   rest; ///< less than a block
    };
  } // namespace



  std::string
  md5(const std::string &bytes)
  {
    Digest digest;
    digest.add(bytes.data(), bytes.size());
    return digest.finish();
  }



  std::string
  md5_of_file(const std::string &path)
  {
    std::ifstream           in(path, std::ios::binary);
    Digest                  digest;
    std::array<char, 65536> piece;
    while (in)
      {
        in.read(piece.data(), piece.size());
        digest.add(piece.data(), static_cast<std::size_t>(in.gcount()));
      }
    if (!in.eof())
      throw InputError("The file " + quoted_name(path) +
                       " does not exist or cannot be read.");
    return digest.finish();
  }
} // namespace asperity
