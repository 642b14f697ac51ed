#include <asperity/base/quantity.h>
#include <asperity/law_export/generated_source.h>

#include <nlohmann/json.hpp>

#include "export_text.h"
#include "exported_numbers.h"
#include "law_template.h"

namespace asperity
{
  namespace
  {
    using json = nlohmann::ordered_json;

    /** A constant in a line; ASCII, and without '<', so that the text may stand
     *  in a page. */
    std::string
    constant(const std::string &name, const json &value)
    {
      std::string text;
      for (const char c : value.dump(-1, ' ', true))
        text += c == '<' ? std::string("\\u003c") : std::string(1, c);
      return "  const " + name + " = " + text + ";\n";
    }

    std::string
    array(const std::string &name, const std::vector<double> &values)
    {
      std::vector<std::string> numbers;
      for (const double value : values)
        numbers.push_back(c_number(value));
      std::string text = "  const " + name + " = [\n";
      for (const std::string &line : number_lines(numbers, 74, ""))
        text += "    " + line + "\n";
      return text + "  ];\n";
    }

    json
    input_json(const LawInput                    &input,
               const ExportedNumbers::Coordinate &seen,
               const ExportedNumbers             &numbers)
    {
      const double zero = to_si(0., input.unit);
      return {{"name", input.name},
              {"symbol", input.symbol},
              {"unit", input.unit},
              {"factor", to_si(1., input.unit) - zero},
              {"offset", zero},
              {"place", seen.place},
              {"logarithmic", seen.logarithmic},
              {"origin", seen.origin},
              {"span", seen.span},
              {"length", seen.length},
              {"lower", seen.lower},
              {"upper", seen.upper},
              {"low_edge", seen.lower - seen.margin},
              {"high_edge", seen.upper + seen.margin},
              {"value",
               seen.place < ContactPointLaw::n_coordinates ?
                 json(nullptr) :
                 json(
                   numbers.further[seen.place - ContactPointLaw::n_coordinates]
                     .value)}};
    }

    std::string
    inputs(const ContactPointLaw &law, const ExportedNumbers &numbers)
    {
      const std::vector<LawInput> &all  = law.law().description().inputs;
      json                         list = json::array();
      for (std::size_t i = 0; i < all.size(); ++i)
        list.push_back(input_json(all[i], numbers.coordinates[i], numbers));
      return constant("inputs", list);
    }

    std::string
    data(const ContactPointLaw &law, const ExportedNumbers &numbers)
    {
      const FrictionLawDescription    &d     = law.law().description();
      const ShearLimit                &limit = numbers.shear_limit;
      const ExportedNumbers::Strength &s     = numbers.strength;
      return inputs(law, numbers) +
             constant("law",
                      {{"output", d.output},
                       {"logarithmic",
                        numbers.output_scale == Scale::logarithmic},
                       {"has_deviation", numbers.has_deviation},
                       {"offset", numbers.offset},
                       {"factor", numbers.factor},
                       {"largest_trusted_deviation",
                        numbers.largest_trusted_deviation},
                       {"profiles", d.n_profiles},
                       {"topography_error", d.topography_error}}) +
             constant("limit",
                      {{"k_0", limit.k_0},
                       {"softens", limit.softens},
                       {"exponent", limit.exponent},
                       {"transition", limit.transition_temperature},
                       {"range",
                        limit.melting_temperature -
                          limit.transition_temperature}}) +
             constant("strength",
                      {{"is_used", s.is_used},
                       {"pressure", s.pressure},
                       {"temperature", s.temperature},
                       {"strain", s.strain},
                       {"ratio", limit.hardening_ratio},
                       {"exponent", limit.hardening_exponent},
                       {"added", ShearLimit::strain_of_indentation},
                       {"limit", limit.strain_limit},
                       {"at_k_0", s.hardening_of_k_0}});
    }

    /** What was trained or fitted. */
    std::string
    model(const ExportedNumbers &numbers)
    {
      if (numbers.fitted)
        return law_template::fill(
          law_template::piecewise_power_law_js, [&](const std::string &) {
            const ExportedNumbers::Fitted &fitted = *numbers.fitted;
            return constant("level", fitted.level) +
                   constant("knee", fitted.knee) +
                   constant("slope", fitted.slope) +
                   constant("end", fitted.end) +
                   array("covariance",
                         {fitted.covariance.begin(), fitted.covariance.end()}) +
                   constant("noise_variance", numbers.noise_variance);
          });
      return law_template::fill(
        law_template::gaussian_process_js, [&](const std::string &) {
          return constant("kernel", numbers.kernel_number()) +
                 array("points", numbers.points) +
                 array("weights", numbers.weights) + array("B", numbers.B) +
                 constant("sum_of_weights", numbers.sum_of_weights) +
                 constant("signal_variance", numbers.signal_variance) +
                 constant("noise_variance", numbers.noise_variance);
        });
    }
  } // namespace



  std::string
  js_source(const ContactPointLaw &law, const bool with_deviation)
  {
    const ExportedNumbers numbers(law, with_deviation);
    return "/*\n" +
           comment_header({"friction_law.js: friction coefficient by pressure, "
                           "velocity and",
                           "temperature, with its 95 % interval. JavaScript "
                           "for pages and",
                           "Node.js, SI units."},
                          law,
                          " *") +
           " */\n" + model(numbers) +
           law_template::fill(law_template::friction_law_js,
                              [&](const std::string &) {
                                return data(law, numbers);
                              });
  }
} // namespace asperity
