#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/postprocess/checkpoint.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>

namespace asperity
{
  CheckpointFolder::CheckpointFolder(const std::string &folder,
                                     const unsigned int n_kept)
    : folder(folder)
    , n_kept(std::max(1u, n_kept))
  {}



  std::string
  CheckpointFolder::path(const unsigned int step) const
  {
    return folder + "/step_" + std::to_string(step) + ".checkpoint";
  }



  std::vector<unsigned int>
  CheckpointFolder::steps() const
  {
    std::vector<unsigned int> found;
    std::error_code           error;
    for (const auto &file : std::filesystem::directory_iterator(folder, error))
      {
        unsigned int step = 0;
        const auto   name = file.path().filename().string();
        // The comparison leaves out temporary files, "step_07", and the like.
        if (std::sscanf(name.c_str(), "step_%u.checkpoint", &step) == 1 &&
            name == std::filesystem::path(path(step)).filename())
          found.push_back(step);
      }
    std::sort(found.begin(), found.end(), std::greater<unsigned int>());
    return found;
  }



  void
  CheckpointFolder::write(const Checkpoint  &checkpoint,
                          const unsigned int step) const
  {
    checkpoint.write(path(step));
    // Files of later steps are of a run that this one repeats from a restart;
    // left alone, they would pass for the newest.
    const auto   all    = steps();
    unsigned int n_seen = 0;
    for (const unsigned int other : all)
      if (other > step || ++n_seen > n_kept)
        {
          std::error_code ignored;
          std::filesystem::remove(path(other), ignored);
        }
  }



  CheckpointFolder::Found
  CheckpointFolder::read_newest(const std::optional<unsigned int> &step) const
  {
    Found found;
    for (const unsigned int candidate :
         step ? std::vector<unsigned int>{*step} : steps())
      try
        {
          found.checkpoint = Checkpoint::read(path(candidate));
          found.step       = candidate;
          found.path       = path(candidate);
          return found;
        }
      catch (const InputError &error)
        {
          found.warnings.emplace_back(error.what());
        }
    std::string message = "The folder " + quoted_name(folder) +
                          " holds no checkpoint to restart from";
    if (step)
      message += " at step " + std::to_string(*step);
    message += found.warnings.empty() ? "." : ": " + found.warnings.front();
    throw InputError(message);
  }



  void
  CheckpointFolder::clear() const
  {
    for (const unsigned int step : steps())
      {
        std::error_code ignored;
        std::filesystem::remove(path(step), ignored);
      }
  }
} // namespace asperity
