#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mpi_session.h>
#include <asperity/base/parameter_file.h>
#include <asperity/base/progress.h>
#include <asperity/base/version.h>
#include <asperity/campaign/campaign_report.h>
#include <asperity/campaign/commands.h>
#include <asperity/campaign/scene_sensitivity.h>
#include <asperity/contact_zone/commands.h>
#include <asperity/postprocess/output_folder.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <iostream>
#include <memory>

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

    /** The output directory of a scene, on the first rank.
     *  @throws InputError on all ranks if it cannot be used */
    std::unique_ptr<OutputFolder>
    lock_results(const SceneInput &input)
    {
      MpiSession::start();
      std::unique_ptr<OutputFolder> folder;
      std::string                   refusal;
      if (is_first_rank())
        try
          {
            folder =
              std::make_unique<OutputFolder>(input.parameters.output.directory,
                                             input.declarator.where(
                                               "Output/Output directory"),
                                             FolderUse::run);
          }
        catch (const InputError &error)
          {
            refusal = error.what();
          }
      refusal = dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD, refusal, 0);
      if (!refusal.empty())
        throw InputError(refusal);
      return folder;
    }
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



  int
  report_sensitivity(const std::string &file)
  {
    if (describes_campaign(file))
      throw InputError(file + " describes a campaign; expected the parameter "
                              "file of a scene.");
    const SceneInput             input(file);
    const std::vector<Variation> variations = variations_of(input);
    const auto                   folder     = lock_results(input);
    ProgressLine                 progress(std::cout,
                          is_first_rank() ? ProgressLine::Mode::automatic :
                                                            ProgressLine::Mode::silent);
    if (is_first_rank())
      std::cout << version_line() << "\n"
                << variations.size() << " variations of " << file
                << ", each alone\n"
                << std::flush;
    const SceneSensitivity sensitivity =
      compute_sensitivity(file,
                          variations,
                          [&](const std::size_t done, const std::size_t all) {
                            progress.update(static_cast<double>(done) / all,
                                            std::to_string(done) + " of " +
                                              std::to_string(all) + " runs");
                          });
    if (!is_first_rank())
      return 0;
    progress.note("");
    print_sensitivity(sensitivity, std::cout);
    write_sensitivity(sensitivity, input.parameters.output.directory);
    std::cout << "Table: " << input.parameters.output.directory
              << "/sensitivity.csv\n";
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
