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
    const std::string command = "'asperity " + arguments[0] + "'";
    for (std::size_t i = 1; i < arguments.size(); ++i)
      {
        const std::string &word = arguments[i];
        if (!is_option(word))
          {
            words.push_back(word);
            continue;
          }
        if (std::find(known.begin(), known.end(), word) == known.end())
          throw InputError(command + " has no option '" + word +
                           "'; its options are " + join(known, ", ") + ".");
        if (i + 1 == arguments.size())
          throw InputError("The option '" + word + "' of " + command +
                           " needs a value behind it.");
        const std::string &value = arguments[++i];
        if (word == "--set")
          settings.push_back(value);
        else if (!values.emplace(word, value).second)
          throw InputError("The option '" + word + "' of " + command +
                           " is given twice.");
      }
  }
} // namespace asperity
