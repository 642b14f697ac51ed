#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/law_export/law_options.h>

#include <algorithm>
#include <cctype>

namespace asperity
{
  namespace
  {
    /** "Plastic strain" of "Load/Plastic strain" */
    std::string
    last_part(const std::string &entry)
    {
      return entry.substr(entry.rfind('/') + 1);
    }

    /** "--plastic-strain" */
    std::string
    long_option(const std::string &name)
    {
      std::string option = "--";
      for (const char c : name)
        option +=
          c == ' ' || c == '/' ?
            '-' :
            static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return option;
    }

    std::string
    quoted_names(const FrictionLawDescription &law)
    {
      std::vector<std::string> names;
      for (const LawInput &input : law.inputs)
        names.push_back(quoted_name(input.name) + " (" + input.symbol + ")");
      return join(names, ", ");
    }
  } // namespace



  std::string
  option_of(const FrictionLawDescription &law, const LawInput &input)
  {
    for (const char *const symbol : {"p", "v", "T"})
      if (input.symbol == symbol)
        return "-" + input.symbol;
    const std::string option = long_option(last_part(input.name));
    for (const LawInput &other : law.inputs)
      if (other.name != input.name &&
          long_option(last_part(other.name)) == option)
        return long_option(input.name);
    return option;
  }



  const LawInput &
  find_input(const FrictionLawDescription &law, const std::string &key)
  {
    for (const LawInput &input : law.inputs)
      if (key == input.name || key == input.symbol)
        return input;
    std::string suggestion;
    for (const LawInput &input : law.inputs)
      if (suggestion.empty() && edit_distance(key, input.name) <= 3)
        suggestion = "did you mean " + quoted_name(input.name) + "?";
    throw InputError("The law has no input " + quoted_name(key) + "; " +
                     (suggestion.empty() ?
                        "its inputs are " + quoted_names(law) + "." :
                        suggestion));
  }



  std::map<std::string, double>
  parse_settings(const FrictionLawDescription   &law,
                 const std::vector<std::string> &settings)
  {
    std::map<std::string, double> result;
    for (const std::string &setting : settings)
      {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos)
          throw InputError("The setting " + quoted_text(setting) +
                           " is not understood; \"name = value unit\" is "
                           "expected.");
        const LawInput &input =
          find_input(law, trim(setting.substr(0, equals)));
        const double value =
          parse_input(input, setting.substr(equals + 1), "--set");
        if (!result.emplace(input.name, value).second)
          throw InputError("The input " + quoted_name(input.name) +
                           " is set twice.");
      }
    return result;
  }



  namespace
  {
    const LawInput &
    input_of_option(const FrictionLawDescription   &law,
                    const std::string              &option,
                    const std::string              &command,
                    const std::vector<std::string> &own)
    {
      std::vector<std::string> known;
      for (const LawInput &input : law.inputs)
        {
          known.push_back(option_of(law, input));
          if (option == known.back() || option == long_option(input.name))
            return input;
        }
      known.insert(known.end(), own.begin(), own.end());
      known.push_back("--set");
      throw InputError("'asperity " + command + "' has no option " +
                       quoted_name(option) + " for this law; its options are " +
                       join(known, ", ") + ".");
    }
  } // namespace



  std::map<std::string, double>
  input_values(const FrictionLawDescription   &law,
               const CommandOptions           &options,
               const std::string              &command,
               const std::vector<std::string> &own)
  {
    std::map<std::string, double> given = parse_settings(law, options.settings);
    for (const auto &[option, text] : options.values)
      {
        if (std::find(own.begin(), own.end(), option) != own.end())
          continue;
        const LawInput &input = input_of_option(law, option, command, own);
        if (!given.emplace(input.name, parse_input(input, text, option)).second)
          throw InputError("The input " + quoted_name(input.name) +
                           " is given by " + quoted_name(option) +
                           " and once more.");
      }
    return given;
  }



  double
  parse_input(const LawInput    &input,
              const std::string &text,
              const std::string &option)
  {
    try
      {
        return parse_quantity(text, dimension_of(input.unit));
      }
    catch (const InputError &error)
      {
        throw InputError("Option " + quoted_name(option) + ", input " +
                         quoted_name(input.name) + ": " + error.what() + ".");
      }
  }
} // namespace asperity
