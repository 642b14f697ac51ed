#ifndef asperity_law_export_commands_h
#define asperity_law_export_commands_h

#include <string>
#include <vector>

namespace asperity
{
  /**
   * `asperity predict MODEL -p 450MPa -v 90m/min -T 300degC`: what a trained
   * law says at a point, with its 95 % interval, whether to trust it,
   * derivatives and shear limit. Further inputs: `--set "Lubrication/Wetting =
   * 0.5"`.
   * @param arguments the command's name first
   * @return exit status
   */
  int
  predict_friction(const std::vector<std::string> &arguments);

  /**
   * `asperity export MODEL DIRECTORY [--tolerance 0.5%] [--units SI] [--set
   * ...]`: the law as source code, user subroutines and tables.
   */
  int
  export_friction_law(const std::vector<std::string> &arguments);
} // namespace asperity

#endif
