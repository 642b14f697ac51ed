#ifndef asperity_surrogate_sample_table_h
#define asperity_surrogate_sample_table_h

#include <asperity/surrogate/friction_law.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace asperity
{
  enum class SampleRole
  {
    training, ///< a law may be fitted to it
    test      ///< a law is only judged by it
  };

  enum class SampleStatus
  {
    done,
    failed ///< the run has no outputs, but a reason
  };

  /** A result of a run that is tabulated, with its SI unit. */
  struct SampleOutput
  {
    std::string name; ///< "mu", "contact_fraction", "oil_pressure"
    std::string unit; ///< SI, "Pa"; "-" without dimension
  };

  /** One run of a campaign, or the mean over several profiles; SI. */
  struct Sample
  {
    unsigned int        id = 0; ///< unique in its table
    std::vector<double> x;      ///< one value an input
    SampleRole          role   = SampleRole::training;
    SampleStatus        status = SampleStatus::done;
    std::string         reason;  ///< why it failed; one sentence
    std::vector<double> outputs; ///< one value an output; empty if it failed

    /** Standard deviation of the first output that is known beforehand, such as
     *  that of a mean over several profiles; 0: none. */
    double deviation = 0.;
  };

  /** What a law is trained on: n points of finished runs. */
  struct SampleData
  {
    std::vector<unsigned int> id;
    std::vector<double>       x;         ///< n x d, SI
    std::vector<double>       y;         ///< n
    std::vector<double>       deviation; ///< n, or empty if all are zero
  };

  /**
   * The runs of a campaign, one a row, as a comma-separated file in SI units
   * that numpy and pandas read (lines with # are comments) and that reads back
   * as the same numbers:
   *
   *     # Asperity sample table, version 1; values in SI units
   *     # input: p; Load/Pressure; MPa; 300000000; 1300000000; linear
   *     id,role,status,p [Pa],mu [-],deviation of mu [-],reason
   *     0,training,done,300000000,0.2,0,
   *     1,test,failed,1300000000,,,"Newton's method ..."
   *
   * An input's line holds its symbol, entry of the scene, unit for people, both
   * ends of its range and its scale.
   */
  class SampleTable
  {
  public:
    /** @throws InputError if a name is empty, stands twice, or holds a
     *  character that the file uses, or if there is no input or output */
    SampleTable(const std::vector<LawInput>     &inputs,
                const std::vector<SampleOutput> &outputs);

    /** @throws InputError if the id is there already, if there are not as many
     *  values as inputs and outputs, if one is not finite, if the deviation is
     *  negative, or if a failed run has no reason */
    void
    add(const Sample &sample);

    /** In the order in which they were added. */
    const std::vector<Sample> &
    samples() const;

    const std::vector<LawInput> &
    inputs() const;

    const std::vector<SampleOutput> &
    outputs() const;

    /** The run with this number, or null. */
    const Sample *
    find(const unsigned int id) const;

    std::size_t
    count(const SampleRole role, const SampleStatus status) const;

    /** Finished runs of a role in the order of their ids, so that the order in
     *  which runs ended does not matter. The deviation is that of the first
     *  output; other outputs have none.
     *  @throws InputError if there is no such output */
    SampleData
    data(const SampleRole role, const std::string &output) const;

    void
    write(std::ostream &out) const;

    /** Atomically, in the order of ids. @throws ComputationError if it fails */
    void
    write(const std::string &path) const;

    /** @throws InputError naming the file, the line, what was found and what is
     *  expected */
    static SampleTable
    read(const std::string &path);

  private:
    std::vector<LawInput>     inputs_;
    std::vector<SampleOutput> outputs_;
    std::vector<Sample>       samples_;
  };
} // namespace asperity

#endif
