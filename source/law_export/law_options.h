#ifndef asperity_law_export_law_options_h
#define asperity_law_export_law_options_h

#include <asperity/surrogate/friction_law.h>

#include <map>
#include <string>
#include <vector>

namespace asperity
{
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
