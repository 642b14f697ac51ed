#ifndef asperity_base_errors_h
#define asperity_base_errors_h

#include <stdexcept>
#include <string>

namespace asperity
{
  /**
   * The input is wrong: the program ends with exit status 2 and this message,
   * one sentence that names the file, the entry, what was found and what is
   * expected.
   */
  class InputError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /**
   * The computation failed beyond repair: exit status 1 and this message, one
   * sentence that says what failed, when, and where the last good state lies.
   */
  class ComputationError : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace asperity

#endif
