#ifndef asperity_solvers_finite_h
#define asperity_solvers_finite_h

#include <algorithm>
#include <cmath>

namespace asperity
{
  /** Whether all entries of a vector are numbers. Norms of deal.II do not serve
   * to ask, since they refuse other entries in Debug builds. */
  template <typename VectorType>
  bool
  is_finite(const VectorType &v)
  {
    return std::all_of(v.begin(), v.end(), [](const double value) {
      return std::isfinite(value);
    });
  }
} // namespace asperity

#endif
