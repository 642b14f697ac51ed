#ifndef asperity_tool_design_commands_h
#define asperity_tool_design_commands_h

#include <string>

namespace asperity
{
  class ParameterDeclarator;

  /** `asperity optimize FILE.prm`: searches a profile of a scene's tool that
   *  makes its results small, and judges it. @return exit status */
  int
  optimize_tool(const std::string &file);

  /** Entries of its parameter file, for the reference. */
  void
  declare_design_parameters(ParameterDeclarator &parameters);
} // namespace asperity

#endif
