#ifndef source_learning_checked_file_h
#define source_learning_checked_file_h

#include <string>

namespace asperity
{
  /** Writes bytes with a line that says what they are, and their check sum.
   *  @param kind "learned model"
   *  @throws ComputationError as write_atomically() */
  void
  write_checked_file(const std::string &path,
                     const std::string &kind,
                     const std::string &bytes);

  /** The bytes of such a file.
   *  @throws InputError with one sentence if it is missing, of another kind or
   *   not as it was written */
  std::string
  read_checked_file(const std::string &path, const std::string &kind);
} // namespace asperity

#endif
