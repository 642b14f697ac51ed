#ifndef asperity_experiment_measured_friction_h
#define asperity_experiment_measured_friction_h

#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /** A measured friction coefficient; SI. */
  struct MeasuredPoint
  {
    unsigned int line = 0; ///< of the file, for messages
    double       mu   = 0.;

    std::optional<double> deviation; ///< standard, of mu; empty: not known

    /** One an input of the file; empty: not known. */
    std::vector<std::optional<double>> x;

    std::string series; ///< which points belong together; may be empty
    std::string source; ///< where the number is from; may be empty
  };

  /**
   * Measured friction, a comma-separated file. Lines that begin with # are
   * comments; the first other line has the headings, and each further one is a
   * measurement:
   *
   *     # AISI 1045 on cemented carbide
   *     v [m/min],T [degC],mu,deviation of mu,series,source
   *     5,300,0.54,0.02,dry,"Lee (2025), section 2.1"
   *     120,,0.31,,dry,"the same, figure 4"
   *
   * `mu` has to be there. `deviation of mu` (its standard deviation), `series`
   * and `source` may be; any other column is an input of a law by its symbol,
   * with its unit: `p [MPa]`, `v [m/min]`, `T [degC]`, `Wetting [1]`. A cell of
   * an input or a deviation is empty where it is not known.
   */
  class MeasuredFriction
  {
  public:
    /** @throws InputError naming the file, the line, what was found and what is
     *  expected */
    static MeasuredFriction
    read(const std::string &path);

    const std::string &
    path() const;

    /** Symbols of the inputs, and the units of their columns. */
    const std::vector<std::string> &
    inputs() const;

    const std::vector<std::string> &
    units() const;

    const std::vector<MeasuredPoint> &
    points() const;

    /** The column of an input, or nothing. */
    std::optional<std::size_t>
    column(const std::string &symbol) const;

    /** The value of an input at a point. @throws InputError naming the line if
     *  there is none. */
    double
    value(const MeasuredPoint &point, const std::string &symbol) const;

    /** Names of the series in the order of the file; empty without names. */
    std::vector<std::string>
    series() const;

    /**
     * Keeps the points of these series.
     * @param names separated by commas; empty: all, if there is one at most
     * @throws InputError if a name is not there, or if there are several series
     *   and none is chosen
     */
    void
    choose(const std::string &names);

    /** The deviations of mu if all points have one, else nothing.
     *  @throws InputError if some have one and others have none */
    std::vector<double>
    deviations() const;

  private:
    std::string                path_;
    std::vector<std::string>   inputs_, units_;
    std::vector<MeasuredPoint> points_;
  };
} // namespace asperity

#endif
