#ifndef asperity_campaign_commands_h
#define asperity_campaign_commands_h

#include <string>
#include <vector>

namespace asperity
{
  class ParameterDeclarator;

  /**
   * `asperity characterize FILE.prm`: runs or resumes a campaign on all ranks,
   * trains the friction law and writes all that other programs need of it.
   * @return exit status
   */
  int
  characterize(const std::string &file);

  /**
   * `asperity check FILE.prm` of a campaign: validates it and its base scene,
   * prints points, inputs and the audit of that scene; computes and writes
   * nothing.
   * @return exit status
   */
  int
  check_campaign(const std::string &file);

  /**
   * `asperity sensitivity FILE.prm [--sobol N]` of a scene: varies what its
   * user decides by hand or does not know, one at a time and on all ranks,
   * prints a table and an interval, and writes sensitivity.csv and .json into
   * the scene's output directory. With N further runs, the largest effects are
   * varied at a time, for Sobol's indices.
   * @return exit status
   */
  int
  report_sensitivity(const std::vector<std::string> &arguments);

  /** Whether a parameter file has a subsection Campaign. */
  bool
  describes_campaign(const std::string &file);

  /** Every parameter of a campaign, for `asperity parameters --campaign`; the
   *  variables live as long as the program. */
  void
  declare_campaign_parameters(ParameterDeclarator &parameters);
} // namespace asperity

#endif
