#include <asperity/base/text.h>
#include <asperity/topography/text_cells.h>
#include <asperity/topography/text_table.h>

#include <algorithm>
#include <cmath>

namespace asperity
{
  namespace
  {
    // A row of a million cells; they are taken apart one row at a time.
    constexpr std::size_t longest_line = std::size_t(1) << 23;

    /** Lines one by one, whatever ends them: LF, CR LF or CR. */
    class Lines
    {
    public:
      explicit Lines(const std::string &text)
        : text(text)
      {}

      bool
      next(std::string &line)
      {
        if (position >= text.size())
          return false;
        const auto end =
          std::min(text.find_first_of("\r\n", position), text.size());
        line     = text.substr(position, end - position);
        position = end + 1;
        if (end + 1 < text.size() && text[end] == '\r' && text[end + 1] == '\n')
          ++position;
        ++number;
        return true;
      }

      unsigned int number = 0;

    private:
      const std::string &text;
      std::size_t        position = 0;
    };

    bool
    starts_as_comment(const std::string &line)
    {
      return line.find_first_of("#%;!*/") == line.find_first_not_of(" \t");
    }

    struct Row
    {
      std::vector<double> values;
      bool                first_is_empty = false;
      bool                last_is_empty  = false;
      bool                all_are_empty  = true;

      /** Of its numbers. */
      char decimal_sign = 0;

      /** The first cell that is not understood, and its column from 1. */
      std::string  wrong_cell;
      unsigned int wrong_column = 0;
      unsigned int n_numbers    = 0;

      bool
      is_understood() const
      {
        return wrong_column == 0 && (values.size() > 1 || n_numbers > 0);
      }
    };

    Row
    read_row(const std::string &line, const char separator)
    {
      Row        row;
      const auto cells   = split_cells(line, separator);
      row.first_is_empty = !cells.empty() && cells.front().empty();
      row.last_is_empty  = cells.size() > 1 && cells.back().empty();
      for (const std::string &cell : cells)
        {
          const TextCell value = read_cell(cell, separator);
          row.all_are_empty    = row.all_are_empty && cell.empty();
          row.values.push_back(value.value);
          if (!value.is_understood && row.wrong_column == 0)
            {
              row.wrong_cell   = cell;
              row.wrong_column = row.values.size();
            }
          else if (value.is_understood && !std::isnan(value.value))
            ++row.n_numbers;
          if (value.decimal_sign != 0)
            row.decimal_sign = value.decimal_sign;
        }
      return row;
    }

    /** Reads the lines in turn; see read_text_table(). */
    class TableReader
    {
    public:
      TableReader(const FileContent &file, const std::string &text)
        : file(file)
        , lines(text)
      {}

      TextTable
      run()
      {
        std::string line;
        while (lines.next(line))
          if (line.size() > longest_line)
            file.fail("text",
                      "has " + std::to_string(line.size()) + " bytes in line " +
                        std::to_string(lines.number) + "; at most " +
                        std::to_string(longest_line) + " are expected");
          else if (rows_end.empty())
            read_line_of_head(line);
          else
            read_line_of_body(line);
        if (rows_end.empty())
          file.fail("text",
                    "holds no line of numbers" +
                      (titles.empty() ?
                         std::string() :
                         "; line " + std::to_string(titles[0].first) + " is " +
                           quoted_text(titles[0].second)));
        unify_rows();
        check_titles();
        write_notes();
        return std::move(table);
      }

    private:
      void
      read_line_of_head(const std::string &line)
      {
        if (strip(line).empty())
          return;
        separator     = find_separator(line);
        const Row row = read_row(line, separator);
        // Lines of dashes underline titles.
        const bool is_rule =
          line.find_first_not_of("- \t") == std::string::npos;
        if (row.is_understood() && !row.all_are_empty && !is_rule)
          {
            table.blocks.push_back({});
            append(row);
          }
        else if (starts_as_comment(line))
          {
            ++n_comments;
            const auto begin = line.find_first_not_of("#%;!*/ \t");
            if (begin != std::string::npos)
              table.header.push_back(strip(line.substr(begin)));
          }
        else if (!row.all_are_empty)
          {
            titles.emplace_back(lines.number, strip(line));
            table.header.push_back(strip(line));
          }
      }

      void
      read_line_of_body(const std::string &line)
      {
        const Row  row = read_row(line, separator);
        const bool is_blank =
          row.all_are_empty && (separator == ' ' || strip(line).empty());
        if (is_blank && row.values.size() != rows_end.front())
          note_break("");
        else if (row.is_understood())
          {
            if (pending.separator_line != 0)
              {
                pending.first_row = rows_end.size();
                table.blocks.push_back(pending);
                pending = {};
              }
            append(row);
          }
        else if (starts_as_comment(line))
          {
            ++n_comments_between;
            note_break(strip(line));
          }
        else
          fail_in_row(row, line, lines.number);
      }

      void
      note_break(const std::string &comment)
      {
        if (pending.separator_line == 0)
          pending.separator_line = lines.number;
        if (pending.comment.empty())
          pending.comment = comment;
      }

      void
      append(const Row &row)
      {
        if (row.decimal_sign != 0 && decimal_sign != 0 &&
            row.decimal_sign != decimal_sign)
          file.fail("text",
                    std::string("has the decimal sign '") + decimal_sign +
                      "' in line " + std::to_string(decimal_line) + " and '" +
                      row.decimal_sign + "' in line " +
                      std::to_string(lines.number) +
                      "; one sign for all numbers is expected");
        if (row.decimal_sign != 0 && decimal_sign == 0)
          {
            decimal_sign = row.decimal_sign;
            decimal_line = lines.number;
          }
        table.values.insert(table.values.end(),
                            row.values.begin(),
                            row.values.end());
        rows_end.push_back(table.values.size());
        first_is_empty.push_back(row.first_is_empty);
        last_is_empty.push_back(row.last_is_empty);
        table.line_of_row.push_back(lines.number);
      }

      [[noreturn]] void
      fail_in_row(const Row         &row,
                  const std::string &line,
                  const unsigned int number) const
      {
        const bool whole_line = row.wrong_column == 0;
        file.fail("text",
                  "has " + quoted_text(whole_line ? line : row.wrong_cell) +
                    " in line " + std::to_string(number) +
                    (whole_line ?
                       std::string() :
                       ", column " + std::to_string(row.wrong_column)) +
                    "; a number or a word for a missing one is expected");
      }

      std::size_t
      begin_of(const std::size_t row) const
      {
        return row == 0 ? 0 : rows_end[row - 1];
      }

      std::size_t
      length_of(const std::size_t row) const
      {
        return rows_end[row] - begin_of(row);
      }

      /** Rows of one length, without what separators at their ends made. */
      void
      unify_rows()
      {
        const std::size_t n = rows_end.size();
        const auto        all =
          [](const std::vector<bool> &flags) { // no cell before or behind them
            return std::all_of(flags.begin(), flags.end(), [](bool flag) {
              return flag;
            });
          };
        const bool indented = separator == '\t' && all(first_is_empty);
        const bool closed   = all(last_is_empty);
        // A row that ends with its last cell tells the length of all.
        std::size_t width = length_of(0) - closed;
        for (std::size_t row = 0; row < n && !closed; ++row)
          if (!last_is_empty[row])
            {
              width = length_of(row);
              break;
            }
        table.n_columns = width - indented;
        std::vector<double> values;
        for (std::size_t row = 0; row < n; ++row)
          {
            const std::size_t length = length_of(row);
            if (length != width && !(length == width + 1 && last_is_empty[row]))
              {
                if (cut_to_first_block(row))
                  break;
                file.fail("text",
                          "has " + std::to_string(length) + " values in line " +
                            std::to_string(table.line_of_row[row]) +
                            "; as many as in the lines before, " +
                            std::to_string(width) + ", are expected");
              }
            const auto begin = table.values.begin() + begin_of(row);
            values.insert(values.end(), begin + indented, begin + width);
          }
        values.resize(table.n_rows() * table.n_columns);
        table.values = std::move(values);
      }

      /** If the row is one of another channel, behind comments. */
      bool
      cut_to_first_block(const std::size_t row)
      {
        if (table.blocks.size() < 2 || row < table.blocks[1].first_row ||
            table.blocks[1].comment.empty())
          return false;
        table.keep_first_block();
        return true;
      }

      /** A line with half a row of numbers is no title but a damaged row. */
      void
      check_titles() const
      {
        for (const auto &[number, title] : titles)
          for (const char s : {separator, ' '})
            {
              const Row row = read_row(title, s);
              if (row.n_numbers > 1 && 2 * row.n_numbers >= table.n_columns)
                fail_in_row(row, title, number);
            }
      }

      void
      write_notes()
      {
        const auto count = [](const std::size_t n, const std::string &what) {
          return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
        };
        if (n_comments + titles.size() > 0)
          table.notes.push_back(
            "Reading: " + count(n_comments, "comment") + " and " +
            count(titles.size(), "title line") +
            " before the first row in line " +
            std::to_string(table.line_of_row.front()) + " were skipped" +
            (titles.empty() ?
               "" :
               "; the first title is " + quoted_text(titles[0].second)) +
            ".");
        if (n_comments_between > 0)
          table.notes.push_back(
            "Reading: " + count(n_comments_between, "comment") +
            " between and behind the rows were skipped.");
      }

      const FileContent &file;
      Lines              lines;
      TextTable          table;
      char               separator    = ' ';
      char               decimal_sign = 0;
      unsigned int       decimal_line = 0;

      /** Ends of the rows in the values of the table. */
      std::vector<std::size_t> rows_end;
      std::vector<bool>        first_is_empty;
      std::vector<bool>        last_is_empty;

      /** The block that the next row begins, if a line separates it. */
      TextTable::Block pending;

      std::vector<std::pair<unsigned int, std::string>> titles;

      std::size_t n_comments         = 0;
      std::size_t n_comments_between = 0;
    };
  } // namespace

  void
  TextTable::keep_first_block()
  {
    const Block second = blocks.at(1);
    warnings.push_back("The rows from line " +
                       std::to_string(line_of_row[second.first_row]) +
                       " on follow " + quoted_text(second.comment) +
                       " and are not read: they belong to another channel.");
    line_of_row.resize(second.first_row);
    if (values.size() > second.first_row * n_columns)
      values.resize(second.first_row * n_columns);
    blocks.resize(1);
  }

  TextTable
  read_text_table(const FileContent &file)
  {
    const std::string text = decode_text(file);
    return TableReader(file, text).run();
  }
} // namespace asperity
