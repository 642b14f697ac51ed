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
   * largest run of open ones, across the end of the period, too.
   *
   * Each column has an amount of oil, a volume at no pressure. A pocket has the
   * sum of its columns. A column that closes keeps its amount, as a film that
   * the surfaces seal, and brings it back when it opens again; pockets that
   * merge add theirs, one that parts is divided as its void is, at the same
   * pressure. Nothing else changes an amount, so the oil is conserved to
   * round-off, whatever opens and closes how often.
   *
   * Volumes per metre of thickness [m^2].
   */
  class GapPockets
  {
  public:
    /** Columns that a flow needs at least: shorter runs stay closed, and keep
     *  their oil until they join others. */
    static constexpr unsigned int smallest_run = 2;

    /** @param voids of the columns, all full of oil; all are open
     *  @param sealing_gap [m] */
    GapPockets(const std::vector<double> &voids, const double sealing_gap);

    /** Opens and closes columns. @param gaps smallest one in each column [m] */
    void
    open(const std::vector<double> &gaps);

    /** Each column gets the share of its pocket's oil that it has of what the
     *  flow found there. @param contents of the columns: their voids, if the
     *  oil is incompressible */
    void
    spread(const std::vector<double> &contents);

    const std::vector<bool> &
    is_open() const;

    unsigned int
    n_pockets() const;

    /** Of an open column, counted from the left. */
    unsigned int
    pocket(const unsigned int column) const;

    /** Of each pocket. */
    std::vector<double>
    oil() const;

    /** Of closed columns. */
    double
    sealed_oil() const;

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

    void
    number_pockets();

    double                    sealing_gap;
    std::vector<double>       oil_;
    std::vector<bool>         open_;
    std::vector<unsigned int> pocket_; ///< of open columns
    unsigned int              n_pockets_ = 0;
  };
} // namespace asperity

#endif
