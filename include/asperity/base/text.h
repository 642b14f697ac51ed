#ifndef asperity_base_text_h
#define asperity_base_text_h

#include <string>
#include <vector>

namespace asperity
{
  /** Without blanks at both ends. */
  std::string
  trim(const std::string &text);

  /** The parts between separators, trimmed; empty text has no parts. */
  std::vector<std::string>
  split(const std::string &text, const char separator);

  /** "a, b, c" for separator ", ". */
  std::string
  join(const std::vector<std::string> &parts, const std::string &separator);

  /** How a message shows a text that somebody wrote: between quotation marks,
   *  shortened to 60 bytes, control characters as question marks. */
  std::string
  quoted(const std::string &text);

  /**
   * Number of insertions, deletions, substitutions and swaps of neighbours
   * that turn one text into the other, regardless of case (optimal string
   * alignment distance).
   */
  unsigned int
  edit_distance(const std::string &first, const std::string &second);
} // namespace asperity

#endif
