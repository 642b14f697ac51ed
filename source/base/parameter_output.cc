#include <asperity/base/commented_parameters.h>
#include <asperity/base/parameter_file.h>
#include <asperity/base/parameters.h>
#include <asperity/base/text.h>

#include <algorithm>
#include <ostream>

// What is written of the parameters: the complete file and the reference.

namespace asperity
{
  namespace
  {
    /** Subsections in the order of declaration, each once. */
    std::vector<std::string>
    subsections_of(const std::vector<ParameterEntry> &entries)
    {
      std::vector<std::string> names;
      for (const ParameterEntry &entry : entries)
        if (std::find(names.begin(), names.end(), entry.subsection) ==
            names.end())
          names.push_back(entry.subsection);
      return names;
    }

    std::string
    code(const std::string &text)
    {
      return text.empty() ? "(empty)" : "`" + text + "`";
    }

    std::string
    escape_table(std::string text)
    {
      for (auto at = text.find('|'); at != std::string::npos;
           at      = text.find('|', at + 2))
        text.insert(at, "\\");
      return text;
    }
  } // namespace

  void
  ParameterDeclarator::write_prm(std::ostream &out) const
  {
    // deal.II's own listing sorts subsections and loses the range; this one
    // keeps the order of declaration.
    for (const std::string &subsection : subsections_of(declared))
      {
        const std::vector<std::string> path = split(subsection, '/');
        std::string                    indent;
        for (const std::string &name : path)
          {
            out << indent << "subsection " << name << '\n';
            indent += "  ";
          }
        for (const ParameterEntry &entry : declared)
          if (entry.subsection == subsection)
            {
              write_wrapped(out, entry.sentence, indent + "# ");
              write_wrapped(out,
                            "[" + entry.kind + ": " + entry.range +
                              (entry.need == Need::mandatory ?
                                 "; mandatory]" :
                                 "; default: " +
                                   (entry.default_text.empty() ?
                                      "empty" :
                                      entry.default_text) +
                                   "]"),
                            indent + "# ");
              const std::string value = written_value(get(entry.path()));
              if (entry.need == Need::mandatory && !entry.given)
                out << indent << "# set " << entry.key << " = \n";
              else
                out << indent << "set " << entry.key << " = " << value << '\n';
            }
        for (std::size_t i = path.size(); i > 0; --i)
          out << std::string(2 * (i - 1), ' ') << "end\n";
        out << '\n';
      }
  }

  void
  ParameterDeclarator::write_markdown(std::ostream &out) const
  {
    for (const std::string &subsection : subsections_of(declared))
      {
        out << "## " << (subsection.empty() ? "Top level" : subsection)
            << "\n\n| entry | default | kind and range | meaning |\n"
               "| --- | --- | --- | --- |\n";
        for (const ParameterEntry &entry : declared)
          if (entry.subsection == subsection)
            out << "| " << entry.key << " | "
                << (entry.need == Need::mandatory ?
                      "**mandatory**" :
                      escape_table(code(entry.default_text)))
                << " | " << escape_table(entry.kind + ": " + entry.range)
                << " | " << escape_table(entry.sentence) << " |\n";
        out << '\n';
      }
  }
} // namespace asperity
