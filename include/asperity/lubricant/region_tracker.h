#ifndef asperity_lubricant_region_tracker_h
#define asperity_lubricant_region_tracker_h

#include <asperity/lubricant/pocket_tracker.h>
#include <asperity/lubricant/void_regions.h>

#include <array>
#include <string>
#include <vector>

namespace asperity
{
  struct PocketSuccession; ///< source/lubricant/pocket_succession.h

  /**
   * Keeps the regions of a void by name, and the oil in each, while they move,
   * merge, split, close and open, by the rules of PocketTracker: regions are
   * those that have most elements in common where they are open. The oil of a
   * region that has closed leaks into that of the lowest pressure of those
   * around it.
   *
   * Amounts add up to round-off. A value: copy it to try a step that may be
   * repeated.
   */
  class RegionTracker
  {
  public:
    struct Region
    {
      std::string name;
      double      mass = 0.; ///< of oil, in any unit

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &name &mass;
      }
    };

    /** @param size elements of the face along x and y */
    explicit RegionTracker(const std::array<unsigned int, 2> &size);

    /**
     * The next step. The first one only opens regions.
     * @param volumes of these regions; negative ones count as zero
     * @param pressures of the regions of the last step [Pa]
     */
    void
    update(const VoidRegions         &next,
           const std::vector<double> &volumes,
           const std::vector<double> &pressures);

    void
    set_masses(const std::vector<double> &masses);

    /** In the order of the regions. */
    const std::vector<Region> &
    regions() const;

    /** Which element belongs to which. */
    const VoidRegions &
    places() const;

    /** Oil that is left where everything is sealed. */
    double
    sealed_mass() const;

    /** What happened in the last step; the steps are not told. */
    const std::vector<PocketEvent> &
    events() const;

    /** All that the next steps depend on. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &current &here.n &here.region &here.open &here.through;
      archive &sealed                                  &n_names_given;
    }

  private:
    PocketSuccession
    find_succession(const VoidRegions &next) const;

    /** The region of the lowest pressure among those around one that has
     *  closed. @param pressures of the next regions */
    unsigned int
    neighbour_of_lower_pressure(const unsigned int         closed,
                                const VoidRegions         &next,
                                const std::vector<double> &pressures) const;

    /** Names the next regions and gives them the oil of those they stem from.
     */
    std::vector<Region>
    hand_down(const PocketSuccession    &succession,
              const std::vector<double> &volumes);

    std::string
    new_name();

    std::array<unsigned int, 2> size;
    std::vector<Region>         current;
    VoidRegions                 here;
    double                      sealed        = 0.;
    unsigned int                n_names_given = 0;
    std::vector<PocketEvent>    happened;
  };
} // namespace asperity

#endif
