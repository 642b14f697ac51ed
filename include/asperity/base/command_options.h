#ifndef asperity_base_command_options_h
#define asperity_base_command_options_h

#include <map>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * The command line of one command: words without a dash in front, and options
   * that each take a value, as in `asperity predict law.json -p 450MPa`.
   */
  struct CommandOptions
  {
    std::vector<std::string> words;

    /** "-p" -> "450MPa" */
    std::map<std::string, std::string> values;

    /** The values of `--set`, "Load/Pressure = 450 MPa", which alone may be
     *  given several times. */
    std::vector<std::string> settings;

    /**
     * @param arguments the command's name first
     * @param known the options of this command
     * @throws InputError for unknown options, options without a value or given
     *   twice
     */
    CommandOptions(const std::vector<std::string> &arguments,
                   const std::vector<std::string> &known);
  };
} // namespace asperity

#endif
