#ifndef asperity_fluid_structure_commands_h
#define asperity_fluid_structure_commands_h

#include <string>

namespace asperity
{
  class ParameterDeclarator;

  /** Whether a parameter file describes a fluid-structure problem: it has a
   *  subsection `Problem`. @throws InputError as read_parameter_lines() */
  bool
  describes_fluid_structure(const std::string &file);

  /** `asperity run FILE.prm` of a fluid-structure problem. @return exit status
   *  @throws InputError if the file is wrong, and ComputationError if a step
   *  has no solution */
  int
  run_fluid_structure(const std::string &file);

  /** `asperity check FILE.prm`: parse, validate, build; run nothing.
   *  @throws InputError if the file is wrong */
  int
  check_fluid_structure(const std::string &file);

  /** Every parameter of a fluid-structure problem, for `asperity parameters`;
   *  the variables live as long as the program. */
  void
  declare_fluid_structure_parameters(ParameterDeclarator &parameters);
} // namespace asperity

#endif
