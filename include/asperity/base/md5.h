#ifndef asperity_base_md5_h
#define asperity_base_md5_h

#include <string>

namespace asperity
{
  /** MD5 of the bytes as 32 lower-case hexadecimal digits (RFC 1321). */
  std::string
  md5(const std::string &bytes);

  /** The same of the content of a file, which is read in pieces.
   *  @throws InputError naming the file if it cannot be read */
  std::string
  md5_of_file(const std::string &path);
} // namespace asperity

#endif
