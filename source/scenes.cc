// The commands of `asperity` that rest on deal.II, for scenes, surfaces and
// campaigns. Users call asperity, which becomes this program when it needs it.

#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/exit_status.h>
#include <asperity/base/mpi_session.h>
#include <asperity/base/parameters.h>
#include <asperity/base/ranks.h>
#include <asperity/base/text.h>
#include <asperity/campaign/commands.h>
#include <asperity/contact_zone/commands.h>
#include <asperity/experiment/commands.h>
#include <asperity/fluid_structure/commands.h>
#include <asperity/learned_fields/commands.h>
#include <asperity/learned_shapes/commands.h>
#include <asperity/tool_design/commands.h>
#include <asperity/topography/commands.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/multithread_info.h>
#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <iostream>
#include <map>
#include <new>
#include <string>
#include <vector>

namespace
{
  using namespace asperity;
  using Arguments = std::vector<std::string>;

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
  report_topography(const Arguments &arguments)
  {
    if (arguments.size() != 2)
      throw InputError("'asperity topography' takes one height map or one "
                       "parameter file, as in 'asperity topography "
                       "surface.sdf'.");
    return topography_report(arguments[1]);
  }

  int
  run_file(const std::string &file)
  {
    if (describes_campaign(file))
      throw InputError(file + " describes a campaign; 'asperity characterize " +
                       file + "' runs it.");
    return describes_fluid_structure(file) ? run_fluid_structure(file) :
                                             run_scene(file);
  }

  int
  check_file(const std::string &file)
  {
    if (describes_campaign(file))
      return check_campaign(file);
    return describes_fluid_structure(file) ? check_fluid_structure(file) :
                                             check_scene(file);
  }

  int
  print_parameters(const Arguments &arguments)
  {
    using Declare = void (*)(ParameterDeclarator &);
    static const std::map<std::string, Declare> kinds = {
      {"--campaign", declare_campaign_parameters},
      {"--fluid-structure", declare_fluid_structure_parameters},
      {"--experiment", declare_experiment_parameters},
      {"--shapes", declare_shape_parameters},
      {"--optimization", declare_design_parameters}};
    bool    markdown = false;
    Declare declare  = nullptr;
    for (std::size_t i = 1; i < arguments.size(); ++i)
      if (arguments[i] == "--markdown")
        markdown = true;
      else if (const auto kind = kinds.find(arguments[i]); kind == kinds.end())
        throw InputError("'asperity parameters' takes no argument but "
                         "'--campaign', '--fluid-structure', '--experiment', "
                         "'--shapes', '--optimization' and '--markdown'.");
      else if (declare != nullptr)
        throw InputError("'asperity parameters' takes only one of "
                         "'--campaign', '--fluid-structure', "
                         "'--experiment', '--shapes' and '--optimization'.");
      else
        declare = kind->second;
    dealii::ParameterHandler handler;
    ParameterDeclarator      parameters(handler);
    (declare == nullptr ? declare_all_parameters : declare)(parameters);
    if (!is_first_rank())
      return success;
    if (markdown)
      parameters.write_markdown(std::cout);
    else
      parameters.write_prm(std::cout);
    return success;
  }

  /** asperity has checked that there is a command. */
  int
  dispatch(const Arguments &arguments)
  {
    static const std::map<std::string, std::function<int(const Arguments &)>>
      commands = {{"run", on_file(run_file)},
                  {"check", on_file(check_file)},
                  {"new", new_scene},
                  {"parameters", print_parameters},
                  {"topography", report_topography},
                  {"characterize", on_file(characterize)},
                  {"sensitivity", report_sensitivity},
                  {"reduce", reduce_fields},
                  {"field", predict_fields},
                  {"conditions", on_file(print_conditions)},
                  {"shapes", on_file(learn_shapes)},
                  {"optimize", on_file(optimize_tool)}};
    if (arguments.empty())
      throw InputError("This program is a part of asperity; please call that.");
    const auto command = commands.find(arguments[0]);
    return command == commands.end() ? run_file(arguments[0]) :
                                       command->second(arguments);
  }

  /**
   * What the ranks do with an error. What is wrong with the input all of them
   * find, since all read it, and the first says it; only where a file differs
   * between machines do the others go on. A computation may fail on one rank
   * while the others wait for it, unless all have found the failure together.
   * Ranks that wait for one with an error MPI has to end.
   */
  int
  report(const ExitStatus   status,
         const std::string &message,
         const bool         is_shared = false)
  {
    const double patience  = 5.; // [s], in which ranks read a file
    const bool   say_first = is_shared || status == input_is_wrong;
    const auto   say       = [&]() {
      std::cout.flush();
      std::cerr << "Error: " << printable(message) << std::endl;
    };
    const bool has_said = is_first_rank() || !say_first;
    if (has_said)
      say();
    if (say_first && MpiSession::all_ranks_meet(patience))
      return status;
    if (!has_said)
      say();
    if (MpiSession::n_ranks() > 1)
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
  dealii::MultithreadInfo::set_thread_limit(1);
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
  const MpiSession mpi(argc, argv);
  try
    {
      const int status = dispatch(Arguments(argv + 1, argv + argc));
      if (!std::cout.flush())
        throw ComputationError("The standard output could not be written; is "
                               "the disk full?");
      return status;
    }
  catch (const InputError &error)
    {
      return report(input_is_wrong, error.what());
    }
  catch (const SharedError &error)
    {
      return report(computation_failed, error.what(), true);
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
