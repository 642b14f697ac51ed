#ifndef asperity_learned_fields_commands_h
#define asperity_learned_fields_commands_h

#include <string>
#include <vector>

namespace asperity
{
  /**
   * `asperity reduce CAMPAIGN [--latent 4] [--decoder manifold|pod|network]
   * [--epochs 600] [--held-out 20%] [--model FILE]`: learns the fields of a
   * campaign's runs, prints what the model errs on those that are held out, and
   * writes field_model.h5 and field_errors.csv into its folder, or beside the
   * file.
   * @param arguments the command's name first
   * @return exit status
   * @throws InputError if an argument or a file is wrong
   */
  int
  reduce_fields(const std::vector<std::string> &arguments);

  /**
   * `asperity field MODEL -p 450MPa -v 90m/min -T 300degC [--output
   * DIRECTORY]`: writes the fields at a point as VTU and the edge's tractions
   * as CSV; prints mu from the tractions with its deviation, the residuals of
   * the balances, and whether to trust it. Inputs are given as for `asperity
   * predict`.
   * @return exit status
   * @throws InputError if an argument or the model is wrong
   */
  int
  predict_fields(const std::vector<std::string> &arguments);
} // namespace asperity

#endif
