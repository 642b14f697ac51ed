#ifndef asperity_optimization_evaluation_record_h
#define asperity_optimization_evaluation_record_h

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace asperity
{
  /** The variables of a search, and what each may be. */
  struct SearchBox
  {
    std::vector<std::string> names;
    std::vector<double>      lower, upper;

    std::size_t
    size() const
    {
      return names.size();
    }

    /** @throws InputError that says which variable has no range, or that there
     *   are none */
    void
    check() const;
  };

  /** What an objective is at a point: a value, or the reason why it has none.
   */
  struct Evaluation
  {
    double      value = std::numeric_limits<double>::quiet_NaN();
    std::string failure; ///< a sentence; empty if there is a value

    bool
    has_failed() const
    {
      return !failure.empty();
    }
  };

  /** Of a point; to be minimised. May throw ComputationError, which is a
   *  failure as well; any other exception ends the search. */
  using Objective = std::function<Evaluation(const std::vector<double> &)>;

  /**
   * All points at which an objective has been evaluated, in a file of
   * comma-separated values that is whole after every evaluation. A search is
   * resumed by being begun again: it asks for the same points in the same
   * order, and those in the record are not computed again, nor are points that
   * are asked for twice.
   */
  class EvaluationRecord
  {
  public:
    /**
     * Reads the file if it exists.
     * @param path of the file; none is read or written if empty
     * @param description of the objective, which evaluations of another one
     *   are not mixed with
     * @param writes whether this process writes; of several ranks one does
     * @throws InputError naming the line, if the file is another objective's
     *   or box's, or not such a file
     */
    EvaluationRecord(const SearchBox   &box,
                     const std::string &path        = "",
                     const std::string &description = "",
                     const bool         writes      = true);

    const SearchBox &
    box() const
    {
      return box_;
    }

    struct Entry
    {
      std::vector<double> point;
      Evaluation          evaluation;
    };

    /** All evaluations, in their order. */
    const std::vector<Entry> &
    entries() const
    {
      return entries_;
    }

    /** From the record or, for a new point, from the objective, and then kept.
     *  @throws what the objective throws, but ComputationError */
    const Evaluation &
    evaluate(const Objective &objective, const std::vector<double> &point);

  private:
    void
    read();

    void
    write() const;

    void
    add(const Entry &entry);

    SearchBox                                  box_;
    std::string                                path, description;
    bool                                       writes;
    std::vector<Entry>                         entries_;
    std::map<std::vector<double>, std::size_t> place; ///< among the entries
  };

  /** How a search went. */
  struct SearchResult
  {
    std::vector<double> best; ///< empty if all evaluations failed
    double              value = std::numeric_limits<double>::quiet_NaN();

    /** Points that the search has asked for, each counted once, whether they
     *  were in the record or not. */
    unsigned int n_evaluations = 0;
    unsigned int n_failed      = 0;
    unsigned int n_to_best     = 0; ///< evaluations until the best

    std::string end; ///< a half sentence that says why the search ended

    /** The best value after each evaluation; none before the first value. */
    std::vector<double> history;
  };
} // namespace asperity

#endif
