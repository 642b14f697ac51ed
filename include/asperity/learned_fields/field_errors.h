#ifndef asperity_learned_fields_field_errors_h
#define asperity_learned_fields_field_errors_h

#include <asperity/learned_fields/field_model.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace asperity
{
  /** Mean and largest of the errors of several runs. */
  struct ErrorOfRuns
  {
    double mean = 0., largest = 0.;

    void
    add(const double error, const std::size_t n_runs);
  };

  /** What a model errs in a quantity on held-out runs. */
  struct FieldErrorRow
  {
    std::string quantity; ///< name of a field, or "mu at 0.8 of the time"

    /** With the code that is nearest to the run, which is the decoder's error
     *  alone, and with the code that the inputs give. */
    ErrorOfRuns best, predicted;
  };

  /** See errors_of(). */
  struct FieldErrors
  {
    /** Fields: norm of the difference over that of the truth, in the L2 norm
     *  over places and times; where the truth all but vanishes (less than 1 %
     *  of the root of the mean square over the held-out runs), as a contact
     *  pressure if oil carries all, over that root. mu: difference over the
     *  truth. */
    std::vector<FieldErrorRow> rows;

    /** Of mu at all times, inside of its 95 % interval. */
    double share_in_interval = 0.;

    /** Runs whose trust score is at most 1. */
    double share_trusted = 0.;
  };

  /** Errors of a model on the held-out runs.
   *  @param codes the best ones of all runs */
  FieldErrors
  errors_of(const FieldModel                       &model,
            const FieldData                        &data,
            const std::vector<std::vector<double>> &codes);

  /** As a table of comma-separated values. */
  void
  write_errors(std::ostream &out, const FieldErrors &errors);

  /** For people. */
  void
  print_errors(std::ostream &out, const FieldErrors &errors);
} // namespace asperity

#endif
