#ifndef asperity_base_parameter_file_h
#define asperity_base_parameter_file_h

#include <iosfwd>
#include <string>
#include <vector>

namespace asperity
{
  /** One `set` of a parameter file, with the place where it stands. */
  struct ParameterLine
  {
    std::vector<std::string> subsections;
    std::string              key;
    std::string              value;
    std::string              file;
    unsigned int             line = 0;

    /** "Load/Pressure" */
    std::string
    path() const;

    /** "name.prm, line 7" */
    std::string
    origin() const;
  };

  /**
   * Reads a file in the format of dealii::ParameterHandler (`subsection`,
   * `set`, `end`, `include`, continuation by a trailing backslash) without
   * knowing which entries exist, and keeps file and line of each, which
   * deal.II's own parser does not. An included file is searched relative to the
   * file that includes it.
   *
   * Comments start with a `#` at the start of a line or after a blank. One
   * inside of a word belongs to the value or the file that is named, `set
   * Output directory = C#1`; only where neither can hold it, as in `end#`, it
   * starts a comment, too. A value or file between quotation marks, `set
   * Output directory = "run #1"`, is taken as it stands, blanks at its ends
   * included; `\"` and `\\` inside stand for `"` and `\`. Text is UTF-8, with
   * or without a byte-order mark; lines end as on Unix, Windows or an old
   * Macintosh.
   *
   * @throws InputError for what is not such a line, for quotation marks without
   *   their partner, for an entry set twice in one file, for files that include
   *   themselves or too many others, and for
   *   what is no readable text file of a sensible size; lines are not repeated,
   *   as the file may be anybody's
   */
  std::vector<ParameterLine>
  read_parameter_lines(const std::string &file_name);

  /** The same from a stream; @p name stands for the file in messages.
   *  @throws InputError */
  std::vector<ParameterLine>
  read_parameter_lines(std::istream &input, const std::string &name);

  /** How a line `set KEY = ...` says @p text, which has no line breaks:
   *  between quotation marks where it would not be read as it is without. */
  std::string
  written_value(const std::string &text);
} // namespace asperity

#endif
