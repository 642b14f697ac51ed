#ifndef asperity_law_export_law_options_h
#define asperity_law_export_law_options_h

#include <asperity/base/command_options.h>
#include <asperity/surrogate/friction_law.h>

#include <map>
#include <string>
#include <vector>

namespace asperity
{
  /** The option of an input of the law: "-p", "-v", "-T", or the name of its
   *  entry, "--wetting", with the section if two entries have one name. */
  std::string
  option_of(const FrictionLawDescription &law, const LawInput &input);

  /**
   * SI values of the inputs by name, which options, `--set` and words behind
   * the first with a sign of equality give.
   * @param own further options of the command, which are left out
   * @throws InputError for an option or name that the law does not have, a
   * value that is not understood, and an input that is given twice
   */
  std::map<std::string, double>
  input_values(const FrictionLawDescription   &law,
               const CommandOptions           &options,
               const std::string              &command,
               const std::vector<std::string> &own = {});

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
