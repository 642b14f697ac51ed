#include <asperity/base/errors.h>
#include <asperity/base/mechanisms.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/law_export/law_options.h>
#include <asperity/tool_design/law_search.h>

#include <cmath>
#include <ostream>

namespace asperity
{
  LawSearch::LawSearch(const ToolDesignParameters &parameters)
    : parameters(parameters)
    , law(FrictionLaw::load(parameters.friction_law))
    , fixed(
        parse_settings(law.description(), split(parameters.fixed_inputs, ',')))
  {
    for (const LawInput &input : law.description().inputs)
      if (const auto value = fixed.find(input.name);
          value != fixed.end() &&
          (value->second < input.lower || value->second > input.upper))
        throw InputError("Objective/Fixed inputs: " + quoted_name(input.name) +
                         " is " + format_quantity(value->second, input.unit) +
                         "; the law knows " +
                         format_quantity(input.lower, input.unit) + " to " +
                         format_quantity(input.upper, input.unit) + ".");
    if (fixed.size() == law.description().inputs.size())
      throw InputError("Objective/Fixed inputs: all inputs of the law are "
                       "fixed; expected at least one that is not.");
  }



  SearchBox
  LawSearch::box() const
  {
    SearchBox box;
    for (const LawInput &input : law.description().inputs)
      if (fixed.count(input.name) == 0)
        {
          const bool logarithmic = input.scale == Scale::logarithmic;
          box.names.push_back((logarithmic ? "ln " : "") + input.symbol);
          box.lower.push_back(logarithmic ? std::log(input.lower) :
                                            input.lower);
          box.upper.push_back(logarithmic ? std::log(input.upper) :
                                            input.upper);
        }
    return box;
  }



  std::vector<double>
  LawSearch::inputs(const std::vector<double> &variables) const
  {
    std::vector<double> x;
    std::size_t         next = 0;
    for (const LawInput &input : law.description().inputs)
      if (const auto value = fixed.find(input.name); value != fixed.end())
        x.push_back(value->second);
      else
        {
          const double v = variables[next++];
          x.push_back(input.scale == Scale::logarithmic ? std::exp(v) : v);
        }
    return x;
  }



  Evaluation
  LawSearch::evaluate(const std::vector<double> &variables) const
  {
    const LawPrediction at = law.predict(inputs(variables).data());
    Evaluation          result;
    if (at.trusted)
      result.value = at.mean;
    else
      result.failure = "the law is not trusted here";
    return result;
  }



  std::vector<LeastFriction>
  LawSearch::run() const
  {
    const Objective objective = [this](const std::vector<double> &variables) {
      return evaluate(variables);
    };
    std::vector<LeastFriction> found;
    for (const bool is_direct : {true, false})
      {
        if (!(is_direct ? parameters.by_direct : parameters.genetically))
          continue;
        const std::string method = is_direct ? "DIRECT" : "genetic";
        EvaluationRecord  record(box(),
                                parameters.directory + "/" + method +
                                  "/evaluations.csv",
                                method + ", " + parameters.friction_law + ", " +
                                  parameters.fixed_inputs);
        LeastFriction     least;
        least.method = method;
        least.search =
          is_direct ? search_by_direct(objective, record, parameters.direct) :
                      search_genetically(objective, record, parameters.genetic);
        if (least.search.best.empty())
          throw ComputationError(quoted_name(parameters.friction_law) +
                                 " is trusted at none of the " +
                                 std::to_string(least.search.n_evaluations) +
                                 " points that were tried.");
        least.x          = inputs(least.search.best);
        least.prediction = law.predict(least.x.data());
        found.push_back(least);
      }
    return found;
  }



  void
  LawSearch::print(const std::vector<LeastFriction> &found,
                   std::ostream                     &out) const
  {
    for (const LeastFriction &least : found)
      {
        out << least.method << ": " << law.description().output << " = "
            << format_quantity(least.prediction.mean, "1", 4) << " ("
            << format_quantity(least.prediction.lower, "1", 4) << " to "
            << format_quantity(least.prediction.upper, "1", 4) << ") at";
        const auto &inputs = law.description().inputs;
        for (std::size_t i = 0; i < inputs.size(); ++i)
          out << (i == 0 ? " " : ", ") << inputs[i].symbol << " = "
              << format_quantity(least.x[i], inputs[i].unit, 4);
        out << ", after " << least.search.n_to_best << " of "
            << least.search.n_evaluations << " answers ("
            << least.search.n_failed << " not trusted); " << least.search.end
            << "\n";
      }
    out << mechanisms_sentence(law.description().mechanisms)
        << "\nAll answers are in " << parameters.directory << "\n";
  }
} // namespace asperity
