#ifndef asperity_topography_zip_archive_h
#define asperity_topography_zip_archive_h

#include <asperity/topography/file_content.h>

#include <cstddef>
#include <string>
#include <vector>

namespace asperity
{
  /**
   * The entries of a ZIP archive (X3P and PLUX files), read one by one through
   * minizip from the bytes in memory. The @p file has to outlive it.
   */
  class ZipArchive
  {
  public:
    /** @throws InputError if @p file is no complete archive. */
    ZipArchive(const FileContent &file, const std::string &format);
    ~ZipArchive();
    ZipArchive(const ZipArchive &) = delete;
    ZipArchive &
    operator=(const ZipArchive &) = delete;

    /**
     * The full name of the entry whose path ends with @p tail, the shortest of
     * them (some programs pack the tree into a folder, and macOS adds copies
     * of its own in __MACOSX), or an empty string.
     */
    std::string
    find(const std::string &tail) const;

    /**
     * The number of bytes that the table of contents states for an entry.
     *
     * @throws InputError if the entry is not there, or if so many bytes cannot
     *   be meant; see check_unpacked_size().
     */
    std::size_t
    stated_size(const std::string &entry) const;

    /**
     * The bytes of an entry.
     *
     * @throws InputError if it is damaged, or if it states or holds more than
     *   @p max_size bytes; unpacking stops there.
     */
    std::string
    read(const std::string &entry, const std::size_t max_size) const;

  private:
    /** The bytes as minizip sees them: an open file. */
    struct Stream
    {
      const std::string *bytes    = nullptr;
      std::size_t        position = 0;
    };

    void
    open_stream();

    const FileContent       &file;
    std::string              format;
    Stream                   stream;
    void                    *handle = nullptr;
    std::vector<std::string> names;
  };

  /**
   * Write @p entries (name, bytes) deflated, with a fixed date.
   *
   * @throws InputError if the file cannot be written.
   */
  void
  write_zip(const std::string                                      &file,
            const std::vector<std::pair<std::string, std::string>> &entries);
} // namespace asperity

#endif
