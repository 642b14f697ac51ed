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

  /** The text as UTF-8 without control characters: '?' for whatever is not. */
  std::string
  printable(const std::string &text);

  /** How a message shows a text that somebody wrote: printable(), between
   *  quotation marks, shortened to 60 bytes. */
  std::string
  quoted_text(const std::string &text);

  /** How a message shows the name of a file, an entry or an input: as
   *  quoted_text(), but whole, since paths differ at their ends. More than 4096
   *  bytes are no name and are shortened. */
  std::string
  quoted_name(const std::string &name);

  /**
   * Number of insertions, deletions, substitutions and swaps of neighbours
   * that turn one text into the other, regardless of case (optimal string
   * alignment distance).
   */
  unsigned int
  edit_distance(const std::string &first, const std::string &second);
} // namespace asperity

#endif
