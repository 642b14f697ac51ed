#ifndef asperity_topography_file_content_h
#define asperity_topography_file_content_h

#include <asperity/topography/height_map.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace asperity
{
  struct ReadOptions;

  /**
   * The bytes of a file and guarded access to them. Whatever lies in the file,
   * no read leaves the bytes and no memory is taken that they cannot fill.
   */
  class FileContent
  {
  public:
    /** @throw InputError if the file is missing, unreadable or empty. */
    explicit FileContent(const std::string &file);

    /** Bytes that lie in memory; archives have to be files. */
    FileContent(const std::string &name, const std::string &bytes);

    const std::string &
    name() const
    {
      return file;
    }

    const std::string &
    bytes() const
    {
      return content;
    }

    bool
    starts_with(const std::string &magic) const
    {
      return content.compare(0, magic.size(), magic) == 0;
    }

    /** A little-endian number at @p offset (the machine is one, too). */
    template <typename T>
    T
    number(const std::size_t offset) const
    {
      require(offset, sizeof(T));
      T value;
      std::memcpy(&value, content.data() + offset, sizeof(T));
      return value;
    }

    /** A fixed field of characters, cut at the first NUL, blanks trimmed. */
    std::string
    field(const std::size_t offset, const std::size_t length) const;

    /** @throw InputError if less than @p length bytes follow @p offset. */
    void
    require(const std::size_t offset, const std::size_t length) const;

    /** @throw InputError "<file> is no readable <format> file: <reason>." */
    [[noreturn]] void
    fail(const std::string &format, const std::string &reason) const;

  private:
    std::string file;
    std::string content;
  };

  /**
   * An empty map of the given size, after a check that it is plausible and
   * that the @p available bytes hold nx*ny points of @p bytes_per_point.
   */
  HeightMap
  allocate_map(const FileContent &file,
               const std::string &format,
               const std::int64_t nx,
               const std::int64_t ny,
               const std::size_t  available,
               const std::size_t  bytes_per_point);

  /** Number of the text, or a failure that names @p what. */
  double
  parse_number(const FileContent &file,
               const std::string &format,
               const std::string &what,
               const std::string &text);

  /** As parse_number, and the number has to be whole. */
  std::int64_t
  parse_integer(const FileContent &file,
                const std::string &format,
                const std::string &what,
                const std::string &text);

  /** Text without blanks, line ends and NULs around it. */
  std::string
  strip(const std::string &text);

  /** As read_height_map() of a file. */
  HeightMap
  read_height_map(const FileContent &file, const ReadOptions &options);

  // One reader a format; see read_height_map().
  HeightMap
  read_x3p(const FileContent &file, const ReadOptions &options);
  HeightMap
  read_sdf(const FileContent &file, const ReadOptions &options);
  HeightMap
  read_sur(const FileContent &file, const ReadOptions &options);
  HeightMap
  read_al3d(const FileContent &file, const ReadOptions &options);
  HeightMap
  read_plux(const FileContent &file, const ReadOptions &options);
  HeightMap
  read_gsf(const FileContent &file, const ReadOptions &options);
  HeightMap
  read_text(const FileContent &file, const ReadOptions &options);
} // namespace asperity

#endif
