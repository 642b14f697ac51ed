#include <asperity/topography/file_content.h>
#include <asperity/topography/text_cells.h>

#include <algorithm>
#include <limits>
#include <set>

namespace asperity
{
  namespace
  {
    std::string
    lower_case(std::string text)
    {
      for (char &c : text)
        if (c >= 'A' && c <= 'Z')
          c += 'a' - 'A';
      return text;
    }

    /** What the C library of Windows prints: 1.#QNAN, -1.#IND00, 1,#INF. */
    bool
    starts_as_windows_number(std::string cell, const std::string &kind)
    {
      cell.erase(0, cell.find_first_not_of("+-"));
      return cell.compare(0, 1, "1") == 0 && cell.size() > 3 &&
             (cell[1] == '.' || cell[1] == ',') &&
             cell.compare(2, kind.size() + 1, "#" + kind) == 0;
    }

    std::string
    without_quotes(const std::string &cell)
    {
      const bool quoted =
        cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
      return quoted ? strip(cell.substr(1, cell.size() - 2)) : cell;
    }

    std::vector<std::string>
    split_at_blanks(const std::string &line)
    {
      std::vector<std::string> cells;
      std::size_t              begin = line.find_first_not_of(" \t");
      while (begin != std::string::npos)
        {
          const auto        end  = line.find_first_of(" \t", begin);
          const std::string word = line.substr(begin, end - begin);
          // "No Data" is one cell.
          if (!cells.empty() && lower_case(word) == "data" &&
              lower_case(cells.back()) == "no")
            cells.back() += " " + word;
          else
            cells.push_back(word);
          begin = line.find_first_not_of(" \t", std::min(end, line.size()));
        }
      return cells;
    }
  } // namespace

  bool
  is_void_word(const std::string &cell)
  {
    static const std::set<std::string> words = {
      "nan",     "-nan",    "+nan",   "nan(ind)", "-nan(ind)", "bad",
      "no data", "no_data", "nodata", "no-data",  "n/a",       "na",
      "#n/a",    "#na",     "#num!",  "#div/0!",  "#value!",   "#ref!",
      "#name?",  "#null!",  "null",   "none",     "nil",       "void",
      "invalid", "missing", "masked", "empty",    "undef",     "undefined",
      "?"};
    const std::string word = lower_case(without_quotes(cell));
    return word.find_first_not_of('-') == std::string::npos ||
           word.find_first_not_of('*') == std::string::npos ||
           words.count(word) != 0 || starts_as_windows_number(word, "qnan") ||
           starts_as_windows_number(word, "snan") ||
           starts_as_windows_number(word, "ind") ||
           starts_as_windows_number(word, "nan");
  }

  TextCell
  read_cell(const std::string &cell, const char separator)
  {
    if (is_void_word(cell))
      return {std::numeric_limits<double>::quiet_NaN(), true, 0};
    std::string word = lower_case(without_quotes(cell));
    if (starts_as_windows_number(word, "inf") || word == "infinite")
      return {std::numeric_limits<double>::infinity(), true, 0};
    TextCell   result;
    const auto comma = separator == ',' ? std::string::npos : word.find(',');
    if (comma != std::string::npos)
      {
        if (word.find_first_of(".,", comma + 1) != std::string::npos ||
            word.find('.') < comma)
          return result; // with marks of thousands, too
        word[comma]         = '.';
        result.decimal_sign = ',';
      }
    else if (word.find('.') != std::string::npos)
      result.decimal_sign = '.';
    result.is_understood = parse_decimal(word, result.value);
    return result;
  }

  char
  find_separator(const std::string &line)
  {
    const auto has = [&line](const char *part) {
      return line.find(part) != std::string::npos;
    };
    if (has(";"))
      return ';';
    // Blanks inside of a cell would make the separator a part of it.
    const auto divides = [&line](const char separator) {
      const auto cells = split_cells(line, separator);
      return std::all_of(cells.begin(),
                         cells.end(),
                         [](const std::string &cell) {
                           return cell.find(' ') == std::string::npos ||
                                  is_void_word(cell);
                         });
    };
    if (has("\t") && !has(",\t") && divides('\t'))
      return '\t';
    // With a comma as separator between values, blanks may follow it.
    if (has(",") && (has(".") || has(", ") || has(",\t") || divides(',')) &&
        !(has("\t") && !has(",\t")))
      return ',';
    return ' ';
  }

  std::vector<std::string>
  split_cells(const std::string &line, const char separator)
  {
    if (separator == ' ')
      return split_at_blanks(line);
    std::vector<std::string> cells;
    for (std::size_t begin = 0;;)
      {
        const auto end = line.find(separator, begin);
        cells.push_back(strip(line.substr(begin, end - begin)));
        if (end == std::string::npos)
          return cells;
        begin = end + 1;
      }
  }
} // namespace asperity
