#include <asperity/topography/md5.h>

#include <boost/uuid/detail/md5.hpp>

#include <cstdio>
#include <cstring>

namespace asperity
{
  std::string
  md5(const std::string &bytes)
  {
    boost::uuids::detail::md5              hash;
    boost::uuids::detail::md5::digest_type digest;
    hash.process_bytes(bytes.data(), bytes.size());
    hash.get_digest(digest);
    // The words of the digest hold its bytes in the order of memory.
    unsigned char raw[16];
    static_assert(sizeof(digest) == sizeof(raw), "MD5 has 16 bytes.");
    std::memcpy(raw, &digest, sizeof(raw));
    std::string text;
    for (const unsigned char byte : raw)
      {
        char two[3];
        std::snprintf(two, sizeof(two), "%02x", byte);
        text += two;
      }
    return text;
  }
} // namespace asperity
