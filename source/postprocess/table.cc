#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/text.h>
#include <asperity/postprocess/table.h>

#include <cerrno>
#include <cmath>
#include <cstdio>

namespace asperity
{
  namespace
  {
    std::string
    heading(const std::vector<TableColumn> &columns, const bool people)
    {
      std::string line;
      for (const TableColumn &column : columns)
        line += (line.empty() ? "" : ",") +
                (people ? column.people_name : column.name);
      return line;
    }

    std::ofstream
    open_table(const std::string              &path,
               const std::vector<TableColumn> &columns,
               const bool                      people)
    {
      write_atomically(path, [&](std::ostream &out) {
        out << heading(columns, people) << '\n';
      });
      return std::ofstream(path, std::ios::app | std::ios::binary);
    }

    void
    write_line(std::ofstream     &out,
               const std::string &line,
               const std::string &path)
    {
      // One write and one flush a row: a kill cannot split older rows.
      errno = 0;
      out << line << std::flush;
      if (!out)
        throw ComputationError(
          "The table " + quoted_name(path) +
          " could not be extended: " + reason_of_failure(errno) + ".");
    }
  } // namespace



  Table::Table(const std::string              &path,
               const std::vector<TableColumn> &columns,
               const std::string              &people_path)
    : path(path)
    , people_path(people_path)
    , columns(columns)
  {
    for (const TableColumn &column : columns)
      if ((column.name + column.people_name).find_first_of(",\"\n") !=
          std::string::npos)
        throw InputError("The heading " + quoted_name(column.name) +
                         " of the table " + quoted_name(path) +
                         " holds a comma, a quote or a line break, which "
                         "would break the table apart.");
    out = open_table(path, columns, false);
    if (!people_path.empty())
      people_out = open_table(people_path, columns, true);
  }



  void
  Table::append(const std::vector<double> &row)
  {
    if (row.size() != columns.size())
      throw ComputationError("A row of " + std::to_string(row.size()) +
                             " numbers was given to the table " +
                             quoted_name(path) + ", which has " +
                             std::to_string(columns.size()) + " columns.");
    std::string line, people_line;
    for (std::size_t i = 0; i < row.size(); ++i)
      {
        if (!std::isfinite(row[i]))
          throw ComputationError(
            "The value of " + quoted_name(columns[i].name) + " for the table " +
            quoted_name(path) + " is not a finite number.");
        const std::string separator = i + 1 < row.size() ? "," : "\n";
        line += shortest_decimal(row[i]) + separator;
        // Twelve digits hide that 0.3 MPa times 1e6 is not quite 300000.
        char shown[32];
        std::snprintf(shown,
                      sizeof(shown),
                      "%.12g",
                      columns[i].factor * row[i] + columns[i].offset);
        people_line += shown + separator;
      }
    write_line(out, line, path);
    if (people_out.is_open())
      write_line(people_out, people_line, people_path);
  }
} // namespace asperity
