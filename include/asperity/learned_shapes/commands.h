#ifndef asperity_learned_shapes_commands_h
#define asperity_learned_shapes_commands_h

#include <string>

namespace asperity
{
  class ParameterDeclarator;

  /** `asperity shapes FILE.prm`: learns a training set of shapes or goes on
   * with it, and writes model, tables and pictures. Collective.
   *  @return exit status */
  int
  learn_shapes(const std::string &file);

  /** For `asperity parameters --shapes`. */
  void
  declare_shape_parameters(ParameterDeclarator &parameters);
} // namespace asperity

#endif
