#include <asperity/topography/xml.h>

#include <boost/property_tree/xml_parser.hpp>

#include <sstream>

namespace asperity
{
  namespace
  {
    /** No element of the text lies deeper than this many others. */
    bool
    is_shallow(const std::string &text, const int max_depth)
    {
      int depth = 0;
      for (std::size_t i = text.find('<'); i != std::string::npos;
           i             = text.find('<', i + 1))
        {
                      const char next = i + 1 < text.size() ? text[i + 1] : ' ';
                      if (next == '/')
            --depth;
          else if (next != '!' && next != '?')
            ++depth;
          const auto close = text.find('>', i);
                      if (close != std::string::npos && text[close - 1] == '/' &&
              next != '/' && next != '!')
            --depth;
          if (depth > max_depth)
            return false;
        }
      return true;
    }
  } // namespace

  boost::property_tree::ptree
  parse_xml(const FileContent &file,
            const std::string &format,
            const std::string &text)
  {
    namespace pt = boost::property_tree;
    // A comment may hold anything that looks like an element, so this bound
    // is generous; real files have about six levels.
    if (!is_shallow(text, 1000))
      file.fail(format, "holds XML that is nested too deeply");
    const bool         has_mark = text.compare(0, 3, "\xef\xbb\xbf") == 0;
    std::istringstream in(has_mark ? text.substr(3) : text);
    pt::ptree          tree;
    try
      {
        pt::read_xml(in,
                     tree,
                     pt::xml_parser::no_comments |
                       pt::xml_parser::trim_whitespace);
      }
    catch (const pt::xml_parser_error &error)
      {
        file.fail(format,
                  "holds XML that cannot be parsed (line " +
                    std::to_string(error.line()) + ": " + error.message() +
                    ")");
      }
    return tree;
  }
} // namespace asperity
