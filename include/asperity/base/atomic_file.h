#ifndef asperity_base_atomic_file_h
#define asperity_base_atomic_file_h

#include <functional>
#include <iosfwd>
#include <string>

namespace asperity
{
  /** Whether a file must outlive a crash of the machine, not only of the
   *  program. */
  enum class Durability
  {
    process, ///< whole after a kill of the program
    machine  ///< whole after a loss of power, too (costs a disk flush)
  };

  /**
   * Writes a file so that a reader, or a restart after a kill, sees either the
   * old content or the new one and never a part: `write` fills a temporary file
   * in the same folder, which is then renamed. Missing folders are made.
   *
   * @throws ComputationError if the folder or file cannot be written; what
   *   `write` throws is passed on, with the temporary file removed.
   */
  void
  write_atomically(const std::string                         &path,
                   const std::function<void(std::ostream &)> &write,
                   const Durability durability = Durability::process);

  /**
   * The shortest decimal that reads back as the same double; whole numbers
   * below 1e15 without exponent. Independent of the locale.
   */
  std::string
  shortest_decimal(const double value);
} // namespace asperity

#endif
