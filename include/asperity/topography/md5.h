#ifndef asperity_topography_md5_h
#define asperity_topography_md5_h

#include <string>

namespace asperity
{
  /** MD5 of the bytes as 32 lower-case hexadecimal digits (RFC 1321). */
  std::string
  md5(const std::string &bytes);
} // namespace asperity

#endif
