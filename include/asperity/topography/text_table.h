#ifndef asperity_topography_text_table_h
#define asperity_topography_text_table_h

#include <asperity/topography/file_content.h>

#include <string>
#include <vector>

namespace asperity
{
  /**
   * The numbers of a text: rows of equal length, read without knowing whether
   * they are heights or coordinates. Nothing behind the first row is skipped
   * unless it is a comment, and the notes say so.
   */
  struct TextTable
  {
    /** Rows between blank lines, comments or the ends of the file. */
    struct Block
    {
      std::size_t first_row = 0;

      /** Line of the blank line or comment before it, 0 of the first block. */
      unsigned int separator_line = 0;

      /** The first comment before it, empty if only blank lines are there. */
      std::string comment;
    };

    /** Cells a row. */
    std::size_t n_columns = 0;

    /** Row after row; NaN where a cell says that nothing was measured. */
    std::vector<double> values;

    /** Of each row, counted from 1. */
    std::vector<unsigned int> line_of_row;

    std::vector<Block> blocks;

    /** Comments and titles before the first row, without the sign of a
     *  comment. */
    std::vector<std::string> header;

    /** What was skipped; see Provenance. */
    std::vector<std::string> notes;
    std::vector<std::string> warnings;

    std::size_t
    n_rows() const
    {
      return line_of_row.size();
    }

    double
    operator()(const std::size_t row, const std::size_t column) const
    {
      return values[row * n_columns + column];
    }

    /** Keep the rows of the first block only, with a warning. */
    void
    keep_first_block();
  };

  /**
   * Read the rows of a text in UTF-8 or UTF-16, with or without a byte-order
   * mark. Separator and decimal sign are seen from the rows. What stands before
   * the first row is a title or comment unless it holds a row's worth of
   * numbers.
   *
   * A block of rows that follows comments and has another length than the first
   * one is another channel, and keep_first_block() is applied.
   *
   * @throws InputError with line and cell if a row is not understood, if rows
   *   are not equally long, or if there is no row.
   */
  TextTable
  read_text_table(const FileContent &file);

  /**
   * The text of a file as UTF-8 without a byte-order mark, or an empty string
   * if its bytes are no text.
   *
   * @throws InputError if it is encoded in UTF-32, or in damaged UTF-16.
   */
  std::string
  decode_text(const FileContent &file);
} // namespace asperity

#endif
