#include <asperity/lubricant/region_tracker.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "pocket_succession.h"

namespace asperity
{
  namespace
  {
    constexpr unsigned int nobody = dealii::numbers::invalid_unsigned_int;

    /** Adds a mass to some of the regions by their volumes; to the first one
     *  if these have none. */
    void
    share_out(const double                        mass,
              const std::vector<unsigned int>    &parts,
              const std::vector<double>          &volumes,
              std::vector<RegionTracker::Region> &regions)
    {
      double volume = 0., left = mass;
      for (const unsigned int j : parts)
        volume += std::max(volumes[j], 0.);
      if (volume > 0.)
        for (std::size_t k = 1; k < parts.size(); ++k)
          {
            const double share =
              mass * std::max(volumes[parts[k]], 0.) / volume;
            regions[parts[k]].mass += share;
            left -= share;
          }
      regions[parts.front()].mass += left;
    }
  } // namespace



  RegionTracker::RegionTracker(const std::array<unsigned int, 2> &size)
    : size(size)
  {}



  PocketSuccession
  RegionTracker::find_succession(const VoidRegions &next) const
  {
    PocketSuccession result;
    result.heir.assign(current.size(), nobody);
    result.ancestor.assign(next.n, nobody);
    result.overlaps.assign(current.size(), std::vector<double>(next.n, 0.));
    auto of_domains = result.overlaps;
    if (current.empty() || next.n == 0)
      return result;
    for (std::size_t e = 0; e < next.region.size(); ++e)
      {
        of_domains[here.region[e]][next.region[e]] += 1.;
        if (here.open[e] && next.open[e])
          result.overlaps[here.region[e]][next.region[e]] += 1.;
      }
    result.pair(result.overlaps);
    for (unsigned int i = 0; i < current.size(); ++i)
      for (unsigned int j = 0; j < next.n; ++j)
        if (!result.overlaps_nothing_after(i) ||
            !result.overlaps_nothing_before(j))
          of_domains[i][j] = 0.;
    result.pair(of_domains);
    return result;
  }



  std::vector<RegionTracker::Region>
  RegionTracker::hand_down(const PocketSuccession    &succession,
                           const std::vector<double> &volumes)
  {
    std::vector<Region>                    next(volumes.size());
    std::vector<std::vector<unsigned int>> parts(current.size());
    for (unsigned int i = 0; i < current.size(); ++i)
      if (succession.heir[i] != nobody)
        {
          next[succession.heir[i]].name = current[i].name;
          parts[i]                      = {succession.heir[i]};
        }
    for (unsigned int j = 0; j < next.size(); ++j)
      if (succession.ancestor[j] == nobody)
        {
          next[j].name = new_name();
          if (succession.overlaps_nothing_before(j))
            {
              happened.push_back(
                {PocketEventKind::opened, 0, next[j].name, ""});
              continue;
            }
          // It has an heir: otherwise the two had been paired.
          const unsigned int i = succession.most_overlapped_before(j);
          parts[i].push_back(j);
          happened.push_back(
            {PocketEventKind::split, 0, next[j].name, current[i].name});
        }
    for (unsigned int i = 0; i < current.size(); ++i)
      if (!parts[i].empty())
        share_out(current[i].mass, parts[i], volumes, next);
    return next;
  }



  unsigned int
  RegionTracker::neighbour_of_lower_pressure(
    const unsigned int         closed,
    const VoidRegions         &next,
    const std::vector<double> &pressures) const
  {
    // From its open elements through the seal around them.
    std::vector<unsigned int> reached;
    std::vector<char>         is_reached(next.region.size(), 0);
    const auto                reach = [&](const unsigned int e) {
      if (!is_reached[e])
        reached.push_back(e);
      is_reached[e] = 1;
    };
    for (unsigned int e = 0; e < next.region.size(); ++e)
      if (here.open[e] && here.region[e] == closed)
        reach(e);
    unsigned int lowest = next.region[reached.front()];
    for (std::size_t k = 0; k < reached.size(); ++k)
      {
        const unsigned int e = reached[k];
        if (next.open[e])
          {
            if (pressures[next.region[e]] < pressures[lowest])
              lowest = next.region[e];
            continue;
          }
        const unsigned int i = e % size[0], row = e - i, n = size[0] * size[1];
        reach(row + (i + 1) % size[0]);
        reach(row + (i + size[0] - 1) % size[0]);
        reach((e + size[0]) % n);
        reach((e + n - size[0]) % n);
      }
    return lowest;
  }



  void
  RegionTracker::update(const VoidRegions         &next,
                        const std::vector<double> &volumes,
                        const std::vector<double> &pressures)
  {
    happened.clear();
    const PocketSuccession succession = find_succession(next);
    std::vector<Region>    regions    = hand_down(succession, volumes);
    std::vector<double>    inherited(next.n, 0.);
    for (unsigned int j = 0; j < next.n; ++j)
      if (succession.ancestor[j] != nobody)
        inherited[j] = pressures[succession.ancestor[j]];
    for (unsigned int i = 0; i < current.size(); ++i)
      {
        if (succession.heir[i] != nobody)
          continue;
        if (next.n == 0)
          {
            sealed += current[i].mass;
            happened.push_back(
              {PocketEventKind::closed, 0, current[i].name, ""});
            continue;
          }
        const bool         merged = !succession.overlaps_nothing_after(i);
        const unsigned int j =
          merged ? succession.most_overlapped_after(i) :
                   neighbour_of_lower_pressure(i, next, inherited);
        regions[j].mass += current[i].mass;
        happened.push_back(
          {merged ? PocketEventKind::merged : PocketEventKind::closed,
           0,
           current[i].name,
           regions[j].name});
      }
    if (next.n > 0 && sealed > 0.)
      {
        std::vector<unsigned int> all(next.n);
        std::iota(all.begin(), all.end(), 0u);
        share_out(std::exchange(sealed, 0.), all, volumes, regions);
      }
    current = std::move(regions);
    here    = next;
  }



  std::string
  RegionTracker::new_name()
  {
    return pocket_name(++n_names_given);
  }



  void
  RegionTracker::set_masses(const std::vector<double> &masses)
  {
    for (std::size_t i = 0; i < current.size(); ++i)
      current[i].mass = masses[i];
  }



  const std::vector<RegionTracker::Region> &
  RegionTracker::regions() const
  {
    return current;
  }



  const VoidRegions &
  RegionTracker::places() const
  {
    return here;
  }



  double
  RegionTracker::sealed_mass() const
  {
    return sealed;
  }



  const std::vector<PocketEvent> &
  RegionTracker::events() const
  {
    return happened;
  }
} // namespace asperity
