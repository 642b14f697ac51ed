#ifndef asperity_law_export_commands_h
#define asperity_law_export_commands_h

#include <string>
#include <vector>

namespace asperity
{
  struct FrictionLawDescription;

  /** The options of `asperity predict` at the middle of a law's ranges:
   *  " -p 800MPa --wetting 0.6". */
  std::string
  example_arguments(const FrictionLawDescription &law);

  /**
   * `asperity predict MODEL -p 450MPa -v 90m/min -T 300degC`: what a trained
   * law says at a point, with its 95 % interval, the mechanisms in its mu,
   * whether to trust it, derivatives and shear limit. Each further input of the
   * law has an option, too, `--wetting 0.5 --plastic-strain 1`; and each is
   * taken by its name, `Lubrication/Wetting=0.5` or `--set "Lubrication/Wetting
   * = 0.5"`.
   * @param arguments the command's name first
   * @return exit status
   * @throws InputError if an argument or the law's file is wrong
   */
  int
  predict_friction(const std::vector<std::string> &arguments);

  /**
   * `asperity export MODEL DIRECTORY [--tolerance 0.5%] [--units SI]
   * [--wetting 0.5]`: the law as source code, user subroutines and tables;
   * further inputs of the law are given as for `predict`.
   * @throws InputError if an argument or the law's file is wrong
   */
  int
  export_friction_law(const std::vector<std::string> &arguments);
} // namespace asperity

#endif
