#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/postprocess/table.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

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

    /** Complete lines of a table that belong to the part that is kept. */
    std::vector<std::string>
    kept_rows(const std::string &path,
              const std::string &expected_heading,
              const std::size_t  n_columns,
              const double       keep_until)
    {
      std::vector<std::string> rows;
      std::ifstream            in(path);
      std::string              line;
      if (!in || !std::getline(in, line))
        return rows;
      if (line != expected_heading)
        throw InputError("The table " + path + " begins with '" + line +
                         "', but a restart that continues it expects '" +
                         expected_heading + "'.");
      while (std::getline(in, line))
        {
          // A line without its end was cut short by a kill.
          if (in.eof())
            break;
          const std::size_t n_commas =
            std::count(line.begin(), line.end(), ',');
          char        *end    = nullptr;
          const double number = std::strtod(line.c_str(), &end);
          if (end == line.c_str() || n_commas + 1 != n_columns)
            throw InputError("The table " + path + " holds the line '" + line +
                             "', but a row of " + std::to_string(n_columns) +
                             " numbers is expected.");
          if (number > keep_until)
            break;
          rows.push_back(line);
        }
      return rows;
    }

    std::ofstream
    open_table(const std::string              &path,
               const std::vector<TableColumn> &columns,
               const bool                      people,
               const double                    keep_until)
    {
      const std::string        first = heading(columns, people);
      std::vector<std::string> rows;
      if (keep_until > Table::keep_nothing)
        rows = kept_rows(path, first, columns.size(), keep_until);
      write_atomically(path, [&](std::ostream &out) {
        out << first << '\n';
        for (const std::string &row : rows)
          out << row << '\n';
      });
      return std::ofstream(path, std::ios::app | std::ios::binary);
    }

    void
    write_line(std::ofstream     &out,
               const std::string &line,
               const std::string &path)
    {
      // One write and one flush a row: a kill cannot split older rows.
      out << line << std::flush;
      if (!out)
        throw ComputationError("The table " + path +
                               " could not be extended; is the disk full?");
    }
  } // namespace



  Table::Table(const std::string              &path,
               const std::vector<TableColumn> &columns,
               const std::string              &people_path,
               const double                    keep_until)
    : path(path)
    , people_path(people_path)
    , columns(columns)
  {
    for (const TableColumn &column : columns)
      if ((column.name + column.people_name).find_first_of(",\"\n") !=
          std::string::npos)
        throw InputError("The heading '" + column.name + "' of the table " +
                         path +
                         " holds a comma, a quote or a line break, which "
                         "would break the table apart.");
    out = open_table(path, columns, false, keep_until);
    if (!people_path.empty())
      people_out = open_table(people_path, columns, true, keep_until);
  }



  void
  Table::append(const std::vector<double> &row)
  {
    if (row.size() != columns.size())
      throw ComputationError("A row of " + std::to_string(row.size()) +
                             " numbers was given to the table " + path +
                             ", which has " + std::to_string(columns.size()) +
                             " columns.");
    std::string line, people_line;
    for (std::size_t i = 0; i < row.size(); ++i)
      {
        if (!std::isfinite(row[i]))
          throw ComputationError("The value of '" + columns[i].name +
                                 "' for the table " + path +
                                 " is not a finite number.");
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
