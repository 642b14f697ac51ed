#ifndef asperity_contact_zone_commands_h
#define asperity_contact_zone_commands_h

#include <string>

namespace asperity
{
  class ParameterDeclarator;

  /** `asperity run FILE.prm`: the whole scene. @return exit status */
  int
  run_scene(const std::string &file);

  /** `asperity check FILE.prm`: parse, validate, audit; run nothing. */
  int
  check_scene(const std::string &file);

  /** Every parameter of a contact scene, for `asperity parameters`; the
   *  variables live as long as the program. */
  void
  declare_all_parameters(ParameterDeclarator &parameters);
} // namespace asperity

#endif
