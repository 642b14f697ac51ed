#ifndef asperity_tool_design_law_search_h
#define asperity_tool_design_law_search_h

#include <asperity/surrogate/friction_law.h>
#include <asperity/tool_design/design_parameters.h>

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace asperity
{
  /** Where a friction law has its least value. */
  struct LeastFriction
  {
    std::string         method; ///< "DIRECT", "genetic"
    SearchResult        search;
    std::vector<double> x; ///< all inputs of the law, SI
    LawPrediction       prediction;
  };

  /**
   * Searches the inputs at which a law has its least mean, among those that it
   * trusts: each evaluation is the law's answer instead of a run.
   */
  class LawSearch
  {
  public:
    /** @throws InputError if the file is no law, or what is fixed is no input
     *  of it, outside of its range, or all of them */
    explicit LawSearch(const ToolDesignParameters &parameters);

    /** The inputs that are not fixed, with their ranges, logarithms where the
     *  law sees these. */
    SearchBox
    box() const;

    std::vector<LeastFriction>
    run() const;

    /** A page for people. */
    void
    print(const std::vector<LeastFriction> &found, std::ostream &out) const;

  private:
    /** Inputs of the law from variables of the search. */
    std::vector<double>
    inputs(const std::vector<double> &variables) const;

    Evaluation
    evaluate(const std::vector<double> &variables) const;

    ToolDesignParameters          parameters;
    FrictionLaw                   law;
    std::map<std::string, double> fixed; ///< SI, by the name of the input
  };
} // namespace asperity

#endif
