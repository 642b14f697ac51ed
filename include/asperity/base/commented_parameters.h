#ifndef asperity_base_commented_parameters_h
#define asperity_base_commented_parameters_h

#include <iosfwd>
#include <string>
#include <vector>

namespace asperity
{
  class ParameterDeclarator;

  /** An entry that somebody or something has chosen, and why. */
  struct CommentedEntry
  {
    std::string path; ///< "Load/Pressure"
    std::string text; ///< "450 MPa"
    std::string reason;
  };

  /**
   * Writes a parameter file of the given entries alone, in the order in which
   * they are declared, each below its own sentence and the reason of its value.
   * What is read back has these values and the defaults of all other entries.
   *
   * @throws InputError if a path is not declared.
   */
  void
  write_commented_prm(std::ostream                      &out,
                      const ParameterDeclarator         &parameters,
                      const std::vector<CommentedEntry> &entries);

  /** Lines of at most @p width characters, each behind @p prefix. */
  void
  write_wrapped(std::ostream      &out,
                const std::string &text,
                const std::string &prefix,
                const std::size_t  width = 80);
} // namespace asperity

#endif
