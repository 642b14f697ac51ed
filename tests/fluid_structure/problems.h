#ifndef asperity_tests_fluid_structure_problems_h
#define asperity_tests_fluid_structure_problems_h

#include <asperity/base/parameters.h>
#include <asperity/fluid_structure/problem.h>

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace asperity
{
  /** What a file in parameter_files/fluid_structure says, with other entries
   *  after it. */
  inline FluidStructureParameters
  read_problem(const std::string &name, const std::string &changes = "")
  {
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    FluidStructureParameters parameters;
    parameters.declare(declarator);
    declarator.read_file(
      ASPERITY_SOURCE_DIR "/parameter_files/fluid_structure/" + name + ".prm");
    declarator.read_text(changes, "changes");
    parameters.check(declarator);
    return parameters;
  }
} // namespace asperity

#endif
