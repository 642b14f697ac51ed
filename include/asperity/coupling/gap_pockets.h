#ifndef asperity_coupling_gap_pockets_h
#define asperity_coupling_gap_pockets_h

#include <vector>

namespace asperity
{
  class InputArchive;
  class OutputArchive;

  /**
   * Which columns of a periodic gap hold oil that flows, and whose oil that is.
   * Columns whose gap is below the sealing gap are closed; a pocket is a
   * largest run of open ones, across the end of the period, too, with the seals
   * on both sides of it up to their narrowest columns. So every column is part
   * of a pocket, as in the model `pocket`: what a seal has no room for is at
   * once the oil of the pocket that it belongs to.
   *
   * Each column has an amount of oil, a volume at no pressure. A pocket has the
   * sum of its columns; pockets that merge add theirs, one that parts is
   * divided as spread() has found it. Nothing else changes an amount, so the
   * oil is conserved to round-off, whatever opens and closes how often.
   *
   * The oil of a pocket flows if it fills the void; if not, the pocket is still
   * and has no pressure, until its void has closed to the oil.
   *
   * Volumes per metre of thickness [m^2].
   */
  class GapPockets
  {
  public:
    /** Columns that a flow needs at least: shorter runs are part of the seal
     *  that they lie in. */
    static constexpr unsigned int smallest_run = 2;

    /** By which share of the void the oil may miss it where it fills it. */
    static constexpr double slack = 1e-3;

    /** What belongs to no pocket, if all columns are closed. */
    static constexpr unsigned int none = -1;

    /** All columns are open. @param oil of the columns
     *  @param sealing_gap [m] */
    GapPockets(const std::vector<double> &oil, const double sealing_gap);

    /** Opens and closes columns.
     *  @param gaps smallest one in each column [m]
     *  @param voids of the columns */
    void
    open(const std::vector<double> &gaps, const std::vector<double> &voids);

    /** Each column gets the share of its pocket's oil that it has of the
     *  pocket's contents. @param contents of the columns; in still pockets
     *  their voids */
    void
    spread(const std::vector<double> &contents);

    /** Columns that the oil flows in. */
    const std::vector<bool> &
    is_flowing() const;

    unsigned int
    n_pockets() const;

    /** Of a column, counted from the left by the runs' first columns; or
     *  none. */
    unsigned int
    pocket(const unsigned int column) const;

    /** The open column next to a closed one, at the end of its pocket's run; of
     *  an open column itself; or none. */
    unsigned int
    open_neighbour(const unsigned int column) const;

    /** Whether the pocket's oil fills its void, and flows. */
    bool
    is_full(const unsigned int pocket) const;

    /** Of each pocket. */
    std::vector<double>
    oil() const;

    /** Of each column. */
    const std::vector<double> &
    amounts() const;

    double
    total() const;

    void
    save(OutputArchive &archive) const;

    /** Takes what save() wrote.
     *  @throws InputError if that has another number of columns */
    void
    load(InputArchive &archive);

  private:
    /** The columns from `first` up to, not including, `end`, modulo their
     *  number. */
    struct Run
    {
      unsigned int first, end;
    };

    std::vector<Run>
    open_runs() const;

    /** Divides the closed columns among the runs of open ones. */
    void
    number_pockets(const std::vector<double> &gaps);

    double                    sealing_gap;
    std::vector<double>       oil_;
    std::vector<bool>         open_, flowing;
    std::vector<unsigned int> pocket_, neighbour;
    std::vector<bool>         full; ///< by pocket
  };
} // namespace asperity

#endif
