#ifndef asperity_lubricant_pocket_tracker_h
#define asperity_lubricant_pocket_tracker_h

#include <asperity/lubricant/pocket_extent.h>

#include <string>
#include <vector>

namespace asperity
{
  enum class PocketEventKind
  {
    opened, ///< a void has opened where there was none
    closed, ///< `other`, if any, has received the oil
    merged, ///< `pocket` has become part of `other`
    split   ///< `pocket` is a new part of what was `other`
  };

  struct PocketEvent
  {
    PocketEventKind kind = PocketEventKind::opened;
    unsigned int    step = 0;
    std::string     pocket;
    std::string     other;
  };

  /** For people, as "step 12: pocket B has become part of A". */
  std::string
  to_string(const PocketEvent &event);



  struct Pocket
  {
    std::string  name;
    PocketExtent extent;
    double       mass = 0.; ///< of oil [kg/m]

    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &name &extent &mass;
    }
  };

  /**
   * Keeps pockets by name, and the mass of oil in each, while they move, merge,
   * split, close and open.
   *
   * A pocket goes on as the new one whose open interval overlaps its own most
   * (pairs in order of overlap, each pocket once, so that a seal that moves by
   * more than its width is not taken for a merger). Then
   * - an old pocket that is left has merged into the new one that it overlaps
   *   most, which gets its mass;
   * - a new pocket that is left has split from the old one that it overlaps
   *   most, whose mass its parts share in proportion to their volumes;
   * - small pockets may move by more than their width: old and new ones that
   *   overlap nothing are paired by their domains;
   * - an old pocket for which there is none has closed: its oil leaks through
   *   the seal into the neighbour with the lower pressure. Where no pocket is
   *   left at all, the oil stays as `sealed_mass()`, and those that open next
   *   share it in proportion to their volumes;
   * - a new pocket for which there is none has opened, and is empty.
   * A name is never used again.
   *
   * Masses are multiples of a power of two (2e-16 of the total), so all sums
   * are exact, and the total never changes by as much as the last bit.
   *
   * A value: copy it to try a step that may be repeated.
   */
  class PocketTracker
  {
  public:
    explicit PocketTracker(const double period);

    /**
     * The next step. The first one only opens pockets.
     * @param extents as from find_pockets()
     * @param volumes of these pockets [m^2, per unit of depth]; negative ones
     *   count as zero
     * @param pressures of the pockets of the last step, pockets() [Pa]
     */
    void
    update(const std::vector<PocketExtent> &extents,
           const std::vector<double>       &volumes,
           const std::vector<double>       &pressures);

    /** Fills the pockets of the present step [kg/m]; rounds to 2e-16 of the
     *  sum. Together with sealed_mass() that is what update() conserves. */
    void
    set_masses(const std::vector<double> &masses);

    /** In order of `extent.domain.begin`. */
    const std::vector<Pocket> &
    pockets() const;

    /** Oil without a pocket, see above [kg/m]. */
    double
    sealed_mass() const;

    /** What happened in the last step. */
    const std::vector<PocketEvent> &
    events() const;

    /** All that the next steps depend on, for archives; what has happened is
     *  not part of it. */
    template <typename Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &current &sealed &quantum &n_names_given &step;
    }

  private:
    struct Succession; ///< source/lubricant/pocket_succession.h

    Succession
    find_succession(const std::vector<PocketExtent> &extents) const;

    unsigned int
    neighbour_of_lower_pressure(const unsigned int               closed,
                                const std::vector<PocketExtent> &extents,
                                const Succession                &succession,
                                const std::vector<double> &pressures) const;

    /** Names the next pockets and gives them the mass of those they stem
     *  from. */
    void
    hand_down(const Succession          &succession,
              const std::vector<double> &volumes,
              std::vector<Pocket>       &next);

    void
    end_without_heir(const Succession          &succession,
                     const std::vector<double> &pressures,
                     std::vector<Pocket>       &next);

    /** Adds a mass to the pockets `parts` of `next` by volume; the first one
     *  gets what is left over by rounding. */
    void
    distribute(const double                     mass,
               const std::vector<unsigned int> &parts,
               const std::vector<double>       &volumes,
               std::vector<Pocket>             &next) const;

    std::string
    new_name();

    double                   period;
    std::vector<Pocket>      current;
    double                   sealed        = 0.;
    double                   quantum       = 0.; ///< all masses are multiples
    unsigned int             n_names_given = 0;
    unsigned int             step          = 0;
    std::vector<PocketEvent> happened;
  };
} // namespace asperity

#endif
