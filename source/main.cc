// What `asperity` does by itself: it lists the commands, and answers from a
// trained friction law. All else it leaves to the program asperity_scenes
// beside it, since the two hundred libraries that deal.II brings along take a
// third of a second to load.

#include <asperity/base/environment.h>
#include <asperity/base/errors.h>
#include <asperity/base/exit_status.h>
#include <asperity/base/text.h>
#include <asperity/base/version.h>
#include <asperity/experiment/commands.h>
#include <asperity/law_export/commands.h>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <new>
#include <string>
#include <vector>

namespace
{
  using namespace asperity;
  using Arguments = std::vector<std::string>;

  struct Command
  {
    std::string usage;
    std::string sentence;
    int (*run)(const Arguments &); ///< null: asperity_scenes does it

    std::string
    name() const
    {
      return usage.substr(0, usage.find(' '));
    }
  };

  const std::vector<Command> &
  commands()
  {
    static const std::vector<Command> table = {
      {"run FILE.prm",
       "run the scene; 'asperity FILE.prm' is the same",
       nullptr},
      {"check FILE.prm",
       "validate the input, print audit, models and size; run nothing",
       nullptr},
      {"new SURFACE [-p P] [-v V] [-T T] [--oil W]",
       "write a parameter file for a height map",
       nullptr},
      {"parameters [--campaign | --fluid-structure | --experiment | --shapes "
       "| --optimization] [--markdown]",
       "explain every parameter",
       nullptr},
      {"topography FILE.prm|MAP",
       "read, filter, measure and fit a surface, or a height map as it is",
       nullptr},
      {"characterize FILE.prm",
       "run or resume a campaign, train the friction law",
       nullptr},
      {"sensitivity FILE.prm [--sobol N]",
       "how far mu depends on what you choose or do not know",
       nullptr},
      {"predict LAW -p P -v V -T T",
       "friction coefficient of a trained law, with its certainty",
       predict_friction},
      {"reduce CAMPAIGN [--latent N]",
       "learn the fields of a campaign's runs",
       nullptr},
      {"field MODEL -p P -v V -T T",
       "fields of a contact zone from a learnt model, and how far to trust "
       "them",
       nullptr},
      {"export LAW DIRECTORY",
       "a trained law for Abaqus, DEFORM, LS-DYNA, C and Fortran",
       export_friction_law},
      {"conditions FILE.prm",
       "pressure, velocity and temperature of a scene from an experiment",
       nullptr},
      {"shapes FILE.prm",
       "learn shapes by a network, and judge what it has learned",
       nullptr},
      {"optimize FILE.prm",
       "search a tool topography with less friction",
       nullptr},
      {"fit MEASURED.csv LAW",
       "a power law over the velocity from measured friction",
       fit_measured_friction},
      {"calibrate LAW|CAMPAIGN MEASURED.csv",
       "shear factor of the interface from measured friction",
       calibrate_law}};
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
    throw InputError(quoted_text(word) +
                     " is neither a command nor a parameter file (*.prm); " +
                     (similar ?
                        "did you mean 'asperity " + nearest->name() + "'?" :
                        "'asperity --help' lists the commands."));
  }

  /** Becomes the program asperity_scenes, with the same arguments. */
  [[noreturn]] void
  become_scenes(char **const argv)
  {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::path  program =
      fs::read_symlink("/proc/self/exe", error).parent_path() /
      "asperity_scenes";
    std::cout.flush();
    choose_blas_kernels();
    execv(program.c_str(), argv);
    throw ComputationError("The program " + program.string() +
                           " cannot be started (" + std::strerror(errno) +
                           "); it is built and kept together with this one.");
  }

  int
  dispatch(const Arguments &arguments, char **const argv)
  {
    if (arguments.empty())
      throw InputError("No parameter file is given; 'asperity --help' lists "
                       "the commands.");
    const std::string &word = arguments[0];
    if (word == "--help" || word == "-h" || word == "--version")
      {
        if (!is_first_rank())
          return success;
        if (word == "--version")
          std::cout << version_line() << '\n';
        else
          print_help();
        return success;
      }
    for (const Command &command : commands())
      if (command.name() == word)
        {
          if (command.run == nullptr)
            become_scenes(argv);
          return command.run(arguments);
        }
    if (!is_parameter_file(word))
      refuse_command(word);
    if (arguments.size() > 1)
      throw InputError("One parameter file is expected, but " +
                       quoted_name(arguments[1]) + " follows " +
                       quoted_text(word) + ".");
    become_scenes(argv);
  }

  /**
   * All ranks find the same error. The first one says it; if another one ended
   * with a status of its own, mpirun might end the first one before that.
   */
  int
  report(const ExitStatus status, const std::string &message)
  {
    std::cout.flush();
    if (!is_first_rank())
      return success;
    std::cerr << "Error: " << printable(message) << std::endl;
    return status;
  }
} // namespace

int
main(int argc, char **argv)
{
  use_one_thread_per_rank();
  try
    {
      const int status = dispatch(Arguments(argv + 1, argv + argc), argv);
      if (!std::cout.flush())
        throw ComputationError("The standard output could not be written; is "
                               "the disk full?");
      return status;
    }
  catch (const InputError &error)
    {
      return report(input_is_wrong, error.what());
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
