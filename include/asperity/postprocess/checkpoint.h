#ifndef asperity_postprocess_checkpoint_h
#define asperity_postprocess_checkpoint_h

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * The state of a run as named vectors of doubles and integers and named
   * strings. What is read is bit for bit what was written, so a run that goes
   * on from it repeats the run that was not interrupted.
   *
   * File: a head (the word "ASPERITY", format version, byte order, length and
   * FNV-1a checksum of the rest), then the entries. The format belongs to the
   * byte order of the machine; another one is refused, not converted.
   */
  class Checkpoint
  {
  public:
    static constexpr std::uint32_t format_version = 1;

    /** An entry of the same name and kind is replaced. */
    void
    set(const std::string &name, const std::vector<double> &values);

    void
    set(const std::string &name, const std::vector<std::int64_t> &values);

    void
    set(const std::string &name, const std::string &text);

    /** For iterators, such as those of dealii::Vector<double>. */
    template <typename Iterator>
    void
    set(const std::string &name, const Iterator first, const Iterator last)
    {
      set(name, std::vector<double>(first, last));
    }

    /** @throws InputError naming the entry and the file if it is missing */
    const std::vector<double> &
    doubles(const std::string &name) const;

    /** @copydoc doubles() */
    const std::vector<std::int64_t> &
    integers(const std::string &name) const;

    /** @copydoc doubles() */
    const std::string &
    text(const std::string &name) const;

    /** As doubles(name), which must have this many. @throws InputError */
    const std::vector<double> &
    doubles(const std::string &name, const std::size_t size) const;

    /** Writes atomically and waits for the disk. @throws ComputationError */
    void
    write(const std::string &path) const;

    /** @throws InputError if the file is missing, not a checkpoint, of another
     *  version or byte order, cut short, or damaged */
    static Checkpoint
    read(const std::string &path);

    /** Same entries, bit for bit (so a NaN equals itself). */
    bool
    operator==(const Checkpoint &other) const;

  private:
    std::string
    pack() const;

    std::map<std::string, std::vector<double>>       double_entries;
    std::map<std::string, std::vector<std::int64_t>> integer_entries;
    std::map<std::string, std::string>               text_entries;

    /** For messages; empty unless read from a file. */
    std::string source;
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
     *  @throws ComputationError */
    void
    write(const Checkpoint &checkpoint, const unsigned int step) const;

    struct Found
    {
      Checkpoint   checkpoint;
      unsigned int step = 0;
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

  private:
    std::string  folder;
    unsigned int n_kept;
  };
} // namespace asperity

#endif
