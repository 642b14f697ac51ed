#ifndef asperity_experiment_commands_h
#define asperity_experiment_commands_h

#include <string>
#include <vector>

namespace asperity
{
  /**
   * `asperity fit MEASURED.csv LAW.json [--constant-up-to 46m/min] [--series
   * NAMES]`: the piecewise power law over the velocity (see PiecewisePowerLaw),
   * fitted to measurements, with its standard errors; it is predicted and
   * exported as any other law. `--constant-up-to` also takes `automatic` (the
   * default), `fitted` and `none`, see ConstantPart.
   * @param arguments the command's name first
   * @return exit status
   * @throws InputError if an argument or the file is wrong, or if the
   *   measurements do not determine the law
   */
  int
  fit_measured_friction(const std::vector<std::string> &arguments);
} // namespace asperity

#endif
