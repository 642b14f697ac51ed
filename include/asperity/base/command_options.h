#ifndef asperity_base_command_options_h
#define asperity_base_command_options_h

#include <map>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * The command line of one command: words without a dash in front, and options
   * that each take a value, as in `asperity predict law.json -p 450MPa`, or
   * `--wetting=0.6`.
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

    /**
     * For a command whose options depend on what its first word names: takes
     * any option, which the caller judges, and counts a word with a sign of
     * equality behind the first one among the settings, "Wetting=0.5".
     * @throws InputError for options without a value or given twice
     */
    explicit CommandOptions(const std::vector<std::string> &arguments);

  private:
    void
    parse(const std::vector<std::string> &arguments,
          const std::vector<std::string> *known);
  };
} // namespace asperity

#endif
