#include "supernodal_lu.h"

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    /** By which products of the factors may exceed the entries of the matrix:
     *  so many digits are lost of sixteen. */
    constexpr double largest_growth = 1e5;
  } // namespace



  bool
  SupernodalLu::analyze(const unsigned int                      n_rows,
                        const std::vector<std::pair<int, int>> &entries)
  {
    if (!structure.analyze(n_rows, entries, true))
      return false;
    const std::vector<unsigned int> place = structure.places();
    slot.clear();
    for (const auto &[i, j] : entries)
      slot.push_back(place[i] >= place[j] ?
                       structure.slot(place[j], place[i]) :
                       structure.n_values() +
                         structure.slot(place[i], place[j]));
    factors.resize(2 * structure.n_values());
    return true;
  }



  void
  SupernodalLu::clear()
  {
    structure.clear();
  }



  bool
  SupernodalLu::factorize(const double *entries)
  {
    std::fill(factors.begin(), factors.end(), 0.);
    double largest = 0.;
    for (std::size_t k = 0; k < slot.size(); ++k)
      {
        factors[slot[k]] = entries[k];
        largest          = std::max(largest, std::abs(entries[k]));
      }
    const double product =
      structure.factorize(factors.data(),
                          factors.data() + structure.n_values());
    return std::isfinite(product) && product <= largest_growth * largest;
  }



  void
  SupernodalLu::solve(double *b) const
  {
    structure.solve(factors.data(), factors.data() + structure.n_values(), b);
  }
} // namespace asperity
