#include "law_options.h"

#include <asperity/base/errors.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>

namespace asperity
{
  namespace
  {
    std::string
    quoted_names(const FrictionLawDescription &law)
    {
      std::vector<std::string> names;
      for (const LawInput &input : law.inputs)
        names.push_back("'" + input.name + "' (" + input.symbol + ")");
      return join(names, ", ");
    }
  } // namespace



  const LawInput &
  find_input(const FrictionLawDescription &law, const std::string &key)
  {
    for (const LawInput &input : law.inputs)
      if (key == input.name || key == input.symbol)
        return input;
    std::string suggestion;
    for (const LawInput &input : law.inputs)
      if (suggestion.empty() && edit_distance(key, input.name) <= 3)
        suggestion = "did you mean '" + input.name + "'?";
    throw InputError("The law has no input '" + key + "'; " +
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
          throw InputError("'--set " + setting +
                           "' is not understood; \"name = value unit\" is "
                           "expected.");
        const LawInput &input =
          find_input(law, trim(setting.substr(0, equals)));
        const double value =
          parse_input(input, setting.substr(equals + 1), "--set");
        if (!result.emplace(input.name, value).second)
          throw InputError("The input '" + input.name +
                           "' is set twice by '--set'.");
      }
    return result;
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
        throw InputError("Option '" + option + "', input '" + input.name +
                         "': " + error.what() + ".");
      }
  }
} // namespace asperity
