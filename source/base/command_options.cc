#include <asperity/base/command_options.h>
#include <asperity/base/errors.h>
#include <asperity/base/text.h>

#include <algorithm>

namespace asperity
{
  namespace
  {
    bool
    is_option(const std::string &word)
    {
      return word.size() > 1 && word[0] == '-';
    }
  } // namespace



  CommandOptions::CommandOptions(const std::vector<std::string> &arguments,
                                 const std::vector<std::string> &known)
  {
    parse(arguments, &known);
  }



  CommandOptions::CommandOptions(const std::vector<std::string> &arguments)
  {
    parse(arguments, nullptr);
  }



  void
  CommandOptions::parse(const std::vector<std::string> &arguments,
                        const std::vector<std::string> *known)
  {
    const std::string command = "'asperity " + arguments[0] + "'";
    for (std::size_t i = 1; i < arguments.size(); ++i)
      {
        std::string       word   = arguments[i];
        const std::size_t equals = word.find('=');
        if (!is_option(word))
          {
            const bool is_setting =
              known == nullptr && !words.empty() && equals != std::string::npos;
            (is_setting ? settings : words).push_back(word);
            continue;
          }
        const bool  has_value = equals != std::string::npos;
        std::string value     = has_value ? word.substr(equals + 1) : "";
        word.resize(std::min(word.size(), equals));
        if (known != nullptr &&
            std::find(known->begin(), known->end(), word) == known->end())
          throw InputError(command + " has no option " + quoted_text(word) +
                           "; its options are " + join(*known, ", ") + ".");
        if (!has_value && ++i == arguments.size())
          throw InputError("The option " + quoted_text(word) + " of " +
                           command + " needs a value behind it.");
        if (!has_value)
          value = arguments[i];
        if (word == "--set")
          settings.push_back(value);
        else if (!values.emplace(word, value).second)
          throw InputError("The option " + quoted_text(word) + " of " +
                           command + " is given twice.");
      }
  }
} // namespace asperity
