#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/postprocess/output_folder.h>

#include <filesystem>
#include <regex>

namespace asperity
{
  namespace fs = std::filesystem;

  namespace
  {
    // The names of all that a run writes, but for parameters.prm, which is
    // replaced and may be the file that is being read.
    const char *const summary = "summary\\.json";
    const char *const results =
      "friction\\.csv|friction_units\\.csv|"
      "fluid_structure\\.csv|fields\\.h5|"
      "(chip|tool|contact|oil|fluid|body)(\\.pvd|_[0-9]+\\.vtu)";
    const char *const checkpoints = "step_[0-9]+\\.checkpoint";

    // write_atomically() ends the names of files that it has begun like this.
    const char *const begun = "\\.tmp[0-9]+";

    void
    remove_files(const std::string &folder, const std::string &names)
    {
      const std::regex expected(names);
      std::error_code  error;
      for (const auto &file : fs::directory_iterator(folder, error))
        if (std::regex_match(file.path().filename().string(), expected) &&
            !fs::is_directory(file.path()))
          {
            std::error_code ignored;
            fs::remove(file.path(), ignored);
          }
    }

    std::string
    group(const std::string &names)
    {
      return "(" + names + ")";
    }
  } // namespace



  OutputFolder::OutputFolder(const std::string &directory,
                             const std::string &where,
                             const FolderUse    use)
    : directory(directory)
    , lock(directory, where)
  {
    const auto holds = [&](const char *name) {
      return fs::exists(directory + "/" + name);
    };
    const std::string found =
      use == FolderUse::run && holds("plan.json") && holds("runs") ?
        "a campaign" :
      use == FolderUse::campaign &&
          (holds("friction.csv") || holds("fluid_structure.csv")) ?
        "a run" :
        "";
    if (!found.empty())
      throw InputError(where + ": the folder " + quoted_name(directory) +
                       " holds the results of " + found +
                       "; expected a folder of its own.");
  }



  void
  OutputFolder::clear(const bool goes_on) const
  {
    const std::string any = "(" + std::string(begun) + ")?";
    remove_files(directory, group(summary) + any);
    remove_files(directory, group(results) + (goes_on ? begun : any));
    remove_files(directory + "/checkpoint",
                 group(checkpoints) + (goes_on ? begun : any));
  }



  const std::string &
  OutputFolder::warning() const
  {
    return lock.warning();
  }
} // namespace asperity
