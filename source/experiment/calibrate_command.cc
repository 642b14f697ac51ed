#include <asperity/base/command_options.h>
#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mechanisms.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/experiment/calibration.h>
#include <asperity/experiment/commands.h>
#include <asperity/experiment/measured_friction.h>
#include <asperity/law_export/law_options.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>

namespace asperity
{
  namespace
  {
    const std::string series_option = "--series", of_option = "--of";

    /** The law's file: the word itself, or in the folder of a campaign. */
    std::string
    law_file(const std::string &word)
    {
      return std::filesystem::is_directory(word) ? word + "/friction_law.json" :
                                                   word;
    }

    std::string
    option(const CommandOptions &options, const std::string &name)
    {
      const auto entry = options.values.find(name);
      return entry == options.values.end() ? "" : entry->second;
    }

    /** Which input is found: the one that `--of` names, else the strength of
     *  the interface. */
    std::size_t
    calibrated_input(const FrictionLawDescription &law,
                     const std::string            &given)
    {
      const auto place = [&](const std::string &name) {
        return static_cast<std::size_t>(
          std::find_if(law.inputs.begin(),
                       law.inputs.end(),
                       [&](const LawInput &input) {
                         return input.name == name;
                       }) -
          law.inputs.begin());
      };
      if (!given.empty())
        return place(find_input(law, given).name);
      std::vector<std::string> names;
      for (const LawInput &input : law.inputs)
        names.push_back(quoted_name(input.name));
      for (const char *const name :
           {"Interface/Shear factor", "Interface/Friction coefficient"})
        if (const std::size_t i = place(name); i < law.inputs.size())
          return i;
      throw InputError(
        "The law depends on " + join(names, ", ") +
        ", and neither on 'Interface/Shear factor' nor on "
        "'Interface/Friction coefficient'; the law of a campaign that varies "
        "one of them is expected, or '--of' with another input.");
    }

    /** What differs between measurements and has to be said. */
    bool
    is_of_the_load(const LawInput &input)
    {
      return input.symbol == "p" || input.symbol == "v" || input.symbol == "T";
    }

    /** An error in the unit of an input, without the unit. */
    std::string
    error_text(const double error, const LawInput &input)
    {
      const double per_si = from_si(1., input.unit) - from_si(0., input.unit);
      return format_quantity(error * per_si, "1", 2);
    }

    const LawInput *
    input_of(const FrictionLawDescription &law, const std::string &symbol)
    {
      for (const LawInput &input : law.inputs)
        if (input.symbol == symbol)
          return &input;
      return nullptr;
    }

    /** A law may be one of a single pressure, for example, but then it cannot
     *  speak of measurements at several. */
    void
    require_constant(const FrictionLawDescription &law,
                     const MeasuredFriction       &measured,
                     const std::string            &symbol)
    {
      const std::size_t column = *measured.column(symbol);
      for (const MeasuredPoint &point : measured.points())
        if (point.x[column] != measured.points().front().x[column])
          {
            std::vector<std::string> names;
            for (const LawInput &input : law.inputs)
              names.push_back(input.symbol);
            throw InputError("The measurements differ in " + symbol +
                             ", on which the law does not depend; its inputs "
                             "are " +
                             join(names, ", ") + ".");
          }
    }

    /** The inputs at each measurement: from its file, else from the command's
     *  options, else the law's own references. */
    CalibrationData
    gather(const FrictionLawDescription        &law,
           const MeasuredFriction              &measured,
           const std::map<std::string, double> &given,
           const std::size_t                    calibrated)
    {
      for (const std::string &symbol : measured.inputs())
        if (const LawInput *const input = input_of(law, symbol);
            input == nullptr)
          require_constant(law, measured, symbol);
        else if (given.count(input->name) > 0)
          throw InputError("The input " + quoted_name(input->name) +
                           " is a column of the measurements and an option; "
                           "one of both is expected.");
      CalibrationData data;
      for (const MeasuredPoint &point : measured.points())
        {
          std::vector<double> x;
          for (std::size_t i = 0; i < law.inputs.size(); ++i)
            {
              const LawInput &input = law.inputs[i];
              if (i == calibrated)
                x.push_back(input.lower);
              else if (measured.column(input.symbol))
                x.push_back(measured.value(point, input.symbol));
              else if (const auto entry = given.find(input.name);
                       entry != given.end())
                x.push_back(entry->second);
              else if (input.reference && !is_of_the_load(input))
                x.push_back(*input.reference);
              else
                throw InputError("The law also depends on " +
                                 quoted_name(input.name) + "; a column " +
                                 quoted_name(input.symbol) +
                                 " of the measurements or the option " +
                                 option_of(law, input) + " is expected.");
            }
          data.x.push_back(x);
          data.mu.push_back(point.mu);
        }
      data.deviation = measured.deviations();
      return data;
    }

    void
    print_points(const FrictionLaw      &law,
                 const MeasuredFriction &measured,
                 const CalibrationData  &data,
                 const Calibration      &found,
                 const std::size_t       calibrated)
    {
      double mean_error = 0.;
      for (std::size_t i = 0; i < data.mu.size(); ++i)
        {
          const MeasuredPoint &point    = measured.points()[i];
          const double         computed = found.computed[i].mean,
                       error            = computed / data.mu[i] - 1.;
          mean_error += std::abs(error) / static_cast<double>(data.mu.size());
          std::vector<double> x = data.x[i];
          x[calibrated]         = found.value;
          std::cout << "  line " << point.line
                    << ": mu = " << format_quantity(data.mu[i], "1", 4)
                    << " measured, " << format_quantity(computed, "1", 4)
                    << " computed, " << (error < 0. ? "" : "+")
                    << format_quantity(error, "%", 2)
                    << (law.is_inside(x.data()) ?
                          "" :
                          "; outside of the law's data, not trusted")
                    << "\n";
        }
      std::cout << "mean error " << format_quantity(mean_error, "%", 2) << "\n";
      for (std::size_t i = 0; i < measured.inputs().size(); ++i)
        if (const std::string &symbol = measured.inputs()[i];
            input_of(law.description(), symbol) == nullptr &&
            measured.points()[0].x[i])
          std::cout << "The law does not depend on " << symbol
                    << "; the measurements are at "
                    << format_quantity(*measured.points()[0].x[i],
                                       measured.units()[i],
                                       4)
                    << ", and its scene has to be, too.\n";
    }
  } // namespace



  int
  calibrate_law(const std::vector<std::string> &arguments)
  {
    const CommandOptions options(arguments);
    if (options.words.size() != 2)
      throw InputError("'asperity calibrate' takes a law, or the folder of its "
                       "campaign, and a file of measurements, as in 'asperity "
                       "calibrate law.json measured.csv -T 300degC'.");
    const FrictionLaw law = FrictionLaw::load(law_file(options.words[0]));
    const FrictionLawDescription &description = law.description();
    if (!is_friction_coefficient(description.output))
      throw InputError("The law is one of " + quoted_name(description.output) +
                       "; a law of 'mu' is expected.");
    const std::size_t calibrated =
      calibrated_input(description, option(options, of_option));
    const std::map<std::string, double> given = input_values(
      description, options, "calibrate", {series_option, of_option});
    MeasuredFriction measured = MeasuredFriction::read(options.words[1]);
    measured.choose(option(options, series_option));
    const CalibrationData data =
      gather(description, measured, given, calibrated);
    const Calibration found = calibrate(law, calibrated, data);
    if (!is_first_rank())
      return 0;
    const LawInput &input = description.inputs[calibrated];
    std::cout << input.name << " = "
              << format_quantity(found.value, input.unit, 4)
              << (found.standard_error ?
                    " (standard error " +
                      error_text(*found.standard_error, input) + ")" :
                    " (one measurement without a deviation: no standard "
                    "error)")
              << "; the law's own deviation adds "
              << error_text(found.error_of_law, input) << "\n";
    print_points(law, measured, data, found, calibrated);
    std::cout << mechanisms_sentence(description.mechanisms) << "\n";
    return 0;
  }
} // namespace asperity
