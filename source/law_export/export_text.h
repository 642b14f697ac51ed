#ifndef asperity_law_export_export_text_h
#define asperity_law_export_export_text_h

#include <asperity/law_export/contact_point_law.h>

#include <string>
#include <vector>

namespace asperity
{
  /** The permissive licence that every exported file carries. */
  std::vector<std::string>
  licence_lines();

  /**
   * What an exported file says of its law: program, kernel, number of runs,
   * leave-one-out error, ranges, fixed inputs, shear limit and provenance. No
   * line is longer than 66 characters or contains the marks of a comment in C.
   */
  std::vector<std::string>
  law_lines(const ContactPointLaw &law);

  /**
   * Text from a law's file, as it may stand in a comment of any program: in one
   * line of printable ASCII characters, without marks of comments and
   * trigraphs, and of at most 500 characters. What is none of these becomes a
   * blank or a question mark.
   */
  std::string
  plain_text(const std::string &text);

  /** Title, law and licence, each line behind the mark of a comment. */
  std::string
  comment_header(const std::vector<std::string> &title,
                 const ContactPointLaw          &law,
                 const std::string              &mark);

  /** Broken between words into lines that are not longer, if words allow. */
  std::vector<std::string>
  wrapped(const std::string &text, const std::size_t width);

  /** "Matern 5/2" */
  std::string
  kernel_name(const KernelKind kernel);

  /** "0.82 %" */
  std::string
  percent(const double ratio, const unsigned int digits = 2);
} // namespace asperity

#endif
