#ifndef asperity_contact_zone_commands_h
#define asperity_contact_zone_commands_h

#include <string>
#include <vector>

namespace asperity
{
  class ParameterDeclarator;

  /** `asperity run FILE.prm`: the whole scene. @return exit status */
  int
  run_scene(const std::string &file);

  /** `asperity check FILE.prm`: parse, validate, audit; run nothing. */
  int
  check_scene(const std::string &file);

  /** `asperity new SURFACE`: a parameter file made for a height map, which is
   *  named after it in the folder where the program is started.
   *  @param arguments the command's name first. @return exit status
   *  @throws InputError if a file of that name is there, or if the map or an
   *  option is wrong */
  int
  new_scene(const std::vector<std::string> &arguments);

  /** Every parameter of a contact scene, for `asperity parameters`; the
   *  variables live as long as the program. */
  void
  declare_all_parameters(ParameterDeclarator &parameters);
} // namespace asperity

#endif
