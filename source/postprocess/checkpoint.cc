#include <asperity/base/archive.h>
#include <asperity/base/atomic_file.h>
#include <asperity/base/errors.h>
#include <asperity/base/md5.h>
#include <asperity/base/text.h>
#include <asperity/postprocess/checkpoint.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace asperity
{
  namespace
  {
    struct Head
    {
      char          word[8]      = {'A', 'S', 'P', 'E', 'R', 'I', 'T', 'Y'};
      std::uint32_t version      = Checkpoint::format_version;
      std::uint32_t order        = 0x01020304;
      std::uint64_t length       = 0;
      char          checksum[32] = {}; ///< MD5 in hexadecimal digits
    };
    static_assert(sizeof(Head) == 56, "the head has no padding");

    /** Word, version and byte order stand at the same place in all versions. */
    constexpr std::size_t size_of_identity = 16;

    void
    check_identity(const Head &head, const std::string &path)
    {
      if (std::memcmp(head.word, Head().word, sizeof(head.word)) != 0)
        throw InputError("The file " + quoted_name(path) +
                         " is not a checkpoint: it does not begin with the "
                         "word ASPERITY.");
      if (head.order != Head().order)
        throw InputError("The checkpoint " + quoted_name(path) +
                         " was written on a machine of another byte order.");
      if (head.version != Checkpoint::format_version)
        throw InputError("The checkpoint " + quoted_name(path) +
                         " has format version " + std::to_string(head.version) +
                         ", but this program reads version " +
                         std::to_string(Checkpoint::format_version) +
                         "; expected one of a run of this program.");
    }

    /** Head and length fit each other; leaves the stream behind the head. */
    Head
    read_head(std::ifstream &in, const std::string &path)
    {
      Head head;
      in.read(reinterpret_cast<char *>(&head), sizeof(head));
      const auto n_read = static_cast<std::size_t>(in.gcount());
      if (n_read < size_of_identity)
        throw InputError("The file " + quoted_name(path) +
                         " is not a checkpoint: it is shorter than the head "
                         "of one.");
      check_identity(head, path);
      std::error_code    error;
      const std::size_t  size = std::filesystem::file_size(path, error);
      const std::int64_t rest = error ?
                                  0 :
                                  static_cast<std::int64_t>(size) -
                                    static_cast<std::int64_t>(sizeof(head));
      if (rest < 0 || static_cast<std::uint64_t>(rest) != head.length)
        throw InputError("The checkpoint " + quoted_name(path) + " holds " +
                         std::to_string(std::max<std::int64_t>(0, rest)) +
                         " bytes behind its head, but " +
                         std::to_string(head.length) +
                         " are expected: it was cut short or added to.");
      return head;
    }
  } // namespace



  void
  Checkpoint::write(const std::string &path) const
  {
    const std::string bytes = to_bytes(
      [&](OutputArchive &archive) { archive << program << inputs << state; });
    const std::string checksum = md5(bytes);
    Head              head;
    head.length = bytes.size();
    std::memcpy(head.checksum, checksum.data(), sizeof(head.checksum));
    write_atomically(
      path,
      [&](std::ostream &out) {
        out.write(reinterpret_cast<const char *>(&head), sizeof(head));
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      },
      Durability::machine);
  }



  Checkpoint
  Checkpoint::read(const std::string &path)
  {
    std::ifstream in(path, std::ios::binary);
    if (!in)
      throw InputError("The checkpoint " + quoted_name(path) +
                       " could not be opened.");
    const Head  head = read_head(in, path);
    std::string bytes(head.length, '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const std::string expected(head.checksum, sizeof(head.checksum));
    if (!in || md5(bytes) != expected)
      throw InputError("The checkpoint " + quoted_name(path) +
                       " is damaged: its checksum does not fit its content.");
    Checkpoint checkpoint;
    from_bytes(bytes,
               "The checkpoint " + quoted_name(path),
               [&](InputArchive &archive) {
                 archive >> checkpoint.program >> checkpoint.inputs >>
                   checkpoint.state;
               });
    return checkpoint;
  }
} // namespace asperity
