#include <asperity/base/command_options.h>
#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/mpi_session.h>
#include <asperity/base/progress.h>
#include <asperity/base/quantity.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/campaign/choice_indices.h>
#include <asperity/campaign/commands.h>
#include <asperity/postprocess/output_folder.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <memory>

namespace asperity
{
  namespace
  {
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

    /** How many of the largest effects are varied at a time. */
    constexpr unsigned int n_choices_at_a_time = 5;

    /** Runs that --sobol asks for; 0 without it. */
    std::size_t
    runs_of_sobol(const CommandOptions &options)
    {
      const auto option = options.values.find("--sobol");
      if (option == options.values.end())
        return 0;
      const unsigned int least = 2 * n_choices_at_a_time + 2;
      const auto         wrong = [&]() {
        return InputError("--sobol: found " + quoted_text(option->second) +
                          "; expected a whole number of runs, at least " +
                          std::to_string(least) + ".");
      };
      double n = 0.;
      try
        {
          n = parse_number(option->second);
        }
      catch (const InputError &)
        {
          throw wrong();
        }
      if (n != std::floor(n) || n < least || n > 1e5)
        throw wrong();
      return static_cast<std::size_t>(n);
    }

    /** The line of progress of the first rank. */
    class Progress
    {
    public:
      Progress()
        : line(std::cout,
               is_first_rank() ? ProgressLine::Mode::automatic :
                                 ProgressLine::Mode::silent)
      {}

      void
      operator()(const std::size_t done, const std::size_t all)
      {
        line.update(static_cast<double>(done) / all,
                    std::to_string(done) + " of " + std::to_string(all) +
                      " runs");
        if (done == all)
          line.note("");
      }

    private:
      ProgressLine line;
    };

    /** Sobol's indices of the largest effects; null for no runs. */
    nlohmann::ordered_json
    find_indices(const std::string      &file,
                 const SceneInput       &input,
                 const SceneSensitivity &sensitivity,
                 const std::size_t       n_runs)
    {
      if (n_runs == 0)
        return {};
      Progress            progress;
      const ChoiceIndices indices = compute_indices(
        file,
        ranges_of_choices(sensitivity, input, n_choices_at_a_time),
        n_runs,
        std::ref(progress));
      if (is_first_rank())
        print_indices(indices, std::cout);
      return to_json(indices);
    }
  } // namespace



  int
  report_sensitivity(const std::vector<std::string> &arguments)
  {
    const CommandOptions options(arguments, {"--sobol"});
    if (options.words.size() != 1)
      throw InputError("'asperity sensitivity' takes one parameter file and, "
                       "if wanted, a number of runs, as in 'asperity "
                       "sensitivity scene.prm --sobol 40'.");
    const std::string &file   = options.words.front();
    const std::size_t  n_runs = runs_of_sobol(options);
    if (describes_campaign(file))
      throw InputError(file + " describes a campaign; expected the parameter "
                              "file of a scene.");
    const SceneInput             input(file);
    const std::vector<Variation> variations = variations_of(input);
    const auto                   folder     = lock_results(input);
    Progress                     progress;
    if (is_first_rank())
      std::cout << version_line() << "\n"
                << variations.size() << " variations of " << file
                << ", each alone\n"
                << std::flush;
    const SceneSensitivity sensitivity =
      compute_sensitivity(file, variations, std::ref(progress));
    if (is_first_rank())
      print_sensitivity(sensitivity, std::cout);
    const auto indices = find_indices(file, input, sensitivity, n_runs);
    if (!is_first_rank())
      return 0;
    write_sensitivity(sensitivity, indices, input.parameters.output.directory);
    std::cout << "Table: " << input.parameters.output.directory
              << "/sensitivity.csv\n";
    return 0;
  }
} // namespace asperity
