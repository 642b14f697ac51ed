#include <asperity/base/command_options.h>
#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mechanisms.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/law_export/commands.h>
#include <asperity/law_export/export_law.h>
#include <asperity/law_export/law_options.h>
#include <asperity/surrogate/power_law.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "export_text.h"

namespace asperity
{
  namespace
  {
    std::string
    in_unit(const double value, const LawInput &input)
    {
      return format_quantity(value, input.unit, 6);
    }

    /** The point of the options, in the law's order. */
    std::vector<double>
    point_of(const FrictionLawDescription &law, const CommandOptions &options)
    {
      const std::map<std::string, double> given =
        input_values(law, options, "predict");
      std::vector<double>      point;
      std::vector<std::string> missing;
      for (const LawInput &input : law.inputs)
        if (const auto entry = given.find(input.name); entry != given.end())
          point.push_back(entry->second);
        else
          missing.push_back(option_of(law, input) + " \"" +
                            in_unit(input.lower, input) + "\"");
      if (!missing.empty())
        throw InputError("The law of " + quoted_name(law.output) +
                         " also needs " + join(missing, ", ") +
                         ", for example.");
      return point;
    }

    /** A law whose numbers are damaged may answer with none. */
    void
    require_finite(const LawPrediction &at, const std::string &path)
    {
      bool finite = std::isfinite(at.mean) && std::isfinite(at.deviation) &&
                    std::isfinite(at.surface_lower) &&
                    std::isfinite(at.surface_upper);
      for (const double slope : at.gradient)
        finite = finite && std::isfinite(slope);
      if (!finite)
        throw InputError("The law in " + quoted_name(path) +
                         " gives no finite number at this point: the file is "
                         "damaged, or the point is absurd.");
    }

    /** "mu", or "mu at the end" of the runs. */
    std::string
    output_name(const FrictionLawDescription &law)
    {
      return law.output == "mu_end" ? "mu at the end" : law.output;
    }

    /** Why a prediction is not to be trusted, or that it is. */
    std::string
    trust_line(const FrictionLawDescription &law,
               const std::vector<double>    &point,
               const LawPrediction          &at)
    {
      std::vector<std::string> reasons;
      for (std::size_t i = 0; i < point.size(); ++i)
        {
          const LawInput &input = law.inputs[i];
          const double    margin =
            FrictionLaw::edge_tolerance * (input.upper - input.lower);
          if (!(point[i] >= input.lower - margin &&
                point[i] <= input.upper + margin))
            reasons.push_back(input.symbol + " = " + in_unit(point[i], input) +
                              " is outside of the data, " +
                              in_unit(input.lower, input) + " to " +
                              in_unit(input.upper, input));
        }
      const double relative = at.deviation / std::abs(at.mean);
      if (!(relative <= law.largest_trusted_deviation))
        reasons.push_back("the deviation is " + percent(relative) +
                          " of the mean, more than " +
                          percent(law.largest_trusted_deviation));
      if (!reasons.empty())
        return "not trusted: " + join(reasons, "; ");
      return "trusted: inside of the data, deviation " + percent(relative) +
             " of the mean";
    }

    /** What is known of the mean over the whole surface. */
    std::string
    surface_line(const FrictionLawDescription &law, const LawPrediction &at)
    {
      if (law.n_profiles < 2)
        return "whole surface: scatter unknown, since all runs are on one "
               "profile";
      return "whole surface: 95 % interval " +
             format_quantity(at.surface_lower, "1", 5) + " to " +
             format_quantity(at.surface_upper, "1", 5) + ", from " +
             std::to_string(law.n_profiles) + " profiles that differ by " +
             percent(law.topography_scatter);
    }

    /** What is known of choices that a user makes by hand; a line, or nothing.
     */
    std::string
    choices_line(const FrictionLawDescription &law, const LawPrediction &at)
    {
      double                   below = 0., above = 0.;
      std::vector<std::string> kinds;
      for (const ChoiceSpread &choice : law.choices)
        {
          if (choice.kind == ChoiceSpread::plane_strain)
            continue;
          below = std::hypot(below, choice.below);
          above = std::hypot(above, choice.above);
          kinds.push_back(choice.kind + " -" + percent(choice.below, 3) +
                          " to +" + percent(choice.above, 3));
        }
      if (kinds.empty())
        return "";
      return "choices by hand, as shares found in one scene: " +
             format_quantity(at.mean * std::max(0., 1. - below), "1", 5) +
             " to " + format_quantity(at.mean * (1. + above), "1", 5) + " (" +
             join(kinds, ", ") + ")\n";
    }

    /** What profiles in plane strain err; a line, or nothing. */
    std::string
    plane_strain_line(const FrictionLawDescription &law,
                      const LawPrediction          &at)
    {
      for (const ChoiceSpread &choice : law.choices)
        if (choice.kind == ChoiceSpread::plane_strain)
          return "plane strain: a patch of the surface may have " +
                 format_quantity(at.mean * (1. - choice.below), "1", 5) +
                 " to " +
                 format_quantity(at.mean * (1. + choice.above), "1", 5) +
                 " (-" + percent(choice.below, 3) + " to +" +
                 percent(choice.above, 3) + ")\n";
      return "";
    }

    void
    print_derivatives(const FrictionLawDescription &law,
                      const LawPrediction          &at)
    {
      for (std::size_t i = 0; i < law.inputs.size(); ++i)
        {
          const LawInput &input = law.inputs[i];
          const double    unit  = to_si(1., input.unit) - to_si(0., input.unit);
          std::cout << "d " << law.output << "/d " << input.symbol << " = "
                    << format_quantity(at.gradient[i] * unit, "1", 4)
                    << (input.unit == "1" ? "" : " per " + input.unit) << "\n";
        }
    }

    /** k and tau, if the law is one of mu over a pressure and a temperature. */
    void
    print_shear(const FrictionLawDescription &law,
                const std::vector<double>    &point,
                const LawPrediction          &at)
    {
      const double *p = nullptr, *T = nullptr;
      for (std::size_t i = 0; i < point.size(); ++i)
        if (law.inputs[i].symbol == "p")
          p = &point[i];
        else if (law.inputs[i].symbol == "T")
          T = &point[i];
      if (!is_friction_coefficient(law.output) || p == nullptr)
        return;
      const bool known =
        law.shear_limit.k_0 > 0. && (T != nullptr || !law.shear_limit.softens);
      const double k       = known ? law.shear_limit(T == nullptr ? 0. : *T) :
                                     std::numeric_limits<double>::infinity();
      const double coulomb = at.mean * *p;
      if (known)
        std::cout << "shear limit k = " << format_quantity(k, "MPa", 4)
                  << "; tau = min(mu p, k) = "
                  << format_quantity(std::min(coulomb, k), "MPa", 4)
                  << (coulomb > k ? ", sticking" : ", sliding") << "\n";
      else
        std::cout << "tau = mu p = " << format_quantity(coulomb, "MPa", 4)
                  << "; the shear limit is unknown\n";
    }

    SolverUnits
    units_of(const std::string &name)
    {
      if (name == "mm")
        return FrictionGridOptions().units;
      if (name == "SI")
        return {{"Pa", "m/s", "K"}};
      throw InputError("The option '--units' is " + quoted_name(name) +
                       "; 'mm' (mm, s, MPa, degC) or 'SI' is expected.");
    }

    void
    print_report(const ExportReport &report, const std::string &directory)
    {
      for (const ExportedFile &file : report.files)
        {
          std::string line = "  " + file.name;
          line.resize(std::max<std::size_t>(28, line.size() + 2), ' ');
          std::cout << line << file.sentence;
          if (file.interpolation_error > 0.)
            std::cout << ", within " << percent(file.interpolation_error);
          std::cout << "\n";
        }
      for (const std::string &warning : report.warnings)
        std::cout << "Warning: " << warning << "\n";
      std::cout << "Written to " << directory << "; see README.txt there.\n";
    }

    /** The laws of practice on the same runs, where they can be fitted. */
    void
    print_comparison(const FrictionLaw &law)
    {
      std::cout << "Leave-one-out error of the law: "
                << percent(law.description().leave_one_out_error) << "\n";
      const auto print = [&](const char *const name,
                             PowerLaw (*fit)(const FrictionLaw &)) {
        try
          {
            const PowerLaw power_law = fit(law);
            std::cout << "  " << name << ": "
                      << percent(power_law.leave_one_out_error) << ", "
                      << to_string(power_law, law.description().inputs) << "\n";
          }
        catch (const InputError &)
          {} // the runs do not allow it, which is no error of the export
      };
      print("a power law", fit_power_law);
      print("a power law over v", fit_velocity_law);
    }
  } // namespace



  std::string
  example_arguments(const FrictionLawDescription &law)
  {
    std::string text;
    for (const LawInput &input : law.inputs)
      {
        const double middle =
          input.scale == Scale::logarithmic ?
            std::sqrt(input.lower) * std::sqrt(input.upper) :
            0.5 * (input.lower + input.upper);
        std::string value;
        for (unsigned int digits = 3; digits <= 17; ++digits)
          {
            value             = format_quantity(middle, input.unit, digits);
            const double read = parse_quantity(value, dimension_of(input.unit));
            if (read >= input.lower && read <= input.upper)
              break; // a narrow range wants more digits
          }
        value.erase(std::remove(value.begin(), value.end(), ' '), value.end());
        text += " " + option_of(law, input) + " " + value;
      }
    return text;
  }



  int
  predict_friction(const std::vector<std::string> &arguments)
  {
    const CommandOptions options(arguments);
    if (options.words.size() != 1)
      throw InputError("'asperity predict' takes one law, as in 'asperity "
                       "predict law.json -p 450MPa -v 90m/min -T 300degC'.");
    const FrictionLaw             law = FrictionLaw::load(options.words[0]);
    const FrictionLawDescription &description = law.description();
    const std::vector<double>     point       = point_of(description, options);
    const LawPrediction           at          = law.predict(point.data());
    require_finite(at, options.words[0]);
    if (!is_first_rank())
      return 0;
    std::cout << output_name(description) << " = "
              << format_quantity(at.mean, "1", 5) << ", 95 % interval "
              << format_quantity(at.lower, "1", 5) << " to "
              << format_quantity(at.upper, "1", 5) << "\n"
              << trust_line(description, point, at) << "\n";
    std::cout << mechanisms_sentence(description.mechanisms) << "\n"
              << (law.fitted() == nullptr ?
                    surface_line(description, at) :
                    to_string(law.fitted()->law(), description.inputs[0].unit))
              << "\n"
              << choices_line(description, at)
              << plane_strain_line(description, at);
    print_derivatives(description, at);
    print_shear(description, point, at);
    return 0;
  }



  int
  export_friction_law(const std::vector<std::string> &arguments)
  {
    const CommandOptions options(arguments);
    if (options.words.size() != 2)
      throw InputError("'asperity export' takes a law and a directory, as in "
                       "'asperity export law.json for_abaqus'.");
    const FrictionLaw law = FrictionLaw::load(options.words[0]);
    ExportOptions     export_options;
    export_options.fixed = input_values(law.description(),
                                        options,
                                        "export",
                                        {"--tolerance", "--units"});
    if (const auto entry = options.values.find("--tolerance");
        entry != options.values.end())
      export_options.grid.tolerance =
        parse_input({"tolerance", "tolerance", "%"},
                    entry->second,
                    entry->first);
    if (const auto entry = options.values.find("--units");
        entry != options.values.end())
      export_options.grid.units = units_of(entry->second);
    if (!is_first_rank())
      return 0;
    print_report(export_law(law, options.words[1], export_options),
                 options.words[1]);
    if (law.fitted() == nullptr)
      print_comparison(law);
    return 0;
  }
} // namespace asperity
