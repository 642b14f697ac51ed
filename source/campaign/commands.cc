#include <asperity/base/version.h>
#include <asperity/campaign/campaign_report.h>
#include <asperity/campaign/commands.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <iostream>

namespace asperity
{
  int
  characterize(const std::string &file)
  {
    dealii::Timer            timer;
    dealii::ParameterHandler handler;
    ParameterDeclarator      declarator(handler);
    CampaignParameters       parameters;
    parameters.declare(declarator);
    declarator.read_file(file);
    parameters.check(declarator);

    Campaign   campaign(parameters, declarator, MPI_COMM_WORLD);
    const bool is_first =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (is_first)
      std::cout << version_line() << "\n"
                << campaign.description() << std::flush;
    campaign.run();
    if (is_first)
      report_campaign(parameters, campaign, timer.wall_time(), std::cout);
    return 0;
  }



  void
  declare_campaign_parameters(ParameterDeclarator &parameters)
  {
    static CampaignParameters campaign;
    campaign.declare(parameters);
  }
} // namespace asperity
