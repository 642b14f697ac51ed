#include <asperity/base/errors.h>
#include <asperity/base/parameter_file.h>
#include <asperity/base/text.h>

#include <cctype>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

namespace asperity
{
  namespace
  {
    namespace fs = std::filesystem;

    constexpr std::uintmax_t largest_file    = 1 << 24; // bytes
    constexpr std::size_t    deepest_include = 50;
    constexpr std::size_t    most_files      = 1000;

    /**
     * Behind the text between quotation marks that begins at @p begin, which is
     * appended to @p content; npos if it has no end.
     */
    std::size_t
    end_of_quotation(const std::string &line,
                     const std::size_t  begin,
                     std::string       &content)
    {
      for (std::size_t at = begin + 1; at < line.size(); ++at)
        if (line[at] == '"')
          return at + 1;
        else
          {
            if (line[at] == '\\' && at + 1 < line.size() &&
                (line[at + 1] == '"' || line[at + 1] == '\\'))
              ++at;
            content += line[at];
          }
      return std::string::npos;
    }

    /** Where the value of a `set` or the file of an `include` begins. */
    std::size_t
    begin_of_value(const std::string &line)
    {
      const std::size_t word  = line.find_first_not_of(" \t");
      const std::size_t blank = line.find_first_of(" \t", word);
      if (blank == std::string::npos)
        return blank;
      const std::string statement = line.substr(word, blank - word);
      std::size_t       before    = std::string::npos;
      if (statement == "set" || statement == "SET")
        before = line.find('=', blank);
      else if (statement == "include" || statement == "INCLUDE")
        before = blank;
      return before == std::string::npos ?
               before :
               line.find_first_not_of(" \t", before + 1);
    }

    /**
     * The line without its comment. A '#' begins one at the start of a line and
     * after a blank; elsewhere it may belong to a word, as in a folder's name.
     * Between quotation marks it belongs to the value.
     */
    std::string
    without_comment(const std::string &line)
    {
      std::size_t       from  = 0;
      const std::size_t value = begin_of_value(line);
      std::string       content;
      if (value != std::string::npos && line[value] == '"')
        from = end_of_quotation(line, value, content);
      for (std::size_t at = line.find('#', from); at != std::string::npos;
           at             = line.find('#', at + 1))
        if (at == 0 || std::isspace(static_cast<unsigned char>(line[at - 1])))
          return line.substr(0, at);
      return line;
    }

    /** The text without its quotation marks, if it begins with one. */
    std::string
    unquoted(const std::string &text, const std::string &origin)
    {
      if (text.empty() || text.front() != '"')
        return text;
      std::string       content;
      const std::size_t end = end_of_quotation(text, 0, content);
      if (end == std::string::npos)
        throw InputError(origin + ": The text behind the quotation mark has no "
                                  "second one at its end.");
      if (end < text.size() && text[end] != '#')
        throw InputError(origin +
                         ": Something stands behind the second quotation "
                         "mark; inside of the text it is written \\\".");
      return content;
    }

    /** The next line, however it ends: as on Unix, Windows or old Macs. */
    bool
    next_line(std::istream &input, std::string &line)
    {
      line.clear();
      for (int c = input.get(); c != std::istream::traits_type::eof();
           c     = input.get())
        {
              if (c == '\r' && input.peek() == '\n')
            input.get();
          if (c == '\r' || c == '\n')
            return true;
          line += static_cast<char>(c);
        }
      return !line.empty();
    }

    class Reader
    {
    public:
      std::vector<ParameterLine> lines;

      /** @p includer is "file, line n" or empty for the first file. */
      void
      read_file(const std::string &file_name, const std::string &includer)
      {
        const std::string prefix = includer.empty() ? "" : includer + ": ";
        std::error_code   error;
        if (fs::is_directory(file_name, error))
          throw InputError(prefix + "The parameter file " +
                           quoted_name(file_name) + " is a folder.");
        if (fs::exists(file_name, error) &&
            !fs::is_regular_file(file_name, error))
          throw InputError(prefix + "The parameter file " +
                           quoted_name(file_name) +
                           " is a device or a pipe; a file is expected.");
        if (!error && fs::file_size(file_name, error) > largest_file && !error)
          throw InputError(prefix + "The file " + quoted_name(file_name) +
                           " is too large for a parameter file; at most " +
                           std::to_string(largest_file >> 20) +
                           " MB are expected.");
        if (open_files.size() == deepest_include)
          throw InputError(prefix + "The file " + quoted_name(file_name) +
                           " is included by " +
                           std::to_string(deepest_include) +
                           " files inside of each other; fewer are expected.");
        if (++n_files > most_files)
          throw InputError(prefix + "More than " + std::to_string(most_files) +
                           " files are included; fewer are expected.");
        std::ifstream input(file_name);
        if (!input)
          throw InputError(prefix + "The parameter file " +
                           quoted_name(file_name) +
                           " does not exist or cannot be read.");
        const fs::path canonical = fs::canonical(file_name);
        for (const fs::path &open_file : open_files)
          if (open_file == canonical)
            throw InputError(prefix + "The file " + quoted_name(file_name) +
                             " includes itself.");
        open_files.push_back(canonical);
        read_stream(input, file_name);
        open_files.pop_back();
      }

      void
      read_stream(std::istream &input, const std::string &name)
      {
        File        file{name, 0, 0, {}, {}};
        std::string line, joined;
        while (next_line(input, line))
          {
            ++file.line;
            if (joined.empty())
              file.first_line = file.line;
            if (file.line == 1)
              skip_byte_order_mark(line, name);
            if (line.find('\0') != std::string::npos)
              throw InputError(file.origin() +
                               ": There are bytes that are no text; a "
                               "parameter file is expected.");
            line               = trim(without_comment(line));
            const bool goes_on = !line.empty() && line.back() == '\\';
            if (goes_on)
              line.pop_back();
            joined += line;
            if (goes_on)
              continue;
            if (!trim(joined).empty())
              interpret(trim(joined), file);
            joined.clear();
          }
        if (!trim(joined).empty())
          throw InputError(file.origin() + ": The last line ends with a '\\'.");
        if (!file.subsections.empty())
          throw InputError(name + ": The file ends inside of subsection " +
                           quoted_name(file.subsections.back()) +
                           "; an 'end' is missing.");
      }

    private:
      /** Editors of Windows begin a text with a mark that one cannot see. */
      static void
      skip_byte_order_mark(std::string &line, const std::string &name)
      {
        const std::string utf8 = "\xEF\xBB\xBF";
        if (line.compare(0, 2, "\xFF\xFE") == 0 ||
            line.compare(0, 2, "\xFE\xFF") == 0)
          throw InputError(name + ": The text is in UTF-16; UTF-8 is expected "
                                  "(an editor's 'save as' offers it).");
        if (line.compare(0, utf8.size(), utf8) == 0)
          line.erase(0, utf8.size());
      }

      struct File
      {
        std::string                         name;
        unsigned int                        line;
        unsigned int                        first_line; // of a continued line
        std::vector<std::string>            subsections;
        std::map<std::string, unsigned int> line_of_path;

        std::string
        origin() const
        {
          return name + ", line " + std::to_string(first_line);
        }
      };

      void
      interpret(const std::string &line, File &file)
      {
        const std::size_t blank = line.find_first_of(" \t");
        const std::string word  = line.substr(0, blank);
        const std::string rest =
          blank == std::string::npos ? "" : trim(line.substr(blank));
        if (word == "set" || word == "SET")
          set(rest, file);
        else if (word == "include" || word == "INCLUDE")
          include(rest, file);
        else if (line.find('#') != std::string::npos)
          interpret(trim(line.substr(0, line.find('#'))), file); // end#comment
        else if (word == "subsection" || word == "SUBSECTION")
          {
            if (rest.empty())
              throw InputError(file.origin() + ": The subsection has no name.");
            file.subsections.push_back(rest);
          }
        else if ((word == "end" || word == "END") && rest.empty())
          {
            if (file.subsections.empty())
              throw InputError(file.origin() +
                               ": This 'end' closes no subsection.");
            file.subsections.pop_back();
          }
        else
          // Without its words: who names a wrong file need not see into it.
          throw InputError(file.origin() +
                           ": The line is not understood; it should be "
                           "'subsection NAME', "
                           "'set KEY = VALUE', 'end', 'include FILE' or a "
                           "comment after '#'.");
      }

      void
      set(const std::string &assignment, File &file)
      {
        const std::size_t equals = assignment.find('=');
        if (equals == std::string::npos)
          throw InputError(file.origin() +
                           ": This 'set' has no '=' between entry and value.");
        ParameterLine line;
        line.subsections = file.subsections;
        line.key         = trim(assignment.substr(0, equals));
        line.value =
          unquoted(trim(assignment.substr(equals + 1)), file.origin());
        line.file = file.name;
        line.line = file.first_line;
        const auto [position, is_new] =
          file.line_of_path.insert({line.path(), line.line});
        if (!is_new)
          throw InputError(file.origin() + ": The entry " +
                           quoted_name(line.path()) +
                           " has already been set in line " +
                           std::to_string(position->second) + ".");
        lines.push_back(line);
      }

      void
      include(const std::string &name, File &file)
      {
        const std::string included = unquoted(name, file.origin());
        if (!file.subsections.empty())
          throw InputError(file.origin() +
                           ": An 'include' must not stand inside of a "
                           "subsection.");
        if (included.empty())
          throw InputError(file.origin() + ": The 'include' names no file.");
        const fs::path path = fs::path(file.name).parent_path() / included;
        read_file(path.lexically_normal().string(), file.origin());
      }

      std::vector<fs::path> open_files;
      std::size_t           n_files = 0;
    };
  } // namespace

  std::string
  ParameterLine::path() const
  {
    return join(subsections, "/") + (subsections.empty() ? "" : "/") + key;
  }

  std::string
  ParameterLine::origin() const
  {
    return file + ", line " + std::to_string(line);
  }

  std::string
  written_value(const std::string &text)
  {
    const std::string line = "set entry = " + text;
    if (text.empty() || (text == trim(text) && text.front() != '"' &&
                         text.back() != '\\' && without_comment(line) == line))
      return text;
    std::string escaped;
    for (const char c : text)
      escaped += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    return '"' + escaped + '"';
  }

  std::vector<ParameterLine>
  read_parameter_lines(const std::string &file_name)
  {
    Reader reader;
    reader.read_file(file_name, "");
    return reader.lines;
  }

  std::vector<ParameterLine>
  read_parameter_lines(std::istream &input, const std::string &name)
  {
    Reader reader;
    reader.read_stream(input, name);
    return reader.lines;
  }
} // namespace asperity
