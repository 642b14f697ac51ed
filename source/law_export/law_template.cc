#include "law_template.h"

#include <asperity/base/text.h>

#include <sstream>
#include <stdexcept>

namespace asperity
{
  namespace
  {
    /** What follows a word at the start of a comment of C, JavaScript or
     * Fortran, or "". */
    std::string
    behind(const std::string &with_blanks, const std::string &word)
    {
      const std::string line = trim(with_blanks);
      for (const char *const mark : {"/* ", "C     "})
        if (line.rfind(mark + word + " ", 0) == 0)
          {
            std::string rest =
              line.substr(std::string(mark).size() + word.size() + 1);
            if (const std::size_t end = rest.rfind(" */");
                end != std::string::npos)
              rest.erase(end);
            return trim(rest);
          }
      return "";
    }
  } // namespace



  std::string
  law_template::fill(
    const std::string                                     &text,
    const std::function<std::string(const std::string &)> &block)
  {
    std::istringstream in(text);
    std::string        result;
    for (std::string line; std::getline(in, line);)
      {
        const std::string begun = behind(line, "BEGIN");
        if (begun.empty())
          {
            result += line + "\n";
            continue;
          }
        const std::string name = begun.substr(0, begun.find(' '));
        result += block(begun);
        while (behind(line, "END") != name)
          if (!std::getline(in, line))
            throw std::logic_error("The block " + name +
                                   " of a template has no end.");
      }
    return result;
  }
} // namespace asperity
