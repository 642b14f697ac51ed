#ifndef asperity_base_random_numbers_h
#define asperity_base_random_numbers_h

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace asperity
{
  /**
   * Random numbers that are the same on every machine: the standard fixes the
   * Mersenne twister, but not its own distributions.
   */
  class RandomNumbers
  {
  public:
    explicit RandomNumbers(const std::uint64_t seed);

    /** Uniform in [0, 1), a multiple of 2^-53. */
    double
    uniform();

    /** Uniform among 0, ..., n - 1; n must be positive. */
    std::size_t
    below(const std::size_t n);

    /** Of the normal distribution of mean 0 and deviation 1 (Box and Muller),
     * as exact as the machine's logarithm and cosine. */
    double
    normal();

    /** The numbers 0, ..., n - 1 in random order (Fisher and Yates). */
    std::vector<std::size_t>
    permutation(const std::size_t n);

  private:
    std::mt19937_64 generator;
  };
} // namespace asperity

#endif
