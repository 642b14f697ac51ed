#include <asperity/topography/xml.h>

#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <cstring>
#include <sstream>

namespace asperity
{
  namespace
  {
    // The parser and the tree recurse into elements; real files have about six
    // levels. A node of the tree takes about 400 bytes, and so do 2^20 of them
    // 400 MB; long lists of heights belong into a binary file of the archive.
    constexpr unsigned int max_depth = 100;
    constexpr unsigned int max_nodes = 1u << 20;

    /**
     * Goes through the marks of a text once, from '<' to '<', and knows what
     * the parser will make of each: comments, sections of characters and
     * instructions hold no elements, and values of attributes no ends of them.
     */
    class MarkupCheck
    {
    public:
      explicit MarkupCheck(const std::string &text)
        : text(text)
      {}

      /** What is wrong, or an empty string. */
      std::string
      run()
      {
        if (text.find('\0') != std::string::npos)
          return "cannot be parsed: it is not encoded in UTF-8";
        while (reason.empty() && (at = text.find('<', at)) != std::string::npos)
          {
            if (is_at("<!--"))
              skip_behind("-->", 4);
            else if (is_at("<![CDATA["))
              skip_behind("]]>", 9);
            else if (is_at("<?"))
              skip_behind("?>", 2);
            else if (is_at("<!"))
              reason = "declares a document type or entities, which no surface "
                       "file needs";
            else
              read_tag();
            if (reason.empty())
              check_size();
          }
        return reason;
      }

    private:
      bool
      is_at(const char *mark) const
      {
        return text.compare(at, std::strlen(mark), mark) == 0;
      }

      void
      skip_behind(const char *mark, const std::size_t offset)
      {
        const auto end = text.find(mark, std::min(at + offset, text.size()));
        ++n_nodes;
        if (end == std::string::npos)
          reason =
            std::string("cannot be parsed: it ends before a '") + mark + "'";
        else
          at = end + std::strlen(mark);
      }

      /** An opening, closing or empty element, and its attributes. */
      void
      read_tag()
      {
        const bool closes = is_at("</");
        char       quote  = 0;
        for (++at; at < text.size() && (quote != 0 || text[at] != '>'); ++at)
          if (text[at] == '<')
            break; // allowed neither in names nor in values
          else if (quote != 0)
            quote = text[at] == quote ? 0 : quote;
          else if (text[at] == '"' || text[at] == '\'')
            quote = text[at];
          else if (text[at] == '=')
            ++n_nodes;
        if (at == text.size() || text[at] == '<')
          reason = "cannot be parsed: an element has no '>'";
        else if (closes && depth-- == 0)
          reason =
            "cannot be parsed: it closes an element that it did not open";
        else if (!closes)
          {
            ++n_nodes;
            depth += text[at - 1] == '/' ? 0 : 1;
          }
      }

      void
      check_size()
      {
        if (depth > max_depth)
          reason = "is nested too deeply, over " + std::to_string(max_depth) +
                   " levels";
        else if (n_nodes > max_nodes)
          reason = "holds more than " + std::to_string(max_nodes) +
                   " elements and attributes";
      }

      const std::string &text;
      std::size_t        at      = 0;
      unsigned int       depth   = 0;
      unsigned int       n_nodes = 0;
      std::string        reason;
    };
  } // namespace

  boost::property_tree::ptree
  parse_xml(const FileContent &file,
            const std::string &format,
            const std::string &text)
  {
    namespace pt             = boost::property_tree;
    const std::string reason = MarkupCheck(text).run();
    if (!reason.empty())
      file.fail(format, "holds XML that " + reason);
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
