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
   * old content or the new one and never a part: what `write` writes goes to a
   * temporary file in the same folder, which is then renamed. Missing folders
   * are made.
   *
   * @throws ComputationError naming the file and the reason ("no space left on
   *   device") if it cannot be written; what `write` throws is passed on, and
   *   nothing is written
   */
  void
  write_atomically(const std::string                         &path,
                   const std::function<void(std::ostream &)> &write,
                   const Durability durability = Durability::process);

  /** What an error number of the system means, as the end of a sentence: "no
   *  space left on device". */
  std::string
  reason_of_failure(const int error_number);

  /**
   * The shortest decimal that reads back as the same double; whole numbers
   * below 1e15 without exponent. Independent of the locale.
   */
  std::string
  shortest_decimal(const double value);
} // namespace asperity

#endif
