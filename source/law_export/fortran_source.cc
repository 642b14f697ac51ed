#include <asperity/base/text.h>
#include <asperity/law_export/generated_source.h>

#include <algorithm>
#include <map>

#include "export_text.h"
#include "fortran_blocks.h"
#include "law_template.h"

namespace asperity
{
  namespace
  {
    /** Two numbers fit into a line, and 18 lines into a statement: Fortran 77
     *  allows 19 continuation lines. */
    constexpr std::size_t numbers_per_statement = 36;
    constexpr std::size_t columns_for_data      = 66;

    std::string
    statement(const std::string &text)
    {
      return "      " + text + "\n";
    }

    std::string
    data_statements(const std::string &name, const std::vector<double> &values)
    {
      std::string text;
      for (std::size_t begin = 0; begin < values.size();
           begin += numbers_per_statement)
        {
          const std::size_t end =
            std::min(begin + numbers_per_statement, values.size());
          std::vector<std::string> numbers;
          for (std::size_t j = begin; j < end; ++j)
            numbers.push_back(fortran_number(values[j]));
          text +=
            statement("DATA (" + name + "(J),J=" + std::to_string(begin + 1) +
                      "," + std::to_string(end) + ")/");
          for (const std::string &line :
               number_lines(numbers, columns_for_data, "/"))
            text += "     &" + line + "\n";
        }
      return text;
    }

    /** One statement for a short array. */
    std::string
    short_array(const std::string              &name,
                const std::vector<std::string> &numbers)
    {
      std::string text = statement("DATA " + name + "/");
      for (const std::string &line :
           number_lines(numbers, columns_for_data, "/"))
        text += "     &" + line + "\n";
      return text;
    }

    std::string
    scales(const ExportedNumbers &numbers)
    {
      std::vector<std::string> place, logarithm, origin, span, length;
      std::vector<std::string> lower, upper, low, high;
      for (const auto &c : numbers.coordinates)
        {
          place.push_back(std::to_string(c.place + 1));
          logarithm.push_back(c.logarithmic ? "1" : "0");
          origin.push_back(fortran_number(c.origin));
          span.push_back(fortran_number(c.span));
          length.push_back(fortran_number(c.length));
          lower.push_back(fortran_number(c.lower));
          upper.push_back(fortran_number(c.upper));
          low.push_back(fortran_number(c.lower - c.margin));
          high.push_back(fortran_number(c.upper + c.margin));
        }
      return short_array("ITABLE", place) + short_array("LOGX", logarithm) +
             short_array("ORIGIN", origin) + short_array("SPAN", span) +
             short_array("LENGTH", length) + short_array("XLOWER", lower) +
             short_array("XUPPER", upper) + short_array("XLOW", low) +
             short_array("XHIGH", high);
    }

    std::string
    factor(const ExportedNumbers &numbers)
    {
      const std::vector<double> B =
        numbers.B.empty() ? std::vector<double>{0.} : numbers.B;
      // the implied loop of the data counts with J
      return statement("DOUBLE PRECISION B(" + std::to_string(B.size()) + ")") +
             statement("SAVE B") + data_statements("B", B);
    }

    std::string
    parameter(const std::string &name, const double value)
    {
      return statement("PARAMETER (" + name + "=" + fortran_number(value) +
                       ")");
    }

    std::string
    hardening(const ExportedNumbers &numbers)
    {
      const ShearLimit &limit = numbers.shear_limit;
      return parameter("RATIO", limit.hardening_ratio) +
             parameter("XN", limit.hardening_exponent) +
             parameter("ADDED", ShearLimit::strain_of_indentation) +
             parameter("EMAX", limit.strain_limit) +
             parameter("H0", numbers.strength.hardening_of_k_0);
    }

    std::string
    limit(const ShearLimit &limit)
    {
      const bool softens = limit.k_0 > 0. && limit.softens;
      return parameter("XK0", limit.k_0) + parameter("XM", limit.exponent) +
             parameter("T0", limit.transition_temperature) +
             parameter("DT",
                       softens ? limit.melting_temperature -
                                   limit.transition_temperature :
                                 1.);
    }

    std::string
    constants(const ExportedNumbers &numbers)
    {
      return statement("OFFSET=" + fortran_number(numbers.offset)) +
             statement("FACTOR=" + fortran_number(numbers.factor)) +
             statement("LIMIT=" +
                       fortran_number(numbers.largest_trusted_deviation));
    }

    std::string
    constants_of(const ExportedNumbers::Fitted &fitted)
    {
      std::string text = statement("LEVEL=" + fortran_number(fitted.level)) +
                         statement("KNEE=" + fortran_number(fitted.knee)) +
                         statement("SLOPE=" + fortran_number(fitted.slope)) +
                         statement("XEND=" + fortran_number(fitted.end));
      for (std::size_t i = 0; i < fitted.covariance.size(); ++i)
        text += statement("C(" + std::to_string(i + 1) +
                          ")=" + fortran_number(fitted.covariance[i]));
      return text;
    }

    std::string
    stated(const ExportedNumbers &numbers)
    {
      if (numbers.further.empty())
        return statement("Q(1)=0D0");
      std::string text;
      for (std::size_t i = 0; i < numbers.further.size(); ++i)
        {
          const auto &input = numbers.further[i];
          for (const std::string &line :
               wrapped(plain_text(input.name + " [" + input.unit + "]"), 60))
            text += "C     " + line.substr(0, 66) + "\n";
          text += statement("Q(" + std::to_string(i + 1) +
                            ")=" + fortran_number(input.value));
        }
      return text;
    }

    std::string
    block_text(const ExportedNumbers &numbers, const std::string &block)
    {
      if (block == "FACTOR")
        return factor(numbers);
      if (block == "LIMIT")
        return limit(numbers.shear_limit);
      if (block == "HARDENING")
        return hardening(numbers);
      if (block == "STATED")
        return stated(numbers);
      if (block == "CONSTANTS")
        return constants(numbers);
      if (block == "PROCESS")
        return statement("SIGNAL=" + fortran_number(numbers.signal_variance)) +
               statement("TOTAL=" + fortran_number(numbers.sum_of_weights));
      if (block == "FITTED")
        return constants_of(*numbers.fitted);
      if (block == "SCALES")
        return scales(numbers);
      if (block == "RUNS")
        return data_statements("X", numbers.points) +
               data_statements("W", numbers.weights);
      return fortran_parameters(numbers, block);
    }

    std::vector<std::string>
    title(const ExportedNumbers &numbers)
    {
      const std::string n =
        std::to_string(std::max<std::size_t>(1, numbers.weights.size()));
      std::vector<std::string> lines = {
        "Friction coefficient by pressure P [Pa], sliding velocity V [m/s]",
        "and temperature T [K]. Fortran 77; everything DOUBLE PRECISION.",
        "",
        "SUBROUTINE TRIBMU(P,V,T,XMU,DMU,INSIDE)",
        "  XMU: mu; DMU(3): its derivatives by P, V and T",
        "  INSIDE: 1 in the box of the training data, else 0",
        "SUBROUTINE TRIBSD(P,V,T,XMU,SIGMA,ITRUST,WORK)",
        "  SIGMA: standard deviation of mu; ITRUST: 1 if mu is to be",
        "  trusted, else 0; WORK: room for " + n + " numbers",
        "SUBROUTINE TRIBMX(P,V,T,Q,XMU,DMU,INSIDE)",
        "SUBROUTINE TRIBSX(P,V,T,Q,XMU,SIGMA,ITRUST,WORK)",
        "  the same with the further inputs of the law as arguments: Q in",
        "  SI and in the order of TRIBST, where the values are that TRIBMU",
        "  and TRIBSD hold them at; DMU has an entry for each of Q, too"};
      for (const std::string &line :
           !numbers.has_deviation ?
             std::vector<std::string>{
               "  Written without the deviation: SIGMA is -1, and ITRUST is 1",
               "  in the box."} :
             std::vector<std::string>{
               "  ITRUST: in the box, and the deviation is small."})
        lines.push_back(line);
      for (const char *const line :
           {"SUBROUTINE TRIBK(T,XK,DXK)",
            "  XK: shear limit k [Pa]; DXK: its derivative by T",
            "DOUBLE PRECISION FUNCTION TRIBTA(P,V,T): min(mu p, k) [Pa]",
            "",
            "Outside of the box the law is still answered, with finite",
            "numbers: far away it tends to a constant. A",
            "pressure, velocity or temperature that is not positive is",
            "replaced by the lower end of its range if the law sees its",
            "logarithm (see the ranges below); the derivative by it is 0",
            "then."})
        lines.push_back(line);
      return lines;
    }
  } // namespace



  std::string
  fortran_parameters(const ExportedNumbers &numbers, const std::string &block)
  {
    const std::map<std::string, std::size_t> integers = {
      {"D", numbers.coordinates.size()},
      {"NQ", numbers.further.size()},
      {"N", numbers.weights.size()},
      {"KERNEL", numbers.kernel_number()},
      {"IPRESS", numbers.strength.pressure + 1},
      {"ITEMP", numbers.strength.temperature + 1},
      {"ISTRN", numbers.strength.strain + 1}};
    const std::map<std::string, bool> flags = {
      {"LOGMU", numbers.output_scale == Scale::logarithmic},
      {"HASDEV", numbers.has_deviation},
      {"HASK", numbers.shear_limit.k_0 > 0.},
      {"SOFTEN", numbers.shear_limit.softens},
      {"OVERK", numbers.strength.is_used}};
    const std::vector<std::string> words = split(block, ' ');
    std::string                    text;
    for (std::size_t i = 1; i < words.size(); ++i)
      {
        const auto integer = integers.find(words[i]);
        const bool is_flag = integer == integers.end();
        text +=
          statement((is_flag ? "LOGICAL " : "INTEGER ") + words[i]) +
          statement("PARAMETER (" + words[i] + "=" +
                    (is_flag ? (flags.at(words[i]) ? ".TRUE." : ".FALSE.") :
                               std::to_string(integer->second)) +
                    ")");
      }
    return text;
  }



  std::string
  fortran_source(const ContactPointLaw &law, const bool with_deviation)
  {
    const ExportedNumbers numbers(law, with_deviation);
    const auto            fill = [&](const char *const text) {
      return law_template::fill(text, [&](const std::string &block) {
        return block_text(numbers, block);
      });
    };
    return comment_header(title(numbers), law, "C") +
           fill(law_template::tribmu_f) +
           fill(numbers.fitted ? law_template::piecewise_power_law_f :
                                 law_template::gaussian_process_f);
  }
} // namespace asperity
