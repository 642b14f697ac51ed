#include <asperity/base/commented_parameters.h>
#include <asperity/base/parameter_file.h>
#include <asperity/base/parameters.h>
#include <asperity/base/text.h>

#include <algorithm>
#include <ostream>
#include <sstream>

namespace asperity
{
  namespace
  {
    /** Leaves the subsections that @p next does not share with @p open, and
     *  enters the others. */
    void
    change_subsection(std::ostream                   &out,
                      std::vector<std::string>       &open,
                      const std::vector<std::string> &next)
    {
      std::size_t common = 0;
      while (common < open.size() && common < next.size() &&
             open[common] == next[common])
        ++common;
      while (open.size() > common)
        {
          open.pop_back();
          out << std::string(2 * open.size(), ' ') << "end\n";
        }
      while (open.size() < next.size())
        {
          out << '\n'
              << std::string(2 * open.size(), ' ') << "subsection "
              << next[open.size()] << '\n';
          open.push_back(next[open.size()]);
        }
    }
  } // namespace



  void
  write_commented_prm(std::ostream                      &out,
                      const ParameterDeclarator         &parameters,
                      const std::vector<CommentedEntry> &entries)
  {
    for (const CommentedEntry &entry : entries)
      parameters.get(entry.path); // throws if there is no such entry
    std::vector<std::string> open;
    bool                     first = true;
    for (const ParameterEntry &declared : parameters.entries())
      {
        const auto entry =
          std::find_if(entries.begin(), entries.end(), [&](const auto &e) {
            return e.path == declared.path();
          });
        if (entry == entries.end())
          continue;
        const auto before = open;
        change_subsection(out, open, split(declared.subsection, '/'));
        if (!first && open == before)
          out << '\n';
        first                    = false;
        const std::string indent = std::string(2 * open.size(), ' ');
        write_wrapped(out, declared.sentence, indent + "# ");
        write_wrapped(out, "Here: " + entry->reason, indent + "# ");
        out << indent << "set " << declared.key << " = "
            << written_value(entry->text) << '\n';
      }
    change_subsection(out, open, {});
  }



  void
  write_wrapped(std::ostream      &out,
                const std::string &text,
                const std::string &prefix,
                const std::size_t  width)
  {
    std::istringstream words(text);
    std::string        word, line;
    while (words >> word)
      {
        if (!line.empty() &&
            prefix.size() + line.size() + 1 + word.size() > width)
          {
            out << prefix << line << '\n';
            line.clear();
          }
        line += (line.empty() ? "" : " ") + word;
      }
    if (!line.empty())
      out << prefix << line << '\n';
  }
} // namespace asperity
