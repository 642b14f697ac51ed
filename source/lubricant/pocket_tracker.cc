#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "pocket_succession.h"

namespace asperity
{
  namespace
  {
    using dealii::numbers::invalid_unsigned_int;

    /** The spacing of doubles below the next power of two above the sum, times
     *  two: multiples of it add up without rounding. */
    double
    mass_quantum(const double sum)
    {
      if (!(sum > 0.))
        return 0.;
      int exponent;
      std::frexp(sum, &exponent);
      return std::ldexp(1., exponent - 52);
    }



    double
    rounded_to(const double quantum, const double mass)
    {
      return quantum > 0. ? std::nearbyint(mass / quantum) * quantum : mass;
    }
  } // namespace



  std::string
  to_string(const PocketEvent &event)
  {
    std::string text =
      "step " + std::to_string(event.step) + ": pocket " + event.pocket;
    switch (event.kind)
      {
        case PocketEventKind::opened:
          return text + " has opened";
        case PocketEventKind::closed:
          return text + " has closed" +
                 (event.other.empty() ? ", its oil is sealed in" :
                                        ", its oil is in " + event.other);
        case PocketEventKind::merged:
          return text + " has become part of " + event.other;
        case PocketEventKind::split:
          return text + " has split from " + event.other;
      }
    Assert(false, dealii::ExcInternalError());
    return text;
  }



  PocketTracker::PocketTracker(const double period)
    : period(period)
  {}



  void
  PocketTracker::update(const std::vector<PocketExtent> &extents,
                        const std::vector<double>       &volumes,
                        const std::vector<double>       &pressures)
  {
    AssertDimension(extents.size(), volumes.size());
    AssertDimension(current.size(), pressures.size());
    ++step;
    happened.clear();
    std::vector<Pocket> next(extents.size());
    for (unsigned int i = 0; i < next.size(); ++i)
      next[i].extent = extents[i];

    const Succession succession = find_succession(extents);
    hand_down(succession, volumes, next);
    end_without_heir(succession, pressures, next);
    if (!next.empty() && sealed > 0.)
      {
        std::vector<unsigned int> all(next.size());
        for (unsigned int i = 0; i < all.size(); ++i)
          all[i] = i;
        distribute(std::exchange(sealed, 0.), all, volumes, next);
      }
    current = std::move(next);
  }



  PocketTracker::Succession
  PocketTracker::find_succession(const std::vector<PocketExtent> &extents) const
  {
    Succession result;
    result.heir.assign(current.size(), invalid_unsigned_int);
    result.ancestor.assign(extents.size(), invalid_unsigned_int);
    result.overlaps.assign(current.size(),
                           std::vector<double>(extents.size(), 0.));
    for (unsigned int i = 0; i < current.size(); ++i)
      for (unsigned int j = 0; j < extents.size(); ++j)
        result.overlaps[i][j] =
          overlap(current[i].extent.open, extents[j].open, period);
    result.pair(result.overlaps);

    std::vector<std::vector<double>> of_domains(
      current.size(), std::vector<double>(extents.size(), 0.));
    for (unsigned int i = 0; i < current.size(); ++i)
      for (unsigned int j = 0; j < extents.size(); ++j)
        if (result.overlaps_nothing_after(i) &&
            result.overlaps_nothing_before(j))
          of_domains[i][j] =
            overlap(current[i].extent.domain, extents[j].domain, period);
    result.pair(of_domains);
    return result;
  }



  void
  PocketTracker::hand_down(const Succession          &succession,
                           const std::vector<double> &volumes,
                           std::vector<Pocket>       &next)
  {
    std::vector<std::vector<unsigned int>> parts(current.size());
    for (unsigned int i = 0; i < current.size(); ++i)
      if (succession.heir[i] != invalid_unsigned_int)
        {
          next[succession.heir[i]].name = current[i].name;
          parts[i]                      = {succession.heir[i]};
        }
    for (unsigned int j = 0; j < next.size(); ++j)
      if (succession.ancestor[j] == invalid_unsigned_int)
        {
          next[j].name = new_name();
          if (succession.overlaps_nothing_before(j))
            happened.push_back(
              {PocketEventKind::opened, step, next[j].name, ""});
          else
            {
              // It has an heir: otherwise the two had been paired.
              const unsigned int i = succession.most_overlapped_before(j);
              parts[i].push_back(j);
              happened.push_back(
                {PocketEventKind::split, step, next[j].name, current[i].name});
            }
        }
    for (unsigned int i = 0; i < current.size(); ++i)
      if (!parts[i].empty())
        distribute(current[i].mass, parts[i], volumes, next);
  }



  void
  PocketTracker::end_without_heir(const Succession          &succession,
                                  const std::vector<double> &pressures,
                                  std::vector<Pocket>       &next)
  {
    std::vector<PocketExtent> extents;
    for (const Pocket &pocket : next)
      extents.push_back(pocket.extent);
    for (unsigned int i = 0; i < current.size(); ++i)
      if (succession.heir[i] == invalid_unsigned_int)
        {
          if (next.empty())
            {
              sealed += current[i].mass;
              happened.push_back(
                {PocketEventKind::closed, step, current[i].name, ""});
              continue;
            }
          const bool         merged = !succession.overlaps_nothing_after(i);
          const unsigned int j =
            merged ?
              succession.most_overlapped_after(i) :
              neighbour_of_lower_pressure(i, extents, succession, pressures);
          next[j].mass += current[i].mass;
          happened.push_back(
            {merged ? PocketEventKind::merged : PocketEventKind::closed,
             step,
             current[i].name,
             next[j].name});
        }
  }



  unsigned int
  PocketTracker::neighbour_of_lower_pressure(
    const unsigned int               closed,
    const std::vector<PocketExtent> &extents,
    const Succession                &succession,
    const std::vector<double>       &pressures) const
  {
    const PeriodicInterval &old    = current[closed].extent.open;
    const double            middle = 0.5 * (old.begin + old.end);
    const unsigned int      n      = extents.size();
    const unsigned int      home   = pocket_at(extents, middle, period);
    const PocketExtent     &extent = extents[home];

    // The place lies in a seal, before or after the open part of its domain.
    double from_begin = std::fmod(middle - extent.domain.begin, period);
    if (from_begin < 0.)
      from_begin += period;
    const double open_before =
      overlap({extent.domain.begin, extent.domain.begin + from_begin},
              extent.open,
              period);
    const unsigned int other = (open_before > 0. ? home + 1 : home + n - 1) % n;

    const auto pressure_of = [&](const unsigned int j) {
      const unsigned int i = succession.ancestor[j];
      return i == invalid_unsigned_int ? 0. : pressures[i];
    };
    return pressure_of(other) < pressure_of(home) ? other : home;
  }



  void
  PocketTracker::distribute(const double                     mass,
                            const std::vector<unsigned int> &parts,
                            const std::vector<double>       &volumes,
                            std::vector<Pocket>             &next) const
  {
    double volume = 0.;
    for (const unsigned int j : parts)
      volume += std::max(volumes[j], 0.);
    double left = mass;
    if (volume > 0.)
      for (unsigned int k = 1; k < parts.size(); ++k)
        {
          const double fraction = std::max(volumes[parts[k]], 0.) / volume;
          const double share =
            std::min(left, rounded_to(quantum, mass * fraction));
          next[parts[k]].mass += share;
          left -= share;
        }
    next[parts.front()].mass += left;
  }



  std::string
  PocketTracker::new_name()
  {
    return pocket_name(++n_names_given);
  }



  void
  PocketTracker::set_masses(const std::vector<double> &masses)
  {
    AssertDimension(masses.size(), current.size());
    double sum = sealed;
    for (const double mass : masses)
      sum += mass;
    quantum = mass_quantum(sum);
    sealed  = rounded_to(quantum, sealed);
    for (unsigned int i = 0; i < current.size(); ++i)
      current[i].mass = rounded_to(quantum, masses[i]);
  }



  const std::vector<Pocket> &
  PocketTracker::pockets() const
  {
    return current;
  }



  double
  PocketTracker::sealed_mass() const
  {
    return sealed;
  }



  const std::vector<PocketEvent> &
  PocketTracker::events() const
  {
    return happened;
  }
} // namespace asperity
