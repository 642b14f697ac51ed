#ifndef asperity_law_export_law_options_h
#define asperity_law_export_law_options_h

#include <asperity/surrogate/friction_law.h>

#include <map>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * The command line of a command on a law: words without a dash in front, and
   * options that each take a value.
   */
  struct LawOptions
  {
    std::vector<std::string> words;

    /** "-p" -> "450MPa" */
    std::map<std::string, std::string> values;

    /** The values of `--set`, "Load/Pressure = 450 MPa". */
    std::vector<std::string> settings;

    /**
     * @param arguments the command's name first
     * @param known options besides `--set`
     * @throws InputError for unknown options, options without a value or given
     *   twice
     */
    LawOptions(const std::vector<std::string> &arguments,
               const std::vector<std::string> &known);
  };

  /** The input with this name or symbol. @throws InputError that lists the
   *  inputs, with the nearest one if one is near */
  const LawInput &
  find_input(const FrictionLawDescription &law, const std::string &key);

  /** SI values of all `--set` by the name of the input. */
  std::map<std::string, double>
  parse_settings(const FrictionLawDescription   &law,
                 const std::vector<std::string> &settings);

  /** "450MPa" in SI. @param option for messages: "-p" */
  double
  parse_input(const LawInput    &input,
              const std::string &text,
              const std::string &option);
} // namespace asperity

#endif
