#ifndef asperity_base_lanes_h
#define asperity_base_lanes_h

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

/**
 * Functions of a number and of several numbers side by side, so that one
 * template is the formula for a point and for a pack of points. Comparisons of
 * packs give masks: `a < b & c < d`, `!mask`, but no `&&` and no jump other
 * than by any().
 */
namespace asperity::lanes
{
  /** Numbers of a pack. */
  constexpr unsigned int width = 4;

  using Pack = double __attribute__((vector_size(width * sizeof(double))));
  using Bits =
    std::uint64_t __attribute__((vector_size(width * sizeof(double))));
  using PackMask = decltype(Pack() < Pack());

  /** The same number in each lane. */
  template <class Number>
  inline Number
  broadcast(const double x)
  {
    return Number() + x;
  }

  inline bool
  any(const bool mask)
  {
    return mask;
  }

  inline bool
  any(const PackMask &mask)
  {
    return (mask[0] | mask[1] | mask[2] | mask[3]) != 0;
  }

  /** a where the mask is set, else b. */
  inline double
  select(const bool mask, const double a, const double b)
  {
    return mask ? a : b;
  }

  inline Pack
  select(const PackMask &mask, const Pack &a, const Pack &b)
  {
    return mask ? a : b;
  }

  /** a where the mask is set, else the number b. */
  inline Pack
  select(const PackMask &mask, const Pack &a, const double b)
  {
    return mask ? a : Pack() + b;
  }

  inline double
  abs(const double x)
  {
    return std::fabs(x);
  }

  inline Pack
  abs(const Pack &x)
  {
    return x < 0. ? -x : x;
  }

  inline double
  sqrt(const double x)
  {
    return std::sqrt(x);
  }

  inline Pack
  sqrt(const Pack &x)
  {
    return Pack{std::sqrt(x[0]),
                std::sqrt(x[1]),
                std::sqrt(x[2]),
                std::sqrt(x[3])};
  }

  inline double
  log(const double x)
  {
    return std::log(x);
  }

  /**
   * Natural logarithm of positive, normal numbers; infinity and NaN stay what
   * they are, what it makes of other numbers is finite and of no meaning. With
   * x = 2^k (1 + f), s = f/(2 + f): log(1 + f) = 2 atanh s by the polynomial of
   * FreeBSD's C library, e_log.c. Off by less than an ulp.
   */
  inline Pack
  log(const Pack &x)
  {
    constexpr std::uint64_t one       = 0x3ff0000000000000;
    constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd;
    constexpr std::uint64_t mantissa  = 0x000fffffffffffff;
    constexpr std::uint64_t magic     = 0x4330000000000000; // 2^52
    const Bits              bits      = (Bits)x + (one - root_half);
    const Pack              k = (Pack)((bits >> 52) | magic) - (0x1p52 + 1023.);
    const Pack              f = (Pack)((bits & mantissa) + root_half) - 1.;
    const Pack              s = f / (2. + f), z = s * s;
    const Pack              R =
      z * (6.666666666666735130e-01 +
           z * (3.999999999940941908e-01 +
                z * (2.857142874366239149e-01 +
                     z * (2.222219843214978396e-01 +
                          z * (1.818357216161805012e-01 +
                               z * (1.531383769920937332e-01 +
                                    z * 1.479819860511658591e-01))))));
    const Pack half_square = 0.5 * f * f;
    const Pack result      = k * 6.93147180369123816490e-01 -
                        ((half_square - (s * (half_square + R) +
                                         k * 1.90821492927058770002e-10)) -
                         f);
    return x < std::numeric_limits<double>::infinity() ? result : x;
  }

  inline double
  exp(const double x)
  {
    return std::exp(x);
  }

  /** e^x for |x| <= 708; beyond that of the nearer end. With x = n ln 2 + r,
   *  |r| <= ln(2)/2: 2^n times Taylor's sum of e^r, which the terms left out
   *  change by 4e-18. Off by less than two ulp. */
  inline Pack
  exp(const Pack &x)
  {
    constexpr double largest = 708.;
    constexpr double magic   = 0x1.8p52; // the sum's last digits are n
    const Pack       bounded =
      x > largest ? Pack() + largest : (x < -largest ? Pack() - largest : x);
    const Pack shifted = bounded * 1.4426950408889634074 + magic;
    const Pack n       = shifted - magic;
    const Pack r       = (bounded - n * 6.93147180369123816490e-01) -
                   n * 1.90821492927058770002e-10;
    Pack sum = Pack() + 1. / 6227020800.;
    for (const double coefficient : {1. / 479001600.,
                                     1. / 39916800.,
                                     1. / 3628800.,
                                     1. / 362880.,
                                     1. / 40320.,
                                     1. / 5040.,
                                     1. / 720.,
                                     1. / 120.,
                                     1. / 24.,
                                     1. / 6.,
                                     0.5})
      sum = sum * r + coefficient;
    sum = 1. + (r + r * r * sum);
    return (Pack)((Bits)sum + ((Bits)shifted << 52));
  }

  inline double
  pow(const double x, const double exponent)
  {
    return std::pow(x, exponent);
  }

  /** x^exponent of positive, normal numbers; its relative error is that of
   *  log(x) times the exponent and |log(x)|. */
  inline Pack
  pow(const Pack &x, const double exponent)
  {
    return exp(exponent * log(x));
  }
} // namespace asperity::lanes

#endif
