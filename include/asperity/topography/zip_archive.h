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
   * minizip. The @p file has to outlive it.
   */
  class ZipArchive
  {
  public:
    /** @throw InputError if @p file is no complete archive. */
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
     * The bytes of an entry. Unpacking stops with an error at @p max_size, so
     * a small archive cannot fill the memory.
     */
    std::string
    read(const std::string &entry, const std::size_t max_size) const;

  private:
    const FileContent       &file;
    std::string              format;
    void                    *handle = nullptr;
    std::vector<std::string> names;
  };

  /** Write @p entries (name, bytes) deflated, with a fixed date. */
  void
  write_zip(const std::string                                      &file,
            const std::vector<std::pair<std::string, std::string>> &entries);
} // namespace asperity

#endif
