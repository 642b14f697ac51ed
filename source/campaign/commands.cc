#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mpi_session.h>
#include <asperity/base/parameter_file.h>
#include <asperity/base/version.h>
#include <asperity/campaign/campaign_report.h>
#include <asperity/campaign/commands.h>
#include <asperity/contact_zone/commands.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <iostream>

namespace asperity
{
  namespace
  {
    /** A campaign's parameter file, read and checked. */
    struct CampaignInput
    {
      explicit CampaignInput(const std::string &file)
        : declarator(handler)
      {
        parameters.declare(declarator);
        declarator.read_file(file);
        parameters.check(declarator);
      }

      dealii::ParameterHandler handler;
      ParameterDeclarator      declarator;
      CampaignParameters       parameters;
    };
  } // namespace



  int
  characterize(const std::string &file)
  {
    dealii::Timer             timer;
    const CampaignInput       input(file);
    const CampaignParameters &parameters = input.parameters;

    Campaign campaign(parameters, input.declarator, MPI_COMM_WORLD);
    if (is_first_rank())
      std::cout << version_line() << "\n"
                << campaign.description() << std::flush;
    campaign.run();
    if (is_first_rank())
      report_campaign(parameters, campaign, timer.wall_time(), std::cout);
    return 0;
  }



  int
  check_campaign(const std::string &file)
  {
    const CampaignInput       input(file);
    const CampaignParameters &parameters = input.parameters;
    CampaignPlan              plan(parameters, input.declarator);
    plan.start(parameters, parameters.directory + "/plan.json");
    const CampaignResults results(parameters, plan); // judges the test table
    if (!is_first_rank())
      return 0;
    std::cout << plan.description(parameters);
    check_scene(parameters.base_scene);
    std::cout << file << " is valid.\n";
    return 0;
  }



  bool
  describes_campaign(const std::string &file)
  {
    const auto lines = read_parameter_lines(file);
    return std::any_of(lines.begin(),
                       lines.end(),
                       [](const ParameterLine &line) {
                         return !line.subsections.empty() &&
                                line.subsections.front() == "Campaign";
                       });
  }



  void
  declare_campaign_parameters(ParameterDeclarator &parameters)
  {
    static CampaignParameters campaign;
    campaign.declare(parameters);
  }
} // namespace asperity
