#ifndef asperity_lubricant_pocket_extent_h
#define asperity_lubricant_pocket_extent_h

#include <vector>

namespace asperity
{
  /** The part [begin, end) of an edge whose parameter s has the period S. The
   *  begin lies in [0, S); an end beyond S means that the part wraps around. */
  struct PeriodicInterval
  {
    double begin = 0.;
    double end   = 0.;

    double
    length() const
    {
      return end - begin;
    }

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &begin &end;
    }
  };

  /** Length that two intervals have in common. */
  double
  overlap(const PeriodicInterval &a,
          const PeriodicInterval &b,
          const double            period);



  /** Where a pocket is. */
  struct PocketExtent
  {
    /** Where the gap exceeds the sealing gap. */
    PeriodicInterval open;

    /** The part of the edge on which the pocket's pressure acts: `open` and
     *  the seals on both sides up to the points of smallest gap. */
    PeriodicInterval domain;

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &open &domain;
    }
  };

  /**
   * Divides the void between an edge and its obstacle into pockets: maximal
   * intervals where the gap exceeds the sealing gap. The gap is the periodic
   * piecewise linear function through the samples. The pockets' domains
   * partition the whole edge; the boundary of two neighbours is the point of
   * smallest gap in the seal between them (the middle of several).
   *
   * Without a seal the one pocket is the entire period, [0, S); where
   * everything is sealed there is none.
   *
   * @param parameters increasing, in [0, period)
   * @param gaps as many [m], negative where the bodies penetrate
   * @return pockets in order of `domain.begin`
   */
  std::vector<PocketExtent>
  find_pockets(const std::vector<double> &parameters,
               const std::vector<double> &gaps,
               const double               period,
               const double               sealing_gap);

  /** Index of the pocket in whose domain s lies. @param pockets at least one,
   *  in order of `domain.begin`, as find_pockets() returns them */
  unsigned int
  pocket_at(const std::vector<PocketExtent> &pockets,
            const double                     s,
            const double                     period);
} // namespace asperity

#endif
