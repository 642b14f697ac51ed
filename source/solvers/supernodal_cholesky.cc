#include "supernodal_cholesky.h"

#include <algorithm>

namespace asperity
{
  bool
  SupernodalCholesky::analyze(const unsigned int                      n_rows,
                              const std::vector<std::pair<int, int>> &entries)
  {
    if (!structure.analyze(n_rows, entries))
      return false;
    const std::vector<unsigned int> place = structure.places();
    source.clear();
    slot.clear();
    for (std::size_t k = 0; k < entries.size(); ++k)
      if (entries[k].first <= entries[k].second)
        {
          const auto ends =
            std::minmax(place[entries[k].first], place[entries[k].second]);
          source.push_back(k);
          slot.push_back(structure.slot(ends.first, ends.second));
        }
    L.resize(structure.n_values());
    return true;
  }



  void
  SupernodalCholesky::clear()
  {
    structure.clear();
  }



  bool
  SupernodalCholesky::factorize(const double *entries)
  {
    std::fill(L.begin(), L.end(), 0.);
    for (std::size_t k = 0; k < slot.size(); ++k)
      L[slot[k]] = entries[source[k]];
    return structure.factorize(L.data());
  }



  void
  SupernodalCholesky::solve(double *b) const
  {
    structure.solve(L.data(), L.data(), b);
  }
} // namespace asperity
