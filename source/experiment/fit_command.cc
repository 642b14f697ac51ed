#include <asperity/base/command_options.h>
#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mechanisms.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/experiment/commands.h>
#include <asperity/experiment/measured_friction.h>
#include <asperity/law_export/commands.h>
#include <asperity/surrogate/friction_law.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace asperity
{
  namespace
  {
    const std::string constant_part_option = "--constant-up-to";

    PiecewisePowerOptions
    fit_options(const CommandOptions &options)
    {
      PiecewisePowerOptions result;
      const auto            entry = options.values.find(constant_part_option);
      if (entry == options.values.end() || entry->second == "automatic")
        return result;
      if (entry->second == "none")
        result.constant_part = ConstantPart::none;
      else if (entry->second == "fitted")
        result.constant_part = ConstantPart::fitted;
      else
        try
          {
            result.constant_part = ConstantPart::given;
            result.v_0 = parse_quantity(entry->second, Dimension::velocity);
            if (!(result.v_0 > 0.))
              throw InputError(
                quoted_text(entry->second) +
                " is no velocity above 0; such a one is expected");
          }
        catch (const InputError &error)
          {
            throw InputError("Option " + quoted_name(constant_part_option) +
                             ": " + error.what() +
                             ", or one of the words automatic, none and "
                             "fitted.");
          }
      return result;
    }

    /** Where the numbers are from, without repetition. */
    std::vector<std::string>
    sources(const MeasuredFriction &measured)
    {
      std::vector<std::string> result;
      for (const MeasuredPoint &point : measured.points())
        if (!point.source.empty() &&
            std::find(result.begin(), result.end(), point.source) ==
              result.end())
          result.push_back(point.source);
      return result;
    }

    FrictionLawDescription
    describe(const MeasuredFriction &measured)
    {
      FrictionLawDescription result;
      const auto             column = measured.column("v");
      result.inputs                 = {
                        {"Load/Velocity", "v", column ? measured.units()[*column] : "m/min"}};
      result.mechanisms            = {measured_mechanisms};
      result.provenance["program"] = version_json();
      result.provenance["measurements"] =
        std::filesystem::path(measured.path()).filename().string();
      if (const auto series = measured.series(); !series.empty())
        result.provenance["series"] = series;
      if (const auto from = sources(measured); !from.empty())
        result.provenance["sources"] = from;
      return result;
    }

    /** Inputs of the file that vary, which the law does not know. */
    void
    print_what_is_left_out(const MeasuredFriction &measured)
    {
      for (const std::string &symbol : measured.inputs())
        {
          std::vector<double> values;
          for (const MeasuredPoint &point : measured.points())
            if (const auto &x = point.x[*measured.column(symbol)])
              values.push_back(*x);
          if (symbol == "v" || values.empty())
            continue;
          const auto [low, high] =
            std::minmax_element(values.begin(), values.end());
          const std::string &unit = measured.units()[*measured.column(symbol)];
          if (*low < *high)
            std::cout << "Warning: " << symbol << " varies from "
                      << format_quantity(*low, unit, 4) << " to "
                      << format_quantity(*high, unit, 4)
                      << " between the measurements, on which this law does "
                         "not depend.\n";
        }
    }

    void
    print_law(const FrictionLaw &law, const MeasuredFriction &measured)
    {
      const LawInput &v = law.description().inputs[0];
      std::cout << to_string(law.fitted()->law(), v.unit) << "\n"
                << "fitted to " << measured.points().size()
                << " measurements, v = " << format_quantity(v.lower, v.unit, 4)
                << " to " << format_quantity(v.upper, v.unit, 4)
                << "; one of them scatters by "
                << format_quantity(law.fitted()->law().scatter, "%", 2)
                << ", leave-one-out error "
                << format_quantity(law.description().leave_one_out_error,
                                   "%",
                                   2)
                << "\n"
                << mechanisms_sentence(law.description().mechanisms) << "\n";
      print_what_is_left_out(measured);
    }
  } // namespace



  int
  fit_measured_friction(const std::vector<std::string> &arguments)
  {
    const CommandOptions options(arguments, {constant_part_option, "--series"});
    if (options.words.size() != 2)
      throw InputError("'asperity fit' takes a file of measurements and the "
                       "file of the law, as in 'asperity fit measured.csv "
                       "law.json'.");
    const PiecewisePowerOptions fit = fit_options(options);
    MeasuredFriction measured       = MeasuredFriction::read(options.words[0]);
    const auto       series         = options.values.find("--series");
    measured.choose(series == options.values.end() ? "" : series->second);
    std::vector<double> v, mu;
    for (const MeasuredPoint &point : measured.points())
      {
        v.push_back(measured.value(point, "v"));
        mu.push_back(point.mu);
      }
    const FrictionLaw law = FrictionLaw::fit_to_measurements(
      describe(measured), v, mu, measured.deviations(), fit);
    if (!is_first_rank())
      return 0;
    law.save(options.words[1]);
    print_law(law, measured);
    std::cout << "Written to " << options.words[1] << "; 'asperity predict "
              << options.words[1] << example_arguments(law.description())
              << "' asks it.\n";
    return 0;
  }
} // namespace asperity
