#ifndef asperity_postprocess_table_h
#define asperity_postprocess_table_h

#include <fstream>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * One column of a Table: its heading in SI units, and how the same quantity
   * is shown to people: shown = factor * value + offset.
   */
  struct TableColumn
  {
    std::string name;        ///< heading with unit, "time [s]"
    std::string people_name; ///< heading with unit, "time [us]"
    double      factor = 1.;
    double      offset = 0.;
  };

  /**
   * A comma-separated table that grows by a row a step. Every row is on disk
   * before append() returns, so a killed run leaves whole rows (and at most one
   * torn last line).
   *
   * Numbers are the shortest decimals that read back as the same double.
   */
  class Table
  {
  public:
    /**
     * @param path the file; replaced if it exists
     * @param columns headings; a comma, quote or line break is not allowed
     * @param people_path a second file with the rows in people's units, or
     *   empty for none
     * @throws InputError if a heading has such a character
     * @throws ComputationError if a file cannot be written
     */
    Table(const std::string              &path,
          const std::vector<TableColumn> &columns,
          const std::string              &people_path = "");

    /**
     * @param row one value a column, in SI units
     * @throws ComputationError naming the column if a value is not finite or if
     *   the file cannot be written
     */
    void
    append(const std::vector<double> &row);

  private:
    std::string              path, people_path;
    std::vector<TableColumn> columns;
    std::ofstream            out, people_out;
  };
} // namespace asperity

#endif
