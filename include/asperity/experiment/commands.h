#ifndef asperity_experiment_commands_h
#define asperity_experiment_commands_h

#include <string>
#include <vector>

namespace asperity
{
  class ParameterDeclarator;

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

  /**
   * `asperity conditions FILE.prm`: pressure, sliding velocity and temperature
   * of a scene from what an experiment gives, an orthogonal cut or a pin, see
   * conditions_of().
   * @return exit status
   * @throws InputError if the file is wrong, or if its numbers contradict each
   *   other
   */
  int
  print_conditions(const std::string &file);

  /** All entries of an experiment's file. */
  void
  declare_experiment_parameters(ParameterDeclarator &parameters);

  /**
   * `asperity calibrate LAW_OR_CAMPAIGN MEASURED.csv [-T 300degC] [--series
   * NAMES] [--of INPUT]`: the shear factor or friction coefficient of the
   * interface with which a law meets measurements best, see calibrate(). Inputs
   * of the law that the file does not have are given as for `predict`.
   * @return exit status
   * @throws InputError if an argument, the law or the file is wrong, or if the
   *   measurements do not determine the input
   */
  int
  calibrate_law(const std::vector<std::string> &arguments);
} // namespace asperity

#endif
