#include <asperity/law_export/generated_source.h>

#include "export_text.h"
#include "exported_numbers.h"
#include "law_template.h"

namespace asperity
{
  namespace
  {
    std::string
    comment(const std::vector<std::string> &title, const ContactPointLaw &law)
    {
      return "/*\n" + comment_header(title, law, " *") + " */\n";
    }

    /** @param numbers as C writes them */
    std::string
    array(const std::string              &type,
          const std::string              &name,
          const std::string              &size,
          const std::vector<std::string> &numbers)
    {
      std::string text =
        "static const " + type + " " + name + "[" + size + "] = {\n";
      for (const std::string &line : number_lines(numbers, 74, "};"))
        text += "  " + line + "\n";
      return text;
    }

    std::string
    array(const std::string         &name,
          const std::string         &size,
          const std::vector<double> &values)
    {
      std::vector<std::string> numbers;
      for (const double value : values)
        numbers.push_back(c_number(value));
      return array("double", name, size, numbers);
    }

    std::string
    constant(const std::string &name, const double value)
    {
      return "static const double " + name + " = " + c_number(value) + ";\n";
    }

    std::string
    define(const std::string &name, const std::size_t value)
    {
      return "#define " + name + " " + std::to_string(value) + "\n";
    }

    /** Where the inputs are found, and how the kernel sees them. */
    std::string
    inputs(const ExportedNumbers &numbers)
    {
      std::vector<std::string> place, logarithm;
      std::vector<double>      origin, span, length, lower, upper, low, high;
      for (const auto &c : numbers.coordinates)
        {
          place.push_back(std::to_string(c.place));
          logarithm.push_back(c.logarithmic ? "1" : "0");
          origin.push_back(c.origin);
          span.push_back(c.span);
          length.push_back(c.length);
          lower.push_back(c.lower);
          upper.push_back(c.upper);
          low.push_back(c.lower - c.margin);
          high.push_back(c.upper + c.margin);
        }
      std::vector<double> stated;
      for (const auto &input : numbers.further)
        stated.push_back(input.value);
      stated.push_back(0.); // C has no empty arrays
      return "/* which input of p, v, T and the further ones each is */\n" +
             array("int", "place", "D", place) +
             "/* how the fit sees it: (g(x) - origin)/span/length, g = log "
             "or identity */\n" +
             array("int", "sees_logarithm", "D", logarithm) +
             array("origin", "D", origin) + array("span", "D", span) +
             array("length", "D", length) +
             "/* its range, and what still counts as inside of that */\n" +
             array("lower", "D", lower) + array("upper", "D", upper) +
             array("low_edge", "D", low) + array("high_edge", "D", high) +
             "/* values at which tribmu() holds the further inputs, and a zero "
             "behind them */\n" +
             array("stated", "TRIBMU_FURTHER + 1", stated);
    }

    std::string
    shear_limit(const ShearLimit &limit)
    {
      const bool softens = limit.k_0 > 0. && limit.softens;
      return constant("k_0", limit.k_0) +
             constant("k_exponent", limit.exponent) +
             constant("k_transition", limit.transition_temperature) +
             constant("k_range",
                      softens ? limit.melting_temperature -
                                  limit.transition_temperature :
                                1.);
    }

    /** Over what the fit sees the pressure. */
    std::string
    strength(const ExportedNumbers &numbers)
    {
      const ExportedNumbers::Strength &s = numbers.strength;
      return "/* whether the fit sees p/k instead of p, and which inputs p, T "
             "and the\n * strain are, D for none */\n" +
             define("OVER_STRENGTH", s.is_used) +
             define("P_INPUT", s.pressure) + define("T_INPUT", s.temperature) +
             define("STRAIN_INPUT", s.strain) +
             "/* k at a strain e over k_0: (1 + ratio min(e + added, "
             "limit)^exponent)/hard_0 */\n" +
             constant("hard_ratio", numbers.shear_limit.hardening_ratio) +
             constant("hard_exponent", numbers.shear_limit.hardening_exponent) +
             constant("hard_added", ShearLimit::strain_of_indentation) +
             constant("hard_limit", numbers.shear_limit.strain_limit) +
             constant("hard_0", s.hardening_of_k_0);
    }

    std::string
    data(const ExportedNumbers &numbers)
    {
      return define("D", numbers.coordinates.size()) +
             define("LOGARITHMIC", numbers.output_scale == Scale::logarithmic) +
             define("HAS_DEVIATION", numbers.has_deviation) +
             define("HAS_LIMIT", numbers.shear_limit.k_0 > 0.) +
             define("SOFTENS", numbers.shear_limit.softens) + "\n" +
             inputs(numbers) + constant("offset", numbers.offset) +
             constant("factor", numbers.factor) +
             constant("largest_trusted_deviation",
                      numbers.largest_trusted_deviation) +
             shear_limit(numbers.shear_limit) + strength(numbers);
    }

    std::string
    runs(const ExportedNumbers &numbers)
    {
      return define("N", numbers.weights.size()) +
             define("KERNEL", numbers.kernel_number()) + "\n" +
             "/* scaled inputs of the training runs, and their weights */\n" +
             array("points", "N * D", numbers.points) +
             array("weights", "N", numbers.weights) +
             "/* inverse triangular factor of the covariance, row by row */\n" +
             (numbers.has_deviation ? array("B", "N * (N + 1) / 2", numbers.B) :
                                      array("B", "1", {0.})) +
             constant("sum_of_weights", numbers.sum_of_weights) +
             constant("signal_variance", numbers.signal_variance);
    }

    std::string
    constants(const ExportedNumbers::Fitted &fitted)
    {
      return constant("level", fitted.level) + constant("knee", fitted.knee) +
             constant("slope", fitted.slope) + constant("end", fitted.end) +
             "/* of level, knee and slope, row by row */\n" +
             array("covariance",
                   "9",
                   {fitted.covariance.begin(), fitted.covariance.end()});
    }

    /** What was trained or fitted. */
    std::string
    model(const ExportedNumbers &numbers)
    {
      if (numbers.fitted)
        return law_template::fill(law_template::piecewise_power_law_c,
                                  [&](const std::string &) {
                                    return constants(*numbers.fitted);
                                  });
      return law_template::fill(law_template::gaussian_process_c,
                                [&](const std::string &block) {
                                  return block == "kernels" ?
                                           std::string(
                                             law_template::kernel_formulas_h) :
                                           runs(numbers);
                                });
    }
  } // namespace



  std::string
  c_header(const ContactPointLaw &law)
  {
    const ExportedNumbers numbers(law, false);
    return comment({"tribmu.h: friction coefficient by pressure, velocity and",
                    "temperature, with its derivatives. C99, SI units."},
                   law) +
           law_template::fill(law_template::tribmu_h, [&](const std::string &) {
             std::string text =
               define("TRIBMU_FURTHER", numbers.further.size());
             for (const auto &input : numbers.further)
               text += "/* " +
                       plain_text(input.name + " [" + input.unit + "] = ") +
                       c_number(input.value) + " */\n";
             return text;
           });
  }



  std::string
  c_source(const ContactPointLaw &law, const bool with_deviation)
  {
    const ExportedNumbers numbers(law, with_deviation);

    std::vector<std::string> title = {
      "tribmu.c: friction coefficient by pressure, velocity and",
      "temperature, with its derivatives. C99, SI units; see tribmu.h."};
    if (numbers.has_deviation)
      title.push_back("With the deviation: `trusted` is that of the program.");
    else
      for (
        const char *const line :
        {"Without the deviation, since there are too many runs: tribmu_sigma",
         "gives -1, and `trusted` means in the box only."})
        title.push_back(line);
    return comment(title, law) +
           law_template::fill(law_template::tribmu_c,
                              [&](const std::string &block) {
                                return block == "model" ? model(numbers) :
                                                          data(numbers);
                              });
  }
} // namespace asperity
