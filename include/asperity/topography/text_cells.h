#ifndef asperity_topography_text_cells_h
#define asperity_topography_text_cells_h

#include <string>
#include <vector>

namespace asperity
{
  /**
   * Whether a cell stands for a missing height: empty, dashes, asterisks, or a
   * word that an instrument, a spreadsheet or a C library writes for it ("Bad",
   * "No Data", "#N/A", "NaN", "1.#QNAN", ...), in capitals or not.
   */
  bool
  is_void_word(const std::string &cell);

  /** A cell of a line of numbers. */
  struct TextCell
  {
    /** The height; NaN if it is missing, infinite if the cell says so. */
    double value = 0.;

    /** False if the cell is neither a number nor a word for a missing one. */
    bool is_understood = false;

    /** Its decimal sign, '.' or ',', or 0. */
    char decimal_sign = 0;
  };

  /** @p separator is that of the cells; a comma that is none is decimal. */
  TextCell
  read_cell(const std::string &cell, const char separator);

  /**
   * What separates the cells of a line: ';', a tab, ',' or ' ', which stands
   * for any number of blanks and tabs.
   */
  char
  find_separator(const std::string &line);

  /** The cells of a line without blanks around them; the last one is empty if
   *  a separator other than blanks ends the line. */
  std::vector<std::string>
  split_cells(const std::string &line, const char separator);
} // namespace asperity

#endif
