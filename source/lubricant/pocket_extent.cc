#include <asperity/lubricant/pocket_extent.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    double
    wrapped(const double s, const double period)
    {
      const double remainder = std::fmod(s, period);
      if (remainder >= 0.)
        return remainder;
      // of -1e-20 the sum would be the period itself
      return remainder + period < period ? remainder + period : 0.;
    }



    /** Samples of a periodic gap, numbered on from turn to turn. */
    struct PeriodicGap
    {
      const std::vector<double> &parameters, &gaps;
      const double               period, sealing_gap;

      unsigned int
      size() const
      {
        return gaps.size();
      }

      bool
      is_open(const unsigned int i) const
      {
        return gaps[i % size()] > sealing_gap;
      }

      double
      s(const unsigned int i) const
      {
        return parameters[i % size()] + period * (i / size());
      }

      /** Where the gap between samples i and i + 1 equals the sealing gap. */
      double
      crossing(const unsigned int i) const
      {
        const double before = gaps[i % size()] - sealing_gap;
        const double after  = gaps[(i + 1) % size()] - sealing_gap;
        return s(i) + (s(i + 1) - s(i)) * before / (before - after);
      }

      /** The point of smallest gap in samples [begin, end), the middle of the
       *  first and the last one if there are several. */
      double
      tightest(const unsigned int begin, const unsigned int end) const
      {
        unsigned int first = begin, last = begin;
        for (unsigned int i = begin + 1; i < end; ++i)
          if (gaps[i % size()] < gaps[first % size()])
            first = last = i;
          else if (gaps[i % size()] == gaps[first % size()])
            last = i;
        return 0.5 * (s(first) + s(last));
      }

      /** The first sample from i on that is open or not. */
      unsigned int
      next(unsigned int i, const bool open) const
      {
        while (is_open(i) != open)
          ++i;
        return i;
      }
    };



    PeriodicInterval
    interval(const double begin, const double end, const double period)
    {
      const double first_turn = wrapped(begin, period);
      return {first_turn, first_turn + (end - begin)};
    }
  } // namespace



  double
  overlap(const PeriodicInterval &a,
          const PeriodicInterval &b,
          const double            period)
  {
    double sum = 0.;
    for (const double shift : {-period, 0., period})
      sum += std::max(0.,
                      std::min(a.end, b.end + shift) -
                        std::max(a.begin, b.begin + shift));
    return sum;
  }



  std::vector<PocketExtent>
  find_pockets(const std::vector<double> &parameters,
               const std::vector<double> &gaps,
               const double               period,
               const double               sealing_gap)
  {
    AssertDimension(parameters.size(), gaps.size());
    const PeriodicGap gap{parameters, gaps, period, sealing_gap};
    unsigned int      n_open = 0;
    for (unsigned int i = 0; i < gap.size(); ++i)
      n_open += gap.is_open(i);
    if (n_open == 0)
      return {};
    if (n_open == gap.size())
      return {{{0., period}, {0., period}}};

    // From the beginning of a seal once around: seal, pocket, seal, pocket, ...
    const unsigned int begin = gap.next(gap.next(0, true), false);
    const unsigned int end   = begin + gap.size();

    std::vector<PocketExtent> pockets;
    unsigned int              seal = begin;
    while (seal < end)
      {
        const unsigned int opening   = gap.next(seal, true);
        const unsigned int next_seal = gap.next(opening, false);
        const unsigned int reopening = gap.next(next_seal, true);
        pockets.push_back({interval(gap.crossing(opening - 1),
                                    gap.crossing(next_seal - 1),
                                    period),
                           interval(gap.tightest(seal, opening),
                                    gap.tightest(next_seal, reopening),
                                    period)});
        seal = next_seal;
      }
    std::sort(pockets.begin(),
              pockets.end(),
              [](const PocketExtent &a, const PocketExtent &b) {
                return a.domain.begin < b.domain.begin;
              });
    return pockets;
  }



  unsigned int
  pocket_at(const std::vector<PocketExtent> &pockets,
            const double                     s,
            const double                     period)
  {
    Assert(!pockets.empty(), dealii::ExcEmptyObject());
    // By the beginnings alone, so that round-off leaves no point without a
    // pocket: before the first one lies the end of the last.
    const auto after =
      std::upper_bound(pockets.begin(),
                       pockets.end(),
                       wrapped(s, period),
                       [](const double t, const PocketExtent &pocket) {
                         return t < pocket.domain.begin;
                       });
    return after == pockets.begin() ? pockets.size() - 1 :
                                      after - pockets.begin() - 1;
  }
} // namespace asperity
