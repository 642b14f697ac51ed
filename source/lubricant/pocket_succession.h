#ifndef asperity_source_fluid_pocket_succession_h
#define asperity_source_fluid_pocket_succession_h

#include <asperity/lubricant/pocket_tracker.h>

#include <deal.II/base/types.h>

#include <algorithm>
#include <string>
#include <vector>

namespace asperity
{
  /** Which pocket of the next step each old one is, and the reverse; without
   *  partner: dealii::numbers::invalid_unsigned_int. */
  struct PocketSuccession
  {
    /** [old][new], what they have in common where they are open: lengths of
     *  intervals, or elements of regions */
    std::vector<std::vector<double>> overlaps;
    std::vector<unsigned int>        heir;     ///< of an old pocket
    std::vector<unsigned int>        ancestor; ///< of a new pocket

    /** Pairs pockets that have no partner yet, those with the largest entries
     *  of the matrix first. */
    void
    pair(const std::vector<std::vector<double>> &common)
    {
      struct Candidate
      {
        double       length;
        unsigned int before, after;
      };
      std::vector<Candidate> candidates;
      for (unsigned int i = 0; i < heir.size(); ++i)
        for (unsigned int j = 0; j < ancestor.size(); ++j)
          if (common[i][j] > 0.)
            candidates.push_back({common[i][j], i, j});
      std::stable_sort(candidates.begin(),
                       candidates.end(),
                       [](const Candidate &a, const Candidate &b) {
                         return a.length > b.length;
                       });
      for (const Candidate &c : candidates)
        if (heir[c.before] == dealii::numbers::invalid_unsigned_int &&
            ancestor[c.after] == dealii::numbers::invalid_unsigned_int)
          {
            heir[c.before]    = c.after;
            ancestor[c.after] = c.before;
          }
    }

    bool
    overlaps_nothing_before(const unsigned int after) const
    {
      return std::all_of(overlaps.begin(),
                         overlaps.end(),
                         [after](const auto &row) { return row[after] == 0.; });
    }

    bool
    overlaps_nothing_after(const unsigned int before) const
    {
      return std::all_of(overlaps[before].begin(),
                         overlaps[before].end(),
                         [](const double length) { return length == 0.; });
    }

    /** The new pocket that an old one overlaps most. */
    unsigned int
    most_overlapped_after(const unsigned int before) const
    {
      const auto &row = overlaps[before];
      return std::max_element(row.begin(), row.end()) - row.begin();
    }

    /** The old pocket that a new one overlaps most. */
    unsigned int
    most_overlapped_before(const unsigned int after) const
    {
      return std::max_element(overlaps.begin(),
                              overlaps.end(),
                              [after](const auto &a, const auto &b) {
                                return a[after] < b[after];
                              }) -
             overlaps.begin();
    }
  };

  struct PocketTracker::Succession : PocketSuccession
  {};

  /** A, B, ..., Z, AA, AB, ... for 1, 2, ... */
  inline std::string
  pocket_name(const unsigned int number)
  {
    std::string name;
    for (unsigned int rest = number; rest > 0; rest = (rest - 1) / 26)
      name.insert(name.begin(), char('A' + (rest - 1) % 26));
    return name;
  }
} // namespace asperity

#endif
