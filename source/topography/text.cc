#include <asperity/base/errors.h>
#include <asperity/topography/file_content.h>
#include <asperity/topography/read_height_map.h>

#include <algorithm>
#include <cstdlib>

// Text: a matrix of heights, or lines "x y z". Which one it is, which
// separator and which decimal sign it uses, is seen from its lines.
namespace asperity
{
  namespace
  {
    using Rows = std::vector<std::vector<double>>;

    struct Dialect
    {
      char separator     = ' '; // blanks stand for any number of blanks, tabs
      bool decimal_comma = false;
    };

    Dialect
    find_dialect(const std::string &line)
    {
      const auto has = [&line](const char c) {
        return line.find(c) != std::string::npos;
      };
      Dialect dialect;
      if (has(';'))
        dialect.separator = ';';
      else if (has(',') && (has('.') || !(has('\t') || has(' '))))
        dialect.separator = ',';
      // With a comma as separator between values, blanks may follow it.
      else if (has(',') && line.find(", ") != std::string::npos)
        dialect.separator = ',';
      dialect.decimal_comma = dialect.separator != ',' && has(',');
      return dialect;
    }

    std::vector<std::string>
    split_line(const std::string &line, const char separator)
    {
      std::vector<std::string> words;
      if (separator != ' ')
        {
          std::size_t begin = 0;
          for (;;)
            {
              const auto end = line.find(separator, begin);
              words.push_back(strip(line.substr(begin, end - begin)));
              if (end == std::string::npos)
                break;
              begin = end + 1;
            }
          if (words.back().empty()) // separator at the end of the line
            words.pop_back();
          return words;
        }
      std::size_t begin = line.find_first_not_of(" \t");
      while (begin != std::string::npos)
        {
          const auto end = line.find_first_of(" \t", begin);
          words.push_back(line.substr(begin, end - begin));
          begin =
            end == std::string::npos ? end : line.find_first_not_of(" \t", end);
        }
      return words;
    }

    bool
    is_missing(const std::string &word)
    {
      static const std::vector<std::string> words = {"",
                                                     "NaN",
                                                     "nan",
                                                     "NAN",
                                                     "BAD",
                                                     "bad",
                                                     "-",
                                                     "--",
                                                     "---",
                                                     "***",
                                                     "inf",
                                                     "-inf",
                                                     "Inf",
                                                     "-Inf",
                                                     "#N/A",
                                                     "None",
                                                     "null",
                                                     "n/a",
                                                     "NA"};
      return std::find(words.begin(), words.end(), word) != words.end();
    }

    /** False if the word is neither a number nor a sign of a missing one. */
    bool
    read_word(std::string word, const bool decimal_comma, double &value)
    {
      value = missing_height;
      if (is_missing(word))
        return true;
      if (decimal_comma)
        std::replace(word.begin(), word.end(), ',', '.');
      char *end = nullptr;
      value     = std::strtod(word.c_str(), &end);
      // strtod also takes hexadecimal numbers, which nobody means here.
      return *end == '\0' && word.find_first_of("xX") == std::string::npos;
    }

    bool
    read_row(const std::string   &line,
             const Dialect       &dialect,
             std::vector<double> &row)
    {
      row.clear();
      bool has_number = false;
      for (const auto &word : split_line(line, dialect.separator))
        {
          double value = 0.;
          if (!read_word(word, dialect.decimal_comma, value))
            return false;
          has_number = has_number || std::isfinite(value);
          row.push_back(value);
        }
      return has_number || row.size() > 1;
    }

    /** All rows after the title lines; rows have to be equally long. */
    Rows
    read_rows(const FileContent &file)
    {
      const std::string  &text = file.bytes();
      Rows                rows;
      Dialect             dialect;
      std::vector<double> row;
      std::size_t         position = 0;
      for (unsigned int n = 1; position < text.size(); ++n)
        {
          const auto end  = std::min(text.find_first_of("\r\n", position), //
                                    text.size());
          const auto line = strip(text.substr(position, end - position));
          position        = end + 1;
          if (end < text.size() && text[end] == '\r' &&
              position < text.size() && text[position] == '\n')
            ++position;
          if (line.empty() || line.find_first_of("#%;!*/") == 0)
            continue;
          if (rows.empty())
            dialect = find_dialect(line);
          if (!read_row(line, dialect, row))
            {
              if (rows.empty())
                continue; // a title
              file.fail("text",
                        "has '" + line.substr(0, 40) + "' in line " +
                          std::to_string(n) + "; numbers are expected");
            }
          if (!rows.empty() && row.size() != rows.front().size())
            file.fail("text",
                      "has " + std::to_string(row.size()) + " values in line " +
                        std::to_string(n) +
                        "; as many as in the lines before, " +
                        std::to_string(rows.front().size()) + ", are expected");
          rows.push_back(row);
        }
      if (rows.empty())
        file.fail("text", "holds no line of numbers");
      return rows;
    }

    /** Sorted coordinates, those closer than a thousandth of the range / n. */
    std::vector<double>
    distinct(std::vector<double> values)
    {
      std::sort(values.begin(), values.end());
      const double        range = values.back() - values.front();
      const double        close = 0.25 * range / values.size();
      std::vector<double> result;
      for (const double value : values)
        if (result.empty() || value - result.back() > close)
          result.push_back(value);
      return result;
    }

    /** The mean step, or 0 if a step differs from it by more than 2 %. */
    double
    regular_step(const std::vector<double> &values)
    {
      if (values.size() < 2)
        return 0.;
      const double step =
        (values.back() - values.front()) / (values.size() - 1);
      for (std::size_t i = 0; i < values.size(); ++i)
        if (std::abs(values[i] - values.front() - i * step) > 0.02 * step)
          return 0.;
      return step;
    }

    /** Three columns whose first two span a grid. */
    bool
    is_point_list(const Rows          &rows,
                  std::vector<double> &x,
                  std::vector<double> &y)
    {
      if (rows.front().size() != 3 || rows.size() < 2)
        return false;
      for (const auto &row : rows)
        {
          if (!std::isfinite(row[0]) || !std::isfinite(row[1]))
            return false;
          x.push_back(row[0]);
          y.push_back(row[1]);
        }
      x = distinct(x);
      y = distinct(y);
      return (y.size() == 1 || regular_step(y) > 0.) && regular_step(x) > 0. &&
             x.size() * y.size() < 2 * rows.size();
    }

    HeightMap
    map_of_points(const FileContent         &file,
                  const Rows                &rows,
                  const std::vector<double> &x,
                  const std::vector<double> &y,
                  const ReadOptions         &options)
    {
      const double step_x = regular_step(x);
      const double step_y = y.size() > 1 ? regular_step(y) : step_x;
      HeightMap    map    = allocate_map(
        file, "text, x y z", x.size(), y.size(), x.size() * y.size(), 1);
      map.dx = step_x * options.lateral_unit;
      map.dy = step_y * options.lateral_unit;
      for (const auto &row : rows)
        {
          const auto i = std::lround((row[0] - x.front()) / step_x);
          const auto j = std::lround((row[1] - y.front()) / step_y);
          if (i < 0 || i >= map.nx || j < 0 || j >= map.ny)
            file.fail("text, x y z", "has points off the grid of the others");
          map(i, j) = row[2] * options.height_unit;
        }
      return map;
    }

    HeightMap
    map_of_matrix(const FileContent &file,
                  const Rows        &rows,
                  const ReadOptions &options)
    {
      if (!(options.spacing_x > 0. && options.spacing_y > 0.))
        file.fail("text, matrix",
                  "holds " + std::to_string(rows.front().size()) + " x " +
                    std::to_string(rows.size()) +
                    " heights without coordinates; give the spacing of the "
                    "samples (Spacing x, Spacing y)");
      HeightMap map = allocate_map(file,
                                   "text, matrix",
                                   rows.front().size(),
                                   rows.size(),
                                   rows.front().size() * rows.size(),
                                   1);
      map.dx        = options.spacing_x;
      map.dy        = options.spacing_y;
      for (std::size_t j = 0; j < rows.size(); ++j)
        for (std::size_t i = 0; i < rows[j].size(); ++i)
          map(i, j) = rows[j][i] * options.height_unit;
      return map;
    }
  } // namespace

  HeightMap
  read_text(const FileContent &file, const ReadOptions &options)
  {
    const Rows          rows = read_rows(file);
    std::vector<double> x, y;
    const bool          is_list = is_point_list(rows, x, y);
    if (!(options.height_unit > 0.) ||
        (is_list && !(options.lateral_unit > 0.)))
      file.fail("text",
                std::string("carries no unit; give the unit of its heights "
                            "(Height unit)") +
                  (is_list ? " and of its coordinates (Lateral unit)" : ""));
    HeightMap map = is_list ? map_of_points(file, rows, x, y, options) :
                              map_of_matrix(file, rows, options);
    map.provenance.unit_source = "given by the user";
    return map;
  }
} // namespace asperity
