#include <asperity/base/random_numbers.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace asperity
{
  RandomNumbers::RandomNumbers(const std::uint64_t seed)
    : generator(seed)
  {}



  double
  RandomNumbers::uniform()
  {
    return static_cast<double>(generator() >> 11) * 0x1p-53;
  }



  std::size_t
  RandomNumbers::below(const std::size_t n)
  {
    // The remainder of a division prefers small numbers unless the range of the
    // generator is cut to a multiple of n.
    const std::uint64_t largest = std::numeric_limits<std::uint64_t>::max();
    const std::uint64_t limit   = largest - largest % n;
    std::uint64_t       number  = generator();
    while (number >= limit)
      number = generator();
    return static_cast<std::size_t>(number % n);
  }



  double
  RandomNumbers::normal()
  {
    const double pi     = 3.14159265358979323846;
    const double radius = std::sqrt(-2. * std::log(1. - uniform()));
    return radius * std::cos(2. * pi * uniform());
  }



  std::vector<std::size_t>
  RandomNumbers::permutation(const std::size_t n)
  {
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = n; i > 1; --i)
      std::swap(order[i - 1], order[below(i)]);
    return order;
  }
} // namespace asperity
