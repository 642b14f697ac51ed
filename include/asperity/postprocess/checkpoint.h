#ifndef asperity_postprocess_checkpoint_h
#define asperity_postprocess_checkpoint_h

#include <asperity/base/input_record.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * The state of a run with the inputs that it belongs to. What is read is bit
   * for bit what was written, so a run that goes on from it repeats the run
   * that was not interrupted.
   *
   * File: a head (the word "ASPERITY", format version, byte order, length and
   * MD5 of the rest), then an archive of Boost.Serialization, see
   * base/archive.h. The format belongs to the byte order of the machine;
   * another one is refused, not converted.
   */
  struct Checkpoint
  {
    /** 1: lists of doubles, without inputs; 2: without the cells of a mesh that
     *  changes, and without the heat that is stored; 3: without the excess of
     *  temperature at a change of the mesh. */
    static constexpr std::uint32_t format_version = 4;

    std::string program; ///< version_line() of the writer
    InputRecord inputs;
    std::string state; ///< as to_bytes() of base/archive.h makes it

    /** Writes atomically and waits for the disk.
     *  @throws ComputationError if the file cannot be written */
    void
    write(const std::string &path) const;

    /** @throws InputError if the file is missing, not a checkpoint, of another
     *  version or byte order, cut short, or damaged */
    static Checkpoint
    read(const std::string &path);
  };

  /**
   * A folder of checkpoints in which the newest few are kept. The newest that
   * is whole is the one to restart from, so a damaged file costs some steps and
   * not the run.
   */
  class CheckpointFolder
  {
  public:
    explicit CheckpointFolder(const std::string &folder,
                              const unsigned int n_kept = 2);

    /** Adds `step_<step>.checkpoint` and removes all but the newest.
     *  @throws ComputationError if the file cannot be written */
    void
    write(const Checkpoint &checkpoint, const unsigned int step) const;

    struct Found
    {
      Checkpoint   checkpoint;
      unsigned int step = 0;
      std::string  path; ///< of the file

      /** One sentence for each newer file that could not be used. */
      std::vector<std::string> warnings;
    };

    /** The newest usable checkpoint, of step `step` if given.
     *  @throws InputError if there is none */
    Found
    read_newest(const std::optional<unsigned int> &step = std::nullopt) const;

    /** Steps with a file, whole or not, newest first. */
    std::vector<unsigned int>
    steps() const;

    std::string
    path(const unsigned int step) const;

    /** Removes the checkpoints, whole or not, and nothing else; the folder
     *  stays. */
    void
    clear() const;

  private:
    std::string  folder;
    unsigned int n_kept;
  };
} // namespace asperity

#endif
