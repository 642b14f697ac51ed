#include "export_text.h"

#include <asperity/base/mechanisms.h>
#include <asperity/base/quantity.h>
#include <asperity/base/version.h>

namespace asperity
{
  namespace
  {
    constexpr std::size_t text_width = 66;

    std::string
    range_line(const LawInput &input)
    {
      return input.symbol + " (" + input.name +
             "): " + format_quantity(input.lower, input.unit, 6) + " to " +
             format_quantity(input.upper, input.unit, 6) +
             (input.scale == Scale::logarithmic ? ", logarithmic" : "");
    }

    std::string
    shear_limit_line(const ShearLimit &limit)
    {
      if (!(limit.k_0 > 0.))
        return "Shear limit k: unknown, so tau = mu p.";
      if (!limit.softens)
        return "Shear limit k = " + format_quantity(limit.k_0, "MPa", 6) +
               ", the flow stress at strain " +
               format_quantity(limit.strain, "1", 4) +
               " over sqrt(3). tau = min(mu p, k).";
      return "Shear limit k(T) = " + format_quantity(limit.k_0, "MPa", 6) +
             " (1 - T*^" + format_quantity(limit.exponent, "1", 6) +
             "), T* = (T - " +
             format_quantity(limit.transition_temperature, "K", 6) + ")/(" +
             format_quantity(limit.melting_temperature, "K", 6) + " - " +
             format_quantity(limit.transition_temperature, "K", 6) +
             ") in [0, 1]; the flow stress at strain " +
             format_quantity(limit.strain, "1", 4) + " and rate " +
             format_quantity(limit.rate, "1/s", 4) +
             " over sqrt(3). tau = min(mu p, k).";
    }

    std::string
    model_line(const FrictionLaw &law)
    {
      const FrictionLawDescription &d = law.description();
      const std::string             n = std::to_string(law.data().y.size());
      const std::string             left =
        ", relative leave-one-out error " + percent(d.leave_one_out_error);
      if (law.fitted() != nullptr)
        return "Law: " + to_string(law.fitted()->law(), d.inputs[0].unit) +
               ", fitted to ln(mu) of " + n + " measurements" + left + ".";
      return "Law: Gaussian process, kernel " +
             kernel_name(law.process().kernel()) + ", " + n + " runs" + left +
             ", fitted to " +
             (d.output_scale == Scale::logarithmic ? "ln(mu)" : "mu") +
             (d.pressure_over_strength ? " over p/k instead of p" : "") +
             (d.output == "mu_end" ? " at the end of the runs." : ".");
    }

    /** As wrapped(), but breaks words that are too long as well. */
    void
    append_wrapped(std::vector<std::string> &lines, const std::string &text)
    {
      for (std::string line : wrapped(plain_text(text), text_width))
        {
          for (; line.size() > text_width; line.erase(0, text_width))
            lines.push_back(line.substr(0, text_width));
          lines.push_back(line);
        }
    }
  } // namespace



  std::vector<std::string>
  licence_lines()
  {
    return {"Copyright (c) the authors of Asperity",
            "",
            "Permission is hereby granted, free of charge, to any person",
            "obtaining a copy of this software and associated documentation",
            "files (the \"Software\"), to deal in the Software without",
            "restriction, including without limitation the rights to use,",
            "copy, modify, merge, publish, distribute, sublicense, and/or",
            "sell copies of the Software, and to permit persons to whom the",
            "Software is furnished to do so, subject to the following",
            "conditions:",
            "",
            "The above copyright notice and this permission notice shall be",
            "included in all copies or substantial portions of the Software.",
            "",
            "THE SOFTWARE IS PROVIDED \"AS IS\", WITHOUT WARRANTY OF ANY KIND,",
            "EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES",
            "OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND",
            "NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT",
            "HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY,",
            "WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING",
            "FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR",
            "OTHER DEALINGS IN THE SOFTWARE."};
  }



  std::vector<std::string>
  law_lines(const ContactPointLaw &law)
  {
    const FrictionLawDescription &d = law.law().description();
    std::vector<std::string>      lines;
    append_wrapped(lines, "Written by " + version_line() + ".");
    append_wrapped(lines, mechanisms_sentence(d.mechanisms));
    append_wrapped(lines, model_line(law.law()));
    if (d.topography_scatter > 0.)
      append_wrapped(lines,
                     "Mean over " + std::to_string(d.n_profiles) +
                       " profiles of the surface, which differ by " +
                       percent(d.topography_scatter) +
                       " (standard deviation): the mean over the whole "
                       "surface may be off by " +
                       percent(d.topography_error) +
                       " (95 %), which is not part of sigma.");
    for (const ChoiceSpread &choice : d.choices)
      {
        const std::string range =
          " -" + percent(choice.below, 3) + " to +" + percent(choice.above, 3);
        append_wrapped(
          lines,
          choice.kind == ChoiceSpread::plane_strain ?
            "A patch of the surface in three dimensions may lie off these "
            "profiles in plane strain by" +
              range + ", which is not part of sigma." :
            "Choices by hand (" + choice.kind + ") may move it by" + range +
              ", found in one scene and not part of sigma.");
      }
    append_wrapped(lines, "Ranges of the training data:");
    for (unsigned int c = 0; c < ContactPointLaw::n_coordinates; ++c)
      if (const LawInput *const input = law.input(c))
        append_wrapped(lines, "  " + range_line(*input));
      else
        append_wrapped(lines,
                       "  " + ContactPointLaw::symbols()[c] +
                         ": the law does not depend on it");
    for (std::size_t i = 0; i < d.inputs.size(); ++i)
      if (law.coordinates()[i] == ContactPointLaw::n_coordinates)
        append_wrapped(
          lines,
          "  " + d.inputs[i].name + " = " +
            format_quantity(law.fixed_values()[i], d.inputs[i].unit, 6) +
            ", held fixed where it is no argument, of " +
            format_quantity(d.inputs[i].lower, d.inputs[i].unit, 6) + " to " +
            format_quantity(d.inputs[i].upper, d.inputs[i].unit, 6));
    append_wrapped(lines, shear_limit_line(d.shear_limit));
    constexpr std::size_t most_entries = 50;
    std::size_t           n            = 0;
    for (const auto &[key, value] : d.provenance.items())
      if (++n <= most_entries)
        append_wrapped(lines, key + ": " + value.dump(-1, ' ', true));
    return lines;
  }



  std::string
  plain_text(const std::string &text)
  {
    constexpr std::size_t largest_size = 500;
    std::string           result;
    for (const char c : text.substr(0, largest_size))
      {
        const auto        code = static_cast<unsigned char>(c);
        const char        next = code < 0x20 || code == 0x7f ? ' ' :
                                 code > 0x7f                 ? '?' :
                                                               c;
        const std::string pair =
          result.empty() ? "" : std::string{result.back(), next};
        for (const char *const mark : {"*/", "/*", "//", "??"})
          if (pair == mark)
            result += ' ';
        result += next;
      }
    return text.size() > largest_size ? result + " ..." : result;
  }



  std::string
  comment_header(const std::vector<std::string> &title,
                 const ContactPointLaw          &law,
                 const std::string              &mark)
  {
    std::string text;
    const auto  append = [&](const std::vector<std::string> &lines) {
      for (const std::string &line : lines)
        text += mark + (line.empty() ? "" : " " + line) + "\n";
    };
    append(title);
    append({""});
    append(law_lines(law));
    append({""});
    append(licence_lines());
    return text;
  }



  std::vector<std::string>
  wrapped(const std::string &text, const std::size_t width)
  {
    std::vector<std::string> lines;
    std::string              rest = text;
    while (rest.size() > width)
      {
        // an indented first word stays where it is
        const std::size_t first = rest.find_first_not_of(' ');
        std::size_t       end   = rest.rfind(' ', width);
        if (end == std::string::npos || end < first)
          end = rest.find(' ', std::max(first, width));
        if (end == std::string::npos)
          break;
        lines.push_back(rest.substr(0, end));
        rest.erase(0, end + 1);
      }
    lines.push_back(rest);
    return lines;
  }



  std::string
  kernel_name(const KernelKind kernel)
  {
    switch (kernel)
      {
        case KernelKind::rbf:
          return "squared exponential (RBF)";
        case KernelKind::matern_3_2:
          return "Matern 3/2";
        case KernelKind::matern_5_2:
          return "Matern 5/2";
      }
    return "";
  }



  std::string
  percent(const double ratio, const unsigned int digits)
  {
    return format_quantity(ratio, "%", digits);
  }
} // namespace asperity
