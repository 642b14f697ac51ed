#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/parameters.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/campaign/commands.h>
#include <asperity/contact_zone/commands.h>
#include <asperity/law_export/commands.h>
#include <asperity/topography/commands.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <new>
#include <string>
#include <vector>

namespace
{
  using namespace asperity;
  using Arguments = std::vector<std::string>;

  // exit statuses; 0 is success
  constexpr int computation_failed = 1;
  constexpr int input_is_wrong     = 2;

  bool
  is_first_rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }

  struct Command
  {
    std::string                           usage;
    std::string                           sentence;
    std::function<int(const Arguments &)> run;

    std::string
    name() const
    {
      return usage.substr(0, usage.find(' '));
    }
  };

  /** A command whose only argument is a parameter file. */
  std::function<int(const Arguments &)>
  on_file(int (*function)(const std::string &))
  {
    return [function](const Arguments &arguments) {
      if (arguments.size() != 2)
        throw InputError("'asperity " + arguments[0] +
                         "' takes one parameter file, as in 'asperity " +
                         arguments[0] + " scene.prm'.");
      return function(arguments[1]);
    };
  }

  int
  run_file(const std::string &file)
  {
    if (describes_campaign(file))
      throw InputError(file + " describes a campaign; 'asperity characterize " +
                       file + "' runs it.");
    return run_scene(file);
  }

  int
  check_file(const std::string &file)
  {
    return describes_campaign(file) ? check_campaign(file) : check_scene(file);
  }

  int
  print_parameters(const Arguments &arguments)
  {
    bool markdown = false, campaign = false;
    for (std::size_t i = 1; i < arguments.size(); ++i)
      if (arguments[i] == "--markdown")
        markdown = true;
      else if (arguments[i] == "--campaign")
        campaign = true;
      else
        throw InputError("'asperity parameters' takes no argument but "
                         "'--campaign' and '--markdown'.");
    dealii::ParameterHandler handler;
    ParameterDeclarator      parameters(handler);
    if (campaign)
      declare_campaign_parameters(parameters);
    else
      declare_all_parameters(parameters);
    if (!is_first_rank())
      return 0;
    if (markdown)
      parameters.write_markdown(std::cout);
    else
      parameters.write_prm(std::cout);
    return 0;
  }

  const std::vector<Command> &
  commands()
  {
    static const std::vector<Command> table = {
      {"run FILE.prm",
       "run the scene; 'asperity FILE.prm' is the same",
       on_file(run_file)},
      {"check FILE.prm",
       "validate the input, print audit, models and size; run nothing",
       on_file(check_file)},
      {"parameters [--campaign] [--markdown]",
       "explain every parameter",
       print_parameters},
      {"topography FILE.prm",
       "read, filter, measure and fit a surface",
       on_file(topography_report)},
      {"characterize FILE.prm",
       "run or resume a campaign, train the friction law",
       on_file(characterize)},
      {"predict LAW -p P -v V -T T",
       "friction coefficient of a trained law, with its certainty",
       predict_friction},
      {"export LAW DIRECTORY",
       "a trained law for Abaqus, DEFORM, LS-DYNA, C and Fortran",
       export_friction_law}};
    return table;
  }

  void
  print_help()
  {
    std::cout
      << "Asperity computes how a rough contact slides: from a measured "
         "surface to a\nfriction coefficient.\n\n";
    for (const Command &command : commands())
      {
        std::string line = "  asperity " + command.usage;
        line.resize(std::max<std::size_t>(line.size() + 2, 36), ' ');
        std::cout << line << command.sentence << '\n';
      }
    std::cout << "\n'mpirun -np N' may stand before any of them; --version "
                 "prints what this program\nwas built with. Exit status: 0 "
                 "done; 1 the computation failed; 2 the input is wrong.\n";
  }

  bool
  is_parameter_file(const std::string &word)
  {
    return word.size() > 4 && word.compare(word.size() - 4, 4, ".prm") == 0;
  }

  [[noreturn]] void
  refuse_command(const std::string &word)
  {
    const Command *nearest = &commands().front();
    for (const Command &command : commands())
      if (edit_distance(command.name(), word) <
          edit_distance(nearest->name(), word))
        nearest = &command;
    const bool similar = edit_distance(nearest->name(), word) <= 2;
    throw InputError(
      "'" + word + "' is neither a command nor a parameter file (*.prm); " +
      (similar ? "did you mean 'asperity " + nearest->name() + "'?" :
                 "'asperity --help' lists the commands."));
  }

  int
  dispatch(const Arguments &arguments)
  {
    if (arguments.empty())
      throw InputError("No parameter file is given; 'asperity --help' lists "
                       "the commands.");
    const std::string &word = arguments[0];
    if (word == "--help" || word == "-h" || word == "--version")
      {
        if (!is_first_rank())
          return 0;
        if (word == "--version")
          std::cout << version_line() << '\n';
        else
          print_help();
        return 0;
      }
    for (const Command &command : commands())
      if (command.name() == word)
        return command.run(arguments);
    if (!is_parameter_file(word))
      refuse_command(word);
    if (arguments.size() > 1)
      throw InputError("One parameter file is expected, but '" + arguments[1] +
                       "' follows '" + word + "'.");
    return run_file(word);
  }

  /**
   * What the ranks do with an error. All ranks read the same input, so all of
   * them find what is wrong with it, and one of them says it. A computation may
   * fail on one rank while the others wait for it: then MPI has to end them.
   */
  int
  report(const int status, const std::string &message)
  {
    const bool alone =
      dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1;
    std::cout.flush();
    if (is_first_rank() || status != input_is_wrong)
      std::cerr << "Error: " << message << std::endl;
    if (!alone && status != input_is_wrong)
      MPI_Abort(MPI_COMM_WORLD, status);
    return status;
  }

  /** What deal.II says, in one line and without its stack trace. */
  std::string
  one_line(const dealii::ExceptionBase &error)
  {
    std::ostringstream out;
    error.print_info(out);
    std::string text = out.str();
    for (char &c : text)
      if (c == '\n')
        c = ' ';
    return "The computation was stopped by deal.II: " + trim(text) + " (" +
           error.get_exc_name() + ")";
  }
} // namespace

int
main(int argc, char **argv)
{
  use_one_thread_per_rank();
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
  const MpiSession mpi(argc, argv);
  try
    {
      return dispatch(Arguments(argv + 1, argv + argc));
    }
  catch (const InputError &error)
    {
      return report(input_is_wrong, error.what());
    }
  catch (const ComputationError &error)
    {
      return report(computation_failed, error.what());
    }
  catch (const dealii::ExceptionBase &error)
    {
      return report(computation_failed, one_line(error));
    }
  catch (const std::bad_alloc &)
    {
      return report(computation_failed, "There is not enough memory.");
    }
  catch (const std::exception &error)
    {
      return report(computation_failed, error.what());
    }
}
