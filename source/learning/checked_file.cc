#include "checked_file.h"

#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/md5.h>
#include <asperity/base/text.h>

#include <fstream>
#include <iterator>

namespace asperity
{
  namespace
  {
    std::string
    first_line(const std::string &kind)
    {
      return "Asperity " + kind + ", version 1\n";
    }
  } // namespace



  void
  write_checked_file(const std::string &path,
                     const std::string &kind,
                     const std::string &bytes)
  {
    write_atomically(
      path,
      [&](std::ostream &out) {
        out << first_line(kind) << md5(bytes) << '\n' << bytes;
      },
      Durability::machine);
  }



  std::string
  read_checked_file(const std::string &path, const std::string &kind)
  {
    std::ifstream in(path, std::ios::binary);
    if (!in)
      throw InputError("The " + kind + " " + quoted_name(path) +
                       " cannot be read.");
    const std::string content{std::istreambuf_iterator<char>(in), {}};
    const std::string line   = first_line(kind);
    const std::size_t header = line.size() + 33;
    if (content.compare(0, line.size(), line) != 0)
      throw InputError("The file " + quoted_name(path) + " is no " + kind +
                       " of this version of Asperity.");
    if (content.size() < header ||
        content.substr(line.size(), 32) != md5(content.substr(header)))
      throw InputError("The " + kind + " " + quoted_name(path) +
                       " is damaged: its content has another check sum than "
                       "it had when it was written.");
    return content.substr(header);
  }
} // namespace asperity
