#ifndef asperity_benchmarks_stability_sweeps_h
#define asperity_benchmarks_stability_sweeps_h

#include <functional>
#include <initializer_list>
#include <map>
#include <stdexcept>
#include <string>

/** Failure modes of methods as functions of the settings of one cell of a map;
 *  tools/stability asks for the cells and judges the values. */
namespace stability
{
  /** The settings of a cell by name. */
  class Cell
  {
  public:
    explicit Cell(std::map<std::string, std::string> settings);

    /** @throws std::invalid_argument if there is no such setting */
    const std::string &
    text(const std::string &name) const;

    /** SI; "inf" is a number, too.
     *  @throws std::invalid_argument if there is no such number */
    double
    number(const std::string &name) const;

    unsigned int
    count(const std::string &name) const;

  private:
    std::map<std::string, std::string> settings;
  };

  /** What was measured, errors as positive shares of the expected value. */
  using Values = std::map<std::string, double>;

  struct Answer
  {
    Answer(const Values &values, const std::string &warning = "")
      : values(values)
      , warning(warning)
    {}

    Answer(const std::initializer_list<Values::value_type> &values)
      : values(values)
    {}

    Values      values;
    std::string warning; ///< that the program gives with them
  };

  /** An iteration that reports its failure, with the sentence of the report:
   *  what the program would end with. */
  class Reported : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  using Sweep  = std::function<Answer(const Cell &)>;
  using Sweeps = std::map<std::string, Sweep>;

  /** By the number of the failure mode. */
  Sweeps
  contact_sweeps();

  /** Coupling, closest point, material law, Gaussian process. */
  Sweeps
  point_sweeps();

  Sweeps
  flow_sweeps();

  Sweeps
  solid_sweeps();
} // namespace stability

#endif
