#ifndef asperity_topography_xml_h
#define asperity_topography_xml_h

#include <asperity/topography/file_content.h>

#include <boost/property_tree/ptree.hpp>

#include <string>

namespace asperity
{
  /**
   * Parse @p text (comments dropped, a byte order mark allowed).
   *
   * @throws InputError if it is not well-formed, declares a document type or
   *   entities, is nested deeper than any format that is read here (the parser
   *   is recursive), or holds more elements than memory should.
   */
  boost::property_tree::ptree
  parse_xml(const FileContent &file,
            const std::string &format,
            const std::string &text);
} // namespace asperity

#endif
