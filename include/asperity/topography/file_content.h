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
    /** @throws InputError if the file is missing, unreadable or empty. */
    explicit FileContent(const std::string &file);

    /**
     * Bytes that lie in memory.
     *
     * @throws InputError if there are none.
     */
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

    /**
     * A little-endian number at @p offset (the machine is one, too).
     *
     * @throws InputError if the file ends before it does.
     */
    template <typename T>
    T
    number(const std::size_t offset) const
    {
      require(offset, sizeof(T));
      T value;
      std::memcpy(&value, content.data() + offset, sizeof(T));
      return value;
    }

    /**
     * A fixed field of characters, cut at the first NUL, blanks trimmed.
     *
     * @throws InputError if the file ends before it does.
     */
    std::string
    field(const std::size_t offset, const std::size_t length) const;

    /** @throws InputError if less than @p length bytes follow @p offset. */
    void
    require(const std::size_t offset, const std::size_t length) const;

    /** @throws InputError "The surface file <file> (<format>) <reason>." */
    [[noreturn]] void
    fail(const std::string &format, const std::string &reason) const;

  private:
    std::string file;
    std::string content;
  };

  /**
   * An empty map of the given size, after a check that it is plausible and
   * that the @p available bytes hold nx*ny points of @p bytes_per_point.
   *
   * @throws InputError if not.
   */
  HeightMap
  allocate_map(const FileContent &file,
               const std::string &format,
               const std::int64_t nx,
               const std::int64_t ny,
               const std::size_t  available,
               const std::size_t  bytes_per_point);

  /**
   * What the bytes from @p end, where the heights that the header states end,
   * to @p limit tell: a trailer of text or less than a row is named in the
   * warnings of the map.
   *
   * @throws InputError if they may be further heights: then the header states
   *   another map than the file holds, and its rows would be sheared.
   */
  void
  check_surplus(const FileContent &file,
                const std::size_t  end,
                const std::size_t  limit,
                const std::size_t  bytes_per_point,
                HeightMap         &map);

  /**
   * Bounds what a small file may unpack to: heights of instruments are packed
   * to a tenth at best, while zeros shrink to a thousandth.
   *
   * @throws InputError if @p unpacked bytes are more than a hundred times the
   *   file, and more than 64 MiB.
   */
  void
  check_unpacked_size(const FileContent  &file,
                      const std::string  &format,
                      const std::uint64_t unpacked);

  /** Whether the whole of @p text is a decimal number; infinite if it is too
   *  large for one. Independent of the case of "inf" and "nan". */
  bool
  parse_decimal(const std::string &text, double &value);

  /**
   * Number of the text.
   *
   * @throws InputError that names @p what if it is none, or not finite.
   */
  double
  parse_number(const FileContent &file,
               const std::string &format,
               const std::string &what,
               const std::string &text);

  /**
   * As parse_number().
   *
   * @throws InputError also if the number is not whole.
   */
  std::int64_t
  parse_integer(const FileContent &file,
                const std::string &format,
                const std::string &what,
                const std::string &text);

  /** No NUL and no other control character in the first bytes. */
  bool
  looks_like_text(const std::string &bytes);

  /** Text without blanks, line ends and NULs around it. */
  std::string
  strip(const std::string &text);

  /** As read_height_map() of a file. */
  HeightMap
  read_height_map(const FileContent &file, const ReadOptions &options);

  /** Whether the content is that of a height map other than plain text. */
  bool
  has_height_map_signature(const FileContent &file);

  // One reader a format; see read_height_map(), whose errors they throw.
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
